"""Who reverses is seen and read to do so."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely
from lxml import etree

from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.motion import build_paths, simulate
from scegen.report.bodies import corners_at
from scegen.report.lane_shapes import bays, road_shapes
from scegen.report.preview import preview_svg
from scegen.report.tile import describe, tile_svg
from scegen.report.words import participant_words
from scegen.road import build_network
from scegen.road.model import LaneType
from scegen.scenario.functional import FunctionalScenario, Hazard, Participant
from scegen.scenario.junction import Junction
from scegen.scenario.logical import Reverses
from scegen.scenario.vocabulary import HazardKind, JunctionKind, Maneuver, Role

WORDS = {
    Reverses.BACKS_UP: ("backs up", "m back from"),
    Reverses.FROM_RIGHT: ("backs out from the right", "comes out backwards from the right"),
    Reverses.FROM_LEFT: ("backs out from the left", "comes out backwards from the left"),
    Reverses.OUT_OF_ARM: ("backs out, ", "comes backwards out of arm "),
    Reverses.SQUARE: ("backs straight out", "m straight back, square to the road"),
}


def listed(kind, arms, ways=frozenset()):
    functional = FunctionalScenario(
        description="for tests",
        junction=Junction(kind=kind, arms=arms),
        participants=(Participant(id="car", maneuvers=ways), Participant(id="ego", role=Role.EGO)),
        hazards=(Hazard(kind=HazardKind.REVERSING, by=("car",), to=("ego",)),),
    )
    return functional, enumerate_scenarios(functional).scenarios


@pytest.fixture(scope="module")
def found():
    """One scenario for every way to reverse."""
    ways = {}
    straight = frozenset({Maneuver.STRAIGHT})
    for kind, arms, *said in (
        (JunctionKind.STRAIGHT, 2),
        (JunctionKind.T, 3),
        (JunctionKind.T, 3, straight),
    ):
        functional, scenarios = listed(kind, arms, *said)
        for scenario in scenarios:
            ways.setdefault(scenario.assignment("car").reverses, (functional, scenario))
    return ways


def texts_of(scenario, functional):
    return [text.text for text in etree.fromstring(tile_svg(scenario, functional).encode()).iter()]


@pytest.mark.parametrize("how", [*Reverses])
def test_tiles_and_tables_say_how(found, how):
    functional, scenario = found[how]
    listed_as, driven_as = WORDS[how]
    assert listed_as in describe(scenario)
    texts = texts_of(scenario, functional)
    assert texts.count("R") == 1
    car = concretize(functional, scenario).participant("car")
    assert driven_as in participant_words(car)


def test_who_does_not_reverse_has_no_mark(found):
    functional, scenario = found[Reverses.BACKS_UP]
    drives = tuple(a.model_copy(update={"reverses": None}) for a in scenario.assignments)
    plain = scenario.model_copy(update={"assignments": drives})
    assert "R" not in [
        text.text for text in etree.fromstring(tile_svg(plain, functional).encode()).iter()
    ]


@pytest.mark.parametrize("side", [Reverses.FROM_RIGHT, Reverses.FROM_LEFT])
def test_the_bay_that_one_backs_out_of_is_paved_up_to_the_lanes(found, side):
    functional, scenario = found[side]
    concrete = concretize(functional, scenario)
    network = build_network(concrete.road)
    paths = build_paths(concrete, network)
    (bay,) = (shapely.Polygon(outline) for outline in bays(concrete, paths))
    start = corners_at(simulate(concrete, paths)["car"], 0)
    lanes = [shapely.Polygon(p) for p in road_shapes(network).lanes[LaneType.DRIVING]]
    assert bay.contains(shapely.Polygon(start))
    assert bay.distance(shapely.union_all(lanes)) < 0.05


def test_the_preview_marks_the_way_back(found):
    functional, scenario = found[Reverses.FROM_RIGHT]
    concrete = concretize(functional, scenario)
    network = build_network(concrete.road)
    paths = build_paths(concrete, network)
    picture = preview_svg(concrete, network, paths)
    assert picture == preview_svg(concrete, network, paths)
    unmarked = {**paths, "car": replace(paths["car"], heading_rad=_way_of_travel(paths["car"]))}
    assert not unmarked["car"].backwards
    traces = simulate(concrete, paths)
    assert preview_svg(concrete, network, paths, traces) == picture
    assert preview_svg(concrete, network, unmarked, traces) != picture


def _way_of_travel(path):
    heading = np.arctan2(np.diff(path.y_m), np.diff(path.x_m))
    return np.append(heading, heading[-1])

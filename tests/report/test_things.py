"""Things in pictures and tables."""

from __future__ import annotations

from by_hand import by_hand, straight_road
from things import thing

from scegen.criticality.encounter import closest_encounter
from scegen.motion import build_paths, simulate
from scegen.report.preview import preview_svg
from scegen.report.tables import tables
from scegen.report.words import thing_words
from scegen.report.world import thing_corners
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteParticipant, DriveMotion
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind, ParticipantKind, Role

WAY = DriveMotion(
    entry=0, entry_lane=1, exit=1, exit_lane=1, start_m=20, turning_starts_m=200, turning_ends_m=200
)
EGO = ConcreteParticipant(
    id="ego", kind=ParticipantKind.CAR, role=Role.EGO, speed_mps=10, motion=WAY
)
HAZARD = Hazard(kind=HazardKind.OBSTACLE, by=("crate_1",), to=("ego",))


def case(*things, hazards=()):
    concrete = by_hand(EGO, objects=things, hazards=hazards, road=straight_road())
    network = build_network(concrete.road)
    paths = build_paths(concrete, network)
    return concrete, network, paths, simulate(concrete, paths)


def test_corners_are_those_of_the_box():
    corners = thing_corners(thing(x_m=1.0, y_m=2.0, heading_deg=90, length_m=4, width_m=2))
    assert sorted(map(tuple, corners.round(6))) == [(0, 0), (0, 4), (2, 0), (2, 4)]


def test_the_closest_approach_is_to_an_obstacle_not_to_what_hides():
    crate = thing(x_m=100.0, y_m=6.0)
    assert closest_encounter(*case(crate)[::3]) is None
    found = closest_encounter(*case(crate, hazards=(HAZARD,))[::3])
    assert found.other == "crate_1"


def test_it_is_drawn_and_listed():
    crate = thing(x_m=100.0, y_m=6.0)
    plain, network, paths, _ = case()
    with_it, *_ = case(crate, hazards=(HAZARD,))
    pictures = [preview_svg(c, network, paths) for c in (plain, with_it, with_it)]
    assert pictures[0] != pictures[1]
    assert pictures[1] == pictures[2]
    (table,) = [t for t in tables(with_it) if t.title == "Things that do not take part"]
    assert table.rows == (
        ("crate_1", "crate", "obstacle", "100.0, 6.0 m", "0°", "1 × 1 × 1 m", "obstacle"),
    )
    assert "does not move" in thing_words(crate)
    assert not [t for t in tables(plain) if t.title == "Things that do not take part"]

"""Doors that open: closed until somebody comes, open when that one is there, and its danger."""

import numpy as np
import pytest
from roads import SCENARIOS, STAY, ego, one, road
from saying import missed
from told import act

from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.errors import MotionInfeasibleError
from scegen.motion import build_paths, simulate
from scegen.motion.doors import OPENS_RAD, REACH_M
from scegen.road import build_network
from scegen.scenario.concrete import AtTime, ConcreteScenario, door_of
from scegen.scenario.functional import FunctionalScenario

DOORS = sorted(name for name in SCENARIOS if "door" in name)
DOOR = door_of("parked")


def concrete_of(name):
    """A scenario's first concrete one."""
    functional = SCENARIOS[name]
    return functional, concretize(functional, enumerate_scenarios(functional).scenarios[0])


@pytest.mark.parametrize("name", DOORS)
def test_a_door_swings_from_its_vehicle_s_side_to_the_side_of_the_traffic(name):
    functional, concrete = concrete_of(name)
    network = build_network(concrete.road)
    paths = build_paths(concrete, network)
    vehicle, door = paths["parked"].start, paths[DOOR]
    body = functional.participant("parked").body
    middle = vehicle.shifted(forward_m=body.centre_ahead_m)
    left = -np.sin(middle.heading_rad), np.cos(middle.heading_rad)
    out = (door.x_m - middle.x_m) * left[0] + (door.y_m - middle.y_m) * left[1]
    sign = 1 if functional.junction.driving_side == "right" else -1
    assert (np.diff(sign * out) > 0).all()
    turned = abs(door.heading_rad[-1] - door.heading_rad[0])
    assert turned == pytest.approx(OPENS_RAD)
    tip = sign * out[-1] + concrete.participant(DOOR).body.width_m / 2 * np.sin(turned)
    assert tip - body.width_m / 2 == pytest.approx(REACH_M)
    assert concrete.participant("parked").parked


@pytest.mark.parametrize("name", DOORS)
def test_it_is_closed_at_first_and_open_in_the_end(name):
    _, concrete = concrete_of(name)
    paths = build_paths(concrete, build_network(concrete.road))
    way = simulate(concrete, paths)[DOOR].s_m
    assert way[: int(1.0 / 0.05)].max() == 0.0
    assert way[-1] == paths[DOOR].length_m


@pytest.mark.parametrize(("opens_s", "lost"), [(0.0, "before"), (30.0, "act.opens")])
def test_one_that_opens_long_before_or_never_is_told(opens_s, lost):
    functional, concrete = concrete_of("a_rider_hits_a_door")
    assert not missed(functional, concrete)
    door = concrete.participant(DOOR)
    phase = door.speed_program[0].model_copy(update={"trigger": AtTime(time_s=opens_s)})
    opened = door.model_copy(update={"speed_program": (phase,)})
    people = tuple(opened if p is door else p for p in concrete.participants)
    wrong = missed(functional, concrete.model_copy(update={"participants": people}))
    assert any(lost in name for name in wrong)


def test_a_door_hangs_on_its_vehicle():
    _, concrete = concrete_of("a_rider_hits_a_door")
    data = concrete.model_dump()
    parked = next(p for p in data["participants"] if p["id"] == "parked")
    parked["motion"]["from_junction_m"] += 1.0
    with pytest.raises(ValueError, match="does not hang on parked"):
        ConcreteScenario.model_validate(data)


def test_a_door_is_no_participant_of_a_description():
    data = SCENARIOS["a_rider_hits_a_door"].model_dump()
    data["participants"][0]["kind"] = "door"
    with pytest.raises(ValueError, match="a door is no participant"):
        FunctionalScenario.model_validate(data)


def test_at_a_junction_it_is_refused():
    functional = SCENARIOS["a_door_opens_before_it"]
    data = functional.model_dump(mode="json")
    data["junction"] |= {"kind": "four_way", "arms": 4}
    functional = FunctionalScenario.model_validate(data)
    logical = enumerate_scenarios(functional).scenarios[0]
    with pytest.raises(MotionInfeasibleError, match="only on a road without a junction"):
        concretize(functional, logical)


@pytest.mark.parametrize("which", [0, 1, 3])
def test_a_row_is_passed_in_the_order_in_which_it_is_listed(which):
    kinds = ["car", "truck", "van", "bus"]
    row = [one(f"p{n}", kind, [], STAY, parked=True) for n, kind in enumerate(kinds)]
    functional = road(
        [ego(40), *row],
        [("obstacle", f"p{which}", "ego")],
        acts=[act("opens", f"p{which}", "open_door")],
    )
    concrete = concretize(functional, enumerate_scenarios(functional).scenarios[0])
    assert not missed(functional, concrete)
    paths = build_paths(concrete, build_network(concrete.road))
    way = np.array([paths["ego"].x_m[-1], paths["ego"].y_m[-1]])
    ends = np.array([paths["ego"].x_m[0], paths["ego"].y_m[0]])
    course = (way - ends) / np.hypot(*(way - ends))
    places = [np.dot([paths[p["id"]].x_m[0], paths[p["id"]].y_m[0]] - ends, course) for p in row]
    assert places == sorted(places)


@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize("keeps", ["left", "right"])
def test_on_either_side_of_a_one_way_street_it_opens_towards_the_lanes(side, keeps):
    functional = road(
        [ego(30), one("parked", "van", [side], STAY, parked=True)],
        [("obstacle", "parked", "ego")],
        acts=[act("opens", "parked", "open_door")],
        carriageway="one_way",
        side=keeps,
    )
    concrete = concretize(functional, enumerate_scenarios(functional).scenarios[0])
    assert not missed(functional, concrete)
    paths = build_paths(concrete, build_network(concrete.road))
    vehicle, way = paths["parked"].start, paths["ego"].start
    door = paths[DOOR].pose(paths[DOOR].length_m)
    assert np.cos(vehicle.heading_rad - way.heading_rad) == pytest.approx(1.0)
    left = np.array([-np.sin(way.heading_rad), np.cos(way.heading_rad)])
    aside = [np.dot([p.x_m - way.x_m, p.y_m - way.y_m], left) for p in (vehicle, door)]
    assert (aside[0] > 0.0) == (side == "left")
    assert abs(aside[1]) < abs(aside[0])

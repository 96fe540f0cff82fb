"""What is parked pulls out when the one in whose way it is has come near."""

import numpy as np
import pytest
from saying import KMH, missed
from told import first, told, who

from scegen.errors import MotionInfeasibleError
from scegen.motion import build_paths, simulate
from scegen.road import build_network
from scegen.scenario.concrete import StandingMotion, Travelled

EGO = who("ego", maneuvers=["straight"])


def parked(name, kind="car", approach="ahead", maneuvers=("straight",)):
    return who(name, kind, [approach], maneuvers, parked=True)


@pytest.mark.parametrize("kind", ["straight", "four_way", "t", "roundabout"])
@pytest.mark.parametrize("vehicle", ["car", "bus", "bicycle"])
def test_it_stands_then_drives_into_the_lane(kind, vehicle):
    concrete = first(
        told(kind, [EGO if kind != "roundabout" else who("ego"), parked("x", vehicle)])
    )
    x = concrete.participant("x")
    assert not x.parked
    assert x.speed_mps == 0.0
    assert x.motion.entry_lane == concrete.road.arms[x.motion.entry].lanes_in + 1
    assert x.motion.lane_changes[0].lane_after == x.motion.entry_lane - 1
    trigger = x.speed_program[0].trigger
    assert isinstance(trigger, Travelled)
    assert trigger.participant == "ego"
    network = build_network(concrete.road)
    trace = simulate(concrete, build_paths(concrete, network), dt_s=0.02)
    sets_off = int(np.flatnonzero(trace["x"].speed_mps > 0.0)[0])
    assert trace["x"].time_s[sets_off] >= 1.0
    assert trace["ego"].s_m[sets_off] >= trigger.distance_m - 0.5
    assert trace["x"].s_m[-1] > 20.0


def test_the_rest_of_the_row_stays():
    people = [EGO, parked("a", maneuvers=["stay"]), parked("x"), parked("b", maneuvers=["stay"])]
    concrete = first(told("straight", people, [("cut_in", "x", "ego")]))
    assert isinstance(concrete.participant("a").motion, StandingMotion)
    assert isinstance(concrete.participant("b").motion, StandingMotion)
    change = concrete.participant("x").motion.lane_changes[0]
    assert str(change.hazard) == "cut_in"


def test_who_is_parked_and_said_to_stay_stays():
    concrete = first(told("straight", [EGO, parked("x", maneuvers=["stay"])]))
    assert isinstance(concrete.participant("x").motion, StandingMotion)


def test_on_the_other_side_it_is_in_nobodys_way():
    with pytest.raises(MotionInfeasibleError, match="on the other side of the road"):
        first(told("straight", [EGO, parked("x", approach="left")]))


@pytest.mark.parametrize("speed_kph", [10, 20, 30])
def test_it_gains_the_speed_that_is_said_and_no_more(speed_kph):
    speed = speed_kph * KMH
    functional = told(
        "straight", [EGO, who("x", "car", ["ahead"], ["straight"], parked=True, speed=speed)]
    )
    concrete = first(functional)
    (phase,) = concrete.participant("x").speed_program
    assert phase.target_speed_mps == pytest.approx(speed, abs=1e-3)
    assert missed(functional, concrete) == set()
    faster = phase.model_copy(update={"target_speed_mps": speed + 2.0})
    people = tuple(
        p.model_copy(update={"speed_program": (faster,)}) if p.id == "x" else p
        for p in concrete.participants
    )
    changed = concrete.model_copy(update={"participants": people})
    assert "speed.x" in missed(functional, changed)


@pytest.mark.parametrize(("side", "turned"), [("right", 180.0), ("left", -180.0)])
@pytest.mark.parametrize("lanes", [0, 1])
def test_it_turns_back_from_the_kerb(lanes, side, turned):
    people = [EGO, parked("x", approach=side, maneuvers=["u_turn"])]
    functional = told(
        "straight", people, [("failure_to_yield", "x", "ego")], lanes=lanes, side=side
    )
    concrete = first(functional)
    assert missed(functional, concrete) == set()
    path = build_paths(concrete, build_network(concrete.road))["x"]
    assert np.degrees(path.heading_rad[-1] - path.heading_rad[0]) == pytest.approx(turned)


def test_where_no_way_leads_back_that_is_missed():
    people = [EGO, parked("x", maneuvers=["u_turn"])]
    functional = told("four_way", people, lanes=2)
    assert missed(functional, first(functional)) == {"maneuver.turn.x"}


def test_it_sets_off_when_it_is_said_to():
    when = {"type": "measure", "measure": "gap_m", "participant": "ego", "reference": "x"}
    acts = [{"id": "off", "participant": "x", "kind": "set_off", "when": when | {"value": 30.0}}]
    people = [who("ego", maneuvers=["straight"], speed=50 * KMH), parked("x", maneuvers=["u_turn"])]
    functional = told("straight", people, [("failure_to_yield", "x", "ego")], acts=acts)
    assert missed(functional, first(functional)) == set()

"""On-ramps, exits and lanes that end: from the functional level to what the player shows."""

import numpy as np
import pytest
from playing import play
from roads import AHEAD, BEHIND, LEFT_LANE, RIGHT_LANE, STRAIGHT, TOWARDS, ego, one, road
from saying import missed
from told import act, apart

from scegen.claims import claims_of
from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.errors import InfeasibleError
from scegen.motion import simulate
from scegen.motion.paths import build_paths
from scegen.road import build_network
from scegen.scenario.junction import Junction

MERGE, EXIT = ["merge"], ["exit"]


def on(kind, functional, **more):
    """The same people on a motorway with an auxiliary lane."""
    told = {"carriageway": "divided", "strips": ["hard_shoulder"], "lanes": (2, 2)} | more
    made = Junction(kind="straight", arms=2, auxiliary=kind, **told)
    return functional.model_copy(update={"junction": made})


def first(functional):
    listed = enumerate_scenarios(functional)
    concrete = concretize(listed.functional, listed.scenarios[0])
    return concrete, simulate(concrete, build_paths(concrete, build_network(concrete.road)))


SITUATIONS = {
    "merges_ahead": on(
        "on_ramp",
        road([ego(110), one("car", "car", RIGHT_LANE, MERGE)], [("cut_in", "car", "ego")]),
    ),
    "merges_where_traffic_keeps_left": on(
        "on_ramp",
        road([ego(100), one("van", "van", LEFT_LANE, MERGE)], [("cut_in", "van", "ego")]),
        driving_side="left",
    ),
    "the_ego_merges_behind_a_truck": on(
        "on_ramp", road([ego(maneuvers=MERGE), one("truck", "truck", LEFT_LANE, speed=80)])
    ),
    "merges_out_of_the_lane_beside": on(
        "on_ramp",
        road(
            [ego(100), one("car", "car", RIGHT_LANE, MERGE, lanes=[3])],
            [("merging_conflict", "car", "ego")],
        ),
    ),
    "leaves_ahead": on("off_ramp", road([ego(120), one("car", "car", AHEAD, EXIT)])),
    "the_ego_leaves": on(
        "off_ramp", road([ego(maneuvers=EXIT), one("car", "car", BEHIND)]), lanes=(3, 3)
    ),
    "leaves_across_the_egos_lane": on(
        "off_ramp",
        road(
            [ego(110), one("car", "car", LEFT_LANE, EXIT, lanes=[2])],
            [("cut_in", "car", "ego")],
            acts=[act("cuts", "car", "change_lane", into="ego")],
        ),
        lanes=(3, 3),
    ),
    "leaves_from_the_innermost_lane": on(
        "off_ramp", road([ego(100), one("car", "car", (), EXIT, lanes=[1])]), lanes=(3, 3)
    ),
    "the_lane_ends": on(
        "lane_drop",
        road([ego(90), one("car", "car", RIGHT_LANE, MERGE)]),
        carriageway="one_way",
        strips=[],
    ),
    "a_ramp_and_oncoming_traffic": on(
        "on_ramp",
        road([ego(80), one("car", "car", RIGHT_LANE, MERGE), one("van", "van", TOWARDS)]),
        carriageway="undivided",
        strips=[],
        lanes=(1, 1),
    ),
}


@pytest.mark.parametrize("name", SITUATIONS)
def test_what_is_said_holds_in_what_is_played(name):
    played = play(SITUATIONS[name])
    assert not played.refused
    assert played.missed == []
    assert played.disagreeing == []
    judged = {claim.id for claim in played.recorded}
    for person in played.functional.participants:
        for maneuver in {"merge", "exit"} & person.maneuvers:
            assert f"maneuver.{maneuver}.{person.id}" in judged


def test_who_merges_gains_the_speed_of_the_traffic_on_the_way():
    concrete, traces = first(SITUATIONS["merges_ahead"])
    speeds = traces["car"].speed_mps * 3.6
    assert speeds[0] == pytest.approx(90.0)
    assert speeds[-1] == pytest.approx(110.0, abs=0.1)
    change = concrete.participant("car").motion.lane_changes[0]
    begins = np.searchsorted(
        traces["car"].s_m, change.position_m - concrete.participant("car").motion.start_m
    )
    assert 80.0 <= speeds[begins] <= 110.0


def test_who_leaves_slows_down_only_in_the_exit_lane():
    concrete, traces = first(SITUATIONS["leaves_ahead"])
    car = concrete.participant("car")
    change = car.motion.lane_changes[0]
    slows = np.argmax(np.diff(traces["car"].speed_mps) < -0.01)
    reached = traces["car"].s_m[slows] + car.motion.start_m
    assert reached >= change.position_m + change.length_m - 1.0
    assert traces["car"].speed_mps[-1] * 3.6 == pytest.approx(90.0, abs=0.1)


def test_nobody_comes_near_anybody_where_no_danger_is_asked_for():
    _, traces = first(SITUATIONS["leaves_ahead"])
    car, own = traces["car"], traces["ego"]
    assert np.hypot(car.x_m - own.x_m, car.y_m - own.y_m).min() > 9.0  # side by side, on the ramp


def test_the_lane_is_as_long_as_a_late_merge_needs():
    late = road(
        [ego(130), one("car", "car", RIGHT_LANE, MERGE, speed=60)],
        [("cut_in", "car", "ego")],
        spacings=[apart("car", "ego", "gap_m", 40.0)],
    )
    concrete, _ = first(on("on_ramp", late))
    change = concrete.participant("car").motion.lane_changes[0]
    lane = concrete.road.auxiliary
    joint = concrete.participant("car").motion.turning_ends_m
    assert change.position_m >= joint
    assert change.position_m + change.length_m <= joint + lane.length_m


@pytest.mark.parametrize(
    ("kind", "people", "told"),
    [
        (None, [ego(), one("car", "car", RIGHT_LANE, MERGE)], "no lane for that"),
        ("off_ramp", [ego(), one("car", "car", RIGHT_LANE, MERGE)], "no lane for that"),
        ("on_ramp", [ego(), one("car", "car", AHEAD, EXIT)], "no lane for that"),
        ("on_ramp", [ego(), one("car", "car", (), [*MERGE, *STRAIGHT])], "must leave it"),
        ("on_ramp", [ego(), one("car", "car", (), MERGE, lanes=[1])], "must leave it"),
    ],
)
def test_a_ramp_that_is_not_there_is_refused(kind, people, told):
    with pytest.raises(InfeasibleError, match=told):
        enumerate_scenarios(on(kind, road(people)))


def test_who_merges_two_lanes_away_is_not_in_line_with_the_ego():
    people = [ego(110, lanes={2}), one("car", "car", [], MERGE)]
    functional = on("on_ramp", road(people), lanes=(3, 3))
    concrete, _ = first(functional)
    assert not missed(functional, concrete)
    assert "order.ego.car" not in {c.id for c in claims_of(functional, concrete.logical)}


def test_who_is_said_to_be_in_the_lane_that_ends_starts_in_it_and_not_on_the_ramp():
    concrete, _ = first(SITUATIONS["merges_out_of_the_lane_beside"])
    car = next(p for p in concrete.participants if p.id == "car").motion
    assert car.start_m > car.turning_ends_m

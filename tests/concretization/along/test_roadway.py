"""Along motorways, one-way streets and bends: lanes, medians, gaps along the lane, comfort."""

from math import sqrt

import numpy as np
import pytest
from roads import AHEAD, CROSS, LEFT_LANE, STRAIGHT, TOWARDS, ego, kmh, one, road
from saying import missed
from told import act, apart, as_soon_as, driven

from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.errors import MotionInfeasibleError
from scegen.motion import simulate
from scegen.motion.paths import build_paths
from scegen.road import build_network
from scegen.road.model import LaneType
from scegen.scenario.junction import Junction


def on(functional, **junction):
    made = Junction(kind="straight", arms=2, **junction)
    return functional.model_copy(update={"junction": made})


def made(functional, index=0):
    logical = enumerate_scenarios(functional).scenarios[index]
    return concretize(functional, logical)


def braking(speed, gap, *more):
    return road(
        [ego(speed), one("lead", "van", AHEAD, speed=speed), *more],
        [("hard_braking", "lead", "ego")],
        acts=[act("slows", "lead", "brake", rate_mps2=6.0)],
        spacings=[apart("ego", "lead", "gap_m", gap, "slows")],
    )


TRIGGERED = {
    "so far before a thing": road(
        [ego(60)],
        acts=[act("s", "ego", "stop", when=as_soon_as("ego", "crate", "gap_m", 35))],
        objects=[{"id": "crate", "kind": "box", "in_way_of": "ego"}],
    ),
    "after so much way": road(
        [ego(60), one("lead", "truck", AHEAD, speed=60)],
        acts=[act("b", "lead", "brake", target_speed_mps=8, when=driven(120))],
    ),
    "off the middle of its own lane": road(
        [ego(50), one("lead", "van", AHEAD, speed=50)],
        spacings=[
            apart("ego", "ego", "lateral_offset_m", -0.4),
            apart("lead", "lead", "lateral_offset_m", 0.3),
        ],
    ),
    "stands for a time": road(
        [ego(50), one("lead", "van", AHEAD, speed=50)],
        acts=[act("w", "lead", "wait", duration_s=4)],
    ),
    "waits, and sets off with a rate": road(
        [ego(50), one("lead", "van", AHEAD, speed=50)],
        acts=[
            act("w", "lead", "wait", duration_s=3),
            act("g", "lead", "set_off", rate_mps2=2, target_speed_mps=8),
        ],
    ),
}


@pytest.mark.parametrize("name", TRIGGERED)
def test_what_sets_acts_off_holds(name):
    functional = TRIGGERED[name]
    told = {
        c
        for c in missed(functional, made(functional))
        if c.startswith(("act.", "speed.", "spacing."))
    }
    assert not told


@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize("radius", [60, 150, 600])
@pytest.mark.parametrize("keeps", ["left", "right"])
def test_a_gap_in_a_bend_is_one_along_the_lane(side, radius, keeps):
    bend = {"side": side, "radius_m": radius}
    functional = on(
        braking(40, 18.0, one("truck", "truck", TOWARDS)), bend=bend, driving_side=keeps
    )
    concrete = made(functional)
    network = build_network(concrete.road)
    paths = build_paths(concrete, network)
    traces = simulate(concrete, paths)
    lead, own = (traces[name] for name in ("lead", "ego"))
    step = int(np.argmax(np.diff(lead.speed_mps) < -0.01))
    rear, front = concrete.participant("lead").body.rear_m, concrete.ego.body.front_m
    apart_m = (
        paths["lead"].s_m[0]
        + concrete.participant("lead").motion.start_m
        + lead.s_m[step]
        - concrete.ego.motion.start_m
        - own.s_m[step]
    )
    assert apart_m - rear - front == pytest.approx(18.0, abs=0.3)
    # And both are in the bend then.
    curved = [np.interp(t.s_m[step], paths[n].s_m, paths[n].heading_rad) for n, t in
              (("lead", lead), ("ego", own))]  # fmt: skip
    begin, end = paths["ego"].heading_rad[0], paths["ego"].heading_rad[-1]
    assert all(min(begin, end) < heading < max(begin, end) for heading in curved)


def test_who_is_said_no_speed_drives_a_bend_in_comfort():
    functional = on(road([ego(), one("car", "car", AHEAD)]), bend={"radius_m": 40})
    concrete = made(functional)
    assert concrete.ego.speed_mps == pytest.approx(sqrt(3.0 * 40), abs=0.01)


def test_what_no_tyre_holds_is_refused():
    functional = on(road([ego(100), one("car", "car", AHEAD)]), bend={"radius_m": 50})
    with pytest.raises(MotionInfeasibleError, match=r"50 m radius needs 15\.4 m/s2 sideways"):
        made(functional)


def test_nobody_overtakes_across_a_median():
    people = [ego(100, maneuvers=["overtake"]), one("truck", "truck", AHEAD, speed=70)]
    narrow = on(road(people), lanes=(1, 1), carriageway="divided")
    with pytest.raises(MotionInfeasibleError, match="across the median"):
        made(narrow)
    assert made(on(road(people), carriageway="divided")).road.arms[0].lanes_in == 2


def test_a_wrong_way_driver_is_beyond_the_median_from_the_start():
    people = [ego(100, lanes=[1]), one("car", "car", TOWARDS, speed=80)]
    functional = on(
        road(people, [("oncoming_lane", "car", "ego")]), lanes=(2, 2), carriageway="divided"
    )
    motion = made(functional).participant("car").motion
    assert (motion.entry_lane, {c.lane_after for c in motion.lane_changes}) == (0, {0})


def test_one_gets_out_of_the_way_of_a_wrong_way_driver():
    people = [ego(100, maneuvers=["lane_change"]), one("car", "car", TOWARDS, speed=90)]
    functional = on(
        road(
            people,
            [("oncoming_lane", "car", "ego")],
            acts=[act("dodges", "ego", "change_lane", side="left")],
            outcome={"kind": "avoided", "between": ["ego", "car"]},
        ),
        lanes=(2, 2),
        carriageway="divided",
    )
    concrete = made(functional)
    assert not missed(functional, concrete)
    assert not concrete.participant("car").motion.lane_changes[1:]


def test_who_is_parked_on_a_motorway_stands_on_its_shoulder():
    people = [ego(100), one("van", "van", AHEAD, maneuvers=["stay"], parked=True)]
    shoulder = {"carriageway": "divided", "strips": ["hard_shoulder"], "lanes": (2, 2)}
    concrete = made(on(road(people), **shoulder))
    network = build_network(concrete.road)
    (span,) = build_paths(concrete, network)["van"].spans
    assert network.road(span.road).lane(span.lane).type is LaneType.SHOULDER


def test_who_crosses_a_motorway_goes_over_the_median():
    walker = one("walker", "pedestrian", ["right"], maneuvers=CROSS)
    functional = on(
        road([ego(80, maneuvers=STRAIGHT), walker], [("crossing_pedestrian", "walker", "ego")]),
        carriageway="divided",
        lanes=(2, 2),
    )
    concrete = made(functional)
    path = build_paths(concrete, build_network(concrete.road))["walker"]
    assert path.length_m > 4 * 3.5 + 5.0


def test_a_cut_in_on_a_one_way_street_in_a_bend():
    people = [
        ego(50, lanes=[2]),
        one("car", "car", LEFT_LANE, maneuvers=["lane_change"], speed=45),
    ]
    functional = on(
        road(
            people,
            [("cut_in", "car", "ego")],
            acts=[act("moves", "car", "change_lane", into="ego")],
            spacings=[apart("ego", "car", "gap_m", 12.0, "moves")],
        ),
        lanes=(2, 2),
        carriageway="one_way",
        bend={"side": "right", "radius_m": 150},
    )
    concrete = made(functional)
    assert concrete.participant("car").speed_mps == pytest.approx(kmh(45), abs=0.01)
    assert {p.motion.entry for p in concrete.participants} == {0}


@pytest.mark.parametrize(
    "bend", [None, {"side": "left", "radius_m": 60}, {"side": "right", "radius_m": 60}]
)
@pytest.mark.parametrize("side", ["left", "right"])
def test_who_crosses_a_road_with_a_crosswalk_does_so_on_it(bend, side):
    walkers = [one(f"w{n}", "pedestrian", [side], CROSS) for n in range(3)]
    hazards = [("crossing_pedestrian", w["id"], "ego") for w in walkers]
    functional = on(road([ego(40), *walkers], hazards), crosswalks={0}, bend=bend)
    concrete = made(functional)
    on_it = {f"maneuver.crosswalk.w{n}" for n in range(3)}
    assert not on_it & missed(functional, concrete)
    aside = concrete.participants[1].motion.model_copy(update={"from_junction_m": 5.5})
    moved = concrete.participants[1].model_copy(update={"motion": aside})
    people = (concrete.participants[0], moved, *concrete.participants[2:])
    wrong = concrete.model_copy(update={"participants": people})
    assert on_it & missed(functional, wrong) == {f"maneuver.crosswalk.{moved.id}"}


def test_nobody_starts_beyond_a_crosswalk_whose_arm_ends_there():
    lead = one("lead", "van", AHEAD, speed=20)
    walker = one("w", "pedestrian", ["right"], CROSS)
    functional = on(
        road(
            [ego(60), lead, walker],
            [("crossing_pedestrian", "w", "ego")],
            spacings=[apart("ego", "w", "gap_m", 60.0), apart("ego", "lead", "gap_m", 90.0)],
        ),
        crosswalks={0},
    )
    with pytest.raises(MotionInfeasibleError, match="crosswalk"):
        made(functional)


def test_who_stops_for_somebody_on_a_crosswalk_does_so_before_it():
    walker = one("w", "pedestrian", ["right"], CROSS)
    functional = on(
        road(
            [ego(50), walker],
            [("crossing_pedestrian", "w", "ego")],
            acts=[act("waits", "ego", "wait", into="w")],
        ),
        crosswalks={0},
    )
    concrete = made(functional)
    paths = build_paths(concrete, build_network(concrete.road))
    trace = simulate(concrete, paths, dt_s=0.05)["ego"]
    rests = int(np.argmax(trace.speed_mps < 0.01))
    walked = paths["w"]
    front = np.array([trace.x_m[rests], trace.y_m[rests]])
    away = np.hypot(*(front - [walked.x_m[0], walked.y_m[0]]))
    body = concrete.ego.body
    aside = abs(walked.y_m[0] - trace.y_m[rests])
    assert np.sqrt(away**2 - aside**2) - body.front_m >= 2.0

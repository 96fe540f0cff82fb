from __future__ import annotations

from importlib import import_module
from itertools import combinations
from math import cos, sin

import numpy as np
import pytest
from shapely.geometry import Polygon

from scegen.concretization import concretize
from scegen.motion import build_paths, simulate
from scegen.motion.model import Path, Trace
from scegen.road import build_network
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import ConcreteScenario, DriveMotion, Travelled
from scegen.scenario.parameters import ParameterRange
from scegen.scenario.vocabulary import HazardKind, JunctionKind, Side

LIMIT_MPS = 50 / 3.6


def run(concrete: ConcreteScenario) -> tuple[dict[str, Path], dict[str, Trace]]:
    network = build_network(concrete.road)
    paths = build_paths(concrete, network)
    return paths, simulate(concrete, paths)


def footprint(x: float, y: float, heading: float, body: Body) -> Polygon:
    c, s = cos(heading), sin(heading)
    x, y = x + c * body.centre_ahead_m, y + s * body.centre_ahead_m
    half, side = body.length_m / 2, body.width_m / 2
    corners = ((half, side), (half, -side), (-half, -side), (-half, side))
    return Polygon([(x + c * a - s * b, y + s * a + c * b) for a, b in corners])


def gap_m(traces, first, second) -> float:
    """Least distance between two bodies."""
    a, b = traces[first], traces[second]
    near = np.flatnonzero(np.hypot(a.x_m - b.x_m, a.y_m - b.y_m) < 30)
    return min(
        (
            footprint(a.x_m[i], a.y_m[i], a.heading_rad[i], a.body).distance(
                footprint(b.x_m[i], b.y_m[i], b.heading_rad[i], b.body)
            )
            for i in near
        ),
        default=float("inf"),
    )


def test_nobody_overlaps_at_the_start(made):
    concrete = concretize(*made)
    paths, _ = run(concrete)
    boxes = {
        p.id: footprint(
            paths[p.id].start.x_m,
            paths[p.id].start.y_m,
            paths[p.id].start.heading_rad,
            p.body,
        )
        for p in concrete.participants
    }
    for a, b in combinations(boxes, 2):
        assert not boxes[a].intersects(boxes[b]), (a, b)


def test_everybody_enters_and_leaves_by_its_arms(made):
    functional, logical = made
    concrete = concretize(functional, logical)
    network = build_network(concrete.road)
    paths, traces = run(concrete)
    for drive in logical.drives:
        path, trace = paths[drive.participant], traces[drive.participant]
        span = path.spans[0]
        assert span.road == network.arm_roads[drive.entry]
        exits = [s for s in path.spans if s.road == network.arm_roads[drive.exit]]
        assert exits, "its way leads out by its arm"
        if concrete.road.kind is JunctionKind.STRAIGHT:
            continue  # it ends after its climax, wherever everybody is
        assert trace.s_m[-1] > exits[-1].start_m
        assert trace.speed_mps[-1] > 0, "drives on where the scenario ends"
    assert concrete.duration_s <= 60.0


def test_the_same_seed_gives_the_same_numbers_and_another_seed_others(made):
    functional, logical = made
    assert concretize(functional, logical, seed=5) == concretize(functional, logical, seed=5)
    others = {concretize(functional, logical, seed=s).model_dump_json() for s in range(3)}
    assert len(others) == 3


def test_lateral_acceleration_stays_possible(made):
    concrete = concretize(*made)
    paths, traces = run(concrete)
    for participant in concrete.participants:
        if not isinstance(participant.motion, DriveMotion):
            continue
        path, trace = paths[participant.id], traces[participant.id]
        step = np.diff(path.s_m)
        curvature = np.diff(path.heading_rad) / step
        places = (path.s_m[1:] + path.s_m[:-1]) / 2
        speed = np.interp(places, trace.s_m, trace.speed_mps)
        reached = places < trace.s_m[-1]
        worst = float(np.max(np.abs(curvature) * speed**2 * reached))
        assert worst <= 6.5, (participant.id, worst)


@pytest.mark.parametrize(
    ("name", "first", "second", "closest_m"),
    [
        ("four_way_left_turn", "ego", "car_1", 2.0),
        ("t_merge_occluded", "ego", "car_1", 2.0),
        ("ring_cut_in", "ego", "car_1", 5.0),
        ("skewed_overtaking", "car_1", "car_2", 2.0),
        ("tailgated_at_crosswalk", "ego", "car_1", 5.0),
        ("walker_from_behind_parked", "ego", "ped_0", 1.2),
        ("left_hand", "ego", "car_1", 5.0),
    ],
)
def test_those_in_conflict_come_together(cases, name, first, second, closest_m):
    _, traces = run(concretize(*cases[name]))
    assert gap_m(traces, first, second) < closest_m


def test_those_without_a_part_in_the_danger_touch_nobody(cases):
    _, traces = run(concretize(*cases["four_way_left_turn"]))
    for a, b in combinations(sorted(traces), 2):
        if {a, b} != {"ego", "car_1"}:
            assert gap_m(traces, a, b) > 0.1, (a, b)


def test_ten_cars_queue_without_driving_into_each_other(cases):
    functional, logical = cases["ten_at_t"]
    concrete = concretize(functional, logical)
    _, traces = run(concrete)
    for a, b in combinations(logical.drives, 2):
        if a.entry == b.entry:
            assert gap_m(traces, a.participant, b.participant) > 1.0


@pytest.mark.parametrize("case", ["ten_at_t", "four_way_left_turn"])
def test_a_road_longer_than_needed_lets_nobody_start_farther_out(cases, case, monkeypatch):
    # Starts are looked for in steps of half a second, so a little may change.
    farthest = {}
    for length in (900, 1500):
        module = import_module("scegen.concretization.concretize")
        monkeypatch.setattr(module, "first_arm_m", lambda _, m=length: m)
        people = concretize(*cases[case]).participants
        farthest[length] = max(p.motion.turning_starts_m - p.motion.start_m for p in people)
    assert farthest[1500] < farthest[900] + 60.0, farthest


def test_who_speeds_is_clearly_above_the_limit(cases):
    concrete = concretize(*cases["skewed_overtaking"])
    factor = concrete.participant("car_2").speed_mps / LIMIT_MPS
    assert 1.2 <= factor <= 1.5


def test_who_tailgates_follows_at_less_than_a_second(cases):
    concrete = concretize(*cases["tailgated_at_crosswalk"])
    ego, lead = concrete.ego, concrete.participant("car_1")
    body = ego.body
    gap = lead.motion.start_m - body.rear_m - ego.motion.start_m - body.front_m
    assert 0.35 <= gap / ego.speed_mps <= 0.85
    brakes = [p for p in lead.speed_program if p.hazard is HazardKind.HARD_BRAKING]
    assert len(brakes) == 1
    assert 7.0 <= brakes[0].rate_mps2 <= 8.0


def test_the_leader_stops_for_the_walker_and_goes_on(cases):
    concrete = concretize(*cases["tailgated_at_crosswalk"])
    _, traces = run(concrete)
    lead = traces["car_1"]
    assert lead.speed_mps.min() == 0.0
    assert lead.speed_mps[-1] > 5.0
    assert gap_m(traces, "car_1", "ped_0") > 0.3


def test_the_walker_is_hidden_and_stops_in_the_way(cases):
    concrete = concretize(*cases["walker_from_behind_parked"])
    ped, parked = concrete.participant("ped_0"), concrete.participant("parked_0")
    assert isinstance(ped.speed_program[0].trigger, Travelled)
    assert ped.speed_program[0].trigger.participant == "ego"
    assert ped.motion.stops_after_m is not None
    front = parked.motion.from_junction_m - parked.body.front_m
    assert 0.5 < front - ped.motion.from_junction_m < 2.5
    _, traces = run(concrete)
    assert traces["ped_0"].speed_mps[-1] == 0.0
    assert gap_m(traces, "ego", "parked_0") > 0.3


def test_who_cuts_in_changes_ring_lanes_just_ahead(cases):
    concrete = concretize(*cases["ring_cut_in"])
    cutter = concrete.participant("car_1")
    assert cutter.motion.ring_lane == 1
    assert [c.lane_after for c in cutter.motion.lane_changes] == [2]
    assert cutter.motion.lane_changes[0].hazard is HazardKind.CUT_IN


@pytest.mark.parametrize(("side", "lane"), [(Side.LEFT, 1), (Side.RIGHT, 2)])
def test_in_a_ring_one_changes_to_the_side_it_is_to(cases, side, lane):
    """Into the lane of whom it cuts in on, also where that one leaves the ring before it."""
    functional, logical = cases["ring_cut_in"]
    moves = {"car_1": {"changes_to": side, "exit": 3, "move": 3}}
    drives = [d.model_copy(update=moves.get(d.participant, {})) for d in logical.assignments]
    concrete = concretize(functional, logical.model_copy(update={"assignments": tuple(drives)}))
    cutter, other = concrete.participant("car_1").motion, concrete.ego.motion
    assert [c.lane_after for c in cutter.lane_changes] == [lane]
    assert cutter.ring_lane != lane == other.ring_lane
    _, traces = run(concrete)
    assert gap_m(traces, "car_1", "ego") < 8.0


def test_who_goes_round_a_blocked_lane_does_not_touch_it(cases):
    concrete = concretize(*cases["blocked_lane"])
    assert [c.lane_after for c in concrete.ego.motion.lane_changes] == [0, 1]
    _, traces = run(concrete)
    assert 0.3 < gap_m(traces, "ego", "parked_0") < 0.8


def test_an_overtaker_ends_in_front(cases):
    concrete = concretize(*cases["skewed_overtaking"])
    fast, slow = concrete.participant("car_2"), concrete.participant("car_1")
    assert fast.motion.start_m < slow.motion.start_m
    _, traces = run(concrete)
    lead = traces["car_2"].s_m[-1] + fast.motion.start_m
    assert lead > traces["car_1"].s_m[-1] + slow.motion.start_m


def test_turning_positions_are_those_of_the_road(made):
    concrete = concretize(*made)
    for participant in concrete.participants:
        motion = participant.motion
        if isinstance(motion, DriveMotion):
            assert motion.start_m < motion.turning_starts_m <= motion.turning_ends_m


def test_a_road_with_one_lane_by_the_text_is_overtaken_on_through_the_oncoming_lane(scenario):
    drives = [
        {"entry": 0, "move": 1, "rank": 1, "maneuver": "overtake"},
        {"entry": 0, "move": 1},
    ]
    made = scenario("straight", 2, drives, [], lanes=(1, 1))
    concrete = concretize(*made)
    assert concrete.road.arms[0].lanes_in == 1
    assert [c.lane_after for c in concrete.ego.motion.lane_changes] == [0, 1]


def test_provenance_names_every_speed(made):
    concrete = concretize(*made)
    named = {change.parameter for change in concrete.provenance}
    for participant in concrete.participants:
        if not participant.parked:
            assert f"{participant.id}.speed_mps" in named


LAYOUTS = {
    "level": ("straight", 2, [{"entry": 0, "move": 1}, {"entry": 0, "move": 1, "beside": "ego"}]),
    "opposed": ("straight", 2, [{"entry": 0, "move": 1}, {"entry": 1, "move": 1}]),
    "behind": ("t", 3, [{"entry": 0, "move": 1}, {"entry": 0, "move": 1, "rank": 1}]),
    "ahead": ("y", 3, [{"entry": 0, "move": 1, "rank": 1}, {"entry": 0, "move": 1}]),
    "crossing": ("four_way", 4, [{"entry": 0, "move": 2}, {"entry": 1, "move": 2}]),
    "ring": ("roundabout", 5, [{"entry": 1, "move": 2}, {"entry": 0, "move": 2}]),
}


@pytest.mark.parametrize("layout", sorted(LAYOUTS))
@pytest.mark.parametrize("kind", [k for k in HazardKind if k is not HazardKind.REVERSING])
def test_every_danger_but_reversing_can_be_made_everywhere(scenario, kind, layout):
    shape, arms, drives = LAYOUTS[layout]
    concrete = concretize(*scenario(shape, arms, drives, [(kind.value, ["car_1"], ["ego"])]))
    _, traces = run(concrete)
    for participant in concrete.participants:
        speeds = traces[participant.id].speed_mps
        limits = participant.body
        change = np.diff(speeds)
        assert speeds.max() <= limits.top_speed_mps
        assert change.max(initial=0.0) <= 0.05 * limits.max_acceleration_mps2 + 1e-6
        assert change.min(initial=0.0) >= -0.05 * limits.max_deceleration_mps2 - 1e-6


def test_sudden_acceleration_raises_the_speed_at_three_or_more(scenario):
    drives = [{"entry": 0, "move": 2}, {"entry": 1, "move": 2}]
    made = scenario("four_way", 4, drives, [("sudden_acceleration", ["car_1"], ["ego"])])
    concrete = concretize(*made)
    car = concrete.participant("car_1")
    phase = next(p for p in car.speed_program if p.hazard is HazardKind.SUDDEN_ACCELERATION)
    assert phase.target_speed_mps > 1.5 * car.speed_mps
    assert 3.0 <= phase.rate_mps2 <= 4.0


def test_a_sudden_turn_without_a_bend_leaves_the_lane_and_comes_back(scenario):
    shape, arms, drives = LAYOUTS["opposed"]
    made = scenario(shape, arms, drives, [("sudden_turn", ["car_1"], ["ego"])])
    car = concretize(*made).participant("car_1")
    out, back = car.motion.lane_changes
    assert (out.hazard, back.hazard) == (HazardKind.SUDDEN_TURN, HazardKind.SUDDEN_TURN)
    assert out.lane_after != car.motion.entry_lane == back.lane_after
    # At a junction where it turns, the bend itself is the sudden turn.
    turns = [{"entry": 0, "move": 2}, {"entry": 2, "move": 3}]
    bend = concretize(*scenario("four_way", 4, turns, [("sudden_turn", ["car_1"], ["ego"])]))
    assert bend.participant("car_1").motion.lane_changes == ()


def test_who_drives_slowly_holds_up_the_ego(scenario):
    drives = [{"entry": 0, "move": 2, "rank": 1}, {"entry": 0, "move": 2}]
    concrete = concretize(*scenario("four_way", 4, drives, [("slow_driving", ["car_1"], ["ego"])]))
    _, traces = run(concrete)
    assert concrete.participant("car_1").speed_mps <= 0.5 * LIMIT_MPS
    assert 0.5 < gap_m(traces, "ego", "car_1") < 10.0


def test_on_a_plain_road_one_merges_from_the_lane_beside(scenario):
    drives = [{"entry": 0, "move": 1}, {"entry": 0, "move": 1, "beside": "ego"}]
    concrete = concretize(
        *scenario("straight", 2, drives, [("merging_conflict", ["car_1"], ["ego"])])
    )
    (change,) = concrete.participant("car_1").motion.lane_changes
    assert change.lane_after == concrete.ego.motion.entry_lane
    assert concrete.participant("car_1").motion.entry_lane != change.lane_after


def test_those_who_cross_together_walk_abreast(scenario):
    walks = [(0, "right"), (0, "right"), (0, "right"), (0, "left")]
    concrete = concretize(*scenario("four_way", 4, [{"entry": 0, "move": 2}], crossings=walks))
    places = [concrete.participant(f"ped_{n}").motion.from_junction_m for n in range(4)]
    first, second, third, from_the_left = places
    assert sorted(round(p - first, 3) for p in (second, third)) == [-0.9, 0.9]
    assert from_the_left == first


def test_one_who_is_said_to_ride_slower_than_usual_does(scenario):
    functional, logical = scenario("straight", 2, [{"entry": 0, "move": 1}], (), [(0, "right")])
    slow = ParameterRange(name="ped_0.speed_mps", low=0.8, high=0.8, default=0.8, reason="stated")
    concrete = concretize(functional, logical.model_copy(update={"parameters": (slow,)}))
    assert concrete.participant("ped_0").speed_program[0].target_speed_mps == 0.8

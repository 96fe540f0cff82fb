"""Every predicate says yes where the danger is, no where it is not, and its margin the sign."""

import numpy as np
import pytest
from criticality_scenarios import participant
from hazard_views import DT_S, line, steady, view, way

from scegen.claims.hazards.judging import decisive, judge
from scegen.claims.hazards.table import PREDICATES
from scegen.motion.model import Path
from scegen.scenario.concrete import AtTime, CrossingMotion, SpeedPhase
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind

EGO, OTHER = participant("ego"), participant("other")


def happens(kind, made, by=("other",), to=("ego",)):
    hazard = Hazard(kind=HazardKind(kind), by=by, to=to)
    proof = judge(made, hazard)
    assert proof.happened == (decisive(made, hazard)[0][0] >= 0.0)
    if proof.margin is not None:
        assert (proof.margin >= 0.0) == proof.happened
    assert all(part.happened for part in proof.parts) == proof.happened
    return proof


def following(follower, leader, gap_m=20.0):
    """The ego follows the other on one lane; ``gap_m`` between the reference points."""
    return view((EGO, OTHER), (line(0, 0, 0), line(gap_m, 0, 0)), (follower, leader))


def crossing(arrives_s, speed=10.0, kind="car"):
    """The ego goes east, the other north; the other is at the crossing later by ``arrives_s``."""
    other = participant("other", kind)
    start = -50.0 - speed * arrives_s
    return view((EGO, other), (line(-50, 0, 0), line(0, start, 90)), (steady(speed), steady(speed)))


def ramp(first, last, rate, seconds=10.0, begins_s=2.0):
    time = np.arange(round(seconds / DT_S) + 1) * DT_S
    change = np.sign(last - first) * rate * np.maximum(0.0, time - begins_s)
    return np.clip(first + change, min(first, last), max(first, last))


def test_every_kind_has_a_predicate():
    assert set(PREDICATES) == set(HazardKind)


def backing(back_m, gap_m=20.0, aside_m=0.0, ego=0.0):
    """The other stands ahead of the ego and then goes straight back at 2 m/s."""
    x = np.array([gap_m, gap_m + 1.0, gap_m + 1.0 - max(back_m, 0.5)])
    s = np.concatenate(([0.0], np.cumsum(np.abs(np.diff(x)))))
    path = Path(s, x, np.full(3, aside_m), np.zeros(3), ())
    speeds = np.zeros(201)
    speeds[40 : 40 + round((1.0 + back_m) / 2.0 / DT_S)] = 2.0
    return view((EGO, OTHER), (line(0, 0, 0), path), (steady(ego), speeds))


@pytest.mark.parametrize(
    ("back_m", "gap_m", "expected"), [(12.0, 20.0, True), (1.0, 8.0, False), (3.0, 30.0, False)]
)
def test_reversing_is_going_back_towards_another_until_near(back_m, gap_m, expected):
    proof = happens("reversing", backing(back_m, gap_m))
    assert proof.happened is expected
    assert proof.parts[0].value == pytest.approx(back_m, abs=0.2)


def test_going_back_behind_one_that_has_passed_or_far_beside_it_is_none():
    assert not happens("reversing", backing(12.0, gap_m=-30.0)).happened
    assert not happens("reversing", backing(6.0, gap_m=12.0, aside_m=9.0)).happened


def test_one_that_stands_is_backed_into():
    forwards, back = Path(np.array([0.0]), np.array([-6.0]), np.zeros(1), np.zeros(1), ()), 4.0
    x = np.array([0.0, 0.5, 0.5 - back])
    path = Path(np.array([0.0, 0.5, 0.5 + back]), x, np.zeros(3), np.zeros(3), ())
    speeds = np.full(201, 1.0)
    scene = view((EGO, OTHER), (forwards, path), (steady(0), speeds))
    assert happens("reversing", scene).happened


def test_who_only_drives_forwards_does_not_reverse():
    proof = happens("reversing", following(steady(12), steady(10)))
    assert not proof.happened
    assert proof.parts[0].value == 0.0


@pytest.mark.parametrize(("speed", "expected"), [(16.0, True), (14.5, False)])
def test_speeding_is_a_tenth_above_the_limit(speed, expected):
    proof = happens("speeding", following(steady(10), steady(speed)))
    assert proof.happened is expected
    assert proof.margin == pytest.approx(speed - 1.1 * 14.0)


@pytest.mark.parametrize(("speed", "expected"), [(6.0, True), (12.0, False)])
def test_slow_driving(speed, expected):
    assert happens("slow_driving", following(steady(10), steady(speed))).happened is expected


def test_somebody_who_stands_does_not_drive_slowly():
    assert not happens("slow_driving", following(steady(0), steady(0))).happened


@pytest.mark.parametrize(
    ("rate", "expected"), [(7.0, True), (5.0 - 1e-12, True), (4.99, False), (3.0, False)]
)
def test_hard_braking(rate, expected):
    proof = happens("hard_braking", following(steady(5), ramp(14, 0, rate)))
    assert proof.happened is expected
    assert proof.margin == pytest.approx(rate - 5.0, abs=0.01)


def test_a_slippery_road_lowers_what_counts_as_hard():
    people, paths = (EGO, OTHER), (line(0, 0, 0), line(40, 0, 0))
    speeds = (steady(5), ramp(10, 0, 1.8))
    assert not happens("hard_braking", view(people, paths, speeds)).happened
    assert happens("hard_braking", view(people, paths, speeds, friction=0.2)).happened


@pytest.mark.parametrize(("rate", "expected"), [(3.5, True), (2.0, False)])
def test_sudden_acceleration(rate, expected):
    made = following(steady(5), ramp(5, 14, rate))
    assert happens("sudden_acceleration", made).happened is expected


def test_stopping_needs_a_second_of_standstill_after_moving():
    brakes = ramp(10, 0, 5.0, begins_s=2.0)
    assert happens("stopping", following(steady(5), brakes)).happened
    short = np.where(np.arange(len(brakes)) * DT_S > 4.6, 5.0, brakes)
    assert not happens("stopping", following(steady(5), short)).happened
    # Who stands in the lane from the start blocks it.
    assert happens("stopping", following(steady(5), steady(0))).happened


@pytest.mark.parametrize(("gap_m", "expected"), [(10.0, True), (25.0, False)])
def test_tailgating(gap_m, expected):
    """At 10 m/s; bodies take 4.79 m of the distance between the reference points."""
    made = following(steady(10), steady(10), gap_m)
    proof = happens("tailgating", made, by=("ego",), to=("other",))
    assert proof.happened is expected
    assert proof.margin == pytest.approx(0.8 - (gap_m - 4.79) / 10, abs=0.01)


def test_the_leader_does_not_tailgate():
    made = following(steady(10), steady(10), 10.0)
    assert not happens("tailgating", made, by=("other",), to=("ego",)).happened


@pytest.mark.parametrize("kind", ["merging_conflict", "cut_in"])
@pytest.mark.parametrize(("arrives_s", "expected"), [(1.0, True), (5.0, False)])
def test_conflicts_are_a_matter_of_time(kind, arrives_s, expected):
    assert happens(kind, crossing(arrives_s)).happened is expected


@pytest.mark.parametrize(
    "kind", ["unprotected_left_turn", "crossing_pedestrian", "crossing_cyclist"]
)
def test_who_comes_as_soon_as_the_other_has_left_endangers_nobody(kind):
    assert not happens(kind, crossing(1.0)).happened
    assert happens(kind, crossing(1.0), by=("ego",), to=("other",)).happened


def test_the_margin_of_a_conflict_falls_as_time_grows():
    margins = [happens("merging_conflict", crossing(t)).margin for t in (1.0, 1.5, 2.0, 3.0)]
    assert margins == sorted(margins, reverse=True)
    assert margins[0] > 0 > margins[-1]


def test_running_a_light_means_not_stopping():
    ways = {"other": way(OTHER, line(0, -60, 90), turn=(50.0, 70.0))}
    paths = (line(-50, 0, 0), line(0, -60, 90))
    on = view((EGO, OTHER), paths, (steady(10), steady(10)), **ways)
    assert happens("red_light_running", on).happened
    stops = np.concatenate([ramp(10, 0.0, 4.0, 6.4, 3.0), steady(10, 4)])
    off = view((EGO, OTHER), paths, (steady(8.0, 10.45)[: len(stops)], stops), **ways)
    assert not happens("red_light_running", off).happened


def test_who_stops_where_the_ways_cross_has_run_the_light():
    """A bus that stalls in the middle came in without a stop."""
    ways = {"other": way(OTHER, line(0, -60, 90), turn=(50.0, 80.0))}
    paths = (line(-50, 0, 0), line(0, -60, 90))
    stalls = ramp(10, 0.0, 8.0, begins_s=5.5)  # 61 m on: across the ego's way
    made = view((EGO, OTHER), paths, (steady(8), stalls), **ways)
    assert happens("red_light_running", made).happened


CROSSES = CrossingMotion(arm=0, start_side="right", from_junction_m=0.0, setback_m=1.5)


@pytest.mark.parametrize(("halts_at_m", "expected"), [(None, True), (7.0, False)])
def test_a_cyclist_who_waits_at_the_kerb_and_then_rides_on_does_not_yield(halts_at_m, expected):
    """It stands before it sets out; what counts is whether it stops before the ego's way."""
    sets_out = SpeedPhase(trigger=AtTime(time_s=2.0), target_speed_mps=4.0, rate_mps2=20.0)
    rider = participant("other", "bicycle", program=[sets_out])
    rider = rider.model_copy(update={"motion": CROSSES})
    speed = ramp(0, 4.0, 20.0, begins_s=2.0)
    if halts_at_m is not None:
        speed = np.where(np.cumsum(speed) * DT_S > halts_at_m, 0.0, speed)
    path = line(0, -10, 90, 20.0)
    made = view((EGO, rider), (line(-50, 0, 0), path), (steady(10.0), speed))
    assert happens("failure_to_yield", made).happened is expected


def test_speeding_of_who_cannot_reach_the_limit():
    """A bicycle is fast above the 25 km/h up to which a pedelec helps, by a tenth."""
    rider = participant("other", "bicycle")
    for speed, expected in ((7.8, True), (7.5, False)):
        made = view((EGO, rider), (line(0, 0, 0), line(20, 0, 0)), (steady(5), steady(speed)))
        assert happens("speeding", made, to=()).happened is expected


@pytest.mark.parametrize(("brakes_at_s", "expected"), [(3.6, True), (0.5, False)])
def test_delayed_braking_is_late_and_hard(brakes_at_s, expected):
    """50 m at 10 m/s; braking at 7 m/s2 needs 7 m, comfort 20 m."""
    speeds = (ramp(10, 0, 7.0, begins_s=brakes_at_s), steady(10))
    made = view((EGO, OTHER), (line(-50, 0, 0), line(0, -60, 90)), speeds)
    assert happens("delayed_braking", made, by=("ego",), to=("other",)).happened is expected


def changing(length_m, speed=10.0, gap_m=12.0, lane=1):
    """The other moves into the ego's lane, ``gap_m`` ahead; its path bends over by 3.5 m."""
    s = np.arange(0.0, 200.0, 0.5)
    begin = 40.0
    share = np.clip((s - begin) / length_m, 0.0, 1.0)
    y = 3.5 * (1 + np.cos(np.pi * share)) / 2
    heading = np.arctan2(np.gradient(y, s), 1.0)
    path = type(line(0, 0, 0))(s, gap_m + s, y, heading, ())
    ways = {"other": way(OTHER, path, changes=((begin, begin + length_m, 3.5, lane),))}
    return view((EGO, OTHER), (line(0, 0, 0), path), (steady(speed), steady(speed)), **ways)


@pytest.mark.parametrize(
    ("length_m", "gap_m", "expected"), [(20, 12, True), (60, 12, False), (20, 40, False)]
)
def test_cut_in_is_quick_and_close(length_m, gap_m, expected):
    assert happens("cut_in", changing(length_m, gap_m=gap_m)).happened is expected


@pytest.mark.parametrize(("gap_m", "expected"), [(12, True), (0, True), (-12, False)])
@pytest.mark.parametrize("kind", ["cut_in", "merging_conflict"])
def test_who_comes_in_does_so_ahead(kind, gap_m, expected):
    """However close behind it comes in, that endangers nobody; two that touch are level."""
    part = happens(kind, changing(20, gap_m=gap_m)).parts[-1]
    assert (part.name, part.happened) == ("front ahead as it comes in", expected)


@pytest.mark.parametrize("kind", ["hard_braking", "stopping", "slow_driving"])
@pytest.mark.parametrize(("gap_m", "expected"), [(30.0, True), (-90.0, False)])
def test_who_slows_down_behind_another_does_not_endanger_it(kind, gap_m, expected):
    speeds = steady(5) if kind == "slow_driving" else ramp(10, 0, 7.0)
    assert happens(kind, following(steady(10), speeds, gap_m)).happened is expected


@pytest.mark.parametrize(("starts_m", "expected"), [(150.0, True), (60.0, False)])
def test_who_goes_over_the_line_behind_one_that_has_passed_does_not_endanger_it(starts_m, expected):
    paths = (line(starts_m, 0, 180), line(0, 3.5, 0))
    crosses = way(OTHER, paths[1], changes=((50.0, 70.0, 3.5, 0),))
    made = view((EGO, OTHER), paths, (steady(10), steady(10)), other=crosses)
    assert happens("oncoming_lane", made).happened is expected


@pytest.mark.parametrize(("length_m", "expected"), [(20, True), (60, False)])
def test_swerving_is_quick(length_m, expected):
    assert happens("swerving", changing(length_m)).happened is expected


@pytest.mark.parametrize(("lane", "expected"), [(0, True), (1, False)])
def test_oncoming_lane(lane, expected):
    assert happens("oncoming_lane", changing(20, lane=lane)).happened is expected


@pytest.mark.parametrize(("speed", "expected"), [(15.0, True), (9.0, False)])
def test_overtaking_goes_from_behind_to_ahead(speed, expected):
    paths = (line(30, 0, 0), line(0, 3.5, 0))
    made = view((EGO, OTHER), paths, (steady(8), steady(speed)))
    assert happens("overtaking", made).happened is expected


def test_all_who_are_named_must_do_it():
    made = following(steady(16), steady(10))
    assert happens("speeding", made, by=("ego",), to=()).happened
    assert not happens("speeding", made, by=("ego", "other"), to=()).happened


def test_an_obstacle_endangers_who_passes_close():
    near = view((EGO, OTHER), (line(0, 0, 0), line(60, 3.0, 0)), (steady(10), steady(0)))
    far = view((EGO, OTHER), (line(0, 0, 0), line(60, 8.0, 0)), (steady(10), steady(0)))
    assert happens("obstacle", near).happened
    assert not happens("obstacle", far).happened


@pytest.mark.parametrize(("aside_m", "expected"), [(0.0, True), (8.0, False)])
def test_an_obstacle_endangers_who_comes_to_rest_before_it(aside_m, expected):
    halts = ramp(10, 0, 5.0)
    made = view((EGO, OTHER), (line(0, 0, 0), line(60, aside_m, 0)), (halts, 0.0 * halts))
    assert happens("obstacle", made).happened is expected

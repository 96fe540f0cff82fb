"""Driving backwards: paths with the body turned round, and the dangers made of them."""

import numpy as np
import pytest

from scegen.concretization import concretize
from scegen.errors import MotionInfeasibleError
from scegen.motion import build_paths, simulate
from scegen.motion.batch import compile_program, simulate_batch, stack_traces
from scegen.motion.paths import lay_drive
from scegen.road import build_network
from scegen.scenario.concrete import ArrivalBelow, DriveMotion
from scegen.scenario.logical import Reverses
from scegen.scenario.reversing import BacksOut, BacksUp
from scegen.scenario.vocabulary import HazardKind

AHEAD = [{"entry": 0, "move": 1, "rank": 1}, {"entry": 0, "move": 1}]
REVERSING = [("reversing", ["car_1"], ["ego"])]


def reversing(how):
    return [AHEAD[0], {**AHEAD[1], "reverses": how}]


FORMS = {
    "ahead": ("straight", 2, reversing(Reverses.BACKS_UP)),
    "right": ("straight", 2, reversing(Reverses.FROM_RIGHT)),
    "left": ("straight", 2, reversing(Reverses.FROM_LEFT)),
    "crossing": ("four_way", 4, [{"entry": 0, "move": 2}, {"entry": 1, "move": 2}]),
    "arm": (
        "t",
        3,
        [{"entry": 0, "move": 1}, {"entry": 2, "move": 2, "reverses": Reverses.OUT_OF_ARM}],
    ),
    "ring": ("roundabout", 4, [{"entry": 1, "move": 2}, {"entry": 0, "move": 2}]),
}


def played(concrete, dt_s=0.05):
    network = build_network(concrete.road)
    paths = build_paths(concrete, network)
    return network, paths, simulate(concrete, paths, dt_s=dt_s)


@pytest.fixture(params=sorted(FORMS))
def made(request, scenario):
    shape, arms, drives = FORMS[request.param]
    return scenario(shape, arms, drives, REVERSING)


def test_a_body_goes_against_its_heading_once_and_leaves_forwards(made):
    concrete = concretize(*made)
    _, paths, traces = played(concrete)
    path, trace = paths["car_1"], traces["car_1"]
    ((begins, ends),) = path.backwards
    assert ends - begins > 2.0
    assert not paths["ego"].backwards
    moved = np.diff(trace.x_m) * np.cos(trace.heading_rad[1:])
    moved += np.diff(trace.y_m) * np.sin(trace.heading_rad[1:])
    inside = (trace.s_m[1:] <= ends) & (trace.s_m[:-1] >= begins)
    assert (moved[inside] <= 1e-9).all()
    assert moved[~inside & (np.abs(np.diff(trace.s_m)) > 0.02)].min() > 0.0
    assert trace.s_m[-1] > ends + 10.0


def test_headings_never_jump_and_positions_along_the_path_grow(made):
    _, paths, _ = played(concretize(*made))
    path = paths["car_1"]
    assert (np.diff(path.s_m) > 0.0).all()
    assert np.abs(np.diff(path.heading_rad)).max() < 0.1
    steps = np.hypot(np.diff(path.x_m), np.diff(path.y_m))
    np.testing.assert_allclose(np.diff(path.s_m), steps, atol=1e-9)


@pytest.mark.parametrize("dt_s", [0.05, 0.01])
def test_it_stands_where_it_changes_direction(made, dt_s):
    _, paths, traces = played(concretize(*made), dt_s)
    trace = traces["car_1"]
    for place in paths["car_1"].backwards[0]:
        rest = trace.s_m[(trace.speed_mps == 0.0) & (np.abs(trace.s_m - place) < 0.1)]
        assert rest.size
        assert np.abs(rest - place).min() < 0.02


def test_it_waits_for_the_other_and_the_other_brakes_for_it(made):
    concrete = concretize(*made)
    _, _, traces = played(concrete)
    car = concrete.participant("car_1")
    go = next(p for p in car.speed_program if p.hazard is HazardKind.REVERSING)
    assert isinstance(go.trigger, ArrivalBelow)
    assert go.trigger.participant == "ego"
    assert 1.0 < go.target_speed_mps < 3.0
    assert (traces["ego"].speed_mps == 0.0).any()
    assert traces["ego"].speed_mps[-1] > 3.0


def test_the_same_seed_gives_the_same_numbers(made):
    assert concretize(*made, seed=3) == concretize(*made, seed=3)


def test_both_simulators_agree_and_the_batch_knows_backwards(made):
    concrete = concretize(*made)
    _, paths, traces = played(concrete)
    program, candidate = compile_program(concrete, paths)
    batch = simulate_batch(program, candidate, duration_s=concrete.duration_s)
    names = [p.id for p in concrete.participants]
    stacked = stack_traces([traces[name] for name in names], [paths[name] for name in names])
    np.testing.assert_allclose(batch.tracks, stacked.tracks, atol=1e-9)
    i = names.index("car_1")
    assert batch.speed_mps[0, :, i].min() < -1.0
    assert batch.speed_mps[0, :, 1 - i].min() >= 0.0


def test_who_backs_out_starts_beside_the_road_and_comes_into_the_lane(scenario):
    shape, arms, drives = FORMS["right"]
    concrete = concretize(*scenario(shape, arms, drives, REVERSING))
    network, paths, _ = played(concrete)
    motion = concrete.participant("car_1").motion
    assert isinstance(motion.reversal, BacksOut)
    path, road = paths["car_1"], network.arm_road(0)
    _, ends = path.backwards[0]
    start, joined = path.pose(0.0), path.pose(ends)
    across = abs((start.y_m - joined.y_m) * np.cos(joined.heading_rad))
    body = concrete.participant("car_1").body
    assert across > network.road(road.id).lanes[0].width_m / 2 + body.rear_m
    turned = abs(np.degrees(start.heading_rad - joined.heading_rad))
    assert turned == pytest.approx(90.0, abs=0.1)


def test_stations_and_places_of_a_way_that_reverses_belong_together(scenario):
    shape, arms, drives = FORMS["ahead"]
    concrete = concretize(*scenario(shape, arms, drives, REVERSING))
    motion = concrete.participant("car_1").motion
    laid = lay_drive(build_network(concrete.road), motion, "car_1")
    reversal = motion.reversal
    begins, ends = laid.path.backwards[0]
    assert laid.path_s_m(reversal.from_m) == pytest.approx(begins)
    assert laid.station_m(ends) == pytest.approx(reversal.from_m - reversal.length_m)
    # A place that lies before where it turns back is reached first on the way there.
    assert laid.path_s_m(reversal.from_m - 2.0) == pytest.approx(begins - 2.0)
    assert laid.path_s_m(reversal.from_m + 2.0) == pytest.approx(ends + reversal.length_m + 2.0)


@pytest.mark.parametrize(
    ("update", "words"),
    [
        ({"from_m": 9.1, "length_m": 3.0}, "cannot stop at 9.1 m"),
        ({"from_m": 50.0, "length_m": 60.0}, "60.0 m back"),
        ({"from_m": 9999.0, "length_m": 5.0}, "cannot stop at 9999.0 m"),
    ],
)
def test_a_way_back_without_room_is_refused(scenario, update, words):
    shape, arms, drives = FORMS["ahead"]
    concrete = concretize(*scenario(shape, arms, drives, REVERSING))
    motion = concrete.participant("car_1").motion.model_copy(
        update={"start_m": 9.0, "reversal": BacksUp(**update)}
    )
    with pytest.raises(MotionInfeasibleError, match=words):
        lay_drive(build_network(concrete.road), motion, "car_1")


@pytest.mark.parametrize(
    ("reversal", "words"),
    [
        (BacksOut(side="right", setback_m=0.5, radius_m=6.0), "quarter turn"),
        (BacksOut(arm=1, setback_m=3.0), "no way leads from arm 1 backwards"),
    ],
)
def test_no_room_to_back_out_is_refused(scenario, reversal, words):
    shape, arms, drives = FORMS["right"]
    concrete = concretize(*scenario(shape, arms, drives, REVERSING))
    motion = concrete.participant("car_1").motion.model_copy(update={"reversal": reversal})
    with pytest.raises(MotionInfeasibleError, match=words):
        lay_drive(build_network(concrete.road), motion, "car_1")


def test_one_comes_out_of_one_place():
    with pytest.raises(ValueError, match="a side of its road, or from an arm"):
        BacksOut(setback_m=3.0)
    with pytest.raises(ValueError, match="a side of its road, or from an arm"):
        BacksOut(setback_m=3.0, side="left", arm=1)


@pytest.mark.parametrize(
    ("drives", "words"),
    [
        ([{"entry": 0, "move": 1}, {"entry": 0, "move": 1, "rank": 1}], "drives behind ego"),
        ([{"entry": 0, "move": 1}, {"entry": 0, "move": 1, "beside": "ego"}], "beside ego"),
        ([{"entry": 0, "move": 1}, {"entry": 1, "move": 1}], "that of ego do not touch"),
        (
            [AHEAD[0], {**AHEAD[1], "maneuver": "lane_change"}],
            "reversing and lane change in one drive",
        ),
    ],
)
def test_what_cannot_be_is_refused_by_name(scenario, drives, words):
    with pytest.raises(MotionInfeasibleError, match=words):
        concretize(*scenario("straight", 2, drives, REVERSING))


def test_reversing_towards_one_who_is_parked_is_refused(scenario):
    hazards = [("reversing", ["ego"], ["parked_0"])]
    made = scenario("straight", 2, [AHEAD[1]], hazards, standings=[(0, "right", False)])
    with pytest.raises(MotionInfeasibleError, match="parked_0, who is parked"):
        concretize(*made)


def test_one_on_foot_crosses_behind_it_while_it_goes_back(scenario):
    hazards = [("reversing", ["ego"], ["ped_0"])]
    concrete = concretize(*scenario("straight", 2, [AHEAD[1]], hazards, crossings=[(0, "right")]))
    _, paths, traces = played(concrete)
    begins, ends = paths["ego"].backwards[0]
    ego, walker = traces["ego"], traces["ped_0"]
    back = (ego.s_m > begins) & (ego.s_m < ends)
    assert ((walker.speed_mps > 0.5) & back).any()


def test_stopping_and_reversing_are_one_stop(scenario):
    shape, arms, drives = FORMS["crossing"]
    hazards = [*REVERSING, ("stopping", ["car_1"], ["ego"]), ("hard_braking", ["car_1"], ["ego"])]
    concrete = concretize(*scenario(shape, arms, drives, hazards))
    car = concrete.participant("car_1")
    assert isinstance(car.motion, DriveMotion)
    assert isinstance(car.motion.reversal, BacksUp)
    stops = [p for p in car.speed_program if p.target_speed_mps == 0.0]
    assert len(stops) == 2
    assert max(p.rate_mps2 for p in car.speed_program) > 5.0


def test_who_drives_past_one_that_backs_out_stays_in_its_lane(scenario):
    shape, arms, (ego, car) = FORMS["right"]
    drives = [{**ego, "maneuver": "overtake"}, car]
    concrete = concretize(*scenario(shape, arms, drives, REVERSING))
    assert not concrete.ego.motion.lane_changes

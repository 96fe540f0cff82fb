"""What depends on paths: gaps to leaders, conflict areas, post-encroachment times."""

import numpy as np
import pytest
import shapely
from criticality_geometry import arc, cruising, line, polygon, through
from series import gap_series

from scegen.measures import build_tables, measure
from scegen.measures.bodies import body_of
from scegen.measures.boxes import track_box
from scegen.measures.post_encroachment import time_of_reaching
from scegen.motion.batch.arrays import S
from scegen.motion.model import Path
from scegen.scenario.bodies import BODIES
from scegen.scenario.vocabulary import ParticipantKind

CAR, PED, TRUCK = (BODIES[ParticipantKind(kind)] for kind in ("car", "pedestrian", "truck"))


def gaps_of(paths, starts, speeds, bodies=(CAR, CAR)):
    scene = build_tables(paths, bodies)
    traces = cruising(paths, starts, speeds, duration_s=3.0)
    gaps, who = gap_series(traces, scene)
    return gaps[0, :, 0], who[0, :, 0]


def test_the_gap_in_a_lane_is_between_bumpers():
    lane = line(0, 0, 0.3, 200)
    gaps, who = gaps_of([lane, lane], [10.0, 40.0], [10.0, 10.0], (CAR, TRUCK))
    assert set(who) == {0}
    np.testing.assert_allclose(gaps, 30.0 - CAR.front_m - TRUCK.rear_m, atol=1e-6)
    gaps, who = gaps_of([lane, lane], [40.0, 10.0], [10.0, 10.0])
    assert set(who) == {1}


def test_the_gap_in_a_bend_is_along_the_path():
    bend = arc(30.0, 0.0, 4.0)
    gaps, _ = gaps_of([bend, bend], [5.0, 30.0], [10.0, 10.0])
    np.testing.assert_allclose(gaps, 25.0 - CAR.front_m - CAR.rear_m, atol=0.1)


def test_no_leader_in_the_next_lane_nor_in_cross_or_oncoming_traffic():
    lane = line(0, 0, 0, 200)
    for other in (line(0, 3.5, 0, 200), line(60, -60, np.pi / 2, 200), line(150, 0, np.pi, 150)):
        gaps, who = gaps_of([lane, other], [10.0, 40.0], [10.0, 10.0])
        assert np.isnan(gaps).all()
        assert set(who) == {-1}


def test_a_car_that_cuts_in_becomes_the_leader_once_it_reaches_into_the_corridor():
    x = np.arange(0.0, 200.0, 0.25)
    shift = np.clip((x - 60.0) / 40.0, 0.0, 1.0)
    y = 3.5 * (1.0 - (shift - np.sin(2 * np.pi * shift) / (2 * np.pi)))
    paths = [line(0, 0, 0, 200), through(np.column_stack((x, y)))]
    scene = build_tables(paths, (CAR, CAR))
    traces = cruising(paths, [20.0, 40.0], [12.0, 12.0], duration_s=8.0)
    gaps, _ = gap_series(traces, scene)
    begins = int(np.flatnonzero(np.isfinite(gaps[0, :, 0]))[0])
    assert np.isfinite(gaps[0, begins:, 0]).all()
    # The ground truth: its box reaches over the edge of the corridor.
    body, track = body_of(scene.bodies, 1), traces.tracks[0, 1]
    low = [polygon(track_box(track, body, t)).bounds[1] for t in range(traces.tracks.shape[3])]
    truth = int(np.flatnonzero(np.array(low) < CAR.width_m / 2)[0])
    assert abs(begins - truth) <= 1


def sweep(path, body, step=0.1):
    """The ground that a body covers on its path."""
    s = np.arange(0.0, path.length_m + step, step)
    traces = cruising([path], [0.0], [step], duration_s=len(s) - 1.0, dt_s=1.0)
    own, track = body_of(build_tables([path], [body]).bodies, 0), traces.tracks[0, 0]
    boxes = [polygon(track_box(track, own, t)) for t in range(track.shape[1])]
    return boxes, shapely.union_all(boxes), step


def slow_extent(path, body, ground):
    """First and last position at which a body touches some ground, to 0.1 m."""
    boxes, _, step = sweep(path, body)
    touching = np.flatnonzero([box.intersects(ground) for box in boxes])
    return touching[0] * step, touching[-1] * step


@pytest.mark.parametrize(
    ("other", "body"),
    [
        (line(50, -60, np.pi / 2, 120), CAR),
        (line(20, -40, np.deg2rad(55), 120), TRUCK),
        (line(40, 7, -np.pi / 2, 14), PED),
        (arc(30.0, -1.2, 1.9), CAR),
        (line(90, -6, np.deg2rad(165), 90), CAR),
    ],
)
def test_conflict_areas_are_where_the_swept_ground_overlaps(other, body):
    way = line(0, 0, 0, 100)
    scene = build_tables([way, other], (CAR, body))
    assert scene.areas.first.tolist() == [0, 1]
    for path, own, whose in ((way, CAR, 0), (other, body, 1)):
        ground = sweep(other, body)[1] if whose == 0 else sweep(way, CAR)[1]
        enter, leave = slow_extent(path, own, ground)
        assert scene.areas.enter_m[0, whose] == pytest.approx(enter, abs=0.15)
        assert scene.areas.leave_m[0, whose] == pytest.approx(leave, abs=0.15)


def test_paths_that_cross_twice_have_two_areas():
    there_and_back = through(
        [(x, 12.0 * np.sin(x / 100.0 * 2.0 * np.pi) - 6.0) for x in np.arange(0.0, 100.0, 0.25)]
    )
    scene = build_tables([line(0, 0, 0, 100), there_and_back], (CAR, CAR))
    assert scene.areas.first[1] == 2


def test_pet_at_a_crossing_by_hand():
    paths = [line(-50, 0, 0, 100), line(0, -50, np.pi / 2, 100)]
    scene = build_tables(paths, (CAR, CAR))
    half = CAR.width_m / 2
    # Entered when the front reaches the side of the other's ground, left when the rear does.
    enter, leave = 50 - half - CAR.front_m, 50 + half + CAR.rear_m
    np.testing.assert_allclose(scene.areas.enter_m[0], enter, atol=2e-3)
    np.testing.assert_allclose(scene.areas.leave_m[0], leave, atol=2e-3)
    pet = measure(cruising(paths, [0, 0], [20.0, 10.0]), scene).pet_s[0, 0]
    assert pet == pytest.approx(enter / 10 - leave / 20, abs=1e-3)
    both_inside = measure(cruising(paths, [0, 0], [10.0, 10.5]), scene)
    assert both_inside.pet_s[0, 0] == pytest.approx(enter / 10 - leave / 10.5, abs=1e-3)
    assert both_inside.pet_s[0, 0] < 0


def merging():
    """A straight lane, and one that bends into it at x = 0."""
    bend = [(40 * np.sin(a) - 40, 40 - 40 * np.cos(a)) for a in np.linspace(-1.5, 0, 240)]
    run_out = [(x, 0.0) for x in np.arange(-39.75, 60, 0.25)]
    return [line(-100, 0, 0, 160), through(bend + run_out)]


def test_pet_of_merging_paths_is_the_gap_at_the_merge_point():
    paths = merging()
    scene = build_tables(paths, (CAR, CAR))
    assert scene.areas.first.tolist() == [0, 1]
    merge = scene.areas.enter_m[0] + CAR.front_m
    np.testing.assert_allclose(scene.areas.leave_m[0], merge + CAR.rear_m, atol=1e-9)
    places = [path.pose(s) for path, s in zip(paths, merge, strict=True)]
    assert np.hypot(places[0].x_m - places[1].x_m, places[0].y_m - places[1].y_m) < 0.4
    assert places[0].x_m == pytest.approx(-44, abs=3)  # the bend ends at x = -40
    pet = measure(cruising(paths, [0, 0], [15.0, 8.0], 12.0), scene).pet_s[0, 0]
    first, second = merge[0] + CAR.rear_m, merge[1] - CAR.front_m
    assert pet == pytest.approx(second / 8.0 - first / 15.0, abs=1e-6)


def test_pet_is_undefined_where_it_is():
    lane = line(0, 0, 0, 200)
    following = build_tables([lane, lane], (CAR, CAR))
    assert following.areas.first[1] == 0
    apart = build_tables([lane, line(0, 50, 0, 200)], (CAR, CAR))
    assert apart.areas.first[1] == 0
    diverging = through(
        [(x, 0.0) for x in np.arange(0, 50, 0.5)]
        + [(50 + 20 * np.sin(a), 20 - 20 * np.cos(a)) for a in np.arange(0, 1.5, 0.02)]
    )
    assert build_tables([lane, diverging], (CAR, CAR)).areas.first[1] == 0
    paths = [line(-50, 0, 0, 100), line(0, -50, np.pi / 2, 100)]
    scene = build_tables(paths, (CAR, CAR))
    for starts, speeds, why in (
        ([0, 0], [0.0, 10.0], "one never enters"),
        ([70, 0], [10.0, 10.0], "one starts beyond"),
        ([50, 0], [0.0, 10.0], "the first never leaves"),
    ):
        assert np.isnan(measure(cruising(paths, starts, speeds), scene).pet_s[0, 0]), why


def test_one_who_stands_in_the_way_never_leaves():
    standing = Path(*(np.array([v]) for v in (0.0, 50.0, 0.5, 0.0)), ())
    scene = build_tables([line(0, 0, 0, 100), standing], (CAR, CAR))
    assert scene.areas.leave_m[0, 1] == np.inf
    result = measure(cruising([line(0, 0, 0, 100), standing], [0, 0], [10.0, 0.0]), scene)
    assert np.isnan(result.pet_s[0, 0])
    assert np.isfinite(result.contact_s[0, 0])


def test_times_are_interpolated_within_a_step():
    track = cruising([line(0, 0, 0, 100)], [1.0], [7.0], dt_s=0.1).tracks[0, 0]
    assert time_of_reaching(track, 10.0, 0.1) == pytest.approx(9.0 / 7.0, abs=1e-12)
    assert time_of_reaching(track, 0.5, 0.1) == 0.0
    assert np.isnan(time_of_reaching(track, 101.0, 0.1))
    assert np.all(np.diff(track[S]) >= 0)

"""Whether two who keep to timetables come near each other, held against shapely and fine steps."""

import numpy as np
import pytest
from criticality_geometry import line
from shapely.affinity import rotate, translate
from shapely.geometry import box

from scegen.measures.nearing import Timetable, come_near

LENGTH_M, WIDTH_M, AHEAD_M, WITHIN_M = 4.6, 1.8, 1.3, 1.0
LASTS_S = 20.0


def timetable(path, late_s, speed_mps):
    """At steady speed along a path."""
    time = np.array([0.0, LASTS_S])
    return Timetable(
        time, time * speed_mps, speed_mps, speed_mps, late_s,
        path.s_m, path.x_m, path.y_m, path.heading_rad, AHEAD_M, LENGTH_M / 2, WIDTH_M / 2,
    )  # fmt: skip


def shape(path, at_m):
    """Where a body is on a straight line, or on its prolongation."""
    heading = path.heading_rad[0]
    ahead = at_m + AHEAD_M
    flat = box(-LENGTH_M / 2, -WIDTH_M / 2, LENGTH_M / 2, WIDTH_M / 2)
    turned = rotate(flat, heading, origin=(0, 0), use_radians=True)
    return translate(
        turned, path.x_m[0] + ahead * np.cos(heading), path.y_m[0] + ahead * np.sin(heading)
    )


@pytest.mark.parametrize("seed", range(60))
def test_crossing_bodies_come_as_near_as_their_outlines(seed):
    rng = np.random.default_rng(seed)
    heading = rng.uniform(0.0, 2 * np.pi)
    paths = line(0, 0, 0, 200), line(80 - 60 * np.cos(heading), -60 * np.sin(heading), heading, 150)
    speeds, lates = rng.uniform(6.0, 15.0, 2), rng.uniform(-3.0, 3.0, 2)
    begins = rng.uniform(-4.0, 4.0)
    tables = [timetable(*each) for each in zip(paths, lates, speeds, strict=True)]
    ends = min(lates) + LASTS_S
    times = np.arange(begins, ends, 0.02)
    apart = min(
        shape(paths[0], (t - lates[0]) * speeds[0]).distance(
            shape(paths[1], (t - lates[1]) * speeds[1])
        )
        for t in times
    )
    found = come_near(*tables, begins, ends, WITHIN_M)
    # Along the sides of a box the free distance is at most the true one, by a corner's diagonal.
    if apart < 0.8:
        assert found
    if apart > WITHIN_M * 2**0.5 + 0.4:
        assert not found


def test_who_has_not_begun_comes_along_the_prolongation_of_its_way():
    lane = line(0, 0, 0, 200)
    ahead, behind = timetable(lane, 0.0, 5.0), timetable(lane, 1.0, 10.0)
    assert come_near(ahead, behind, 0.0, 10.0, WITHIN_M)
    apart = timetable(lane, 4.0, 5.0)
    assert not come_near(ahead, apart, -10.0, 10.0, WITHIN_M)
    assert come_near(ahead, timetable(lane, 0.5, 5.0), -10.0, -9.0, WITHIN_M)


def test_nothing_counts_before_the_beginning_or_after_the_end():
    one, two = timetable(line(0, 0, 0, 200), 0.0, 10.0), timetable(line(50, -50, 1.6, 150), 0.0, 10)
    assert come_near(one, two, 0.0, 10.0, WITHIN_M)
    assert not come_near(one, two, 7.0, 10.0, WITHIN_M)
    assert not come_near(one, two, 0.0, 3.0, WITHIN_M)

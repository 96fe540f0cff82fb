"""When something begins is read off the trace, whatever was planned."""

import numpy as np
import pytest

from scegen.claims.boxes import Boxes, free, gap_m, seen
from scegen.claims.runs import greatest_runs
from scegen.claims.statements.spacings import overlap_percent
from scegen.scenario.vocabulary import Side

DT_S = 0.05


def speeds(*parts):
    """Pieces of (from, to, seconds)."""
    pieces = [np.linspace(a, b, round(s / DT_S), endpoint=False) for a, b, s in parts]
    return np.concatenate([*pieces, [parts[-1][1]]])[None, :]


def runs(series, sense, count=1):
    return greatest_runs(series, sense, 0.3 * DT_S, 1.0, count)


def test_a_run_begins_with_the_last_step_of_the_old_speed():
    (run,) = runs(speeds((10, 10, 1), (10, 4, 1), (4, 4, 1)), -1)
    assert (run.begin[0], run.end[0]) == (20, 40)
    assert run.change_mps[0] == pytest.approx(6.0)


def test_the_greatest_runs_come_in_the_order_of_time():
    series = speeds((10, 9, 0.5), (9, 9, 1), (9, 2, 1), (2, 2, 1), (2, 0, 1))
    first, second = runs(series, -1, 2)
    assert first.change_mps[0] == pytest.approx(7.0)
    assert second.change_mps[0] == pytest.approx(2.0)
    assert first.begin[0] < second.begin[0]


def test_what_does_not_happen_is_no_run():
    steady = speeds((10, 10, 2))
    assert not runs(steady, -1)[0].happens[0]
    first, second = runs(speeds((5, 5, 1), (5, 8, 1)), 1, 2)
    assert first.happens[0]
    assert not second.happens[0]


def box(x, y, heading_deg=0.0, length=4.0, width=2.0):
    heading = np.radians(heading_deg)
    values = (np.array([v]) for v in (x, y, np.cos(heading), np.sin(heading)))
    return Boxes(*values, length / 2, width / 2)


def test_a_box_is_seen_from_another():
    place = seen(box(0, 0), box(10, 3, 90))
    assert [float(v[0]) for v in place] == pytest.approx([10, 3, 9, 11, 1, 5])
    assert [float(v[0]) for v in free(box(0, 0), box(10, 3))] == pytest.approx([6, -14, 1, -5])
    assert gap_m(box(0, 0), box(-10, 0))[0] == pytest.approx(6)


@pytest.mark.parametrize(
    ("y", "side", "percent"),
    [
        (0, None, 100),
        (1, None, 50),
        (1, Side.LEFT, 50),
        (1, Side.RIGHT, -50),
        (-0.5, Side.RIGHT, 75),
    ],
)
def test_overlap_is_the_share_of_the_width_that_is_covered(y, side, percent):
    assert overlap_percent(box(0, 0), box(8, y), side)[0] == pytest.approx(percent)


def test_a_narrow_one_that_is_covered_whole_overlaps_whole():
    assert overlap_percent(box(0, 0), box(8, 0.5, width=0.6), None)[0] == 100

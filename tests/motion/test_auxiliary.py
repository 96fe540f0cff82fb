"""Who uses a ramp, or a lane that begins or ends, keeps to where it is."""

import pytest

from scegen.errors import MotionInfeasibleError
from scegen.motion.paths import lay_drive
from scegen.road import build_network, plan_road
from scegen.road.ramps import gore_m
from scegen.scenario.concrete import DriveMotion, LaneChange
from scegen.scenario.junction import Junction

ARM_M = 500.0


def laid(kind, entry_lane, exit_lane, *changes, start_m=10.0):
    junction = Junction(
        kind="straight", arms=2, lanes=(2, 2), carriageway="divided", auxiliary=kind
    )
    parameters = plan_road(junction, arm_length_m=ARM_M)
    motion = DriveMotion(
        entry=0, entry_lane=entry_lane, exit=1, exit_lane=exit_lane, start_m=start_m,
        turning_starts_m=0.0, turning_ends_m=0.0,
        lane_changes=tuple(
            LaneChange(position_m=at, length_m=length, lane_after=lane)
            for at, length, lane in changes
        ),
    )  # fmt: skip
    return lay_drive(build_network(parameters), motion, "car_1"), gore_m(parameters)


def test_who_merges_comes_by_the_ramp_and_stays_in_its_lane():
    drive, gore = laid("on_ramp", 3, 2, (ARM_M + 75 + 50, 80, 2))
    assert drive.stretches[0].road.name == "ramp"
    assert drive.stretches[2].start_m == pytest.approx(ARM_M + gore)
    # Beside the others it is one lane farther out than where it ends.
    end, beside = drive.path.y_m[-1], drive.path.y_m[drive.path.s_m.searchsorted(ARM_M + 90)]
    assert abs(beside - end) == pytest.approx(3.5, abs=0.01)


def test_who_leaves_ends_on_the_ramp():
    drive, _ = laid("off_ramp", 2, 3, (300, 80, 3))
    assert drive.stretches[-1].road.name == "ramp"
    assert abs(drive.path.y_m[-1]) > 40.0


def test_who_passes_a_ramp_may_change_lanes_beside_it():
    drive, gore = laid("on_ramp", 1, 2, (ARM_M - 20, 100, 2))
    assert 0.0 < gore < 80.0
    assert abs(drive.path.y_m[-1] - drive.path.y_m[0]) == pytest.approx(3.5, abs=0.01)


@pytest.mark.parametrize(
    ("kind", "lanes", "change", "told"),
    [
        ("on_ramp", (3, 2), (ARM_M + 20, 60, 2), "on the ramp or where it parts"),
        ("on_ramp", (3, 2), (ARM_M + 290, 60, 2), "not there all the way"),
        ("on_ramp", (3, 3), None, "not there all the way"),
        ("off_ramp", (2, 3), (100, 80, 3), "not there all the way"),
        ("off_ramp", (2, 3), (ARM_M - 20, 80, 3), "on the ramp or where it parts"),
        ("lane_drop", (3, 2), (ARM_M + 240, 60, 2), "not there all the way"),
    ],
)
def test_elsewhere_the_lane_is_not_to_be_had(kind, lanes, change, told):
    with pytest.raises(MotionInfeasibleError, match=told):
        laid(kind, *lanes, *([change] if change else []))

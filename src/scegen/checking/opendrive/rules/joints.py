"""Linked lanes meet: same place, same heading, same width, same height."""

from collections.abc import Iterator
from math import degrees, pi

from scegen.checking.opendrive.lanes import LaneJoint, lane_joints
from scegen.checking.opendrive.network import Network
from scegen.checking.opendrive.tolerances import GAP_M, KINK_DEG, heading_step
from scegen.checking.results import Finding, error


def check_joints(network: Network) -> Iterator[Finding]:
    """``xodr.lane_gap``, ``lane_kink``, ``lane_step``: measured at the ends of linked lanes.

    Centre, heading and width together fix both edges; reference lines need not meet, since a
    connecting road's lies on its lane's centre.
    """
    seen = set()
    for joint in lane_joints(network):
        ends = frozenset({joint.first.place, joint.second.place})
        if ends in seen or not (joint.first.road.measurable and joint.second.road.measurable):
            continue
        seen.add(ends)
        yield from _meet(joint)


def _meet(joint: LaneJoint) -> Iterator[Finding]:
    first, second = joint.first.pose, joint.second.pose
    place = f"{joint.first.place} – {joint.second.place}"
    gap = abs(first.centre - second.centre)
    if gap > GAP_M:
        yield error("xodr.lane_gap", place, f"linked lanes end {gap:.3f} m apart")
    # Where two ends of the same kind meet, the roads' s run against each other.
    turned = pi if joint.first.contact == joint.second.contact else 0.0
    kink = degrees(heading_step(first.heading + turned, second.heading))
    if abs(kink) > KINK_DEG:
        yield error("xodr.lane_kink", place, f"linked lanes bend by {kink:.2f}°")
    width = second.width - first.width
    if abs(width) > GAP_M:
        message = f"the width jumps from {first.width:.3f} m to {second.width:.3f} m"
        yield error("xodr.lane_step", place, message)
    height = second.height - first.height
    if abs(height) > GAP_M:
        yield error("xodr.lane_step", place, f"the height jumps by {height:+.3f} m")

"""Lanes of an arm road, from the centre line outwards: driving, parking, sidewalk."""

from __future__ import annotations

from math import radians

from scegen.road.geometry import Pose, ReferenceLine, Segment
from scegen.road.model import Crosswalk, Lane, LaneType, Road, RoadLink
from scegen.scenario.concrete import ArmRoad, RoadParameters
from scegen.scenario.vocabulary import DrivingSide

PARKING_WIDTH_M = 2.5
SIDEWALK_WIDTH_M = 2.0
CROSSWALK_WIDTH_M = 4.0
CROSSWALK_SETBACK_M = 1.0
"""From the inner edge of a crosswalk to the junction's end of the arm road."""
CONNECTING_ROADS_FROM = 101
RINGS_FROM = 21
JUNCTIONS_FROM = 1001


def side_sign(side: DrivingSide) -> int:
    """1 where traffic keeps right, -1 where it keeps left: the sign of lanes out of an arm road."""
    return 1 if side is DrivingSide.RIGHT else -1


def arm_road_id(arm: int) -> int:
    """Road ids of arms count from 1."""
    return arm + 1


def lane_centre_m(arm: ArmRoad, number: int) -> float:
    """Distance of a lane's centre from the centre line; number 1 lies next to it."""
    return (number - 0.5) * arm.lane_width_m


def arm_lanes(parameters: RoadParameters, arm: ArmRoad) -> tuple[Lane, ...]:
    """All lanes of an arm road, without links."""
    out = side_sign(parameters.driving_side)
    lanes: list[Lane] = []
    for sign, count in ((-out, arm.lanes_in), (out, arm.lanes_out)):
        strips = [(LaneType.DRIVING, arm.lane_width_m)] * count
        strips += verge(parameters, arm.id)
        lanes += [Lane(sign * k, kind, width) for k, (kind, width) in enumerate(strips, start=1)]
    return tuple(sorted(lanes, key=lambda lane: -lane.id))


def verge(parameters: RoadParameters, arm: int) -> list[tuple[LaneType, float]]:
    """The strips outside the driving lanes, outwards."""
    strips = [(LaneType.SIDEWALK, SIDEWALK_WIDTH_M)]
    if arm in parameters.parking_lanes:
        strips.insert(0, (LaneType.PARKING, PARKING_WIDTH_M))
    return strips


def half_width_m(lanes: tuple[Lane, ...], sign: int, types: frozenset[LaneType]) -> float:
    """Width of the lanes of these types left (sign 1) or right (-1) of the centre line."""
    return sum(lane.width_m for lane in lanes if lane.id * sign > 0 and lane.type in types)


KERBED = frozenset({LaneType.DRIVING})
CARRIAGEWAY = frozenset({LaneType.DRIVING, LaneType.PARKING, LaneType.SHOULDER})
ALL_STRIPS = frozenset(LaneType)


def arm_line(arm: ArmRoad, distance_m: float) -> ReferenceLine:
    """The straight line from the outer end of an arm to its inner end, towards the centre."""
    outward = radians(arm.angle_deg)
    outer = Pose(0.0, 0.0, outward).shifted(forward_m=distance_m + arm.length_m).reversed()
    return ReferenceLine((Segment(outer, arm.length_m),))


def arm_road(
    parameters: RoadParameters, arm: ArmRoad, line: ReferenceLine, successor: RoadLink
) -> Road:
    """An arm's road on a given reference line."""
    lanes = arm_lanes(parameters, arm)
    return Road(
        id=arm_road_id(arm.id),
        name=f"arm_{arm.id}",
        line=line,
        lanes=lanes,
        speed_limit_mps=arm.speed_limit_mps,
        driving_side=parameters.driving_side,
        arm=arm.id,
        successor=successor,
        crosswalks=crosswalks(parameters, arm, lanes, line.length_m),
    )


def crosswalks(
    parameters: RoadParameters, arm: ArmRoad, lanes: tuple[Lane, ...], length_m: float
) -> tuple[Crosswalk, ...]:
    """The crosswalk of an arm, if it has one, from kerb to kerb."""
    if arm.id not in parameters.crosswalks:
        return ()
    return (
        Crosswalk(
            id=arm_road_id(arm.id),
            s_m=length_m - CROSSWALK_SETBACK_M - CROSSWALK_WIDTH_M / 2,
            width_m=CROSSWALK_WIDTH_M,
            t_min_m=-half_width_m(lanes, -1, CARRIAGEWAY),
            t_max_m=half_width_m(lanes, 1, CARRIAGEWAY),
        ),
    )


def lane_in(road: Road, number: int) -> int:
    """The id of the lane with this number that leads to the junction."""
    return -side_sign(road.driving_side) * number


def lane_out(road: Road, number: int) -> int:
    """The id of the lane with this number that leads away from the junction."""
    return side_sign(road.driving_side) * number


def pose_in(road: Road, number: int) -> Pose:
    """Where traffic on an incoming lane enters the junction."""
    return road.line.pose(road.length_m, road.lane_centre_t_m(lane_in(road, number)))


def pose_out(road: Road, number: int) -> Pose:
    """Where traffic leaves the junction into an outgoing lane."""
    return road.line.pose(road.length_m, road.lane_centre_t_m(lane_out(road, number))).reversed()

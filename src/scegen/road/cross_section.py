"""Lanes of an arm road, from the centre line outwards: driving, parking, sidewalk."""

from collections.abc import Set as AbstractSet
from math import radians

from scegen.road.geometry import Pose, ReferenceLine, Segment
from scegen.road.model import Crosswalk, Extent, Lane, LaneType, Road, RoadLink
from scegen.scenario.road_parameters import ArmRoad, RoadParameters
from scegen.scenario.roadway import AuxiliaryLane, Carriageway, Strip
from scegen.scenario.vocabulary import DrivingSide

PARKING_WIDTH_M = 2.5
SIDEWALK_WIDTH_M = 2.0
MEDIAN_WIDTH_M = 5.0
SHOULDER_WIDTH_M = 3.0
BUS_STOP_WIDTH_M = 3.0
CYCLE_LANE_WIDTH_M = 1.85
"""Usual widths of a bay for buses and, with its marks, of a lane for bicycles."""
BORDER_WIDTH_M = 1.5
"""Median and hard shoulder with the marked edge strips (0.5 m) that part them from the lanes, and
the border beyond: cross section RQ 28 of the German RAA (2008), whose lanes are 3.5 m wide, too."""
CROSSWALK_WIDTH_M = 4.0
CROSSWALK_SETBACK_M = 1.0
"""From the inner edge of a crosswalk to the junction's end of the arm road."""
CROSSWALK_MIDDLE_M = CROSSWALK_SETBACK_M + CROSSWALK_WIDTH_M / 2
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
    median = median_half_m(parameters.carriageway)
    for sign, count in ((-out, arm.lanes_in), (out, arm.lanes_out)):
        strips = [(LaneType.MEDIAN, median)] if median else []
        strips += [(LaneType.DRIVING, arm.lane_width_m)] * count
        side: list[tuple[LaneType, float, Extent | None]] = [(*strip, None) for strip in strips]
        auxiliary = auxiliary_extent(parameters, arm, inward=sign == -out)
        if auxiliary is not None:
            side.append((LaneType.DRIVING, arm.lane_width_m, auxiliary))
        side += [(*strip, None) for strip in verge(parameters, arm.id)]
        lanes += [
            Lane(sign * k, kind, width, extent=extent)
            for k, (kind, width, extent) in enumerate(side, start=1)
        ]
    return tuple(sorted(lanes, key=lambda lane: -lane.id))


def auxiliary_extent(parameters: RoadParameters, arm: ArmRoad, *, inward: bool) -> Extent | None:
    """Where an arm has the auxiliary lane on one of its sides; None if it has not.

    Traffic of its direction enters at arm 0 and leaves at arm 1. An exit lane begins on the one, an
    acceleration lane ends on the other, and so does a lane that has been there from the beginning.
    """
    auxiliary = parameters.auxiliary
    if auxiliary is None or inward != (arm.id == 0):
        return None
    if auxiliary.kind is AuxiliaryLane.LANE_DROP and arm.id == 0:
        return Extent(0.0, arm.length_m)
    if (auxiliary.kind is AuxiliaryLane.OFF_RAMP) != (arm.id == 0):
        return None
    begins_m = arm.length_m - auxiliary.length_m - auxiliary.taper_m
    return Extent(max(begins_m, 0.0), arm.length_m, opens_m=auxiliary.taper_m)


def median_half_m(carriageway: Carriageway) -> float:
    """From the centre line to the first lane: half a median, or nothing."""
    return MEDIAN_WIDTH_M / 2 if carriageway is Carriageway.DIVIDED else 0.0


def verge(parameters: RoadParameters, arm: int) -> list[tuple[LaneType, float]]:
    """The strips outside the driving lanes, outwards."""
    if parameters.auxiliary is not None and Strip.HARD_SHOULDER not in parameters.strips:
        return [(LaneType.BORDER, BORDER_WIDTH_M)]
    return strips_beside(parameters.strips, parked=arm in parameters.parking_lanes)


def strips_beside(strips: AbstractSet[Strip], *, parked: bool) -> list[tuple[LaneType, float]]:
    """What lies beside the lanes, outwards; ``parked``: with a strip for standing vehicles."""
    if Strip.HARD_SHOULDER in strips:
        last = (LaneType.BORDER, BORDER_WIDTH_M)
        if Strip.PAVEMENT in strips:
            last = (LaneType.SIDEWALK, SIDEWALK_WIDTH_M)
        return [(LaneType.SHOULDER, SHOULDER_WIDTH_M), last]
    found = [(LaneType.BIKING, CYCLE_LANE_WIDTH_M)] if Strip.CYCLE_LANE in strips else []
    if parked:
        found.append((LaneType.PARKING, strip_width_m(strips)))
    return [*found, (LaneType.SIDEWALK, SIDEWALK_WIDTH_M)]


LANE_TYPES = {
    Strip.HARD_SHOULDER: LaneType.SHOULDER,
    Strip.CYCLE_LANE: LaneType.BIKING,
    Strip.PARKING: LaneType.PARKING,
    Strip.BUS_STOP: LaneType.PARKING,
    Strip.PAVEMENT: LaneType.SIDEWALK,
}
"""As which type of lane a strip is built."""


def strip_width_m(strips: AbstractSet[Strip]) -> float:
    """Width of the strip beside the lanes on which vehicles stand, where there is one."""
    if Strip.HARD_SHOULDER in strips:
        return SHOULDER_WIDTH_M
    return BUS_STOP_WIDTH_M if Strip.BUS_STOP in strips else PARKING_WIDTH_M


def half_width_m(lanes: tuple[Lane, ...], sign: int, types: frozenset[LaneType]) -> float:
    """Width of the lanes of these types left (sign 1) or right (-1) of the centre line."""
    return sum(lane.width_m for lane in lanes if lane.id * sign > 0 and lane.type in types)


KERBED = frozenset({LaneType.MEDIAN, LaneType.DRIVING})
CARRIAGEWAY = KERBED | {LaneType.PARKING, LaneType.SHOULDER, LaneType.BIKING}
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
            s_m=length_m - CROSSWALK_MIDDLE_M,
            width_m=CROSSWALK_WIDTH_M,
            t_min_m=-half_width_m(lanes, -1, CARRIAGEWAY),
            t_max_m=half_width_m(lanes, 1, CARRIAGEWAY),
        ),
    )


def lane_in(road: Road, number: int) -> int:
    """The id of the lane with this number that leads to the junction."""
    return road.driving(-side_sign(road.driving_side))[number - 1]


def lane_out(road: Road, number: int) -> int:
    """The id of the lane with this number that leads away from the junction."""
    return road.driving(side_sign(road.driving_side))[number - 1]


def pose_in(road: Road, number: int) -> Pose:
    """Where traffic on an incoming lane enters the junction."""
    return road.line.pose(road.length_m, road.lane_centre_t_m(lane_in(road, number)))


def pose_out(road: Road, number: int) -> Pose:
    """Where traffic leaves the junction into an outgoing lane."""
    return road.line.pose(road.length_m, road.lane_centre_t_m(lane_out(road, number))).reversed()

"""Where those stand and walk who do not drive through the junction."""

from math import pi, radians

import numpy as np

from scegen.errors import MotionInfeasibleError
from scegen.motion.lanes import STANDING
from scegen.motion.model import LaneSpan, Path
from scegen.road.cross_section import LANE_TYPES
from scegen.road.geometry import Pose
from scegen.road.model import Lane, LaneType, Road, RoadNetwork
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import ConcreteScenario, CrossingMotion, StandingMotion
from scegen.scenario.objects import StaticObject
from scegen.scenario.vocabulary import DrivingSide, Side

KERB_GAP_M = 0.3
"""Between the edge of the carriageway and one who stands beside it without a strip."""


def side_sign(side: Side) -> int:
    """+1 for the left of the reference line, -1 for its right: arm roads run to the junction."""
    return 1 if side is Side.LEFT else -1


def _place_on_arm(
    network: RoadNetwork, motion: CrossingMotion | StandingMotion, who: str
) -> tuple[Road, float]:
    if motion.arm >= len(network.arm_roads):
        raise MotionInfeasibleError(f"there is no arm {motion.arm}", where=who)
    road = network.arm_road(motion.arm)
    s = road.length_m - motion.from_junction_m
    if s < 0:
        raise MotionInfeasibleError(
            f"{motion.from_junction_m:.1f} m before the junction lies beyond the outer end of "
            f"{road.name}, which is {road.length_m:.1f} m long",
            where=who,
        )
    return road, s


def crossing_path(network: RoadNetwork, motion: CrossingMotion, who: str) -> Path:
    """Straight across an arm, at right angles, from one setback to the other.

    The carriageway is counted without parking strips. ``stops_after_m`` cuts the path there.
    The length of the body does not matter: the path is that of its reference point.

    Raises:
        MotionInfeasibleError: the place lies off the arm, or the stop behind its end.
    """
    road, s = _place_on_arm(network, motion, who)
    sign = side_sign(motion.start_side)
    start_t = road.edge_t_m(sign, s) + sign * motion.setback_m
    end_t = road.edge_t_m(-sign, s) - sign * motion.setback_m
    length = abs(start_t - end_t)
    if motion.stops_after_m is not None:
        if motion.stops_after_m > length:
            raise MotionInfeasibleError(
                f"stops after {motion.stops_after_m:.1f} m of a way of {length:.1f} m", where=who
            )
        length = motion.stops_after_m
    start = road.line.pose(s, start_t)
    heading = start.heading_rad - sign * pi / 2
    way = Pose(start.x_m, start.y_m, heading)
    end = way.shifted(forward_m=length)
    return Path(
        np.array([0.0, length]),
        np.array([way.x_m, end.x_m]),
        np.array([way.y_m, end.y_m]),
        np.array([heading, heading]),
        (),
    )


def standing_path(network: RoadNetwork, motion: StandingMotion, body: Body, who: str) -> Path:
    """One pose: on the strip beside the lanes, beside the carriageway, or in its outermost lane.

    It heads the way of the traffic on its side, on a one-way road of all.

    Raises:
        MotionInfeasibleError: the place lies off the arm.
    """
    road, s = _place_on_arm(network, motion, who)
    sign = side_sign(motion.side)
    lane = _standing_lane(road, s, sign, motion)
    if lane is not None:
        t = road.lane_centre_t_m(lane.id, s)
    else:
        t = road.edge_t_m(sign, s) + sign * (body.width_m / 2 + KERB_GAP_M)
    forward = heads_for_junction(network, motion)
    pose = road.line.pose(s, t)
    if not forward:
        pose = pose.reversed()
    spans = () if lane is None else (LaneSpan(road.id, lane.id, forward, 0.0, 0.0),)
    return Path.at(pose, spans)


def heads_for_junction(network: RoadNetwork, motion: StandingMotion) -> bool:
    """Whether the traffic beside which one stands comes in on its arm."""
    sign = side_sign(motion.side)
    traffic = sign if network.arm_road(motion.arm).driving(sign) else -sign
    return (traffic == -1) == (network.driving_side is DrivingSide.RIGHT)


def _standing_lane(road: Road, s_m: float, sign: int, motion: StandingMotion) -> Lane | None:
    wanted = set(STANDING)
    if motion.in_lane or motion.strip is not None:
        wanted = {LaneType.DRIVING if motion.strip is None else LANE_TYPES[motion.strip]}
    there = [lane for lane in road.lanes if lane.width_at_m(s_m) == lane.width_m]
    lanes = [lane for lane in there if lane.id * sign > 0 and lane.type in wanted]
    return max(lanes, key=lambda lane: abs(lane.id), default=None)


def object_paths(concrete: ConcreteScenario) -> dict[str, Path]:
    """The one pose of every object, by id."""
    return {thing.id: object_path(thing) for thing in concrete.objects}


def object_path(thing: StaticObject) -> Path:
    """One pose: that of its centre."""
    return Path.at(Pose(thing.x_m, thing.y_m, radians(thing.heading_deg)))

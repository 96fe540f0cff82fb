"""A straight road, or a bend: two arms joined end to end."""

from dataclasses import dataclass, replace
from math import pi, radians, tan

from scegen.errors import RoadInfeasibleError
from scegen.road.cross_section import (
    arm_line,
    arm_road,
    arm_road_id,
    median_half_m,
    side_sign,
    strip_width_m,
)
from scegen.road.fillet import chain, wrapped
from scegen.road.geometry import Pose, ReferenceLine
from scegen.road.links import arm_route
from scegen.road.model import ContactPoint, Lane, LaneType, Road, RoadLink, RoadNetwork, Route
from scegen.road.ramps import build_ramp, gore_m
from scegen.scenario.road_parameters import RoadParameters
from scegen.scenario.roadway import AuxiliaryLane

BEND_RADIUS_M = 50.0
"""Radius of the centre line of a bend, unless ``corner_radius_m`` gives another."""
MIN_BEND_RADIUS_M = 20.0
MIN_LINE_M = 5.0
"""So much of each arm at least is straight."""
_STRAIGHT_RAD = 1e-9


def build_straight(parameters: RoadParameters, name: str) -> RoadNetwork:
    """Two arm roads that meet end to end at the origin (at the middle of the arc in a bend).

    Raises:
        RoadInfeasibleError: if lanes do not continue or it bends too sharply.
    """
    _check(parameters)
    if gore_m(parameters):
        return build_ramp(parameters, name)
    arms = tuple(
        arm_road(
            parameters,
            arm,
            _line(parameters, index),
            RoadLink("road", arm_road_id(1 - arm.id), ContactPoint.END),
        )
        for index, arm in enumerate(parameters.arms)
    )
    arms = tuple(_linked(road, parameters) for road in arms)
    driving_side = parameters.driving_side
    routes: dict[tuple[int, int], tuple[Route, ...]] = {}
    for entry, leaving in ((0, 1), (1, 0)):
        if not parameters.arms[entry].lanes_in:
            continue
        lanes = range(1, len(arms[entry].driving(-side_sign(driving_side))) + 1)
        routes[entry, leaving] = tuple(
            arm_route(arms, (entry, leaving), (number, number)) for number in lanes
        )
    return RoadNetwork(
        name=name,
        driving_side=driving_side,
        roads=arms,
        junctions=(),
        arm_roads=tuple(road.id for road in arms),
        routes=routes,
        plain=True,
    )


def _check(parameters: RoadParameters) -> None:
    first, second = parameters.arms
    for entry, leaving in ((first, second), (second, first)):
        if entry.lanes_in != leaving.lanes_out:
            msg = (
                f"{entry.lanes_in} lanes in from arm {entry.id} do not continue in "
                f"{leaving.lanes_out} lanes out of arm {leaving.id}"
            )
            raise RoadInfeasibleError(msg, where="arms", hint="Make the two numbers equal.")
    if first.lane_width_m != second.lane_width_m:
        msg = f"lanes are {first.lane_width_m:g} m wide on arm 0 and {second.lane_width_m:g} on 1"
        raise RoadInfeasibleError(msg, where="arms", hint="Make the lane widths equal.")
    auxiliary = parameters.auxiliary
    if auxiliary is None:
        return
    if abs(bend_rad(parameters)) > _STRAIGHT_RAD:
        raise RoadInfeasibleError("lies in a bend, where none is built", where="auxiliary")
    side = first if auxiliary.kind is AuxiliaryLane.OFF_RAMP else second
    needed = auxiliary.length_m + auxiliary.taper_m + MIN_LINE_M
    if side.length_m < needed:
        msg = f"needs {needed:g} m of arm {side.id}, which is {side.length_m:g} m long"
        raise RoadInfeasibleError(msg, where="auxiliary", hint="Make the arm longer.")


@dataclass(frozen=True, slots=True)
class Curve:
    """The arc of a road: curvature (left positive, for who enters at arm 0), half its length."""

    curvature_1pm: float
    half_arc_m: float


def curve_of(parameters: RoadParameters) -> Curve | None:
    """The arc of a road's centre line, its middle where the two arms meet; None if it has none."""
    bend = bend_rad(parameters)
    if abs(bend) < _STRAIGHT_RAD:
        return None
    radius = parameters.corner_radius_m or BEND_RADIUS_M
    return Curve((1 if bend > 0 else -1) / radius, radius * abs(bend) / 2)


def bend_rad(parameters: RoadParameters) -> float:
    """Change of heading from arm 0 into arm 1 (left positive)."""
    first, second = (radians(arm.angle_deg) for arm in parameters.arms)
    return wrapped(second - first - pi)


def _line(parameters: RoadParameters, index: int) -> ReferenceLine:
    """From the outer end of an arm straight on, then over its half of the bend."""
    arm, curve = parameters.arms[index], curve_of(parameters)
    if curve is None:
        return arm_line(arm, 0.0)
    widest = (
        median_half_m(parameters.carriageway) + max(arm.lanes_in, arm.lanes_out) * arm.lane_width_m
    )
    radius = parameters.corner_radius_m or BEND_RADIUS_M
    tightest = max(MIN_BEND_RADIUS_M, 2 * widest)
    if radius < tightest:
        msg = f"a bend of {radius:g} m radius is tighter than {tightest:g} m"
        raise RoadInfeasibleError(msg, where="corner_radius_m")
    line = arm.length_m - curve.half_arc_m
    if arm.length_m < curve.half_arc_m + MIN_LINE_M:
        msg = (
            f"arm {arm.id} is {arm.length_m:g} m long, but its half of the bend needs "
            f"{curve.half_arc_m + MIN_LINE_M:.1f} m"
        )
        raise RoadInfeasibleError(msg, where=f"arms[{arm.id}].length_m")
    outward = Pose(0.0, 0.0, radians(arm.angle_deg))
    tangent = radius * tan(abs(bend_rad(parameters)) / 2)
    start = outward.shifted(forward_m=tangent + line).reversed()
    turns = curve.curvature_1pm if index == 0 else -curve.curvature_1pm
    return chain(start, [(line, 0.0), (curve.half_arc_m, turns)])


def _linked(road: Road, parameters: RoadParameters) -> Road:
    """Lanes continue in the opposite lanes of the other arm; verges are made to match."""
    lanes: list[Lane] = []
    for sign in (-1, 1):
        side = [lane for lane in road.lanes if lane.id * sign > 0]
        side.sort(key=lambda lane: abs(lane.id))
        if parameters.parking_lanes and road.arm not in parameters.parking_lanes:
            # Where only the other arm has parking, a shoulder keeps the sidewalk in line.
            width = strip_width_m(parameters.strips)
            side.insert(-1, Lane(0, LaneType.SHOULDER, width))
        lanes += [
            replace(lane, id=sign * k, successor=-sign * k) for k, lane in enumerate(side, start=1)
        ]
    return replace(road, lanes=tuple(sorted(lanes, key=lambda lane: -lane.id)))

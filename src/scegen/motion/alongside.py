"""A drive along a road without a crossing: from lane to lane, past a ramp or by way of it.

The parts of such a road have their lanes side by side, so a change of lane may run across a joint.
A lane that begins or ends is used where it has its full width; on a ramp there is one lane.
"""

from dataclasses import replace
from functools import partial

from scegen.errors import MotionInfeasibleError
from scegen.motion.lanes import arm_lane_id
from scegen.motion.stretches import Stretch, Walk
from scegen.road.model import LaneType, RouteStep

_ENDS_M = 0.05
"""A change of lane may so far run beyond the end of a lane."""


def along_plain(walk: Walk) -> None:
    """Lay a drive along a road without a crossing.

    Raises:
        MotionInfeasibleError: no such lane, one that is not there, or a change across a median.
    """
    motion = walk.motion
    for part in range(len(walk.network.routes[motion.entry, motion.exit][0].steps)):
        walk.lay(partial(_step, walk, part))
    for change in walk.todo:
        raise MotionInfeasibleError(
            f"the lane change from {change.position_m:.1f} to "
            f"{change.position_m + change.length_m:.1f} m ends beyond the road, which is "
            f"{walk.end_m:.1f} m long",
            where=walk.who,
            hint="Move it, shorten it or choose a longer road.",
        )
    _check_median(walk)
    _check_extents(walk)


def _step(walk: Walk, part: int, number: int) -> RouteStep:
    """The road and lane of a lane number on one part of the way.

    Raises:
        MotionInfeasibleError: there is no such lane.
    """
    entry, leaving, network = walk.motion.entry, walk.motion.exit, walk.network
    routes = network.routes[entry, leaving]
    for route in routes:
        if route.entry_lane == number:
            return route.steps[part]
    if number == 0 and (leaving, entry) in network.routes:
        back = network.routes[leaving, entry][0].steps[-1 - part]
        return replace(back, forward=not back.forward)
    if 0 < part < len(routes[0].steps) - 1:
        raise walk.refused(f"there is no lane {number} beside the ramp")
    arm, inbound = (entry, True) if part == 0 else (leaving, False)
    road = network.arm_road(arm)
    return RouteStep(road.id, arm_lane_id(road, number, inbound=inbound), forward=inbound)


def _check_median(walk: Walk) -> None:
    """Nobody drives across a median."""
    for begins_m, _, road, (before, after) in walk.moved:
        types = {lane.type for lane in walk.network.road(road).lanes}
        if LaneType.MEDIAN in types and before * after < 0:
            raise MotionInfeasibleError(
                f"the lane change at {begins_m:.1f} m leads across the median",
                where=walk.who,
                hint="Change into another lane of this direction, or leave out the median.",
            )


def _check_extents(walk: Walk) -> None:
    """Whoever uses a lane that begins or ends does so where it is.

    Raises:
        MotionInfeasibleError: with the places of the lane and of the drive.
    """
    for piece, lane in ((each, lane) for each in walk.done for lane in each.road.lanes):
        if lane.extent is None:
            continue
        used = [(a, b) for a, b, number in piece.lanes() if number == lane.id]
        used += [
            (a, b) for a, b, road, both in walk.moved if road == piece.road.id and lane.id in both
        ]
        within = lane.extent.from_m + lane.extent.opens_m, lane.extent.to_m
        for begins, ends in used:
            low, high = max(begins, walk.motion.start_m, piece.start_m), min(ends, piece.end_m)
            places = sorted(_s_m(piece, u) for u in (low, high))
            if low < high and not (
                within[0] - _ENDS_M <= places[0] and places[1] <= within[1] + _ENDS_M
            ):
                raise walk.refused(
                    f"is in a lane from {low:.1f} to {high:.1f} m that is not there all "
                    f"the way ({piece.road.name}, {within[1] - within[0]:.0f} m long)"
                )


def _s_m(piece: Stretch, station_m: float) -> float:
    """The place on a road's reference line of a station."""
    travelled = (station_m - piece.start_m) / piece.scale
    return travelled if piece.forward else piece.road.length_m - travelled

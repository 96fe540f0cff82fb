"""From a drive's numbers to the stretches that it runs over, lane changes included.

Which lane a number means: ``entry_lane`` is the lane in which the vehicle starts; lane changes
move it; it goes through the junction by the route of the lane in which it arrives there (and of
``ring_lane``, its first ring lane); ``exit_lane`` is the lane in which it ends.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from scegen.errors import MotionInfeasibleError
from scegen.motion.alongside import along_plain
from scegen.motion.lanes import arm_lane_id, is_ring, ring_lane_id, ring_lane_number
from scegen.motion.stretches import Shift, Stretch, lane_offset_d_m, stretch
from scegen.road.model import Road, RoadNetwork, Route, RouteStep
from scegen.scenario.concrete import DriveMotion, LaneChange

_ROUNDING_M = 1e-6


@dataclass
class _Walk:
    """The state while a drive is laid out road by road."""

    network: RoadNetwork
    motion: DriveMotion
    who: str
    todo: list[LaneChange]
    offset_m: float = 0.0
    done: list[Stretch] = field(default_factory=list)

    @property
    def end_m(self) -> float:
        return self.done[-1].end_m if self.done else 0.0

    def stretch(self, road: Road, lane: int, start_m: float, *, forward: bool) -> Stretch:
        """A road entered in a lane, as far beside its centre as the drive keeps now."""
        piece = stretch(road, lane, start_m, forward=forward)
        return replace(piece, d_m=piece.d_m + self.offset_m)

    def shifted(self, piece: Stretch, change: LaneChange, before: int, after: int) -> Stretch:
        """The stretch with one more change, from lane id ``before`` to ``after``."""
        kept = self.offset_m
        self.offset_m = change.offset_m
        shift = Shift(
            change.position_m,
            change.length_m,
            lane_offset_d_m(piece.road, before, forward=piece.forward) + kept,
            lane_offset_d_m(piece.road, after, forward=piece.forward) + change.offset_m,
        )
        return piece.with_shift(shift, after)

    def takes(self, until_m: float) -> list[LaneChange]:
        """The changes that start before ``until_m``, taken off the list."""
        now = [c for c in self.todo if c.position_m < until_m - _ROUNDING_M]
        self.todo = self.todo[len(now) :]
        return now

    def refuse(self, change: LaneChange, piece: Stretch) -> MotionInfeasibleError:
        room = f"{piece.road.name} has room from {piece.start_m:.1f} to {piece.end_m:.1f} m"
        end = change.position_m + change.length_m
        return MotionInfeasibleError(
            f"the lane change from {change.position_m:.1f} to {end:.1f} m does not lie wholly on "
            f"one road outside the junction: {room} ({piece.end_m - piece.start_m:.1f} m)",
            where=self.who,
            hint="Move it, shorten it or choose a longer road.",
        )


def walk_route(
    network: RoadNetwork, motion: DriveMotion, who: str
) -> tuple[tuple[Stretch, ...], int]:
    """The stretches of a drive and the lane in which it ends; ``exit_lane`` is only a wish here.

    Raises:
        MotionInfeasibleError: no such route or lane, or a lane change without room.
    """
    if (motion.entry, motion.exit) not in network.routes:
        raise MotionInfeasibleError(
            f"no route leads from arm {motion.entry} to arm {motion.exit}",
            where=who,
            hint="Routes: " + ", ".join(f"{a}->{b}" for a, b in sorted(network.routes)),
        )
    _check_order(motion, who)
    if network.plain:
        return along_plain(network, motion, who)
    walk = _Walk(network, motion, who, list(motion.lane_changes), motion.offset_m)
    lane = _along_entry(walk)
    route = _choose_route(walk, lane)
    steps = list(route.steps[1:-1])
    while steps:
        steps = _along_step(walk, steps, route)
    lane = _exit_number(network, motion, route, walk.done[-1])
    arrived = _along_exit(walk, lane)
    return tuple(walk.done), arrived


def _check_order(motion: DriveMotion, who: str) -> None:
    before = motion.start_m
    for change in motion.lane_changes:
        if change.position_m < before - _ROUNDING_M:
            raise MotionInfeasibleError(
                f"the lane change at {change.position_m:.1f} m starts before {before:.1f} m, "
                "where the vehicle starts or its change before ends",
                where=who,
            )
        before = change.position_m + change.length_m


def _along_entry(walk: _Walk) -> int:
    """Lay the entry arm; returns the lane number at its inner end."""
    road = walk.network.arm_road(walk.motion.entry)
    lane = walk.motion.entry_lane
    piece = walk.stretch(road, arm_lane_id(road, lane, inbound=True), 0.0, forward=True)
    return _on_arm(walk, piece, lane, inbound=True)


def _along_exit(walk: _Walk, lane: int) -> int:
    """Lay the exit arm, entered in lane number ``lane``; returns the lane at its outer end."""
    road = walk.network.arm_road(walk.motion.exit)
    lane_id = arm_lane_id(road, lane, inbound=False)
    piece = walk.stretch(road, lane_id, walk.end_m, forward=False)
    arrived = _on_arm(walk, piece, lane, inbound=False)
    if walk.todo:
        raise walk.refuse(walk.todo[0], walk.done[-1])
    return arrived


def _on_arm(walk: _Walk, piece: Stretch, lane: int, *, inbound: bool) -> int:
    """Append an arm with its lane changes; returns the lane number at its end."""
    for change in walk.takes(piece.end_m):
        if change.position_m + change.length_m > piece.end_m + _ROUNDING_M:
            raise walk.refuse(change, piece)
        before = arm_lane_id(piece.road, lane, inbound=inbound)
        after = arm_lane_id(piece.road, change.lane_after, inbound=inbound)
        piece = walk.shifted(piece, change, before, after)
        lane = change.lane_after
    walk.done.append(piece)
    if lane == 0:
        raise MotionInfeasibleError(
            f"the vehicle is still in the oncoming lane at the end of {piece.road.name}",
            where=walk.who,
            hint="Add a lane change back to lane 1.",
        )
    return lane


def _along_step(walk: _Walk, steps: list[RouteStep], route: Route) -> list[RouteStep]:
    """Append the first step; returns those that remain, by another lane after a ring change."""
    step, rest = steps[0], steps[1:]
    road = walk.network.road(step.road)
    piece = walk.stretch(road, step.lane, walk.end_m, forward=step.forward)
    for change in walk.takes(piece.end_m):
        fits = change.position_m + change.length_m <= piece.end_m + _ROUNDING_M
        starts = change.position_m >= piece.start_m - _ROUNDING_M
        if not is_ring(road) or not fits or not starts:
            raise walk.refuse(change, piece)
        before = piece.lane_after[-1][1] if piece.lane_after else piece.lane
        after = ring_lane_id(road, change.lane_after)
        piece = walk.shifted(piece, change, before, after)
        rest = _rest_from(walk, road.id, after, route)
    walk.done.append(piece)
    return rest


def _rest_from(walk: _Walk, road_id: int, lane: int, route: Route) -> list[RouteStep]:
    """The steps between a ring lane and the exit arm: the shortest of all routes that have it."""
    found: list[tuple[bool, int, list[RouteStep]]] = []
    for (_, exit_), routes in walk.network.routes.items():
        if exit_ != walk.motion.exit:
            continue
        for other in routes:
            for index, step in enumerate(other.steps):
                if (step.road, step.lane) == (road_id, lane):
                    rest = list(other.steps[index + 1 : -1])
                    found.append((other.exit_lane != route.exit_lane, len(rest), rest))
    if not found:
        number = ring_lane_number(walk.network.road(road_id), lane)
        raise MotionInfeasibleError(
            f"no way leads from ring lane {number} to arm {walk.motion.exit}", where=walk.who
        )
    return min(found, key=lambda option: option[:2])[2]


def _choose_route(walk: _Walk, lane: int) -> Route:
    """The route of this entry lane and ring lane that leads to the exit lane, or next to it."""
    motion = walk.motion
    routes = walk.network.routes[motion.entry, motion.exit]
    fitting = [r for r in routes if r.entry_lane == lane]
    if motion.ring_lane is not None:
        fitting = [r for r in fitting if r.ring_lane == motion.ring_lane]
    if not fitting:
        known = ", ".join(f"lane {r.entry_lane} (ring {r.ring_lane or '-'})" for r in routes)
        raise MotionInfeasibleError(
            f"from lane {lane}, ring lane {motion.ring_lane or '-'} of arm {motion.entry} no route "
            f"leads to arm {motion.exit}",
            where=walk.who,
            hint=f"Routes to arm {motion.exit} start in: {known}.",
        )
    junction_m = walk.end_m
    later = [c for c in walk.todo if c.position_m >= junction_m]
    if later and motion.ring_lane is None:
        first = later[0].lane_after
        return min(fitting, key=lambda r: (r.exit_lane == first, abs(r.exit_lane - first)))
    return min(fitting, key=lambda r: abs(r.exit_lane - motion.exit_lane))


def _exit_number(network: RoadNetwork, motion: DriveMotion, route: Route, last: Stretch) -> int:
    """The lane of the exit arm into which the last connecting road leads."""
    for routes in (network.routes[motion.entry, motion.exit], *network.routes.values()):
        for other in routes:
            if other.exit == motion.exit and other.steps[-2].road == last.road.id:
                return other.exit_lane
    return route.exit_lane

"""From a drive's numbers to the stretches that it runs over, lane changes included.

Which lane a number means: ``entry_lane`` is the lane in which the vehicle starts; lane changes
move it; it goes through the junction by the route of the lane in which it arrives there (and of
``ring_lane``, its first ring lane); ``exit_lane`` is the lane in which it ends.
"""

from dataclasses import replace

from scegen.errors import MotionInfeasibleError
from scegen.motion.alongside import along_plain
from scegen.motion.lanes import arm_lane_id, is_ring, ring_lane_id, ring_lane_number
from scegen.motion.stretches import ROUNDING_M, Stretch, Walk
from scegen.road.model import RoadNetwork, Route, RouteStep
from scegen.scenario.concrete import DriveMotion


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
    walk = Walk(network, motion, who)
    if network.plain:
        along_plain(walk)
    else:
        _through(walk)
    return tuple(walk.done), walk.lane


def _check_order(motion: DriveMotion, who: str) -> None:
    before = motion.start_m
    for change in motion.lane_changes:
        if change.position_m < before - ROUNDING_M:
            raise MotionInfeasibleError(
                f"the lane change at {change.position_m:.1f} m starts before {before:.1f} m, "
                "where the vehicle starts or its change before ends",
                where=who,
            )
        before = change.position_m + change.length_m


def _through(walk: Walk) -> None:
    """Lay a drive through a junction: an arm, what lies between, and another arm."""
    motion = walk.motion
    _along_arm(walk, motion.entry, inbound=True)
    route = _choose_route(walk, walk.lane)
    steps = list(route.steps[1:-1])
    while steps:
        steps = _along_step(walk, steps, route)
    walk.lane = _exit_number(walk.network, motion, route, walk.done[-1])
    _along_arm(walk, motion.exit, inbound=False)
    for change in walk.todo:
        raise _refused(walk, change.position_m, change.length_m)


def _along_arm(walk: Walk, arm: int, *, inbound: bool) -> None:
    """Lay an arm with its changes of lane."""
    road = walk.network.arm_road(arm)

    def step(number: int) -> RouteStep:
        return RouteStep(road.id, arm_lane_id(road, number, inbound=inbound), forward=inbound)

    walk.lay(step)
    _check_room(walk)
    if walk.lane == 0:
        raise MotionInfeasibleError(
            f"the vehicle is still in the oncoming lane at the end of {road.name}",
            where=walk.who,
            hint="Add a lane change back to lane 1.",
        )


def _along_step(walk: Walk, steps: list[RouteStep], route: Route) -> list[RouteStep]:
    """Lay the first step; returns those that remain, by another lane after a ring change."""
    way, rest = steps[0], steps[1:]
    road, changes = walk.network.road(way.road), len(walk.moved)
    if is_ring(road):
        walk.lane = ring_lane_number(road, way.lane)
        walk.lay(lambda number: replace(way, lane=ring_lane_id(road, number)))
    else:
        walk.lay(lambda _: way)
    _check_room(walk, changes_here=is_ring(road))
    for *_, (_, after) in walk.moved[changes:]:
        rest = _rest_from(walk, road.id, after, route)
    return rest


def _check_room(walk: Walk, *, changes_here: bool = True) -> None:
    """Every change of lane lies wholly on one road, and on one where that can be done."""
    piece = walk.done[-1]
    for shift in piece.shifts:
        if not changes_here or shift.end_m > piece.end_m + ROUNDING_M:
            raise _refused(walk, shift.u_m, shift.length_m)


def _refused(walk: Walk, begins_m: float, length_m: float) -> MotionInfeasibleError:
    piece = walk.done[-1]
    room = f"{piece.road.name} has room from {piece.start_m:.1f} to {piece.end_m:.1f} m"
    return MotionInfeasibleError(
        f"the lane change from {begins_m:.1f} to {begins_m + length_m:.1f} m does not lie wholly "
        f"on one road outside the junction: {room} ({piece.end_m - piece.start_m:.1f} m)",
        where=walk.who,
        hint="Move it, shorten it or choose a longer road.",
    )


def _rest_from(walk: Walk, road_id: int, lane: int, route: Route) -> list[RouteStep]:
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


def _choose_route(walk: Walk, lane: int) -> Route:
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

"""Crossings: arms that meet in one junction, joined lane by lane."""

from collections.abc import Callable, Mapping
from math import pi, radians

from scegen.errors import RoadInfeasibleError
from scegen.road.cross_section import (
    CONNECTING_ROADS_FROM,
    JUNCTIONS_FROM,
    arm_line,
    arm_road,
    lane_in,
    lane_out,
    pose_in,
    pose_out,
    side_sign,
)
from scegen.road.fillet import connect, reach_m, smallest_radius_m, turn_back, wrapped
from scegen.road.geometry import ReferenceLine
from scegen.road.lane_choice import LaneWay, lane_ways
from scegen.road.links import LaneEnd, arm_route, connecting_road
from scegen.road.model import (
    Connection,
    JunctionArea,
    Road,
    RoadLink,
    RoadNetwork,
    Route,
    RouteStep,
)
from scegen.road.spacing import CLOSE_DISTANCE_M, MAX_DISTANCE_M, arm_distances_m
from scegen.scenario.road_parameters import RoadParameters

MIN_RADIUS_M = 3.0
"""No connecting road bends tighter than this."""
U_TURN_RADIUS_M = 4.0
_STEP_M = 1.0
_ALIKE_M = 0.01
_SWAY_RAD = radians(15.0)
"""A way that turns by less is nearly straight, and may shift sideways in an S-curve."""


def build_crossing(parameters: RoadParameters, name: str) -> RoadNetwork:
    """Arms joined in one junction at the origin.

    Raises:
        RoadInfeasibleError: if arms are too close, or a way would bend too tightly.
    """
    _check_corner(parameters)
    ways = _ways(parameters)
    arms, lines = _settle(parameters, ways)
    roads: list[Road] = list(arms)
    connections: list[Connection] = []
    routes: dict[tuple[int, int], list[Route]] = {}
    for number, way in enumerate(sorted(ways)):
        source = LaneEnd(arms[way.entry], lane_in(arms[way.entry], way.lane_in))
        target = LaneEnd(arms[way.exit], lane_out(arms[way.exit], way.lane_out))
        road = connecting_road(
            CONNECTING_ROADS_FROM + number, JUNCTIONS_FROM, lines[way], source, target
        )
        roads.append(road)
        lane = road.lanes[0].id
        connections.append(Connection(number, source.road.id, road.id, source.lane, lane))
        ends, through = (way.entry, way.exit), RouteStep(road.id, lane, forward=True)
        route = arm_route(arms, ends, (way.lane_in, way.lane_out), [through])
        routes.setdefault(ends, []).append(route)
    return RoadNetwork(
        name=name,
        driving_side=parameters.driving_side,
        roads=tuple(roads),
        junctions=(JunctionArea(JUNCTIONS_FROM, "crossing", tuple(connections)),),
        arm_roads=tuple(road.id for road in arms),
        routes={pair: tuple(found) for pair, found in sorted(routes.items())},
    )


def _ways(parameters: RoadParameters) -> dict[LaneWay, float | None]:
    """All ways, and the radii that are asked of them."""
    ways: dict[LaneWay, float | None] = dict.fromkeys(
        lane_ways(parameters.arms, parameters.driving_side)
    )
    special = {LaneWay(t.entry, t.lane_in, t.exit, t.lane_out): t for t in parameters.turns}
    for way in special:
        _check_turn(parameters, way)
    back = {way.entry for way in special if way.entry == way.exit}
    ways |= dict.fromkeys(LaneWay(arm, 1, arm, 1) for arm in parameters.u_turns - back)
    return ways | {way: turn.radius_m for way, turn in special.items()}


def _check_turn(parameters: RoadParameters, way: LaneWay) -> None:
    count = len(parameters.arms)
    if max(way.entry, way.exit) >= count:
        msg = f"there is no arm {max(way.entry, way.exit)}; arms are 0 to {count - 1}"
        raise RoadInfeasibleError(msg, where="turns")
    if way.entry == way.exit and way.entry not in parameters.u_turns:
        msg = f"a turn leads back to arm {way.entry}, where u_turns allows none"
        raise RoadInfeasibleError(msg, where="turns")
    entry, leaving = parameters.arms[way.entry], parameters.arms[way.exit]
    if way.lane_in > entry.lanes_in or way.lane_out > leaving.lanes_out:
        msg = (
            f"no way from lane {way.lane_in} of {entry.lanes_in} on arm {way.entry} to lane "
            f"{way.lane_out} of {leaving.lanes_out} on arm {way.exit}"
        )
        raise RoadInfeasibleError(msg, where="turns")


def _check_corner(parameters: RoadParameters) -> None:
    """Traffic turns half a lane outside the kerb; that must be wide enough."""
    radius = parameters.corner_radius_m
    width = min(arm.lane_width_m for arm in parameters.arms)
    if radius is not None and radius + width / 2 < MIN_RADIUS_M:
        msg = (
            f"a kerb radius of {radius:g} m lets traffic turn at {radius + width / 2:.2f} m, "
            f"less than {MIN_RADIUS_M:g} m"
        )
        raise RoadInfeasibleError(msg, where="corner_radius_m")


def _settle(
    parameters: RoadParameters, ways: Mapping[LaneWay, float | None]
) -> tuple[tuple[Road, ...], dict[LaneWay, ReferenceLine]]:
    """The arm roads and the lines of the ways, arms as close as good ways allow.

    Ways that turn should do so in one go; only where the arms would have to move too far out
    for that, any way that is wide enough will do.
    """
    try:
        return _moved_out(parameters, ways, CLOSE_DISTANCE_M, _is_good)
    except RoadInfeasibleError:
        return _moved_out(parameters, ways, MAX_DISTANCE_M, _is_wide)


def _moved_out(
    parameters: RoadParameters,
    ways: Mapping[LaneWay, float | None],
    limit_m: float,
    suits: Callable[[ReferenceLine], bool],
) -> tuple[tuple[Road, ...], dict[LaneWay, ReferenceLine]]:
    """Move arms outwards until every way suits."""
    distances = list(arm_distances_m(parameters))
    link = RoadLink("junction", JUNCTIONS_FROM)
    while True:
        arms = tuple(
            arm_road(parameters, arm, arm_line(arm, distance), link)
            for arm, distance in zip(parameters.arms, distances, strict=True)
        )
        lines = {way: _line(arms, way, radius) for way, radius in ways.items()}
        tight = [
            way
            for way, line in lines.items()
            if line is None or not suits(line) or _too_far(line, way, distances)
        ]
        if not tight:
            return arms, {way: line for way, line in lines.items() if line is not None}
        # The end nearer to the centre is the one in the way.
        pairs = [(way.entry, way.exit) for way in tight]
        pairs += [(leaving, entry) for entry, leaving in pairs]
        moved = {arm for arm, other in pairs if distances[arm] < distances[other] + _ALIKE_M}
        for arm in moved:
            distances[arm] += _STEP_M
        if max(distances[arm] for arm in moved) > limit_m:
            way = tight[0]
            msg = (
                f"no way from lane {way.lane_in} of arm {way.entry} to lane {way.lane_out} of arm "
                f"{way.exit} bends at {MIN_RADIUS_M:g} m or more with the arms ending within "
                f"{limit_m:g} m of the centre"
            )
            raise RoadInfeasibleError(msg, where="arms")


def _line(arms: tuple[Road, ...], way: LaneWay, radius_m: float | None) -> ReferenceLine | None:
    entry, leaving = arms[way.entry], arms[way.exit]
    start = pose_in(entry, way.lane_in)
    if way.entry != way.exit:
        return connect(start, pose_out(leaving, way.lane_out), radius_m)
    separation = abs(
        entry.lane_centre_t_m(lane_in(entry, way.lane_in))
        - entry.lane_centre_t_m(lane_out(entry, way.lane_out))
    )
    return turn_back(start, separation, radius_m or U_TURN_RADIUS_M, side_sign(entry.driving_side))


def _is_wide(line: ReferenceLine) -> bool:
    return smallest_radius_m(line) >= MIN_RADIUS_M


def _is_good(line: ReferenceLine) -> bool:
    """Wide, and no S-curve where the way turns; U-turns are bulbs and may be."""
    signs = [segment.curvature_1pm > 0 for segment in line.segments if segment.curvature_1pm]
    turn = abs(wrapped(line.end.heading_rad - line.start.heading_rad))
    sways = any(signs) and not all(signs) and _SWAY_RAD < turn < pi - _SWAY_RAD
    return _is_wide(line) and not sways


def _too_far(line: ReferenceLine, way: LaneWay, distances: list[float]) -> bool:
    """A U-turn must not reach beyond the centre."""
    return way.entry == way.exit and reach_m(line) > distances[way.entry]

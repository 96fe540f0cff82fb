"""Ways that cross because their curves swing wide, as seen on the drawn road.

Whether two ways must cross follows from the order of their ends round the junction. Between arms
that lie close together, a curve may beside that swing over another way and back: two cars there
are in each other's way as much as at any crossing.
"""

from functools import lru_cache
from itertools import combinations, pairwise

import numpy as np
import shapely

from scegen.errors import RoadInfeasibleError
from scegen.road import build_network, plan_road
from scegen.road.model import RoadNetwork, Route, RouteStep
from scegen.scenario.arms import arm_angles_deg
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import JunctionKind

CLOSE_DEG = 45.0
"""Arms at least this far apart leave every curve room (property-tested over random roads)."""
NEAR_M = 0.1
"""Centre lines this near to each other meet: two cars do not fit side by side there."""
_STEP_M = 0.5

Ways = tuple[int, int, int, int]
"""Entry and exit of one vehicle, entry and exit of another."""


@lru_cache(maxsize=64)
def curves_that_meet(junction: Junction, *, u_turns: bool = False) -> frozenset[Ways]:
    """Pairs of ways from different arms to different arms whose centre lines meet as drawn.

    The road is the one that the description's junction gets by default. Empty where all arms lie
    well apart, and where no such road can be built. With ``u_turns``, these are drawn too: they
    swing out far, however the arms lie.
    """
    if junction.kind in {JunctionKind.ROUNDABOUT, JunctionKind.STRAIGHT}:
        return frozenset()
    angles = arm_angles_deg(junction)
    gaps = [b - a for a, b in pairwise((*angles, angles[0] + 360.0))]
    found = _meeting(junction, frozenset()) if min(gaps) < CLOSE_DEG else frozenset()
    if u_turns:
        drawn = _meeting(junction, frozenset(range(junction.arms)))
        found |= {(e, x, f, y) for e, x, f, y in drawn if e == x or f == y}
    return found


def _meeting(junction: Junction, u_turns: frozenset[int]) -> frozenset[Ways]:
    try:
        network = build_network(plan_road(junction, u_turns=u_turns))
    except RoadInfeasibleError:
        return frozenset()
    lines = {
        way: shapely.multilinestrings([_centre_line(network, route) for route in routes])
        for way, routes in network.routes.items()
    }
    return frozenset(
        (*way, *other)
        for way, other in combinations(sorted(lines), 2)
        if way[0] != other[0]
        and way[1] != other[1]
        and shapely.dwithin(lines[way], lines[other], NEAR_M)
    )


def _centre_line(network: RoadNetwork, route: Route) -> shapely.LineString:
    points = [point for step in route.steps for point in _points(network, step)]
    return shapely.linestrings(np.array(points))


def _points(network: RoadNetwork, step: RouteStep) -> list[tuple[float, float]]:
    """Arms of a crossing are straight: their ends will do."""
    road = network.road(step.road)
    count = 1 if road.junction is None else max(1, round(road.length_m / _STEP_M))
    poses = [network.pose_at(step, road.length_m * k / count) for k in range(count + 1)]
    return [(pose.x_m, pose.y_m) for pose in poses]

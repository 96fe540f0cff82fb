"""How long amber and the time between two greens are.

Sources: [RiLSA] FGSV, Richtlinien fuer Lichtsignalanlagen (2010), 2.4 and 2.5: amber 3 s at
50 km/h, 4 s at 60, 5 s at 70; the time between greens is the crossing time (3 s straight on, 2 s
turning) plus the clearing time ((way + 6 m) / 10 m/s straight on, 7 m/s turning) less the entering
time (way at 40 km/h) of the worst pair of ways (*). The same sum as the red clearance of [ITE],
Traffic Signal Timing Manual (FHWA, 2008), 5.4.2, less the entering time. (*) quoted from memory:
the text itself could not be consulted.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import permutations
from math import ceil

import numpy as np
from numpy.typing import NDArray

from scegen.motion.lanes import is_ring
from scegen.road.model import RoadNetwork, Route
from scegen.units import speed_mps

LEAST_GREEN_S = 10.0
"""Above the 5 s of [RiLSA]: so long that several pass."""
LEAST_GREEN_AFOOT_S = 5.0
"""The least of [RiLSA], 2.7.2 (*); [ITE], 6.4, asks for 4 to 7 s (*)."""
_WALKS_MPS = 1.2
"""People on foot clear a road so fast: [RiLSA], 2.5 (*); 3.5 ft/s = 1.07 m/s in [ITE]."""
_AMBER_S = ((50.0, 3.0), (60.0, 4.0))
_AMBER_FASTEST_S = 5.0
_CROSSING_S, _TURNING_S = 3.0, 2.0
_CLEARS_MPS, _TURNING_MPS = 10.0, 7.0
_VEHICLE_M = 6.0
_ENTERS_MPS = 40.0 / 3.6
_SAMPLE_M, _NEAR_M = 1.0, 2.5
_BENDS_RAD = 0.5
_LEAST_RED_S = 1.0


def amber_s(limit_mps: float) -> float:
    """How long amber is shown before red."""
    for limit_kph, seconds in _AMBER_S:
        if limit_mps <= speed_mps(limit_kph, "km/h") + 0.1:
            return seconds
    return _AMBER_FASTEST_S


@dataclass(frozen=True)
class _Through:
    """A way through the junction from the stop line on: places along it, whether it turns."""

    arm: int
    way_m: NDArray[np.float64]
    x_m: NDArray[np.float64]
    y_m: NDArray[np.float64]
    turns: bool


def walked_s(network: RoadNetwork, arm: int) -> float:
    """How long people on foot take to clear an arm."""
    road = network.arm_road(arm)
    return ceil(2 * abs(road.edge_t_m(1) - road.edge_t_m(-1)) / _WALKS_MPS) / 2


def all_red_s(network: RoadNetwork, phases: Sequence[int], amber: float) -> float:
    """How long everybody has red between the amber of one phase and the green of the next."""
    ways = _ways(network)
    longest = _LEAST_RED_S
    for first, second in permutations(ways, 2):
        if phases[first.arm] == phases[second.arm]:
            continue
        met = _last_meeting(first, second)
        if met is None:
            continue
        clears_m, enters_m = met
        mps, crossing = (_TURNING_MPS, _TURNING_S) if first.turns else (_CLEARS_MPS, _CROSSING_S)
        between = crossing + (clears_m + _VEHICLE_M) / mps - enters_m / _ENTERS_MPS
        longest = max(longest, between - amber)
    return ceil(longest * 2) / 2


def _last_meeting(first: _Through, second: _Through) -> tuple[float, float] | None:
    """How far the first has to go to clear the second's way, and the second to get there."""
    near = (
        np.hypot(first.x_m[:, None] - second.x_m[None, :], first.y_m[:, None] - second.y_m[None, :])
        < _NEAR_M
    )
    if not near.any():
        return None
    return float(first.way_m[near.any(axis=1)].max()), float(second.way_m[near.any(axis=0)].min())


def _ways(network: RoadNetwork) -> list[_Through]:
    """One for every two arms: lanes beside each other differ by less than is rounded up."""
    return [
        _through(network, entry, routes[0])
        for (entry, _), routes in sorted(network.routes.items())
        if routes
    ]


def _through(network: RoadNetwork, entry: int, route: Route) -> _Through:
    """In a roundabout, as far as the ring: who is on it is past the lights."""
    way = network.arm_road(entry).stop_line_m
    rows: list[tuple[float, float, float, float]] = []
    for step in route.steps[1:-1]:
        road = network.road(step.road)
        for along in np.arange(0.0, road.length_m, _SAMPLE_M):
            pose = network.pose_at(step, float(along))
            rows.append((way + float(along), pose.x_m, pose.y_m, pose.heading_rad))
        way += road.length_m
        if is_ring(road):
            break
    turn = (rows[-1][3] - rows[0][3] + np.pi) % (2 * np.pi) - np.pi if rows else 0.0
    places, xs, ys, _ = np.array(rows).reshape(-1, 4).T
    return _Through(entry, places, xs, ys, abs(turn) > _BENDS_RAD)

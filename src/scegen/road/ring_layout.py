"""Where the arms of a roundabout meet its ring.

Each arm has a small junction that spans the angle ``half_rad`` to either side of the arm's axis;
between neighbouring junctions the ring is a road.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import cos, pi, radians, sin, tan

import numpy as np

from scegen.errors import RoadInfeasibleError
from scegen.road.cross_section import lane_centre_m
from scegen.road.spacing import MAX_DISTANCE_M, gap_to_next_deg, narrowest_gap, strip_distances_m
from scegen.scenario.road_parameters import ArmRoad, RoadParameters

FIRST_RADIUS_M = {1: 15.0, 2: 20.0}
"""Radius of the outermost lane's centre to start from, by number of ring lanes."""
MAX_RING_RADIUS_M = 60.0
MIN_RING_ROAD_M = 4.0
TURN_RADII_M = (10.0, 8.0, 6.0, 5.0, 4.0)
"""Radii of the ways into and out of the ring, the first that fits."""
WIDE_TURN_RADII_M = tuple(range(40, 10, -1))
"""Where a ring of one lane is larger than it has to be, its ways in and out are wider, too."""
_STEP_RAD = radians(0.5)
_WIDEST_RAD = radians(75.0)
_SPLITTER_M = 1.0


@dataclass(frozen=True, slots=True)
class RingLayout:
    """Radii of the ring lanes' centres (innermost first), and per arm its angle and distance."""

    radii_m: tuple[float, ...]
    lane_width_m: float
    half_rad: tuple[float, ...]
    distances_m: tuple[float, ...]


def lay_out_ring(parameters: RoadParameters) -> RingLayout:
    """The smallest ring that holds all arms, or the one with the given radius.

    Raises:
        RoadInfeasibleError: if the ring is too small for its arms, or arms are too close.
    """
    for radius, turn in _sizes(parameters):
        layout = _try(parameters, radius, turn)
        if layout is not None:
            return _checked(parameters, layout)
    arms, index = parameters.arms, narrowest_gap(parameters.arms)
    following, gap_deg = (index + 1) % len(arms), gap_to_next_deg(arms, index)
    if parameters.ring_radius_m is None:
        msg = (
            f"arms {index} and {following} lie only {gap_deg:.1f} deg apart: even a ring of "
            f"{MAX_RING_RADIUS_M:g} m radius is too small for them"
        )
        raise RoadInfeasibleError(msg, where="arms")
    msg = (
        f"a ring of {parameters.ring_radius_m:g} m radius is too small for arms {index} and "
        f"{following}, {gap_deg:.1f} deg apart, with ways in and out of at least "
        f"{TURN_RADII_M[-1]:g} m radius"
    )
    raise RoadInfeasibleError(msg, where="ring_radius_m", hint="Leave it out to have it chosen.")


def _sizes(parameters: RoadParameters) -> Iterator[tuple[float, float]]:
    """Radii of the ring, and of the ways into and out of it, in the order of preference."""
    given, lanes = parameters.ring_radius_m, parameters.ring_lanes
    if given is not None:
        wide = WIDE_TURN_RADII_M if lanes == 1 else ()  # two need room to change
        yield from ((given, turn) for turn in (*wide, *TURN_RADII_M))
        return
    for turn in TURN_RADII_M:
        # A wider turn needs a wider ring: prefer a compact roundabout to a gentle one.
        limit = MAX_RING_RADIUS_M if turn == TURN_RADII_M[-1] else MAX_RING_RADIUS_M / 2
        yield from ((r, turn) for r in np.arange(FIRST_RADIUS_M[lanes], limit + 0.5).tolist())


def _checked(parameters: RoadParameters, layout: RingLayout) -> RingLayout:
    """Neighbouring arms must part within reach of the ring."""
    worst = max(range(len(layout.distances_m)), key=lambda arm: layout.distances_m[arm])
    limit = max(MAX_DISTANCE_M, 2 * layout.radii_m[-1])
    if layout.distances_m[worst] > limit:
        msg = (
            f"arm {parameters.arms[worst].id} parts from its neighbour only "
            f"{layout.distances_m[worst]:.1f} m from the centre, more than {limit:g} m"
        )
        raise RoadInfeasibleError(msg, where="arms")
    return layout


def _try(parameters: RoadParameters, radius_m: float, turn_radius_m: float) -> RingLayout | None:
    """The layout with this outermost radius, None if it does not fit."""
    arms = parameters.arms
    width = max(arm.lane_width_m for arm in arms)
    radii = tuple(radius_m - width * k for k in reversed(range(parameters.ring_lanes)))
    if radii[0] < turn_radius_m + width:
        return None
    halves: list[float] = []
    distances: list[float] = []
    for arm, strips_m in zip(arms, strip_distances_m(parameters), strict=True):
        found = _arm_fit(arm, radii, turn_radius_m)
        if found is None:
            return None
        half, reach = found
        halves.append(half)
        distances.append(max(reach, strips_m, radii[-1] + width / 2 + _SPLITTER_M))
    for index, half in enumerate(halves):
        following = halves[(index + 1) % len(halves)]
        free = radians(gap_to_next_deg(arms, index)) - half - following
        if free * radii[0] < MIN_RING_ROAD_M:
            return None
    return RingLayout(radii, width, tuple(halves), tuple(distances))


def _arm_fit(
    arm: ArmRoad, radii_m: tuple[float, ...], turn_radius_m: float
) -> tuple[float, float] | None:
    """Half angle and distance at which all ways of an arm bend at the radius or wider.

    In the arm's frame (x outwards), the ring's tangent at angle ``half`` meets a lane's centre
    line ``offset`` off the axis after ``tangent`` metres; one arc joins the two.
    """
    offsets = [lane_centre_m(arm, k + 1) for k in range(max(arm.lanes_in, arm.lanes_out))]
    half = _STEP_RAD
    while half <= _WIDEST_RAD:
        ways = [
            (radius, (radius * sin(half) - offset) / cos(half))
            for radius in radii_m
            for offset in offsets
        ]
        least_m = turn_radius_m * tan((pi / 2 - half) / 2)
        if all(tangent >= least_m for _, tangent in ways):
            return half, max(r * cos(half) + tangent * (sin(half) + 1) for r, tangent in ways)
        half += _STEP_RAD
    return None

"""How far from the centre each arm of a crossing ends."""

from math import cos, radians, sin, tan

from scegen.errors import RoadInfeasibleError
from scegen.road.cross_section import ALL_STRIPS, KERBED, arm_lanes, half_width_m
from scegen.scenario.road_parameters import ArmRoad, RoadParameters

MAX_DISTANCE_M = 60.0
"""Arms that part farther from the centre than this are too close to each other."""
CLOSE_DISTANCE_M = 40.0
"""Kerb radii are tightened, where they may be chosen, to let arms end within this."""
MIN_DISTANCE_M = 6.0
KERB_RADII_M = (8.0, 6.0, 5.0, 4.0, 3.0)
"""Kerb radii to choose from, the first that fits."""
_OPEN_CORNER_DEG = 150.0
"""From this angle on, neighbouring kerbs run on almost straight and need no corner."""
_STRIP_GAP_M = 0.5
_SHIFT_PER_M = 3.0
"""Length in which a lane may shift sideways by one metre at an open corner."""


def _parting_m(own_m: float, other_m: float, gap_rad: float) -> float:
    """Distance along an arm at which edges ``own_m`` and ``other_m`` off two axes meet."""
    return (other_m + own_m * cos(gap_rad)) / sin(gap_rad)


def _corner_m(
    widths: tuple[tuple[float, float], tuple[float, float]], gap_deg: float, radius_m: float
) -> tuple[float, float]:
    """Distances that one corner asks of its two arms; widths are (kerb, all strips) of each."""
    (kerb, strips), (next_kerb, next_strips) = widths
    if gap_deg >= _OPEN_CORNER_DEG:
        shift = _SHIFT_PER_M * abs(kerb - next_kerb)
        return shift, shift
    gap = radians(gap_deg)
    arc = radius_m / tan(gap / 2)
    return (
        max(
            _parting_m(kerb, next_kerb, gap) + arc,
            _parting_m(strips, next_strips, gap) + _STRIP_GAP_M,
        ),
        max(
            _parting_m(next_kerb, kerb, gap) + arc,
            _parting_m(next_strips, strips, gap) + _STRIP_GAP_M,
        ),
    )


def strip_distances_m(parameters: RoadParameters) -> list[float]:
    """Distances (m) from which on no strip of an arm overlaps another arm's, corners left out."""
    return _distances_m(parameters, 0.0)


def _distances_m(parameters: RoadParameters, radius_m: float) -> list[float]:
    arms = parameters.arms
    # Looking out from the centre, an arm's right lanes lie counter-clockwise of its axis.
    widths = {
        (arm.id, sign): (
            half_width_m(arm_lanes(parameters, arm), sign, KERBED),
            half_width_m(arm_lanes(parameters, arm), sign, ALL_STRIPS),
        )
        for arm in arms
        for sign in (-1, 1)
    }
    distances = [MIN_DISTANCE_M] * len(arms)
    for i, arm in enumerate(arms):
        j = (i + 1) % len(arms)
        gap_deg = gap_to_next_deg(arms, i)
        corner = _corner_m((widths[arm.id, -1], widths[arms[j].id, 1]), gap_deg, radius_m)
        distances[i] = max(distances[i], corner[0])
        distances[j] = max(distances[j], corner[1])
    return distances


def gap_to_next_deg(arms: tuple[ArmRoad, ...], index: int) -> float:
    """Angle from an arm to the next one, counter-clockwise (deg)."""
    following = arms[(index + 1) % len(arms)]
    return (following.angle_deg - arms[index].angle_deg) % 360.0


def narrowest_gap(arms: tuple[ArmRoad, ...]) -> int:
    """The arm that lies nearest to the next one."""
    return min(range(len(arms)), key=lambda index: gap_to_next_deg(arms, index))


def arm_distances_m(parameters: RoadParameters) -> tuple[float, ...]:
    """Distances from the centre to the inner ends of the arms (m), in arm order.

    Raises:
        RoadInfeasibleError: if arms lie so close that they part too far out.
    """
    given = parameters.corner_radius_m
    distances: list[float] = []
    for radius in (given,) if given is not None else KERB_RADII_M:
        distances = _distances_m(parameters, radius)
        if max(distances) <= CLOSE_DISTANCE_M:
            break
    else:
        radius = given if given is not None else KERB_RADII_M[-1]
    worst = max(distances)
    if worst > MAX_DISTANCE_M:
        arms = parameters.arms
        index = narrowest_gap(arms)
        following = arms[(index + 1) % len(arms)]
        msg = (
            f"arms {arms[index].id} and {following.id} lie {gap_to_next_deg(arms, index):.1f} deg "
            f"apart: with a kerb radius of {radius:g} m the roads part {worst:.1f} m from the "
            f"centre, more than {MAX_DISTANCE_M:g} m"
        )
        raise RoadInfeasibleError(
            msg, where="arms", hint="Widen the angle, use fewer lanes or a smaller corner radius."
        )
    return tuple(distances)

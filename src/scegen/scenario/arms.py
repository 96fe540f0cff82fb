"""Arms of a junction: their directions, and what a movement between two of them is called.

Arms 0..n-1 run counter-clockwise. A vehicle that enters at arm e with the symbolic move d
leaves at (e + d) mod n; d = 1 is the rightmost turn, d = 0 the U-turn.
"""

from functools import lru_cache

from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import Approach, DrivingSide, JunctionKind, Maneuver

URBAN_LIMIT_MPS = 50 / 3.6
"""The urban limit of the Vienna Convention's countries."""
STRAIGHT_WITHIN_DEG = 45.0
"""A movement that bends less than this may be called straight."""
STRAIGHT_TIE_DEG = 10.0
"""Movements that bend as little as the straightest, within this, are straight too."""

_TEMPLATE_DEG: dict[JunctionKind, tuple[float, ...]] = {
    JunctionKind.STRAIGHT: (0.0, 180.0),
    JunctionKind.T: (0.0, 180.0, 270.0),
    JunctionKind.Y: (30.0, 150.0, 270.0),
    JunctionKind.FOUR_WAY: (0.0, 90.0, 180.0, 270.0),
    JunctionKind.SKEWED: (0.0, 60.0, 180.0, 240.0),
}


def arm_angles_deg(junction: Junction) -> tuple[float, ...]:
    """Directions of the arms seen from the centre (deg, counter-clockwise from east)."""
    if junction.arm_angles_deg:
        return junction.arm_angles_deg
    if junction.bend is not None:
        limit = junction.speed_limit_mps or URBAN_LIMIT_MPS
        return 0.0, 180.0 + junction.bend.turn_deg(limit)
    if junction.kind in _TEMPLATE_DEG:
        return _TEMPLATE_DEG[junction.kind]
    return tuple(360.0 * arm / junction.arms for arm in range(junction.arms))


def exit_arm(entry: int, move: int, arms: int) -> int:
    """The arm at which a vehicle leaves."""
    return (entry + move) % arms


def ring_move(junction: Junction, number: int) -> int:
    """The symbolic move to the k-th exit of a ring, and the number of the exit to which one leads.

    Traffic goes round counter-clockwise where it keeps right, clockwise where left.
    """
    right = junction.driving_side is DrivingSide.RIGHT
    return (number if right else -number) % junction.arms


def turn_deg(angles_deg: tuple[float, ...], entry: int, move: int) -> float:
    """Change of heading through the junction (deg, left positive, in (-180, 180])."""
    leaving = angles_deg[exit_arm(entry, move, len(angles_deg))]
    turn = (leaving - angles_deg[entry] - 180.0) % 360.0
    return turn - 360.0 if turn > 180.0 else turn


@lru_cache(maxsize=4096)
def turn_name(angles_deg: tuple[float, ...], entry: int, move: int) -> Maneuver:
    """``u_turn``, ``straight``, ``left`` or ``right``, by geometry.

    The straightest movement from an arm is straight if it bends less than 45 deg, with all
    that bend as little within 10 deg; the rest turn left or right by their sign. So a Y has
    no straight movement, and a flat X has one.
    """
    arms = len(angles_deg)
    if move % arms == 0:
        return Maneuver.U_TURN
    if arms == 2:
        return Maneuver.STRAIGHT  # along the road, even in a bend
    bends = [abs(turn_deg(angles_deg, entry, d)) for d in range(1, arms)]
    bend = turn_deg(angles_deg, entry, move)
    if abs(bend) <= min(STRAIGHT_WITHIN_DEG, min(bends) + STRAIGHT_TIE_DEG):
        return Maneuver.STRAIGHT
    return Maneuver.LEFT if bend > 0 else Maneuver.RIGHT


_SEEN_FROM: dict[Maneuver, Approach] = {
    Maneuver.LEFT: Approach.LEFT,
    Maneuver.RIGHT: Approach.RIGHT,
    Maneuver.STRAIGHT: Approach.OPPOSITE,
}


def seen_from(angles_deg: tuple[float, ...], reference: int, other: int) -> frozenset[Approach]:
    """How one who enters at arm ``reference`` says where one at arm ``other`` comes from.

    On the same arm: ahead, behind or adjacent. Where no two arms face each other (a Y), every
    other arm may also be called opposite.
    """
    arms = len(angles_deg)
    if reference == other:
        return frozenset({Approach.AHEAD, Approach.BEHIND, Approach.ADJACENT})
    side = _SEEN_FROM[turn_name(angles_deg, reference, (other - reference) % arms)]
    return frozenset({side} if _faces(angles_deg) else {side, Approach.OPPOSITE})


@lru_cache(maxsize=256)
def _faces(angles_deg: tuple[float, ...]) -> bool:
    """Whether a way straight through exists between any two arms."""
    arms = range(len(angles_deg))
    return any(
        turn_name(angles_deg, entry, move) is Maneuver.STRAIGHT
        for entry in arms
        for move in arms[1:]
    )

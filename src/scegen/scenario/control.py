"""What a junction's control means on the ground: where its signs stand, which lights are green."""

from scegen.scenario.arms import arm_angles_deg, turn_deg, turn_name
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import Control, JunctionKind, Maneuver

LIGHTS = frozenset({Control.SIGNALS, Control.SIGNALS_OFF})
"""Where traffic lights stand, whether they work or not."""
STOPS = frozenset({Control.STOP, Control.ALL_WAY_STOP})
"""Whoever comes to such a sign stands before going on."""
_MINOR_ROAD = frozenset({Control.YIELD, Control.STOP})


def controlled_arms(junction: Junction) -> frozenset[int]:
    """The arms at which the control's signs or lights stand.

    Yield and stop signs face the minor road: the stem of a T, every second arm of a crossing,
    every entry of a roundabout. All other controls hold for all arms alike.
    """
    arms = range(junction.arms)
    if junction.control in {Control.UNCONTROLLED, Control.PRIORITY_TO_RIGHT}:
        return frozenset()
    everywhere = junction.kind is JunctionKind.ROUNDABOUT or junction.control not in _MINOR_ROAD
    if everywhere:
        return frozenset(arms)
    angles = arm_angles_deg(junction)
    stems = [
        arm
        for arm in arms
        if all(
            turn_name(angles, arm, move) is not Maneuver.STRAIGHT
            for move in range(1, junction.arms)
        )
    ]
    if stems and len(stems) < junction.arms:
        return frozenset(stems)
    return frozenset(arms[1::2])


def oncoming_arms(junction: Junction) -> frozenset[tuple[int, int]]:
    """Pairs of arms (both ways round) whose traffic comes towards each other.

    From either arm the way to the other is called straight.
    """
    angles, count = arm_angles_deg(junction), junction.arms
    return frozenset(
        (one, other)
        for one in range(count)
        for other in range(count)
        if one != other
        and turn_name(angles, one, (other - one) % count) is Maneuver.STRAIGHT
        and turn_name(angles, other, (one - other) % count) is Maneuver.STRAIGHT
    )


def signal_phases(junction: Junction) -> tuple[int, ...]:
    """The phase in which each arm has green: arms that face each other share one.

    Of several arms that face one, the straightest shares. The plain two-phase plan of a
    crossing, with left turns (right turns where traffic keeps left) that filter through the
    oncoming traffic: permissive left turns in FHWA, Traffic Signal Timing Manual (2008), chapter 4.
    """
    angles, count = arm_angles_deg(junction), junction.arms
    facing = oncoming_arms(junction)
    phases: dict[int, int] = {}
    for arm in range(count):
        if arm in phases:
            continue
        free = [other for other in range(count) if (arm, other) in facing and other not in phases]
        phases[arm] = number = len(set(phases.values()))
        if free:
            bends = {other: abs(turn_deg(angles, arm, (other - arm) % count)) for other in free}
            phases[min(free, key=lambda other: (round(bends[other], 6), other))] = number
    return tuple(phases[arm] for arm in range(count))


def has_crosswalk(junction: Junction, arm: int) -> bool:
    """Whether somebody who crosses an arm does so on a marked crosswalk.

    Where the description names one; and at every junction, where the road gets a crosswalk
    wherever somebody crosses. On an open road people cross anywhere.
    """
    return junction.kind is not JunctionKind.STRAIGHT or arm in junction.crosswalks

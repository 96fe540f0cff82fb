"""Who waits in a circle: the rule of deadlock.lp for one scenario, without a solver run each."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from scegen.enumeration.right_of_way import RoadRules
from scegen.scenario.logical import MEETING, Assignment, Conflict, Drive
from scegen.scenario.vocabulary import Maneuver


def may_be_stuck(rules: RoadRules, assignment: Assignment) -> bool:
    """Whether somebody can be in a deadlock: first on its arm, on a way that one can hold up.

    Those behind wait for their own leader, and reach the line when the leaders are through.
    """
    return (
        isinstance(assignment, Drive)
        and assignment.rank == 0
        and assignment.maneuver is not Maneuver.STAY
        and (assignment.entry, assignment.exit) in rules.stuck
    )


def deadlock_among(names: Sequence[str], conflicts: Iterable[Conflict]) -> tuple[str, ...]:
    """Those of the named who wait for another of them in a circle, in the order of the names."""
    number = {name: index for index, name in enumerate(names)}
    behind = [0] * len(names)  # a bit for everybody who is waited for
    for conflict in conflicts:
        if conflict.yields is None or conflict.kind not in MEETING:
            continue
        other = conflict.second if conflict.yields == conflict.first else conflict.first
        if other in number and conflict.yields in number:
            behind[number[conflict.yields]] |= 1 << number[other]
    for via in range(len(names)):
        for one, reached in enumerate(behind):
            if reached >> via & 1:
                behind[one] |= behind[via]
    return tuple(name for name, index in number.items() if behind[index] >> index & 1)

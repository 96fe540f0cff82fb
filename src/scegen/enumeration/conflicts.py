"""Where two participants meet, and who of them waits in a circle."""

from collections.abc import Iterable, Sequence
from collections.abc import Set as AbstractSet
from functools import lru_cache

from scegen.enumeration.right_of_way import RoadRules, right_of_way
from scegen.scenario.logical import (
    MEETING,
    Assignment,
    Conflict,
    ConflictKind,
    Crossing,
    Drive,
    Rule,
)
from scegen.scenario.vocabulary import Maneuver


def conflict_between(
    rules: RoadRules,
    first: Assignment,
    second: Assignment,
    on_call: AbstractSet[str] = frozenset(),
) -> Conflict | None:
    """The conflict of two participants and who yields, None if their paths do not meet.

    To those ``on_call`` everybody else gives way (VC 34.1).
    """
    kind = _kind(rules, first, second)
    if kind is ConflictKind.NONE:
        return None
    names = first.participant, second.participant
    others = [name for name in names if name not in on_call]
    if kind in MEETING and len(others) == 1:
        return _met(*names, kind, others[0], Rule.ON_CALL)
    return _met(*names, kind, *right_of_way(rules, first, second))


@lru_cache(maxsize=65_536)
def _met(
    first: str, second: str, kind: ConflictKind, yields: str | None, rule: Rule | None
) -> Conflict:
    """Forty cars meet a million times, but not in many different ways."""
    return Conflict(first=first, second=second, kind=kind, yields=yields, rule=rule)


def _kind(rules: RoadRules, first: Assignment, second: Assignment) -> ConflictKind:
    if not isinstance(first, Drive):
        first, second = second, first
    if not isinstance(first, Drive):
        return ConflictKind.NONE
    if isinstance(second, Drive):
        stands = Maneuver.STAY in {first.maneuver, second.maneuver}
        if stands and first.entry != second.entry:
            return ConflictKind.NONE
        ways = (first.entry, first.exit, second.entry, second.exit)
        return rules.kinds.get(ways, ConflictKind.NONE)
    if isinstance(second, Crossing):
        meets = second.arm in {first.entry, first.exit}
        return ConflictKind.CROSSING if meets else ConflictKind.NONE
    blocked = second.in_lane and second.arm == (
        first.entry if second.side is rules.kerb else first.exit
    )
    return ConflictKind.FOLLOWING if blocked else ConflictKind.NONE


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

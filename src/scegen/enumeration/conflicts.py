"""How paths meet: the table of conflicts.lp, looked up for the participants of a scenario."""

from __future__ import annotations

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

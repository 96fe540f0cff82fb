"""How paths meet: the table of conflicts.lp, looked up for the participants of a scenario."""

from __future__ import annotations

from functools import lru_cache

from clorm import Predicate

from scegen.enumeration import answers as a
from scegen.enumeration import predicates as p
from scegen.enumeration.programs import Part, consequences
from scegen.scenario.functional import Junction
from scegen.scenario.logical import Assignment, Conflict, ConflictKind, Crossing, Drive, Standing
from scegen.scenario.vocabulary import DrivingSide, JunctionKind

Ways = tuple[int, int, int, int]
"""Entry and exit of one vehicle, entry and exit of another."""


def conflict_table(junction: Junction) -> dict[Ways, ConflictKind]:
    """For every pair of ways through the junction that meet, how they do."""
    return _table(
        junction.arms,
        junction.kind is JunctionKind.ROUNDABOUT,
        junction.driving_side is DrivingSide.LEFT,
    )


@lru_cache(maxsize=64)
def _table(arms: int, ring: bool, left_hand: bool) -> dict[Ways, ConflictKind]:
    facts: list[Predicate] = [p.Arms(arms)]
    facts += [p.Ring()] if ring else []
    facts += [p.LeftHand()] if left_hand else []
    return {
        (fact.entry, fact.exit, fact.other_entry, fact.other_exit): ConflictKind(fact.kind)
        for fact in consequences(facts, (Part.ARMS, Part.CONFLICTS), (a.Meets,))
    }


def conflict_between(
    table: dict[Ways, ConflictKind], first: Assignment, second: Assignment
) -> Conflict | None:
    """The conflict of two participants, None if their paths do not meet."""
    kind = _kind(table, first, second)
    if kind is ConflictKind.NONE:
        return None
    return Conflict(first=first.participant, second=second.participant, kind=kind)


def _kind(table: dict[Ways, ConflictKind], first: Assignment, second: Assignment) -> ConflictKind:
    if not isinstance(first, Drive):
        first, second = second, first
    if not isinstance(first, Drive):
        return ConflictKind.NONE
    if isinstance(second, Drive):
        ways = (first.entry, first.exit, second.entry, second.exit)
        return table.get(ways, ConflictKind.NONE)
    if isinstance(second, Crossing):
        meets = second.arm in {first.entry, first.exit}
        return ConflictKind.CROSSING if meets else ConflictKind.NONE
    return _behind_obstacle(first, second)


def _behind_obstacle(drive: Drive, standing: Standing) -> ConflictKind:
    blocked = standing.in_lane and standing.arm == drive.entry
    return ConflictKind.FOLLOWING if blocked else ConflictKind.NONE

"""What thousands of scenarios have in common is made once: who drives how, and who meets whom.

A scenario is little more than a row of references to immutable parts. A part is what one
participant does; two parts determine their conflict, and when the one arrives at the other.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any, TypeVar

from scegen.enumeration.conflicts import conflict_between, deadlock_among, may_be_stuck
from scegen.enumeration.on_foot import Place
from scegen.enumeration.problem import Problem
from scegen.enumeration.ranges import offset_range, speed_range
from scegen.enumeration.reading import Way
from scegen.enumeration.right_of_way import road_rules
from scegen.scenario.arms import exit_arm, turn_name
from scegen.scenario.logical import (
    Assignment,
    Conflict,
    ConflictKind,
    Crossing,
    Drive,
    Reverses,
    Standing,
    Walking,
)
from scegen.scenario.parameters import ParameterRange
from scegen.scenario.vocabulary import Maneuver, Side

MOST_DEADLOCKS = 4096
"""Deadlocks that are kept."""
MOST_PAIRS = 400_000
"""Pairs that are kept (some 100 MB at the very most); then they are made anew."""

_SIDEWAYS = {Maneuver.LANE_CHANGE, Maneuver.MERGE, Maneuver.EXIT}
_MANNERS = {m.value: m for m in (Maneuver.OVERTAKE, Maneuver.STAY)}
_CHANGES = {f"lane_change_{side.value}": side for side in Side}
_REVERSES = {r.value: r for r in Reverses}


K = TypeVar("K")
V = TypeVar("V")


class Kept(dict[K, V]):
    """Values that are made when first asked for."""

    __slots__ = ("_make",)

    def __init__(self, make: Callable[[K], V]) -> None:
        super().__init__()
        self._make = make

    def __missing__(self, key: K) -> V:
        value = self[key] = self._make(key)
        return value


class Share:
    """What one participant does: its assignment and speed, and how it meets the others.

    ``conflicts`` are those with participants listed after it, ``offsets`` the arrivals of others
    against it; the latter are asked of the ego alone. ``may_be_stuck`` tells who can be in a
    deadlock.
    """

    __slots__ = ("assignment", "conflicts", "may_be_stuck", "offsets", "speed")

    def __init__(self, sharing: Sharing, assignment: Assignment) -> None:
        self.assignment = assignment
        self.speed = sharing.speed(assignment)
        self.may_be_stuck = may_be_stuck(sharing.rules, assignment)
        self.conflicts: Kept[Share, Conflict | None] = Kept(
            lambda other: sharing.conflict(assignment, other.assignment)
        )
        self.offsets: Kept[Share, ParameterRange | None] = Kept(
            lambda other: sharing.offset(assignment, other.assignment)
        )


def conflicts_among(shares: tuple[Share, ...]) -> tuple[Conflict, ...]:
    """All pairs whose paths meet, in the order of the participants."""
    found: list[Conflict | None] = []
    for place, first in enumerate(shares, start=1):
        found += map(first.conflicts.__getitem__, shares[place:])
    return tuple([conflict for conflict in found if conflict is not None])


def _deadlock_in(line: tuple[Share, ...]) -> tuple[str, ...]:
    return deadlock_among([share.assignment.participant for share in line], conflicts_among(line))


class Sharing:
    """The parts of all scenarios of one problem.

    ``drives`` are the shares of the vehicle in a place of the listing order, by way; ``others``
    those of who crosses an arm or stands on one.
    """

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        turns_back = any(move == 0 for found in problem.wanted.values() for move, _ in found)
        self.rules = road_rules(problem.functional.junction, u_turns=turns_back)
        self._pairs = 0
        self.full = False
        self._equal: dict[Any, Any] = {}
        self.drives: Kept[tuple[int, Place], Kept[Way, Share]] = Kept(
            lambda key: Kept(lambda way: Share(self, self._drive(way, *key)))
        )
        self.others: Kept[Crossing | Standing | Walking, Share] = Kept(
            lambda assignment: Share(self, assignment)
        )
        self._deadlock = lru_cache(maxsize=MOST_DEADLOCKS)(_deadlock_in)

    def _drive(self, way: Way, slot: int, place: Place) -> Drive:
        entry, move, manner = way
        angles = self._problem.angles_deg
        turn = turn_name(angles, entry, move)
        vehicle = self._problem.vehicles[slot]
        said = bool(vehicle.maneuvers & _SIDEWAYS)
        changes_to = _CHANGES.get(manner)
        if changes_to is None and place.beside is not None:
            other, side = place.beside
            if (vehicle.id, other) in self._problem.besides:
                changes_to = side.opposite
        return Drive(
            participant=vehicle.id,
            entry=entry,
            move=move,
            exit=exit_arm(entry, move, len(angles)),
            turn=turn,
            maneuver=Maneuver.LANE_CHANGE
            if manner in _CHANGES and said
            else _MANNERS.get(manner, turn),
            changes_to=changes_to,
            circulating=vehicle.circulating,
            reverses=_REVERSES.get(manner),
            **place.fields(),
        )

    def deadlock(self, shares: tuple[Share, ...]) -> tuple[str, ...]:
        """Those of whom each must wait for another of them, among those who may be stuck."""
        return self._deadlock(tuple([share for share in shares if share.may_be_stuck]))

    def speed(self, assignment: Assignment) -> ParameterRange | None:
        """How fast a participant may be, None if it stands."""
        if isinstance(assignment, Standing):
            return None
        return self._one(speed_range(self._problem.functional, assignment))

    def conflict(self, first: Assignment, second: Assignment) -> Conflict | None:
        """How two participants meet."""
        self._pairs += 1
        self.full = self._pairs > MOST_PAIRS
        return conflict_between(self.rules, first, second, self._problem.functional.on_call)

    def forget(self) -> None:
        """Let go of all shares: too many are made anew, not piled up."""
        self._pairs, self.full = 0, False
        self.drives.clear()
        self.others.clear()
        self._deadlock.cache_clear()

    def offset(self, ego: Assignment, other: Assignment) -> ParameterRange | None:
        """When another participant arrives, against the ego."""
        met = conflict_between(self.rules, ego, other)
        kind = ConflictKind.NONE if met is None else met.kind
        return self._one(offset_range(self._problem.functional, ego, other, kind))

    def _one(self, part: V) -> V:
        """Of equal parts the one that was made first."""
        found: V = self._equal.setdefault(part, part)
        return found

"""Ways to place vehicles that share nothing but the room on the arms and the number in a group.

Kinds of vehicles are placed one after the other, and states that leave equal room are one. So the
work grows with the number of ways to leave room, not with the number of ways to place.
"""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple, TypeVar

from scegen.enumeration.patterns import Row
from scegen.errors import InputError

MAX_STATES = 100_000
"""More ways to leave room than this are not counted: it would take minutes."""


class Room(NamedTuple):
    """What is left: vehicles that fit on each arm, and members of each group still to do it.

    ``arms`` is empty where all fit on one arm.
    """

    arms: tuple[int, ...]
    groups: tuple[int, ...]

    def after(self, place: int, number: int, uses: tuple[int, ...]) -> Room | None:
        """The room after so many more in a place, each using up groups; None if they do not fit."""
        arms, groups = self.arms, self.groups
        if arms:
            if number > arms[place]:
                return None
            arms = (*arms[:place], arms[place] - number, *arms[place + 1 :])
        if groups:
            groups = tuple(left - number * use for left, use in zip(groups, uses, strict=True))
            if min(groups) < 0:
                return None
        return Room(arms, groups)


class Slot(NamedTuple):
    """A place, the members of each group that one who chooses here uses up, the choices here."""

    place: int
    uses: tuple[int, ...]
    choices: int


@dataclass(frozen=True)
class Kind:
    """Vehicles that are placed alike and not told apart: ``members`` in number.

    Who uses a slot once takes ``share`` members and one place: 1, or under a rotation as many as
    it carries round.
    """

    members: int
    share: int
    slots: tuple[Slot, ...]

    def merged(self) -> Kind:
        """The same where all arms hold everybody: slots of equal use are one."""
        choices: Counter[tuple[int, ...]] = Counter()
        for slot in self.slots:
            choices[slot.uses] += slot.choices
        slots = tuple(Slot(0, uses, number) for uses, number in sorted(choices.items()))
        return Kind(self.members, self.share, slots)

    @property
    def alike(self) -> bool:
        """Whether all places are the same to it."""
        per_place: defaultdict[int, set[tuple[tuple[int, ...], int]]] = defaultdict(set)
        for slot in self.slots:
            per_place[slot.place].add((slot.uses, slot.choices))
        return len({frozenset(found) for found in per_place.values()}) == 1


def placements(kinds: Sequence[Kind], room: Room) -> int:
    """Ways to place all and to choose their moves, so that every group has its number.

    Raises:
        InputError: there are too many ways to leave room.
    """
    if not room.arms:
        kinds = [kind.merged() for kind in kinds]
    states: dict[Room, int] = {room: 1}
    for kind in sorted(kinds, key=lambda kind: kind.alike):
        following: defaultdict[Room, int] = defaultdict(int)
        for before, times in states.items():
            for after, ways in _spread(kind, before):
                # Who is still to come sees all places alike, so their order no longer matters.
                key = Room(tuple(sorted(after.arms)), after.groups) if kind.alike else after
                following[key] += times * ways
        states = _bounded(following)
    return sum(times for left, times in states.items() if not any(left.groups))


def rows_of_placements(
    vehicles: Sequence[Sequence[tuple[int, tuple[int, ...], Row]]], room: Room
) -> dict[tuple[Row, ...], int]:
    """Ways to place vehicles who are told apart, by the rows of moves that this leaves them.

    ``vehicles``: the places of each, what it uses up there, and its row of moves.
    """
    anywhere = [v[0][2] for v in vehicles if _same_everywhere(v, room)]
    others = [v for v in vehicles if not _same_everywhere(v, room)]
    states: dict[tuple[Room, tuple[Row, ...]], int] = {(room, ()): 1}
    for places in others:
        following: defaultdict[tuple[Room, tuple[Row, ...]], int] = defaultdict(int)
        if not room.arms:
            alike = Counter((0, uses, row) for _, uses, row in places)
            options = [(*key, times) for key, times in alike.items()]
        else:
            options = [(*place, 1) for place in places]
        for (before, found), times in states.items():
            for arm, uses, row, ways in options:
                after = before.after(arm, 1, uses)
                if after is not None:
                    following[after, tuple(sorted((*found, row)))] += times * ways
        states = _bounded(following)
    out: Counter[tuple[Row, ...]] = Counter()
    for (left, found), times in states.items():
        if not any(left.groups):
            ways = _fillings(tuple(sorted(left.arms)), len(anywhere))
            out[tuple(sorted((*found, *anywhere)))] += times * ways
    return dict(+out)


def _same_everywhere(places: Sequence[tuple[int, tuple[int, ...], Row]], room: Room) -> bool:
    """Whether one may choose the same at every arm, whatever others do."""
    alike = len({row for _, _, row in places}) == 1 and not any(any(u) for _, u, _ in places)
    return alike and 0 < len(room.arms) == len(places)


@lru_cache(maxsize=4096)
def _fillings(arms: tuple[int, ...], vehicles: int) -> int:
    """Ways to put vehicles, told apart, on arms that hold so many."""
    ways = [1, *[0] * vehicles]
    for holds in arms:
        ways = [
            sum(ways[n - here] * math.comb(n, here) for here in range(min(holds, n) + 1))
            for n in range(vehicles + 1)
        ]
    return ways[vehicles]


def _spread(kind: Kind, room: Room) -> Iterator[tuple[Room, int]]:
    """The room that is left, and the ways to leave it: multisets of choices in every slot."""
    states: dict[tuple[Room, int], int] = {(room, kind.members): 1}
    for place, uses, choices in kind.slots:
        following: defaultdict[tuple[Room, int], int] = defaultdict(int)
        for (before, members), times in states.items():
            following[before, members] += times
            for number in range(1, members // kind.share + 1 if choices else 1):
                after = before.after(place, number, uses)
                if after is None:
                    break
                ways = math.comb(number + choices - 1, number)
                following[after, members - number * kind.share] += times * ways
        states = _bounded(following)
    return ((left, ways) for (left, members), ways in states.items() if not members)


K = TypeVar("K", bound=Hashable)


def _bounded(states: dict[K, int]) -> dict[K, int]:
    if len(states) > MAX_STATES:
        raise InputError(
            f"more than {MAX_STATES:,} ways to fill the arms: too many to count",
            where="participants",
            hint="Say more about where they come from, or describe fewer different ones.",
        )
    return states

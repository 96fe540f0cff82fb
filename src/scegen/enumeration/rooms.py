"""Ways to place vehicles that share nothing but the room on the arms.

Groups are placed one after the other, and states that leave equal room are one. Those who may
enter anywhere, with as many choices everywhere, come last and all at once. So the work grows with
the number of ways to leave room, not with the number of ways to place.
"""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeVar

from scegen.enumeration.patterns import Row
from scegen.errors import InputError

Room = tuple[tuple[int, int], ...]
"""For each arm, how many more fit: of those limited to some arms by the text, and of the others."""

MAX_ROOMS = 100_000
"""More ways to leave room than this are not counted: it would take minutes."""

K = TypeVar("K")


@dataclass(frozen=True)
class Kind:
    """Vehicles that are placed alike and not told apart: ``members`` in number.

    Each slot is (place in the room, choices there); who uses a slot once takes ``share`` members
    and one place: 1, or under a rotation as many as it carries round.
    """

    members: int
    share: int
    slots: tuple[tuple[int, int], ...]
    limited: bool

    @property
    def alike(self) -> bool:
        """Whether all places are the same to it."""
        return not self.limited and len({choices for _, choices in self.slots}) == 1


def placements(kinds: Sequence[Kind], room: Room) -> int:
    """Ways to place all and to choose their moves.

    Raises:
        InputError: there are too many ways to leave room.
    """
    pool = [k for k in kinds if k.alike and k.members == k.share == 1 and len(k.slots) == len(room)]
    others = sorted((k for k in kinds if k not in pool), key=lambda k: (k.alike, not k.limited))
    states: dict[Room, int] = {room: 1}
    for kind in others:
        following: defaultdict[Room, int] = defaultdict(int)
        for before, times in states.items():
            for after, ways in _spread(kind, before):
                # What is still to do sees all places alike, so their order no longer matters.
                following[tuple(sorted(after)) if kind.alike else after] += times * ways
        states = _bounded(following)
    moves = math.prod(kind.slots[0][1] for kind in pool)
    return sum(moves * times * _filled(left, len(pool)) for left, times in states.items())


def rows_of_placements(
    vehicles: Sequence[tuple[bool, tuple[Row | None, ...]]], room: Room
) -> dict[tuple[Row, ...], int]:
    """Ways to place vehicles who are told apart, by the rows of moves that this leaves them.

    Args:
        vehicles: whether each is limited to some arms, and its row at every arm, None where it
            may not enter.
        room: as left to them.
    """
    anywhere = [rows[0] for limited, rows in vehicles if not limited and len(set(rows)) == 1]
    others = [v for v in vehicles if v[0] or len(set(v[1])) > 1]
    states: dict[tuple[Room, tuple[Row, ...]], int] = {(room, ()): 1}
    for limited, rows in sorted(others, key=lambda vehicle: not vehicle[0]):
        following: defaultdict[tuple[Room, tuple[Row, ...]], int] = defaultdict(int)
        for (before, found), times in states.items():
            for arm, row in enumerate(rows):
                after = _entered(before, arm, 1, limited=limited)
                if row is not None and after is not None:
                    following[after, tuple(sorted((*found, row)))] += times
        states = _bounded(following)
    always = [row for row in anywhere if row is not None]
    out: Counter[tuple[Row, ...]] = Counter()
    for (left, found), times in states.items():
        out[tuple(sorted((*found, *always)))] += times * _filled(left, len(always))
    return dict(+out)


def _spread(kind: Kind, room: Room) -> Iterator[tuple[Room, int]]:
    """The room that is left, and the ways to leave it: multisets of choices in every slot."""
    states: dict[tuple[Room, int], int] = {(room, kind.members): 1}
    for place, choices in kind.slots:
        following: defaultdict[tuple[Room, int], int] = defaultdict(int)
        for (before, members), times in states.items():
            following[before, members] += times
            for number in range(1, members // kind.share + 1 if choices else 1):
                after = _entered(before, place, number, limited=kind.limited)
                if after is None:
                    break
                ways = math.comb(number + choices - 1, number)
                following[after, members - number * kind.share] += times * ways
        states = _bounded(following)
    return ((left, ways) for (left, members), ways in states.items() if not members)


def _entered(room: Room, place: int, number: int, *, limited: bool) -> Room | None:
    """The room after so many more, None if they do not fit; the limited ones come first."""
    for_limited, for_others = room[place]
    if number > (for_limited if limited else for_others):
        return None
    left = (for_limited - number if limited else 0, max(for_others - number, 0))
    return (*room[:place], left, *room[place + 1 :])


def _filled(room: Room, vehicles: int) -> int:
    return _fillings(tuple(sorted(others for _, others in room)), vehicles)


@lru_cache(maxsize=4096)
def _fillings(room: tuple[int, ...], vehicles: int) -> int:
    """Ways to put vehicles, told apart, on places that hold so many."""
    ways = [1, *[0] * vehicles]
    for holds in room:
        ways = [
            sum(
                ways[total - here] * math.comb(total, here) for here in range(min(holds, total) + 1)
            )
            for total in range(vehicles + 1)
        ]
    return ways[vehicles]


def _bounded(states: dict[K, int]) -> dict[K, int]:
    if len(states) > MAX_ROOMS:
        raise InputError(
            f"more than {MAX_ROOMS:,} ways to fill the arms: too many to count",
            where="participants",
            hint="Say more about where they come from, or describe fewer different ones.",
        )
    return states

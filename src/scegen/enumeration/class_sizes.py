"""How many assignments each exact class holds: swaps within groups times turned copies.

Thousands of scenarios are asked about, so what depends on one group alone is kept, and a
multiset of choices is one integer: digit k counts those who made choice number k.
"""

from __future__ import annotations

import math
from collections import Counter

from scegen.enumeration.symmetry import Symmetry

Choice = tuple[int | str, ...]
"""What a participant chose; the arm comes first."""


MOST_KEPT = 65_536
"""Choices of groups that are kept; a stream of millions must not fill the memory."""


class ClassSizes:
    """Class sizes under the symmetry of one problem."""

    def __init__(self, symmetry: Symmetry, arms: int) -> None:
        self._symmetry = symmetry
        self._arms = arms
        self._digit = max((len(g.members) for g in symmetry.groups), default=1).bit_length()
        self._places: dict[tuple[int, Choice], int] = {}
        self._kept: dict[tuple[int, tuple[Choice, ...]], tuple[int, tuple[int, ...]]] = {}
        still = symmetry.anchor is not None or len(symmetry.rotations) == 1
        self._copies = len(symmetry.rotations) if still else None

    def of(self, chosen: list[list[Choice]]) -> int:
        """The size of the class of a scenario, given what each group's members chose."""
        size, codes = 1, []
        for key in enumerate(map(tuple, chosen)):
            ways, code = self._kept.get(key) or self._known(key)
            size *= ways
            codes.append(code)
        if self._copies is not None:
            return size * self._copies
        return size * len(set(map(sum, zip(*codes, strict=True))))

    def key(self, chosen: list[list[Choice]]) -> int:
        """A number that exactly the assignments of one class share."""
        codes = [self._known(key)[1] for key in enumerate(map(tuple, chosen))]
        return min(map(sum, zip(*codes, strict=True)))

    def _known(self, key: tuple[int, tuple[Choice, ...]]) -> tuple[int, tuple[int, ...]]:
        """What depends on one group alone: its arrangements, and its part of every copy."""
        if len(self._kept) >= MOST_KEPT:
            self._kept.clear()
        found = self._kept[key] = arrangements(key[1]), self._codes(*key)
        return found

    def _codes(self, group: int, members: tuple[Choice, ...]) -> tuple[int, ...]:
        """For every rotation, the part of the turned multiset that these members make."""
        return tuple(
            sum(self._digit_of(images[group], choice, turn) for choice in members)
            for turn, images in self._symmetry.rotations.items()
        )

    def _digit_of(self, group: int, choice: Choice, turn: int) -> int:
        turned = (group, ((int(choice[0]) + turn) % self._arms, *choice[1:]))
        place = self._places.setdefault(turned, len(self._places))
        return 1 << (self._digit * place)


def arrangements(chosen: tuple[Choice, ...]) -> int:
    """Ways to hand out these choices to the members of a group, who are told apart by name."""
    ways = math.factorial(len(chosen))
    for times in Counter(chosen).values():
        ways //= math.factorial(times)
    return ways

"""How many assignments each exact class holds: swaps within groups times turned copies.

Thousands of scenarios are asked about, so what depends on a few participants alone is kept, and a
multiset of choices is one integer: digit k counts those who made choice number k.
"""

import math
from collections import Counter
from collections.abc import Callable, Sequence
from functools import lru_cache
from operator import itemgetter

from scegen.enumeration.symmetry import Symmetry

Choice = tuple[int | str, ...]
"""What a participant chose; the arm comes first."""
Chosen = tuple[tuple[Choice, ...], ...]
"""What the members of each group chose."""

MOST_KEPT = 32_768
"""Choices of groups that are kept; a stream of millions must not fill the memory."""


class ClassSizes:
    """Class sizes under the symmetry of one problem, whose groups have these places in a list."""

    def __init__(self, symmetry: Symmetry, arms: int, groups: Sequence[Sequence[int]]) -> None:
        self._symmetry = symmetry
        self._arms = arms
        self._digit = max((len(g.members) for g in symmetry.groups), default=1).bit_length()
        self._places: dict[tuple[int, Choice], int] = {}
        self._turns = tuple(symmetry.rotations)
        # One who is one of a kind on all arms is moved by every rotation.
        searched = self._turns[1:] if symmetry.anchor is None else ()
        self._prime = tuple(t for t in searched if _is_prime(arms // math.gcd(arms, t)))
        self._groups = tuple(_picker(places) for places in groups)
        self._part = lru_cache(maxsize=MOST_KEPT)(self._part_of)

    def groups(self, made: Sequence[Choice]) -> Chosen:
        """What the members of each group chose, of what everybody chose."""
        return tuple([pick(made) for pick in self._groups])

    def of(self, made: Sequence[Choice]) -> int:
        """The size of the class of a scenario, given what everybody chose.

        If any rotation fixes the scenario, one of prime order does: mostly these few are looked
        at, and all turned copies are different ones.
        """
        size, changes = len(self._turns), []
        for group, members in enumerate(self.groups(made)):
            ways, change = self._part(group, members)
            size *= ways
            changes.append(change)
        if 0 in map(sum, zip(*changes, strict=True)):
            return size // len(self._turns) * len(set(self._copies(made)))
        return size

    def key(self, made: Sequence[Choice]) -> int:
        """A number that exactly the assignments of one class share."""
        return min(self._copies(made))

    def _copies(self, made: Sequence[Choice]) -> list[int]:
        """The multiset of choices after every rotation."""
        chosen = self.groups(made)
        return [
            sum(self._code(group, members, turn) for group, members in enumerate(chosen))
            for turn in self._turns
        ]

    def _part_of(self, group: int, members: tuple[Choice, ...]) -> tuple[int, tuple[int, ...]]:
        """The arrangements of a group, and what each rotation of prime order adds to the multiset.

        For no change all are 0.
        """
        still = self._code(group, members, 0)
        changes = tuple([self._code(group, members, turn) - still for turn in self._prime])
        return arrangements(members), changes

    def _code(self, group: int, members: tuple[Choice, ...], turn: int) -> int:
        """The part of the turned multiset that these members make."""
        image = self._symmetry.rotations[turn][group]
        return sum(self._digit_of(image, choice, turn) for choice in members)

    def _digit_of(self, group: int, choice: Choice, turn: int) -> int:
        turned = (group, ((int(choice[0]) + turn) % self._arms, *choice[1:]))
        place = self._places.setdefault(turned, len(self._places))
        return 1 << (self._digit * place)


def arrangements(chosen: tuple[Choice, ...]) -> int:
    """Ways to hand out these choices to the members of a group, who are told apart by name."""
    alike = math.prod(map(math.factorial, Counter(chosen).values()))
    return math.factorial(len(chosen)) // alike


def _picker(places: Sequence[int]) -> Callable[[Sequence[Choice]], tuple[Choice, ...]]:
    """What picks the choices in these places; of one place, too, a tuple."""
    if len(places) == 1:
        return itemgetter(slice(places[0], places[0] + 1))
    return itemgetter(*places)


def _is_prime(number: int) -> bool:
    return number > 1 and all(number % factor for factor in range(2, number))

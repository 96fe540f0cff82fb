"""Lanes as one small choice problem: of all that is open, what breaks the least of what is wished.

Every word, act, danger and meeting is a wish with a weight; a choice is anything that stands for
where somebody drives. Earlier options are taken where all else is equal.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import TypeVar

SAID, LIKELY, USUAL = 100.0, 10.0, 1.0
"""How much it weighs that something is not as it is said, as a danger needs it, as is usual."""
_LATER = 0.01
"""What an option costs for each before it."""
T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Wish:
    """Something wanted: what suits of the choices of those whom it concerns; ``words`` say what."""

    who: tuple[str, ...]
    weight: float
    suits: Callable[..., bool]
    words: str

    def met(self, chosen: Mapping[str, object]) -> bool:
        """Whether what is chosen meets it."""
        return self.suits(*(chosen[name] for name in self.who))

    def can_be_met(self, options: Mapping[str, Sequence[object]]) -> bool:
        """Whether any choice of those whom it concerns meets it."""
        return any(self.suits(*chosen) for chosen in product(*(options[n] for n in self.who)))


def least_broken(
    options: Mapping[str, Sequence[T]], wishes: Sequence[Wish]
) -> tuple[float, dict[str, T]]:
    """(cost, the choices that break the least), branch by branch."""
    names = list(options)
    best: tuple[float, dict[str, T]] = (float("inf"), {})
    last: dict[str, list[Wish]] = {name: [] for name in names}
    for wish in wishes:
        last[max(wish.who, key=names.index)].append(wish)

    def extend(n: int, chosen: dict[str, T], cost: float) -> None:
        nonlocal best
        if cost >= best[0]:
            return
        if n == len(names):
            best = cost, dict(chosen)
            return
        name = names[n]
        for place, option in enumerate(options[name]):
            chosen[name] = option
            broken = sum(wish.weight for wish in last[name] if not wish.met(chosen))
            extend(n + 1, chosen, cost + broken + _LATER * place)
        del chosen[name]

    extend(0, {}, 0.0)
    return best

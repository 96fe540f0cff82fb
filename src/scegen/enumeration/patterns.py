"""Patterns as polynomials: x1**2 * x3 stands for the multiset of moves {1, 1, 3}.

A vehicle that chooses among the moves 1 and 3 is x1 + x3; vehicles that choose on their own
multiply; the coefficient of a monomial is the number of assignments with that pattern.
"""

from collections import Counter
from collections.abc import Mapping

from scegen.errors import InputError

Row = tuple[tuple[int, int], ...]
"""(move, number of manners) of one vehicle at one entry, in rising order."""

Polynomial = dict[tuple[int, ...], int]
"""Number of assignments by the numbers of vehicles that make the moves 0, 1, 2, ..."""

MAX_TERMS = 200_000
"""More patterns than this are not counted: nobody could list them."""


def product(loose: Mapping[tuple[tuple[Row, ...], tuple[int, ...]], int]) -> Polynomial:
    """Sum over all (rows of the independent vehicles, tied moves), each so many times.

    Raises:
        InputError: there are too many patterns to count.
    """
    out: Counter[tuple[int, ...]] = Counter()
    known: dict[tuple[Row, ...], Polynomial] = {}
    for (rows, tied), times in loose.items():
        if rows not in known:
            known[rows] = _expand(rows, len(tied))
        for monomial, coefficient in known[rows].items():
            out[tuple(map(sum, zip(monomial, tied, strict=True)))] += coefficient * times
    return dict(out)


def _expand(rows: tuple[Row, ...], arms: int) -> Polynomial:
    terms: Polynomial = {(0,) * arms: 1}
    for row in rows:
        following: Counter[tuple[int, ...]] = Counter()
        for monomial, coefficient in terms.items():
            for move, manners in row:
                grown = list(monomial)
                grown[move] += 1
                following[tuple(grown)] += coefficient * manners
        terms = dict(following)
        if len(terms) > MAX_TERMS:
            raise InputError(
                f"more than {MAX_TERMS:,} patterns: too many to count",
                where="reduction pattern",
                hint="Use the reduction exact, or describe fewer participants.",
            )
    return terms

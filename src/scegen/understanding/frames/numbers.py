"""What each number of a text is: a speed, a gap, a rate."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace

from scegen.understanding.frames.loader import AmountFrame
from scegen.understanding.frames.windows import Window, frame_of, window
from scegen.understanding.words.quantities import Quantity
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token


@dataclass(frozen=True, slots=True)
class Measured:
    """The words around a number, and what they make of it."""

    around: Window
    frame: AmountFrame


class Numbers:
    """The numbers of a text.

    Args:
        terms: its terms.
        tokens: its tokens.
        of_the_road: numbers that are said of the road (a speed limit).
    """

    def __init__(
        self, terms: list[Term], tokens: list[Token], of_the_road: Collection[Term]
    ) -> None:
        self._tokens = tokens
        found: list[Quantity] = [
            t.data["quantity"]
            for t in terms
            if t.data.get("quantity") is not None and all(t is not r for r in of_the_road)
        ]
        self.quantities = sorted(found, key=lambda q: q.i)
        self._ends = {q.j: q.i for q in found}
        self._around: dict[int, Window] = {}
        self._behind = {t.i: t.j - t.i for t in terms if (t.cat, t.value) == ("locus", "behind")}

    def measured(self, quantity: Quantity, verb: str = "", at: int | None = None) -> Measured:
        """A number with its role.

        Args:
            quantity: the number.
            verb: what happens in its clause; empty if nothing does.
            at: the word for it, unless it is told as over ("has covered").
        """
        lemma = [f"to {self._tokens[at].forms[-1][0]}"] if at is not None else []
        around = self._around.get(quantity.i)
        if around is None:
            around = window(self._tokens, quantity.i, quantity.j, self._ends)
            self._around[quantity.i] = around
        if quantity.j in self._behind:  # "20 m after the lead", "1.9 s astern"
            rest = around.after.split()[self._behind[quantity.j] :]
            around = replace(around, after=f" {' '.join(['behind', *rest])} ")
        low, verbs = quantity.value.low, frozenset([verb, *lemma])
        return Measured(around, frame_of(quantity.dimension, low, around, verbs))

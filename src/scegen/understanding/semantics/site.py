"""One phrase of place of a clause, as what rows put somebody there sees it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

from scegen.understanding.chunks import NounPhrase, Place, Prep
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.semantics.context import Clause, Context


@dataclass(frozen=True, slots=True)
class Site:
    """A noun with the preposition that governs it, or an object or subject (no preposition)."""

    noun: NounPhrase
    prep: Prep | None
    basis: Basis
    clause: Clause
    context: Context

    @property
    def place(self) -> Place:
        """The noun, of a row that asks for a place.

        Raises:
            TypeError: if it is none.
        """
        if not isinstance(self.noun, Place):
            msg = f"no place: {type(self.noun).__name__}"
            raise TypeError(msg)
        return self.noun

    @property
    def value(self) -> str:
        """Which preposition."""
        return self.prep.value if self.prep is not None else ""

    @property
    def word(self) -> str:
        """The preposition as it stands in the text."""
        return self.context.tokens[self.prep.word.i].low if self.prep is not None else ""


Put: TypeAlias = Callable[[Entity, Site], None]

"""Numbers and letters that name participants and places: "vehicle 1", "cars A and B", "lane 2"."""

from __future__ import annotations

from dataclasses import dataclass

from scegen.understanding.chunks import Chunk, Mention, Word
from scegen.understanding.words.terms import Term, cat_at
from scegen.understanding.words.tokens import Token

_WIDEST_GAP = 2
"""Room for a space and a "#"."""


@dataclass(frozen=True, slots=True)
class Namer:
    """Looks for names right after a noun.

    Attributes:
        terms: the terms of the text.
        tokens: its tokens, for the written form of letters.
    """

    terms: list[Term]
    tokens: list[Token]

    def single(self, mention: Mention, m: int) -> int:
        """``vehicle 1``, ``car A``: names the mention; a plural only as the first of a list.

        Returns:
            The index of the term after the name, ``m`` if there is none.
        """
        plural = self.tokens[mention.j - 1].text.endswith("s")
        bare = not mention.mods and not plural
        name = self._name(m, bare=bare)
        if name is None or (plural and not self._listed(m + 1)):
            return m
        mention.label, mention.label_at, mention.j = name, self.terms[m].i, self.terms[m].j
        return m + 1

    def further(self, first: Mention, m: int) -> tuple[list[Chunk], int]:
        """``vehicles 1, 2 and 3``: a mention for each name after the first.

        Returns:
            The further chunks and the index of the term after them.
        """
        found: list[Chunk] = []
        named = [first]
        while first.label is not None and first.plural and self._listed(m):
            name = self._name(m + 1)
            term = self.terms[m + 1]
            mention = Mention(term.i, term.j, list(first.mods), first.head, heads=first.heads)
            mention.label, mention.label_at = name, term.i
            found += [Word(self.terms[m]), mention]
            named.append(mention)
            m += 2
        for one in named if found else []:  # "two cars A and B": the names say who the two are
            one.mods = [t for t in one.mods if t.cat not in {"num", "quant"}]
        return found, m

    def numbered(self, head: Term, m: int) -> bool:
        """``lane 2``: the number is the place's name."""
        if cat_at(self.terms, m) != "num" or head.value not in {"lane", "road"}:
            return False
        bare = cat_at(self.terms, m - 2) not in {"det", "dir"}
        written = self.tokens[self.terms[m].i].kind == "number"
        return (bare or written) and cat_at(self.terms, m + 1) not in {"actor", "place"}

    def _listed(self, m: int) -> bool:
        """Whether a further name comes after a joint."""
        joint = m < len(self.terms) and self.terms[m].value in {"and", "or", ","}
        return joint and self._name(m + 1) is not None

    def _model(self, i: int) -> bool:
        """``F-150``: a letter joined to a number is a model, not a name."""
        after = self.tokens[i + 1] if i + 1 < len(self.tokens) else None
        joined = after is not None and after.start == self.tokens[i].end + 1
        written = after is not None and after.kind == "number"
        return joined and written and self.tokens[i].text != "A"

    def _name(self, m: int, *, bare: bool = False) -> str | None:
        """The name that the term is, if it is one; after a bare noun ("vehicle two") it is."""
        if m >= len(self.terms):
            return None
        term = self.terms[m]
        token = self.tokens[term.i]
        if token.start - self.tokens[term.i - 1].end > _WIDEST_GAP:
            return None  # "ego + 2 others"
        alone = term.j - term.i == 1  # no "T-bones"
        follows = cat_at(self.terms, m + 1)
        told = bare or token.kind == "number" or follows not in {"place", "verb", "manner"}
        if term.cat == "num" and told and alone and follows != "actor":
            return f"#{term.data['number']:g}"
        letter = alone and len(token.text) == 1 and token.text.isupper() and token.text != "I"
        letter = letter and not self._model(term.i)
        if letter and follows not in {"actor", "place", "dir", "shape", "manner", "state"}:
            return f"#{token.low}"
        return None

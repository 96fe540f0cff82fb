"""Terms whose class only the words around them tell: ``contexts.yaml``, ``talk.yaml``."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import lru_cache
from itertools import takewhile
from typing import Any

from scegen.understanding.lexicon import load_contexts
from scegen.understanding.words.paces import doing
from scegen.understanding.words.quantities import quantity_at
from scegen.understanding.words.terms import NOTHING, Term, longest_match, term_at
from scegen.understanding.words.tokens import Token

_SOON = 6
"""So many words count as near."""


@dataclass(frozen=True, slots=True)
class _Item:
    """Alternatives of which one holds, or none, by what they ask."""

    negated: bool
    edge: bool
    words: frozenset[str]
    lemmas: frozenset[str]
    kinds: frozenset[str]
    measures: frozenset[str]
    named: frozenset[str]

    @classmethod
    def of(cls, written: str) -> _Item:
        first, *rest = written.split()
        atoms = rest if first == "not" else [first, *rest]
        signed = {s: frozenset(a[1:] for a in atoms if a[0] == s) for s in "=+:#"}
        named = frozenset(a for a in atoms if a[0].isalpha())
        edge = not {"^", "$"}.isdisjoint(atoms)
        return cls(first == "not", edge, signed["="], signed["+"], signed[":"], signed["#"], named)

    def fits_name(self, names: tuple[str, ...]) -> bool:
        """Whether the item asks for something that is called so."""
        return self.negated == self.named.isdisjoint(names)

    def fits_term(self, term: Term, tokens: list[Token]) -> bool:
        """Whether a term, or the beginning of the text, is what the item asks for."""
        if term is NOTHING:
            return self.negated != self.edge
        first, measured = tokens[term.i], term.cat == "quantity" and term.value in self.measures
        spelled = first.low in self.words or tokens[term.j - 1].low in self.words
        if measured or spelled or first.base in self.lemmas:
            return not self.negated
        return self.fits_name(_names(term.cat, term.value, term.form))

    def fits_at(self, tokens: list[Token], j: int) -> bool:
        """Whether what begins at a token is."""
        if j >= len(tokens):
            return self.negated != self.edge
        token, quantity = tokens[j], quantity_at(tokens, j) if self.measures else None
        measured = quantity is not None and quantity.dimension in self.measures
        if measured or token.low in self.words or token.base in self.lemmas:
            return not self.negated
        match = longest_match(tokens, j) if self.named else None
        if token.kind in self.kinds or match is None:
            return self.negated != (token.kind in self.kinds)
        return self.fits_name((*match.cats, *(f"{cat}.{match.form}" for cat in match.cats)))


@lru_cache(maxsize=4096)
def _names(cat: str, value: str, form: str) -> tuple[str, ...]:
    """All names of a term in the rows."""
    named = f"{cat}/{value}"
    return cat, named, f"{cat}.{form}", f"{named}.{form}"


@dataclass(frozen=True, slots=True)
class _Row:
    """A row of the file, its items read."""

    at: _Item | None = None
    ends: frozenset[str] = frozenset()
    single: bool = False
    before: tuple[_Item, ...] = ()
    after: tuple[_Item, ...] = ()
    soon: _Item | None = None
    ago: _Item | None = None
    doing: bool = False
    length: int | None = None
    takes: int = 0
    becomes: dict[str, Any] = field(default_factory=dict)
    previous: dict[str, Any] = field(default_factory=dict)

    @classmethod
    def of(cls, record: dict[str, Any]) -> _Row:
        told = {key: v for key, v in record.items() if key not in {"of", "word", "lemma", "is"}}
        for key in told.keys() & {"at", "soon", "ago"}:
            told[key] = _Item.of(told[key])
        for key in told.keys() & {"before", "after"}:
            told[key] = tuple(map(_Item.of, told[key]))
        return cls(
            **told | {"ends": frozenset(told.get("ends", ())), "becomes": record.get("is", {})}
        )

    def fits(self, term: Term, terms: list[Term], tokens: list[Token]) -> bool:
        """Whether the words around a term are those of the row."""
        if self.single and term.j - term.i != 1:
            return False
        if self.ends and tokens[term.j - 1].low not in self.ends:
            return False
        for back, item in enumerate(self.before, 1):
            if not item.fits_term(term_at(terms, len(terms) - back), tokens):
                return False
        if not all(item.fits_at(tokens, term.j + k) for k, item in enumerate(self.after)):
            return False
        near = range(term.j, min(term.j + _SOON, len(tokens)))
        if self.soon is not None and not any(self.soon.fits_at(tokens, k) for k in near):
            return False
        since = takewhile(lambda before: before.value not in {".", ";"}, reversed(terms))
        if self.ago is not None and not any(self.ago.fits_term(t, tokens) for t in since):
            return False
        return not self.doing or doing(tokens, term.i)


@lru_cache(maxsize=1)
def _rows() -> dict[str, tuple[tuple[int, _Row], ...]]:
    """First word, or what the term is -> the rows that may fit, by their place in the file."""
    found: dict[str, list[tuple[int, _Row]]] = {}
    for number, record in enumerate(load_contexts()):
        row = _Row.of(record)
        words = [f"={w}" for w in record.get("word", ())]
        for key in words or [f"+{w}" for w in record.get("lemma", ())] or record["at"].split():
            found.setdefault(key, []).append((number, row))
    return {key: tuple(rows) for key, rows in found.items()}


@lru_cache(maxsize=8192)
def _candidates(low: str, lemma: str, cat: str, value: str, form: str) -> tuple[_Row, ...]:
    names = _names(cat, value, form)
    found = [pair for key in (f"={low}", f"+{lemma}", *names) for pair in _rows().get(key, ())]
    rows = [row for _, row in sorted(found, key=lambda pair: pair[0])]
    return tuple(row for row in rows if row.at is None or row.at.fits_name(names))


def in_context(term: Term, terms: list[Term], tokens: list[Token]) -> Term:
    """The term as the words around it would have it.

    Some terms before it are changed in its light, or become part of it.
    """
    first = tokens[term.i]
    lemma = first.base
    for row in _candidates(first.low, lemma, term.cat, term.value, term.form):
        if not row.fits(term, terms, tokens):
            continue
        if row.previous:
            terms[-1] = replace(terms[-1], **row.previous)
        i = terms[-row.takes].i if row.takes else term.i
        del terms[len(terms) - row.takes :]
        j = term.j if row.length is None else term.i + row.length
        return replace(term, i=i, j=j, **row.becomes)
    return term


_MOST_LANES = 6
"""More lanes than that are no lanes that one tells apart."""


def retag(term: Term, terms: list[Term], tokens: list[Token]) -> Term:
    """The term as the words before it would have it.

    Some terms before it are changed in its light.
    """
    if term.cat == "punct":
        return term
    term = in_context(term, terms, tokens)
    term = _of_so_many(term, terms, tokens)
    if _speed(term) and doing(tokens, term.i):
        _as_motion(terms, tokens)
    return term


def _of_so_many(term: Term, terms: list[Term], tokens: list[Token]) -> Term:
    """``the middle lane of three``: the lane, with how many; ``a jam of six cars``: the six."""
    lane, of = terms[-2:] if len(terms) > 1 else (term, term)
    if (of.value, term.cat) == ("of", "num") and not {"mass", "stands"}.isdisjoint(lane.data):
        goes = any(t.base in {"crawl", "move", "slow"} for t in tokens[term.j : term.j + 4])
        said = ("state", "stationary") if "stands" in lane.data and not goes else ("inert", "noun")
        start = -3 if len(terms) > 2 and terms[-3].cat in {"det", "possessive"} else -2
        terms[start:] = [Term(*said, terms[start].i, of.j)]
        return term
    counted = (lane.cat, lane.value, of.value, term.cat) == ("place", "lane", "of", "num")
    if not counted or not 1 < term.data["number"] <= _MOST_LANES:
        return term
    del terms[-2:]
    return replace(lane, j=term.j, data={**lane.data, "count": int(term.data["number"])})


def _as_motion(terms: list[Term], tokens: list[Token]) -> None:
    """``doing about fifty``: driving."""
    k = next((k for k in range(len(terms) - 1, -1, -1) if terms[k].cat == "verb"), None)
    if k is not None and tokens[terms[k].i].base == "do":
        terms[k] = replace(terms[k], value="move", data={"drives": True})


def _speed(term: Term) -> bool:
    """Whether a term says how fast: "50 mph", "40 in a 30", or a bare number after "doing"."""
    paced = term.cat == "manner" and term.value in {"fast", "slow"}
    return paced or term.cat in {"quantity", "num"}

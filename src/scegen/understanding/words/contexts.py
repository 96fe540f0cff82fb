"""Terms whose class only the words around them tell, by the rows of ``lexicon/contexts.yaml``."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any

from scegen.understanding.lexicon import load_contexts
from scegen.understanding.words.paces import doing
from scegen.understanding.words.quantities import quantity_at
from scegen.understanding.words.terms import Match, Term, longest_match, term_at
from scegen.understanding.words.tokens import Token

_SOON = 6
"""So many words count as near."""


@dataclass(frozen=True, slots=True)
class _Item:
    """Alternatives of which one holds, or none."""

    negated: bool
    atoms: tuple[str, ...]

    @classmethod
    def of(cls, written: str) -> _Item:
        atoms = written.split()
        negated = atoms[0] == "not"
        return cls(negated, tuple(atoms[negated:]))

    def fits_term(self, term: Term | None, tokens: list[Token]) -> bool:
        """Whether a term, or None for the beginning of the text, is what the item asks for."""
        return self.negated != any(_is(atom, term, tokens) for atom in self.atoms)

    def fits_at(self, tokens: list[Token], j: int) -> bool:
        """Whether what begins at a token is."""
        match = longest_match(tokens, j)
        return self.negated != any(_begins(atom, tokens, j, match) for atom in self.atoms)


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
        if self.at is not None and not self.at.fits_term(term, tokens):
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
        if self.ago is not None and not _ago(self.ago, terms, tokens):
            return False
        return not self.doing or doing(tokens, term.i)


def _ago(item: _Item, terms: list[Term], tokens: list[Token]) -> bool:
    for term in reversed(terms):
        if term.value in {".", ";"}:
            return False
        if item.fits_term(term, tokens):
            return True
    return False


def _is(atom: str, term: Term | None, tokens: list[Token]) -> bool:
    if term is None:
        return atom == "^"
    if atom[0] == "=":
        return atom[1:] in {tokens[term.i].low, tokens[term.j - 1].low}
    if atom[0] == "+":
        return tokens[term.i].base == atom[1:]
    if atom[0] == "#":
        return (term.cat, term.value) == ("quantity", atom[1:])
    named, _, form = atom.partition(".")
    cat, _, value = named.partition("/")
    return term.cat == cat and value in {"", term.value} and form in {"", term.form}


def _begins(atom: str, tokens: list[Token], j: int, match: Match | None) -> bool:
    if j >= len(tokens):
        return atom == "$"
    if atom[0] == "=":
        return tokens[j].low == atom[1:]
    if atom[0] == "+":
        return tokens[j].base == atom[1:]
    if atom[0] == ":":
        return tokens[j].kind == atom[1:]
    if atom[0] == "#":
        quantity = quantity_at(tokens, j)
        return quantity is not None and quantity.dimension == atom[1:]
    cat, _, form = atom.partition(".")
    return match is not None and match.has(cat) and form in {"", match.form}


@lru_cache(maxsize=1)
def _rows() -> dict[str, tuple[tuple[int, _Row], ...]]:
    """First word, or what the term is -> the rows that may fit, by their place in the file."""
    found: dict[str, list[tuple[int, _Row]]] = {}
    for number, record in enumerate(load_contexts()):
        row = _Row.of(record)
        words = [f"={w}" for w in record.get("word", ())]
        for key in words or [f"+{w}" for w in record.get("lemma", ())] or [record["at"]]:
            found.setdefault(key, []).append((number, row))
    return {key: tuple(rows) for key, rows in found.items()}


@lru_cache(maxsize=8192)
def _candidates(low: str, lemma: str, cat: str, value: str, form: str) -> tuple[_Row, ...]:
    named = f"{cat}/{value}"
    keys = (f"={low}", f"+{lemma}", cat, named, f"{cat}.{form}", f"{named}.{form}")
    found = [pair for key in keys for pair in _rows().get(key, ())]
    return tuple(row for _, row in sorted(found, key=lambda pair: pair[0]))


def in_context(term: Term, terms: list[Term], tokens: list[Token]) -> Term:
    """The term as the words around it would have it.

    Args:
        term: the term.
        terms: the terms before it; some are changed in its light, or become part of it.
        tokens: the tokens of the text.
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

"""Words for junctions, signs and lights that are not there, do not work, or only count arms."""

from itertools import takewhile

from scegen.scenario.junction import ARM_COUNTS
from scegen.scenario.vocabulary import JunctionKind
from scegen.understanding.entity import Basis
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import NOTHING, Term
from scegen.understanding.words.tokens import Token


def held(terms: list[Term], k: int) -> bool:
    """``a worker with a stop sign``: carried, not put up."""
    who, link = (None, None, *(t for t in terms[max(0, k - 3) : k] if t.cat != "det"))[-2:]
    carried = link is not None and (link.value == "with" or link.form == "ing")
    return carried and who is not None and (who.cat, who.value) == ("actor", "pedestrian")


def away_from(terms: list[Term], k: int) -> bool:
    """``outside a junction``, ``between two junctions``, ``without a junction``: on the road."""
    before = [t.value for t in terms[max(0, k - 3) : k] if t.cat not in {"shape", "num", "det"}]
    between = before[-1:] == ["between"] and terms[k].form == "s"
    return negated(terms, k) or between or before[-1:] == ["outside"]


_NONE = frozenset({"negative", "without", "neither"})
_LIMITS = frozenset({"verb", "aux", "neg", "prep", "actor", "pronoun", "punct", "sub", "rel"})


def negated(terms: list[Term], k: int) -> bool:
    """``no traffic lights``, ``without any signs or lights``, ``neither lights nor signs``."""
    limits = (t for t in reversed(terms[:k]) if t.cat in _LIMITS or t.value in _NONE)
    last = next(limits, NOTHING)
    return last.cat == "neg" or last.value in _NONE


_ARMS_SAID = {JunctionKind.T: 3, JunctionKind.FOUR_WAY: 4}


def named_by_letter(terms: list[Term], k: int) -> bool:
    """``at the T``, ``reaches a T``: the junction itself."""
    before = [t.cat for t in terms[max(0, k - 2) : k]]
    after = [t.cat for t in terms[k + 1 : k + 2]]
    placed = before in (["prep", "det"], ["verb", "det"])
    return placed and after not in (["actor"], ["place"], ["num"])


def only_counted(terms: list[Term], k: int, tokens: list[Token]) -> int | None:
    """``a four-arm roundabout``: the arms are counted, the noun says what kind it is.

    Returns:
        How many arms; None if the word says more than that.
    """
    term = terms[k]
    kind = JunctionKind(term.value)
    if kind not in _ARMS_SAID or tokens[term.j - 1].low not in word_list("counting"):
        return None
    shapes = (t for t in terms[k + 1 : k + 4] if t.cat == "shape" or t.value == "junction")
    after = next(shapes, NOTHING)
    named = after.value if after.cat == "shape" else after.data.get("kind")
    if named is None or named in {kind, JunctionKind.FOUR_WAY}:
        return None
    fewest, most = ARM_COUNTS[JunctionKind(named)]
    return _ARMS_SAID[kind] if fewest <= _ARMS_SAID[kind] <= most else None


_CLAUSES = frozenset({",", ".", ";", "when", "while", "as", "and", "before", "but"})
_BROKEN_REACH, _BROKEN_NEAR = 7, 4


def out_of_order(term: Term, tokens: list[Token]) -> Basis | None:
    """``non-working traffic lights``, ``traffic lights that are out of order``: all these words."""
    i, j = term.i, term.j
    before = [t.low for t in tokens[max(0, i - 3) : i]]
    if before[-1:] and before[-1] in word_list("broken"):
        return Basis(i - 1, j)
    for count in (2, 3):
        if " ".join(before[-count:]) in {*word_list("switched_off"), "non working"}:
            return Basis(i - count, j)
    after = _rest_of_clause(j, tokens)
    for m, word in enumerate(after):
        something_else = bool(m) and after[m - 1] in {"a", "an", "the"}
        if m < _BROKEN_NEAR and word in word_list("broken") and not something_else:
            return Basis(i, j + m + 1)
        for phrase in sorted(word_list("switched_off"), key=len, reverse=True):
            length = len(phrase.split())
            if " ".join(after[m : m + length]) == phrase:
                return Basis(i, j + m + length)
    return None


def flashing(term: Term, tokens: list[Token], colours: frozenset[str]) -> Basis | None:
    """``a flashing amber light``, ``a light that is flashing amber``."""
    i, j, words = term.i, term.j, word_list("flashing")
    if i and tokens[i - 1].low in words and colours & {t.low for t in tokens[i:j]}:
        return Basis(i - 1, j)
    after = _rest_of_clause(j, tokens)
    flashes = (m for m, word in enumerate(after[:-1]) if word in words)
    m = next((m for m in flashes if after[m + 1] in colours), None)
    return Basis(i, j + m + 2) if m is not None else None


def _rest_of_clause(j: int, tokens: list[Token]) -> list[str]:
    after = [t.low for t in tokens[j : j + _BROKEN_REACH]]
    return list(takewhile(lambda word: word not in _CLAUSES, after))

"""Nouns that no rule knows, of those who drive: "a black Transit overtakes the ego"."""

from __future__ import annotations

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_OPENERS = frozenset({"det", "num"})
_GOVERNING = frozenset({"prep", "locus", "verb"})
_BETWEEN = frozenset({"label", "dir", "manner", "state"})
_INSTEAD = "no known kind of road user; as it drives, it is read as a car"


def who_drive(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """The terms with such nouns as cars, which is said.

    A driving verb would else find its subject in the next noun, and turn who does it to whom.

    Args:
        terms: of the text, in its order.
        tokens: its tokens.
    """
    return [
        Term("actor", "car", t.i, t.j, _number(tokens[t.i]), {"instead": _INSTEAD})
        if t.cat == "unknown"
        and _opened(terms, k)
        and (_acts(terms, k, _number(tokens[t.i])) or _suffers(terms, k))
        else t
        for k, t in enumerate(terms)
    ]


def _number(token: Token) -> str:
    return "s" if token.low.endswith("s") else "base"


def _opener(terms: list[Term], k: int) -> int:
    """Where the words before a noun end that are said of it."""
    k -= 1
    while k >= 0 and terms[k].cat in _BETWEEN:
        k -= 1
    return k


def _opened(terms: list[Term], k: int) -> bool:
    opener = _opener(terms, k)
    return opener >= 0 and terms[opener].cat in _OPENERS


def _acts(terms: list[Term], k: int, number: str) -> bool:
    verb = terms[k + 1] if k + 1 < len(terms) else None
    before = _opener(terms, k) - 1
    governed = before >= 0 and terms[before].cat in _GOVERNING  # "a kid on a BMX shoots out"
    if verb is None or verb.cat != "verb" or governed:
        return False
    forms = {"base", "ed"} if number == "s" else {"s", "ed"}
    return verb.form in forms and verb.value in word_list("driving")


def _suffers(terms: list[Term], k: int) -> bool:
    """``overtakes a Transit``, unless a compound goes on."""
    before = _opener(terms, k) - 1
    verb, after = terms[before] if before >= 0 else None, terms[k + 1 : k + 2]
    ends = not after or after[0].cat in {"punct", "conj", "prep", "locus", "sub", "verb", "rel"}
    met = verb is not None and verb.cat == "verb" and verb.value in word_list("met_driving")
    return ends and met and terms[before + 1].value == "indef"

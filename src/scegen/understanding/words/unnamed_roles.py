"""Ordinals and roles without article or noun: "First lead brakes, second stops"."""

from __future__ import annotations

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.nominal import ORDINALS
from scegen.understanding.words.sidewords import does_it
from scegen.understanding.words.terms import Term, longest_match
from scegen.understanding.words.tokens import Token

_OPENERS = frozenset({"punct", "conj", "sub"})
_VERBAL = frozenset({"s", "ed"})


def with_articles(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """``First car stops, second brakes``: the first car, the second."""
    found: list[Term] = []
    named = {k for k in range(len(terms)) if _names(terms, k, tokens)}
    for k, term in enumerate(terms):
        word = tokens[term.i].low
        if k in named and (len(named) > 1 or word != "first"):
            found += [Term("det", "def", term.i, term.i), Term("label", word, term.i, term.j)]
        else:
            found.append(term)
    return found


def _names(terms: list[Term], k: int, tokens: list[Token]) -> bool:
    """Whether an ordinal that opens a clause stands for a participant."""
    term = terms[k]
    if tokens[term.i].low not in ORDINALS or term.j - term.i != 1:
        return False
    before, after = terms[k - 1] if k else None, terms[k + 1] if k + 1 < len(terms) else None
    if term.cat not in {"manner", "label"} or after is None:
        return False
    if before is not None and before.cat not in _OPENERS:
        return False
    acts = (after.cat == "verb" and after.form in _VERBAL) or after.cat in {"aux", "copy"}
    return acts or after.cat == "actor" or after.value in {"(", ","}


def role_alone(term: Term, terms: list[Term], tokens: list[Token]) -> Term:
    """``the lead brakes``, ``other 90 km/h``: the name of a role without "vehicle".

    Args:
        term: a term.
        terms: the terms before it.
        tokens: the tokens of the text.
    """
    word = tokens[term.i].low
    if term.j - term.i != 1 or word not in word_list("roles_alone"):
        return term
    after = tokens[term.j].low if term.j < len(tokens) else ""
    definite = bool(terms) and (terms[-1].cat, terms[-1].value) == ("det", "def")
    if word == "subject" and definite and after not in word_list("governed"):
        return Term("actor", "ego", term.i, term.j, data={"ego": True})
    if (
        word == "one"
        and tokens[term.i - 1].low in (word_list("minor") | word_list("major"))
        and term.i > 1
    ):
        kind = "access" if tokens[term.i - 1].low in word_list("minor") else "road"
        return Term("place", kind, term.i, term.j)  # "from the major road into a minor one"
    opens = not terms or terms[-1].cat in _OPENERS
    measured = term.j < len(tokens) and tokens[term.j].kind == "number"
    if word == "other" and opens and (measured or after == "at"):
        return Term("actor", "driver", term.i, term.j, data={"driver": True})
    if word == "lead" and term.cat == "dir" and _alone(tokens, term.j):
        return Term("actor", "driver", term.i, term.j, data={"driver": True, "dir": "ahead"})
    return term


def _alone(tokens: list[Token], j: int) -> bool:
    """``the lead brakes``, ``lead at 50 km/h``, ``ego 20 m behind the lead``: the vehicle."""
    if j >= len(tokens) or tokens[j].kind in {"number", "punct"}:
        return True
    return _acts(tokens, j) or tokens[j].low in {
        "at",
        "is",
        "with",
        "by",
        "and",
        "in",
        "'s",
        "to",
        "speed",
        "deceleration",
        "acceleration",
        "velocity",
    }


def _acts(tokens: list[Token], j: int) -> bool:
    following = longest_match(tokens, j)
    if following is None:
        return False
    if following.has("actor"):
        return does_it(following, tokens, j - 1)  # "the lead creeps"
    return following.has("aux") or (following.has("verb") and following.form in _VERBAL)

"""Words before a noun that are adjectives only there."""

from __future__ import annotations

from scegen.understanding.words.terms import Term, term_at

_ROADS = frozenset({"highway", "road", "ramp"})


def loose_modifier(terms: list[Term], m: int, opened: bool) -> bool:
    """Participles before a noun, and nouns or weather words used as adjectives.

    Args:
        terms: the terms of the text.
        m: index of the term in question.
        opened: an article or number stands before.
    """
    term = terms[m]
    if term.cat == "verb" and term.premod:
        return True
    following = term_at(terms, m + 1)
    follows = following.cat if following is not None else ""
    nounlike = follows in {"actor", "place", "thing", "view", "verb", "inert", "shape"}
    if term.cat == "inert":
        return opened and term.value == "adjective" and nounlike
    if term.cat == "place" and term.value in _ROADS:
        mass = following is not None and "mass" in following.data  # "slow highway traffic"
        return mass and follows == "actor" and not (m and terms[m - 1].value == "def")
    if term.cat == "env":
        return follows in {"place", "actor"}
    return opened and term.cat == "unknown" and follows in {"actor", "place", "unknown", "thing"}

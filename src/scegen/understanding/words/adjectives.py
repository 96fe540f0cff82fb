"""Words before a noun that are adjectives only there."""

from __future__ import annotations

from scegen.understanding.words.terms import Term

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
    follows = terms[m + 1].cat if m + 1 < len(terms) else ""
    nounlike = follows in {"actor", "place", "thing", "view", "verb", "inert", "shape"}
    if term.cat == "inert":
        return opened and term.value == "adjective" and nounlike
    if term.cat == "place" and term.value in _ROADS:
        mass = follows == "actor" and "mass" in terms[m + 1].data  # "slow highway traffic"
        return mass and not (m and terms[m - 1].value == "def")
    if term.cat == "env":
        return follows in {"place", "actor"}
    return opened and term.cat == "unknown" and follows in {"actor", "place", "unknown", "thing"}

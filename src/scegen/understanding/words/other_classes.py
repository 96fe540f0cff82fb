"""Words that are of another class here than most often: "facing", "neither", "left"."""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.particles import a_drive
from scegen.understanding.words.terms import Term, longest_match
from scegen.understanding.words.tokens import Token

_LANE_REACH = 6


def other_class(term: Term, terms: list[Term], tokens: list[Token]) -> Term:
    """The term with the class that the words around it ask for.

    Args:
        term: the term.
        terms: the terms before it.
        tokens: the tokens of the text.
    """
    if (term.cat, term.value) == ("verb", "collide") and _a_part(term, terms, tokens):
        return Term("dir", "rear", term.i, term.j)
    if tokens[term.i].low in word_list("films") and _filmed(term, terms):
        return Term("inert", "noun", term.i, term.j)
    if (term.cat, term.value) == ("manner", "close") and _how_measured(term, terms, tokens):
        return replace(term, value="mild")
    if _changes_from(term, tokens):
        return Term("verb", "lane_change", term.i, term.j, tokens[term.i].forms[-1][1])
    if term.value == "close" and tokens[term.i].low == "closes":
        return Term("verb", "approach", term.i, term.j, "s")
    if term.value == "neither" and _negates_a_verb(term, terms, tokens):
        return replace(term, cat="neg", value="not")
    if term.value == "left" and term.cat == "dir" and _remains(terms, tokens, term):
        return replace(term, cat="inert", value="adjective")
    if (term.cat, tokens[term.i].low) == ("dir", "next") and _of_a_row(term, tokens):
        return replace(term, cat="inert", value="adjective")
    if term.cat == "verb" and a_drive(tokens, term.i):
        return Term("place", "access", term.i, term.j, term.form)
    if tokens[term.i].low == "facing" and _across_from_somebody(term, terms, tokens):
        return Term("locus", "opposite", term.i, term.j)  # "the truck facing the ego"
    return term


def _of_a_row(term: Term, tokens: list[Token]) -> bool:
    """``from each truck to the next``: the next one, no lane beside."""
    before = [t.low for t in tokens[max(0, term.i - 2) : term.i]]
    ends = term.j >= len(tokens) or tokens[term.j].kind == "punct"
    return ends and before == ["to", "the"]


def _a_part(term: Term, terms: list[Term], tokens: list[Token]) -> bool:
    """``its rear end``: a part of a vehicle."""
    owned = bool(terms) and terms[-1].cat in {"det", "possessive"}
    return owned and [t.low for t in tokens[term.i : term.j]] == ["rear", "end"]


def _filmed(term: Term, terms: list[Term]) -> bool:
    """``the clip shows``, ``Clip: …``: a piece of film, no contact."""
    opened = not terms or terms[-1].cat == "det" or terms[-1].value == "noun"
    return term.cat == "verb" and term.form == "base" and opened


def _how_measured(term: Term, terms: list[Term], tokens: list[Token]) -> bool:
    """``40 m behind it, from bumper to bumper``: between what, not how close."""
    if tokens[term.i].low != "bumper":
        return False
    for before in reversed(terms):
        if before.cat == "punct" and before.value in {".", ";"}:
            return False
        if (before.cat, before.value) == ("quantity", "length"):
            return True
    return False


def _changes_from(term: Term, tokens: list[Token]) -> bool:
    """``changes from the right lane into the left``."""
    if term.j - term.i != 1 or tokens[term.i].forms[-1][0] != "change":
        return False
    after = tokens[term.j : term.j + _LANE_REACH]
    lane = any(t.forms[-1][0] == "lane" for t in after)
    return lane and after[0].low in {"from", "out"}


def _negates_a_verb(term: Term, terms: list[Term], tokens: list[Token]) -> bool:
    """``the van neither brakes nor yields``: its subject stands before it."""
    after = tokens[term.j].low if term.j < len(tokens) else "of"
    opens = not terms or terms[-1].cat in {"punct", "conj", "sub", "rel", "prep"}
    return term.j - term.i == 1 and not opens and after != "of" and after.isalpha()


def _remains(terms: list[Term], tokens: list[Token], term: Term) -> bool:
    """``until a metre is left``: nothing of a side."""
    ends = term.j >= len(tokens) or tokens[term.j].kind == "punct"
    copula = bool(terms) and (terms[-1].cat, terms[-1].value) == ("aux", "be")
    measured = len(terms) > 1 and terms[-2].cat not in {"actor", "pronoun", "rel"}
    return ends and copula and measured


def _across_from_somebody(term: Term, terms: list[Term], tokens: list[Token]) -> bool:
    """Whether a participant stands right before "facing", and another after it."""
    after = longest_match(tokens, term.j)
    if after is not None and after.has("det", "possessive") and after.j < len(tokens):
        after = longest_match(tokens, after.j)
    named = after is not None and after.has("actor", "pronoun")
    return named and bool(terms) and terms[-1].cat == "actor"

"""Letters and ordinals that name somebody without a noun: "A brakes", "second brakes"."""

from __future__ import annotations

import re
from dataclasses import replace

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.ordinals import POSITIONS
from scegen.understanding.words.terms import Term, term_at
from scegen.understanding.words.tokens import Token, low_at

_LETTER = re.compile(r"^[A-HJ-SU-XZ]$")
"""Not I, who tells it, and not the shapes of junctions."""
_NAMED = frozenset({"actor", "place", "thing", "inert", "shape", "leg", "limit"})
_JOINTS = frozenset({"and", "or", ","})
_PHRASE_ENDS = frozenset({"aux", "copy", "neg", "prep", "conj", "punct", "locus", "rel"})
_OPENERS = frozenset({"punct", "conj", "sub"})
_VERBAL = frozenset({"s", "ed"})


def name_letters(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """``three cars: A turns, B follows A``: each letter is one of them.

    A letter counts where its neighbour in the alphabet stands for somebody, too; in talk ("A: What
    happened? B: I braked.") it only tells who speaks, and is left out.
    """
    if not word_list("first_person").isdisjoint(t.low for t in tokens):
        told = {
            k for k, t in enumerate(terms) if _is_letter(t, tokens) and low_at(tokens, t.j) == ":"
        }
        terms = [t for k, t in enumerate(terms) if told.isdisjoint({k, k - 1})]
    letters = {
        k: tokens[t.i].text
        for k, t in enumerate(terms)
        if _is_letter(t, tokens) and (t.value != "indef" or _stands_alone(terms, k))
    }
    if not letters:
        return terms
    used = set(letters.values())
    found = list(terms)
    for k, letter in letters.items():
        named = {chr(ord(letter) - 1), chr(ord(letter) + 1)} & used
        if named and not _belongs(terms, k, tokens):
            data = {"label": f"#{letter.lower()}"}
            found[k] = replace(terms[k], cat="actor", value="car", form="base", data=data)
    return found


def _is_letter(term: Term, tokens: list[Token]) -> bool:
    if term.cat != "unknown" and (term.cat, term.value) != ("det", "indef"):
        return False
    return term.j - term.i == 1 and bool(_LETTER.match(tokens[term.i].text))


def _stands_alone(terms: list[Term], k: int) -> bool:
    """Whether "A" is no article: a verb or the end of the phrase comes after it."""
    after = term_at(terms, k + 1)
    if after is None or after.cat in _PHRASE_ENDS:
        return True
    verb = term_at(terms, k + 2) if after.cat == "manner" else after
    return verb is not None and (verb.cat, verb.form, verb.premod) == ("verb", "s", False)


def _belongs(terms: list[Term], k: int, tokens: list[Token]) -> bool:
    """``car A``, ``roads A and B``: a name after a noun."""
    m = k - 1
    while m > 0 and terms[m].value in _JOINTS and _is_letter(terms[m - 1], tokens):
        m -= 2
    return m >= 0 and terms[m].cat in _NAMED


def with_articles(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """``First car stops, second brakes``: the first car, the second."""
    named = {k for k in range(len(terms)) if _names(terms, k, tokens)}
    if not named:
        return terms
    found: list[Term] = []
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
    if tokens[term.i].low not in POSITIONS or term.j - term.i != 1:
        return False
    before, after = term_at(terms, k - 1), term_at(terms, k + 1)
    if after is None or (before is not None and before.cat not in _OPENERS):
        return False
    acts = (after.cat == "verb" and after.form in _VERBAL) or after.cat in {"aux", "copy"}
    return acts or after.cat == "actor" or after.value in {"(", ","}

"""Letters that stand for participants by themselves: "A brakes, B swerves"."""

from __future__ import annotations

import re
from dataclasses import replace

from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_LETTER = re.compile(r"^[A-HJ-SU-XZ]$")
"""Not I, who tells it, and not the shapes of junctions."""
_NAMED = frozenset({"actor", "place", "thing", "inert", "shape", "leg", "limit"})
_JOINTS = frozenset({"and", "or", ","})
_PHRASE_ENDS = frozenset({"aux", "copy", "neg", "prep", "conj", "punct", "locus", "rel"})


def name_letters(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """``three cars: A turns, B follows A``: each letter is one of them.

    A letter counts where its neighbour in the alphabet stands for somebody, too.
    """
    if not any(_LETTER.match(token.text) for token in tokens):
        return terms
    used = {
        tokens[t.i].text
        for k, t in enumerate(terms)
        if _is_letter(t, tokens) and (t.value != "indef" or _stands_alone(terms, k))
    }
    named = {c for c in used if {chr(ord(c) - 1), chr(ord(c) + 1)} & used}
    found: list[Term] = []
    for k, term in enumerate(terms):
        letter = tokens[term.i].text
        alone = letter in named and _is_letter(term, tokens) and not _belongs(terms, k, tokens)
        if alone and (term.value != "indef" or _stands_alone(terms, k)):
            data = {"label": f"#{letter.lower()}"}
            found.append(replace(term, cat="actor", value="car", form="base", data=data))
        else:
            found.append(term)
    return found


def _is_letter(term: Term, tokens: list[Token]) -> bool:
    single = term.j - term.i == 1 and bool(_LETTER.match(tokens[term.i].text))
    return single and (term.cat == "unknown" or (term.cat, term.value) == ("det", "indef"))


def _stands_alone(terms: list[Term], k: int) -> bool:
    """Whether "A" is no article: a verb or the end of the phrase comes after it."""
    after = terms[k + 1] if k + 1 < len(terms) else None
    if after is None or after.cat in _PHRASE_ENDS:
        return True
    acts = after.cat == "verb" and after.form == "s" and not after.premod
    adverb = after.cat == "manner" and k + 2 < len(terms) and terms[k + 2].cat == "verb"
    return acts or (adverb and terms[k + 2].form == "s")


def _belongs(terms: list[Term], k: int, tokens: list[Token]) -> bool:
    """``car A``, ``roads A and B``: a name after a noun."""
    m = k - 1
    while m > 0 and terms[m].value in _JOINTS and _is_letter(terms[m - 1], tokens):
        m -= 2
    return m >= 0 and terms[m].cat in _NAMED and terms[m].j == terms[m + 1].i

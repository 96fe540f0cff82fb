"""Places in a file that are counted: "the car two ahead of the ego", "the second car ahead"."""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.words.numbers import POSITIONS, number_at
from scegen.understanding.words.terms import Term, cat_at, term_at
from scegen.understanding.words.tokens import Token

_LINE = frozenset({"ahead", "behind"})
_NEXT_BUT_ONE, _MOST = 2, 5
_ENDS = {"front": "first", "ahead": "first", "rear": "last", "behind": "last"}


def count_places(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """Who is two ahead of the ego is ahead of the one ahead of it, which is told with it."""
    found: list[Term] = []
    for k, term in enumerate(terms):
        if term.cat == "dir" and term.value in _ENDS and _one_of_several(terms, k):
            end = _ENDS[term.value]
            found.append(replace(term, cat="label", value=end, data={"in_file": True}))
            continue
        line = term.cat == "locus" and term.value in _LINE
        before = term_at(terms, k - 1)
        if line and before is not None and (places := _places(terms, k, tokens)) > 1:
            counted = before if before.cat in {"num", "quantity"} else None
            i, j = (counted.i, counted.j) if counted is not None else (term.i, term.i)
            found = found[:-1] if counted is not None else found
            # "The car ahead", told later, is the only one between.
            one = Term("det", "def" if places == _NEXT_BUT_ONE else "indef", i, i)
            between = [Term("locus", term.value, i, i), one, Term("actor", "car", i, j)]
            found += between * (places - 1)
        found.append(term)
    return found


def _one_of_several(terms: list[Term], k: int) -> bool:
    """``two cars come towards us; the rear one …``: at that end of their file."""
    noun = term_at(terms, k + 1)
    several = [t.value for t in terms[:k] if t.cat == "actor" and t.form == "s"]
    if noun is None or cat_at(terms, k - 1) != "det" or not several:
        return False
    one = noun.cat == "num" and noun.data["number"] == 1
    return one or (noun.cat == "actor" and noun.form != "s" and noun.value == several[-1])


def _places(terms: list[Term], k: int, tokens: list[Token]) -> int:
    """How many places ahead or behind it is, by the words before "ahead"; 1 if none tells."""
    before = terms[k - 1]
    counts = before.cat == "num" or (before.cat, before.value) == ("quantity", "other")
    number = number_at(tokens, before.i) if counts else None
    if number is not None:  # "the car two ahead of the ego", "a truck two cars ahead of us"
        told = cat_at(terms, k - 2) == "actor" and number.value <= _MOST
        return int(number.value) if told else 1
    label = term_at(terms, k - 2)
    ranked = label is not None and label.cat == "label" and before.cat == "actor"
    if label is None or not ranked or term_at(terms, k - 3) is None or terms[k].value != "ahead":
        return 1
    several = (t for t in terms[: k - 3] if t.cat in {"num", "quant"} or t.value in POSITIONS)
    counted = terms[k - 3].value == "def" and not any(several)  # of nobody told of before
    return POSITIONS.get(label.value, 0) + 1 if counted else 1

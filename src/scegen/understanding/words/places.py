"""Words of place spelled out: near and far sides, "left of" somebody, "the car two ahead"."""

from dataclasses import replace

from scegen.scenario.vocabulary import DrivingSide
from scegen.understanding.words.numbers import POSITIONS, number_at
from scegen.understanding.words.terms import Term, cat_at, term_at
from scegen.understanding.words.tokens import Token

_AFTER = frozenset({"punct", "conj", "sub", "quantity", "prep"})
_OTHER = {"left": "right", "right": "left"}


def settle_sides(terms: list[Term], side: DrivingSide | None) -> list[Term]:
    """The terms with "near" and "far" sides replaced by left and right, "left of" spelled out.

    The near side is the side of the kerb along which one drives.
    """
    near = "left" if side is DrivingSide.LEFT else "right"
    values = {"near": near, "far": _OTHER[near]}
    found: list[Term] = []
    for k, t in enumerate(terms):
        near_or_far = t.cat == "dir" and t.value in values
        parked = k > 0 and terms[k - 1].value == "park" and t.cat == "dir" and t.value in _OTHER
        over = " ".join(x.value for x in terms[k : k + 3]) in {"left to right", "right to left"}
        if (near_or_far or parked or over) and _bare(terms, k, {"verb"} if parked else set()):
            # "crosses, right to left", "a child crossing, farside", "a van parked left"
            found.append(Term("prep", "from", t.i, t.i))
        if t.cat == "dir" and t.value in _OTHER and _of_somebody(terms, k):
            found += [Term("prep", "to", t.i, t.i), Term("det", "def", t.i, t.i)]
        if (ranked := t.data.get("dir")) in values:  # "the fast lane"
            found.append(replace(t, data={**t.data, "dir": values[ranked]}))
        else:
            found.append(replace(t, value=values[t.value], form="base") if near_or_far else t)
    return found


def _of_somebody(terms: list[Term], k: int) -> bool:
    """``in the lane left of the ego``: to the left of it."""
    before, after = terms[max(0, k - 1) : k], terms[k + 1 : k + 6]
    bare = not any(t.cat in {"det", "possessive", "quantity", "dir"} for t in before)
    named = [t.cat if t.cat != "place" else t.value for t in after if t.cat != "det"]
    whose = named[1:2] in (["actor"], ["pronoun"])
    whole = named[2:3] != ["possessive"] or named[3:4] == ["lane"]  # not "of the ego's centre"
    return bare and bool(after) and after[0].value == "of" and whose and whole


def _bare(terms: list[Term], k: int, also: set[str]) -> bool:
    """Whether a side stands alone, as in "pedestrian, nearside, 5 km/h"."""
    before, after = terms[max(0, k - 1) : k], terms[k + 1 : k + 2]
    joined = any(t.cat in {"actor", "verb", "punct", "place"} for t in before)
    return joined and all(t.cat in _AFTER | also for t in after)


_NEXT_BUT_ONE, _MOST, _RANKED = 2, 5, 3
_ENDS = {"front": "first", "ahead": "first", "rear": "last", "behind": "last"}


def count_places(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """Who is two ahead of the ego is ahead of the one ahead of it, which is told with it."""
    found: list[Term] = []
    for k, term in enumerate(terms):
        if term.cat == "dir" and term.value in _ENDS and _one_of_several(terms, k):
            end = _ENDS[term.value]
            found.append(replace(term, cat="label", value=end, data={"in_file": True}))
            continue
        line = term.cat == "locus" and term.value in {"ahead", "behind"}
        before = term_at(terms, k - 1)
        if line and k and (places := _places(terms, k, tokens)) > 1:
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
    ranked = label.cat == "label" and before.cat == "actor"
    if not ranked or k < _RANKED or terms[k].value != "ahead":
        return 1
    several = (t for t in terms[: k - 3] if t.cat in {"num", "quant"} or t.value in POSITIONS)
    counted = terms[k - 3].value == "def" and not any(several)  # of nobody told of before
    return POSITIONS.get(label.value, 0) + 1 if counted else 1

"""Sides: which is the near one, by the side of the road driven on; "left of" somebody."""

from __future__ import annotations

from dataclasses import replace

from scegen.scenario.vocabulary import DrivingSide
from scegen.understanding.words.terms import Term

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
        if (near_or_far or parked) and _bare(terms, k, {"verb"} if parked else set()):
            # "a child crossing, farside", "a van parked left"
            found.append(Term("prep", "from", t.i, t.i))
        if t.cat == "dir" and t.value in _OTHER and _of_somebody(terms, k):
            found += [Term("prep", "to", t.i, t.i), Term("det", "def", t.i, t.i)]
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
    joined = any(t.cat in {"actor", "verb", "punct"} for t in before)
    return joined and all(t.cat in _AFTER | also for t in after)

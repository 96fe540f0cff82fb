"""Which side is the near one: "nearside" and "farside" depend on the side of the road driven on."""

from __future__ import annotations

from dataclasses import replace

from scegen.scenario.vocabulary import DrivingSide
from scegen.understanding.words.terms import Term

_OTHER = {"left": "right", "right": "left"}


def settle_sides(terms: list[Term], side: DrivingSide | None) -> list[Term]:
    """The terms with "near" and "far" sides replaced by left and right.

    The near side is the side of the kerb along which one drives.

    Args:
        terms: the terms of the text.
        side: the driving side that the text names.
    """
    near = "left" if side is DrivingSide.LEFT else "right"
    values = {"near": near, "far": _OTHER[near]}
    found: list[Term] = []
    for k, t in enumerate(terms):
        near_or_far = t.cat == "dir" and t.value in values
        if near_or_far and _bare(terms, k):
            found.append(Term("prep", "from", t.i, t.i))  # "a child crossing, farside"
        found.append(replace(t, value=values[t.value], form="base") if near_or_far else t)
    return found


def _bare(terms: list[Term], k: int) -> bool:
    """Whether a side stands alone, as in "pedestrian, nearside, 5 km/h"."""
    before, after = terms[max(0, k - 1) : k], terms[k + 1 : k + 2]
    joined = any(t.cat in {"actor", "verb", "punct"} for t in before)
    return joined and all(t.cat in {"punct", "conj", "sub", "quantity", "prep"} for t in after)

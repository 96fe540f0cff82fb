"""Which side is the near one: "nearside" and "farside" depend on the side of the road driven on."""

from __future__ import annotations

from dataclasses import replace

from scegen.scenario.vocabulary import DrivingSide
from scegen.understanding.words.terms import Term

_OTHER = {"left": "right", "right": "left"}
_REACH = 4


def settle_sides(terms: list[Term], side: DrivingSide | None) -> list[Term]:
    """The terms with "near" and "far" sides replaced by left and right.

    The near side is the side of the kerb along which one drives. "The far side of the junction"
    is no such side: it is where one comes out.

    Args:
        terms: the terms of the text.
        side: the driving side that the text names.
    """
    near = "left" if side is DrivingSide.LEFT else "right"
    values = {"near": near, "far": _OTHER[near]}
    found: list[Term] = []
    for k, t in enumerate(terms):
        if t.cat != "dir" or t.value not in values or _of_a_junction(terms, k):
            found.append(t)
            continue
        if _bare(terms, k):
            found.append(Term("prep", "from", t.i, t.i))  # "a child crossing, farside"
        found.append(replace(t, value=values[t.value], form="base"))
    return found


def _bare(terms: list[Term], k: int) -> bool:
    """Whether a side stands alone, as in "pedestrian, nearside, 5 km/h"."""
    before = terms[k - 1] if k else None
    after = terms[k + 1] if k + 1 < len(terms) else None
    joined = before is not None and before.cat in {"actor", "verb", "punct"}
    return joined and (after is None or after.cat in {"punct", "conj", "sub", "quantity", "prep"})


def _of_a_junction(terms: list[Term], k: int) -> bool:
    after = terms[k + 1 : k + _REACH]
    return bool(after) and after[0].value == "of" and any(t.value == "junction" for t in after)

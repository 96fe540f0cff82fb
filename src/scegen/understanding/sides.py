"""Which side is the near one: "nearside" and "farside" depend on the side of the road driven on."""

from __future__ import annotations

from dataclasses import replace

from scegen.scenario.vocabulary import DrivingSide
from scegen.understanding.terms import Term

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
    return [
        replace(t, value=values[t.value], form="base")
        if t.cat == "dir" and t.value in values and not _of_a_junction(terms, k)
        else t
        for k, t in enumerate(terms)
    ]


def _of_a_junction(terms: list[Term], k: int) -> bool:
    after = terms[k + 1 : k + _REACH]
    return bool(after) and after[0].value == "of" and any(t.value == "junction" for t in after)

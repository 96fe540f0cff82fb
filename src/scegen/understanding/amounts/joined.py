"""Parts of a sentence that share a verb: "A brakes with 4 m/s², B 1 s later"."""

from __future__ import annotations

from collections.abc import Collection

from scegen.scenario.acts import ActKind
from scegen.understanding.amounts.figures import Figure
from scegen.understanding.entity import Entity
from scegen.understanding.happenings import Doing
from scegen.understanding.lexicon import word_list


def part_of(figure: Figure) -> tuple[int, list[Entity]]:
    """Where the part of a sentence begins in which it stands, and who it is about.

    A comma or conjunction begins a part if it has a subject of its own.
    """
    for k in range(figure.i - 1, figure.start - 1, -1):
        if k > figure.start and figure.text.tokens[k - 1].low not in word_list("joints"):
            continue
        named = (m for m in figure.text.mentions if k <= m.i < figure.i and m.prep is None)
        free = [m for m in named if m.entities]
        if free and not free[0].possessor:
            return k, list(free[0].entities)
    return figure.start, []


def likewise(figure: Figure, kinds: Collection[ActKind]) -> Doing | None:
    """``A brakes with 4 m/s², B 1 s later``: B does the same, without a verb."""
    begin, who = part_of(figure)
    text, (start, end) = figure.text, (figure.start, figure.end)
    joints = (k for k in range(figure.i, end) if text.tokens[k].low in word_list("joints"))
    elided = bool(who) and any(c.actors for c in text.within(start, begin))
    if not elided or text.within(begin, next(joints, end)):
        return None
    told = text.acts(start, begin, kinds)
    if not told or told[-1].entity in who:
        return None
    made = [text.same(told[-1], e, figure.i, figure.amount.basis) for e in who]
    return made[0]

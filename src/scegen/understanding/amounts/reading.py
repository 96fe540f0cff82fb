"""Reads all numbers of a text, what is done, when, and how it ends."""

from __future__ import annotations

from scegen.scenario.acts import ActKind
from scegen.understanding.amounts import aside, struck
from scegen.understanding.amounts.acting import read_acts
from scegen.understanding.amounts.as_fast import as_fast, kept_apart
from scegen.understanding.amounts.clauses import clauses_of
from scegen.understanding.amounts.fields import place, says_how
from scegen.understanding.amounts.figures import Figure
from scegen.understanding.amounts.items import read_items
from scegen.understanding.amounts.letting_by import go_on
from scegen.understanding.amounts.ordering import order
from scegen.understanding.amounts.outcomes import read_outcome
from scegen.understanding.amounts.telling import Telling
from scegen.understanding.chunks import Chunk
from scegen.understanding.entity import Entity
from scegen.understanding.frames import Numbers
from scegen.understanding.happenings import Doing, Happenings
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.rows import say


def read_amounts(
    numbers: Numbers, chunks: list[Chunk], scenes: list[Clause], context: Context, ego: Entity
) -> Happenings:
    """Acts, spacings and the outcome; every number in its field or reported.

    Speeds are filled in, notes are added.
    """
    text = Telling(chunks, scenes, context, ego)
    read_acts(text)
    read_outcome(text)
    figures = [Figure(q, numbers, text) for q in numbers.quantities]
    _place([f for f in figures if f.role == "speed"])
    as_fast(text)
    read_items(text)
    figures.sort(key=lambda figure: not says_how(figure.role))
    _place([f for f in figures if f.role != "speed"])
    aside.within_the_lane(text)
    struck.settle(text)
    order(text)
    go_on(text)
    kept_apart(text)
    text.found.acts = _kept(text.found)
    for clause in clauses_of(text.found):
        say("dangers.told", clause, context)
    return text.found


def _place(figures: list[Figure]) -> None:
    for figure in figures:
        if not place(figure):
            figure.note()


def _kept(found: Happenings) -> list[Doing]:
    """Acts that are ones by themselves, or that a number or another act makes ones."""
    named = [d.when.act for d in found.acts if d.when is not None and d.when.act is not None]
    named += [s.at for s in found.spacings if isinstance(s.at, Doing)]
    home = [(d.entity, d.i) for d in found.acts if d.kind is ActKind.CHANGE_LANE]
    kept = [
        d
        for d in found.acts
        if d.always or d.amounts or d.when is not None or d in named
        or (d.kind is ActKind.OVERTAKE  # "overtakes it on the right", "overtakes it and cuts in"
            and (d.side is not None or any(e is d.entity and i > d.i for e, i in home)))
    ]  # fmt: skip
    counts: dict[ActKind, int] = {}
    for doing in kept:
        counts[doing.kind] = counts.get(doing.kind, 0) + 1
        doing.name = f"{doing.kind.value}_{counts[doing.kind]}"
    return kept

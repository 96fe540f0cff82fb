"""Reads all numbers of a text, what is done, when, and how it ends."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from scegen.scenario.acts import ActKind
from scegen.understanding.amounts.acting import acts_in
from scegen.understanding.amounts.as_fast import as_fast, kept_apart
from scegen.understanding.amounts.aside import Aside
from scegen.understanding.amounts.clauses import clauses_of
from scegen.understanding.amounts.doings import FIELDS, Filler
from scegen.understanding.amounts.items import items_in
from scegen.understanding.amounts.letting_by import go_on
from scegen.understanding.amounts.outcomes import Judge
from scegen.understanding.amounts.placed import MEASURES, Spacer
from scegen.understanding.amounts.releasing import Releaser
from scegen.understanding.amounts.sentences import Sentences
from scegen.understanding.amounts.sizes import SIZES, owns, size_of
from scegen.understanding.amounts.speeds import held, relative
from scegen.understanding.amounts.struck import Struck
from scegen.understanding.amounts.timing import Clock
from scegen.understanding.chunks import Chunk
from scegen.understanding.frames import AmountFrame, Measured, Numbers
from scegen.understanding.happenings import Doing, Happenings
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.rows import say
from scegen.understanding.words.quantities import Quantity


def read_amounts(
    numbers: Numbers, chunks: list[Chunk], scenes: list[Clause], context: Context
) -> Happenings:
    """Acts, spacings and the outcome; every number in its field or reported.

    Args:
        numbers: the numbers of the text.
        chunks: its chunks.
        scenes: what happens, in the order of the text.
        context: the scenario in the making; speeds are filled in, notes are added.
    """
    text = Sentences(context.tokens, chunks, scenes)
    found = Happenings(acts=acts_in(text, context))
    judge = Judge(text, context, found)
    judge.read()
    measured = [_of_a_size(_measured(q, numbers, text), text) for q in numbers.quantities]
    for number in (n for n in measured if n.frame.role == "speed"):
        if not held(number, text, context, found):
            _note(number, context)
    as_fast(text, context)
    found.items = items_in(text, context)
    filler, clock = Filler(text, context, found), Clock(text, context, found)
    spacer, releaser = Spacer(text, context, found), Releaser(text, context, found)
    for number in (n for n in measured if n.frame.role in FIELDS):
        if not filler.read(number):
            _note(number, context)
    takers: dict[str, Callable[[Measured], bool]] = {
        **dict.fromkeys(MEASURES, spacer.read),
        **dict.fromkeys(SIZES, lambda number: size_of(number, text, found, context.draft)),
        "driven": releaser.driven,
        "delay": clock.delay,
        "impact": judge.impact,
        "relative_speed": lambda number: relative(number, text, context),
    }
    for number in (n for n in measured if n.frame.role not in FIELDS and n.frame.role != "speed"):
        take = takers.get(number.frame.role)
        if take is None or not take(number):
            _note(number, context)
    Aside(text, context, found).within_the_lane()
    Struck(text, context, found).settle()
    clock.order()
    found.acts = go_on(found.acts, text)
    kept_apart(found)
    found.acts = _kept(found)
    for clause in clauses_of(found):
        say("dangers.told", clause, context)
    return found


def _measured(quantity: Quantity, numbers: Numbers, text: Sentences) -> Measured:
    event = text.verb_at(quantity.i, quantity.j)
    if event is None:
        return numbers.measured(quantity)
    return numbers.measured(quantity, event.name, None if event.perfect else event.i)


def _of_a_size(number: Measured, text: Sentences) -> Measured:
    """``a 12 m bus``: how large the noun is before which a length stands."""
    known = number.frame.role in SIZES or (number.frame.role == "other" and number.frame.next)
    if known or number.frame.dimension != "length" or owns(number, text.chunks) is None:
        return number
    return replace(number, frame=AmountFrame("length", "long"))


def _note(number: Measured, context: Context) -> None:
    instead = number.frame.instead or "a measure that no rule could attach; left out"
    context.draft.note(number.i, number.j, instead)


def _kept(found: Happenings) -> list[Doing]:
    """Acts that are ones by themselves, or that a number or another act makes ones."""
    acts = found.acts
    named = [d.when.act for d in acts if d.when is not None and d.when.act is not None]
    named += [s.at for s in found.spacings if isinstance(s.at, Doing)]
    kept = [d for d in acts if d.always or d.amounts or d.when is not None or d in named]
    sided = [d for d in acts if d.kind is ActKind.OVERTAKE and d.side is not None]
    kept = [d for d in acts if d in kept or d in sided]  # "overtakes it on the right"
    counts: dict[ActKind, int] = {}
    for doing in kept:
        counts[doing.kind] = counts.get(doing.kind, 0) + 1
        doing.name = f"{doing.kind.value}_{counts[doing.kind]}"
    return kept

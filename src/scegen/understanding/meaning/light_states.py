"""What is said of lights that no field holds: when they change, amber, lights of people on foot."""

from __future__ import annotations

from collections.abc import Iterable

from scegen.understanding.chunks import Event, Place
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context

_TURNS = "when a light changes follows from its plan; it is not set by the text"
_AMBER = "crossing on amber is not judged: a line is passed on red, or not on red"
_AFOOT = "people on foot have no lights of their own"


def note_states(clauses: Iterable[Clause], context: Context) -> None:
    """Reports them.

    Args:
        clauses: what happens, dangers understood.
        context: the scenario in the making; remarks are added.
    """
    for clause in clauses:
        event = clause.event
        if event.name == "inert" and _is_light(event.object):
            _note(event, event.object, _TURNS, context)
        for prep in event.pps:
            if not isinstance(prep.target, Place) or not _is_light(prep.target):
                continue
            words = {t.low for t in context.tokens[prep.target.i : prep.target.j]}
            if words & set(word_list("flashing_colours")):
                context.draft.note(prep.target.i, prep.target.j, _AMBER)
            elif clause.walkers and words & set(word_list("light_colours")):
                context.draft.note(prep.target.i, prep.target.j, _AFOOT)


def _is_light(thing: object) -> bool:
    return isinstance(thing, Place) and thing.kind == "signal"


def _note(event: Event, light: object, instead: str, context: Context) -> None:
    ends = [event.j, light.j] if isinstance(light, Place) else [event.j]
    begins = [event.i, light.i] if isinstance(light, Place) else [event.i]
    context.draft.note(min(begins), max(ends), instead)

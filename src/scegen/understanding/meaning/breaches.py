"""Rules that are broken: red lights, signs, the right of way."""

from __future__ import annotations

from scegen.scenario.vocabulary import Control, HazardKind
from scegen.understanding.semantics.context import Context


def subsume(context: Context) -> None:
    """Who runs a red light does not give way either; the first says it all.

    Nobody runs a light that does not work.
    """
    if context.junction.control is Control.SIGNALS_OFF:
        _none_is_red(context)
    red = {
        e.index
        for d in context.draft.dangers
        if d.kind is HazardKind.RED_LIGHT_RUNNING
        for e in d.by
    }
    context.draft.dangers[:] = [
        d
        for d in context.draft.dangers
        if d.kind is not HazardKind.FAILURE_TO_YIELD or not d.by or {e.index for e in d.by} - red
    ]


def _none_is_red(context: Context) -> None:
    for danger in context.draft.dangers:
        basis = danger.basis
        red = danger.kind is HazardKind.RED_LIGHT_RUNNING
        if red and basis.i is not None and basis.j is not None:
            context.draft.note(basis.i, basis.j, "a light that does not work is not run; left out")
    context.draft.dangers[:] = [
        d for d in context.draft.dangers if d.kind is not HazardKind.RED_LIGHT_RUNNING
    ]

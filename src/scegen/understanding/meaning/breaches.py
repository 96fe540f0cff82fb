"""Rules that are broken: red lights, signs, the right of way."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind
from scegen.understanding.draft import Danger
from scegen.understanding.semantics.context import Context


def subsume(context: Context) -> None:
    """Who runs a red light does not give way either; the first says it all."""
    red = {
        e.index
        for d in context.draft.dangers
        if d.kind is HazardKind.RED_LIGHT_RUNNING
        for e in d.by
    }
    context.draft.dangers[:] = [
        d for d in context.draft.dangers if d.by or d.to or not _told_of_somebody(d, context)
    ]
    context.draft.dangers[:] = [
        d
        for d in context.draft.dangers
        if d.kind is not HazardKind.FAILURE_TO_YIELD or not d.by or {e.index for e in d.by} - red
    ]


def _told_of_somebody(danger: Danger, context: Context) -> bool:
    """``Running a red light: a van runs …``: what nobody does is what somebody does."""
    alike = [d for d in context.draft.dangers if d.kind is danger.kind and d.by]
    return bool(alike) and danger.kind not in {HazardKind.OBSTACLE, HazardKind.OCCLUSION}

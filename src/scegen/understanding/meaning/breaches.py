"""Rules that are broken: red lights, signs, the right of way."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, Control, DrivingSide, HazardKind
from scegen.understanding.draft import Danger, Draft
from scegen.understanding.semantics.context import Context

_FROM_THE_SIDE = frozenset({Approach.LEFT, Approach.RIGHT})


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


def onto_the_road(draft: Draft, side: DrivingSide) -> None:
    """Who comes from the side and turns left in front of somebody fails to give way.

    An unprotected left turn is one across oncoming traffic.

    Args:
        draft: the scenario in the making, positions settled.
        side: which side traffic keeps to.
    """
    for danger in draft.dangers:
        across = danger.kind is HazardKind.UNPROTECTED_LEFT_TURN and side is DrivingSide.RIGHT
        aside = all(e.approaches and e.approaches <= _FROM_THE_SIDE for e in danger.by)
        if across and danger.by and aside:
            danger.kind = HazardKind.FAILURE_TO_YIELD
    kept: list[Danger] = []
    for danger in draft.dangers:
        same = next((d for d in kept if d.kind is danger.kind and d.by == danger.by), None)
        if same is None or danger.kind is not HazardKind.FAILURE_TO_YIELD:
            kept.append(danger)
    draft.dangers[:] = kept

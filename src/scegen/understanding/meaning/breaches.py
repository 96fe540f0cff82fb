"""Rules that are broken: red lights, signs, the right of way."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, Control, HazardKind
from scegen.understanding.chunks import Mention, NounPhrase, Place, Thing
from scegen.understanding.draft import Basis, Danger
from scegen.understanding.semantics.context import Clause, Context

_CERTAIN = frozenset({"walk", "breach", "obey", "encounter", "overlook"})
"""Verbs that, with a sign or a light, mean that it is not heeded, whatever its colour."""


def fail_to_yield(clause: Clause, context: Context) -> None:
    """Yielding that does not happen."""
    context.draft.hazard(HazardKind.FAILURE_TO_YIELD, clause.words, clause.drivers, clause.targets)
    _from_the_side(clause, context)


def _from_the_side(clause: Clause, context: Context) -> None:
    """Who has to give way and comes from the side comes from another road."""
    sides = (Approach.LEFT, Approach.RIGHT)
    if context.draft.from_kerb:
        return
    if any(context.placed(e, side) for e in clause.drivers for side in sides):
        context.crossing_implied(clause.words, "who does not give way comes from the side")


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


def turns_across(clause: Clause, context: Context) -> bool:
    """A turn across the oncoming lane, which a red light forbids everywhere."""
    event = clause.event
    side = event.object.dirs if isinstance(event.object, Place) else []
    return event.name in {"turn", "light"} and context.across in {
        *(t.value for t in event.dirs),
        *side,
    }


def may_break(clause: Clause, context: Context) -> bool:
    """Whether a movement is one that a red light forbids, or is said to go against it.

    Args:
        clause: what happens.
        context: the scenario in the making.
    """
    return turns_across(clause, context) or _defies(clause, context)


def _defies(clause: Clause, context: Context) -> bool:
    """``creeps over the line against the red``: whatever it does there, it may not."""
    return any(
        context.tokens[p.word.i].low in {"against", "despite"}
        and isinstance(p.target, Place)
        and p.target.kind == "signal"
        for p in clause.event.pps
    )


def _regulated(context: Context) -> bool:
    return context.junction.crossing or context.junction.control is not None


def _breach_of_control(clause: Clause, context: Context) -> None:
    """``a stop sign … a car ignores it``, ``ignores the tram``: who has to wait does not."""
    signals = context.junction.control is Control.SIGNALS
    ignored = [clause.event.object, *(p.target for p in clause.event.pps)]
    pronoun = any(isinstance(m, Mention) and m.pronoun is not None for m in ignored)
    if signals and pronoun:
        context.draft.hazard(HazardKind.RED_LIGHT_RUNNING, clause.words, clause.drivers)
    else:
        context.draft.hazard(HazardKind.FAILURE_TO_YIELD, clause.words, clause.drivers)


def _sign(noun: NounPhrase | None, context: Context) -> bool:
    """``ignores its sign``: one that says who waits."""
    return isinstance(noun, Thing) and context.tokens[noun.j - 1].forms[-1][0] == "sign"


def breach(clause: Clause, context: Context) -> bool:
    """``runs the red light``, ``ignores a stop sign``, ``violates the right of way``.

    Returns:
        Whether a rule is broken.
    """
    before = len(context.draft.dangers)
    driven_through = {
        id(p.target)
        for p in clause.event.pps
        if context.tokens[p.word.i].low in {"through", "against"}
    }
    through = [p.target for p in clause.event.pps if id(p.target) in driven_through]
    ignored = any(isinstance(m, Mention) for m in (clause.event.object, *through))
    if clause.event.name == "breach" and ignored and _regulated(context):
        _breach_of_control(clause, context)
    if clause.event.name == "breach" and _sign(clause.event.object, context):
        context.draft.hazard(HazardKind.FAILURE_TO_YIELD, clause.words, clause.drivers)
    over = {
        id(p.target)
        for p in clause.event.pps
        if context.tokens[p.word.i].low in {"over", "past", "through", "across", "beyond"}
    }
    if any(p.kind == "stop_line" and id(p) in over for p in clause.places()):
        others = [e for e in clause.drivers if not e.ego]
        if others:
            context.draft.hazard(HazardKind.FAILURE_TO_YIELD, clause.words, others)
    for place in clause.places():
        certain = clause.event.name in _CERTAIN or id(place) in driven_through
        basis = Basis(clause.event.i, max(place.j, clause.event.j))
        words = {t.low for t in context.tokens[place.i : place.j]}
        if place.kind == "signal":
            if "green" in words or not (certain or "red" in words):
                continue
            if clause.drivers or not clause.walkers:
                context.draft.hazard(HazardKind.RED_LIGHT_RUNNING, basis, clause.drivers)
        elif certain and place.kind in {"stop_sign", "yield_sign", "right_of_way"}:
            context.draft.hazard(HazardKind.FAILURE_TO_YIELD, basis, clause.drivers)
            _from_the_side(clause, context)
    return len(context.draft.dangers) > before

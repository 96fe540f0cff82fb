"""Dangers from what hides somebody or blocks the way."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind, Maneuver
from scegen.understanding.chunks import Event, Mention, NounPhrase, Place, Prep, Thing
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.rows import say

_HIDING = frozenset({"behind", "between"})
_OPAQUE_PLACES = frozenset({"bus_stop", "feature", "parking"})
_SPRINGING = frozenset({"cross", "appear"})
_COMING = frozenset({"move", "enter", "pull_out"})
_WAITING = frozenset({"wait", "locate", "walk", "move", "stop", "park", "appear"})


def from_behind(clause: Clause, context: Context) -> None:
    """``emerges from behind a parked van``: until then it was out of sight."""
    for prep in clause.event.pps:
        unknown = prep.target is None and prep.outer == "from" and clause.event.name in _SPRINGING
        people = any(not e.is_vehicle or context.is_cyclist(e) for e in clause.actors)
        if not _hides(prep) and not (unknown and people):
            continue
        out = prep.outer == "from" or context.tokens[prep.word.i].low == "from"
        sprung = out or clause.event.name == "appear"
        sprung = sprung or (prep.value == "between" and bool(clause.walkers))
        still = isinstance(prep.target, Thing) or _stands(prep, context)
        sprung = sprung or (still and people and clause.event.name == "cross")
        if sprung:
            basis, by = _screen(prep, clause.actors)
            context.draft.hazard(HazardKind.OCCLUSION, basis, by)
            if clause.event.name in _COMING:
                say("dangers.cyclists_cross", clause, context)
        elif clause.event.name in _WAITING:
            wait_behind(prep, clause.actors, context)


def _stands(prep: Prep, context: Context) -> bool:
    """``crosses behind a stationary bus``: what hides stands still."""
    target = prep.target
    if not isinstance(target, Mention) or not target.entities:
        return False
    stopped = [e for d in context.draft.dangers if d.kind is HazardKind.STOPPING for e in d.by]
    return all(e.parked or e in stopped for e in target.entities)


def wait_behind(prep: Prep, entities: list[Entity], context: Context) -> None:
    """``waits behind a kiosk``: out of sight if they come out later.

    Args:
        prep: the phrase that says behind what.
        entities: who is there.
        context: the scenario in the making.
    """
    if not _hides(prep):
        return
    basis, by = _screen(prep, entities)
    for entity in entities:
        if not entity.is_vehicle or (context.is_cyclist(entity) and not entity.ego):
            context.draft.screened.append((entity, basis, by))


def come_out(context: Context) -> None:
    """Who waited out of sight and crosses after all was hidden."""
    backing = [e for d in context.draft.dangers if d.kind is HazardKind.REVERSING for e in d.by]
    for entity, basis, by in context.draft.screened:
        seen = bool(by) and all(e in backing for e in by)  # "walks behind a reversing van"
        unsaid = not entity.maneuvers and not entity.is_vehicle  # on foot one crosses then
        if (Maneuver.CROSS in entity.maneuvers or unsaid) and not seen:
            context.draft.hazard(HazardKind.OCCLUSION, basis, by)


def _hides(prep: Prep) -> bool:
    """Behind something that one cannot see through."""
    if prep.word.cat != "locus" or prep.value not in _HIDING:
        return False
    target: NounPhrase | Event | None = prep.target
    if isinstance(target, Place):
        return target.kind in _OPAQUE_PLACES
    if isinstance(target, Mention):
        return not any(e.ego or not e.is_vehicle for e in target.entities)
    return isinstance(target, Thing)


def _screen(prep: Prep, actors: list[Entity]) -> tuple[Basis, list[Entity]]:
    target = prep.target
    by = list(target.entities) if isinstance(target, Mention) else []
    end = target.j if target is not None else prep.word.j
    return Basis(prep.word.i, end), [e for e in by if e not in actors]

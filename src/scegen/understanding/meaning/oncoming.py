"""Who comes from the front, by what they have to do with others that do."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding.chunks import Mention
from scegen.understanding.draft import Basis, Entity, Placement
from scegen.understanding.semantics.context import Clause, Context

_SLOWER = frozenset({HazardKind.STOPPING, HazardKind.SLOW_DRIVING})


def hidden_behind(clause: Clause, context: Context) -> None:
    """``a motorcycle hidden behind an oncoming bus``: it comes the same way as the bus.

    Args:
        clause: what happens.
        context: the scenario in the making.
    """
    if clause.event.name != "hide" or not clause.event.passive:
        return
    for prep in clause.event.pps:
        if prep.value != "behind" or not isinstance(prep.target, Mention):
            continue
        if any("opposite" in e.dirs for e in clause.drivers):
            basis = Basis(clause.event.i, prep.target.j, "what it hides comes from the front")
            for entity in prep.target.entities:
                told = any(p.entity is entity for p in context.draft.placements)
                if entity.moving_vehicle and not (entity.ego or told):
                    context.draft.place(entity, None, {Approach.OPPOSITE}, basis)
        if not any(context.oncoming(e) for e in prep.target.entities):
            continue
        basis = Basis(clause.event.i, prep.target.j, "what hides it comes from the front")
        for entity in clause.drivers:
            said = [p for p in context.draft.placements if p.entity is entity]
            if not entity.ego and all(p.reference in prep.target.entities for p in said):
                context.draft.place(entity, None, {Approach.OPPOSITE}, basis)


def turned_across(context: Context) -> None:
    """``the ego turns left across the path of a motorcyclist``: who comes towards it.

    Args:
        context: the scenario in the making.
    """
    for danger in context.draft.dangers:
        if danger.kind is not HazardKind.UNPROTECTED_LEFT_TURN or not any(e.ego for e in danger.by):
            continue
        others = [e for e in context.draft.entities if e.moving_vehicle and not e.ego]
        for entity in danger.to or (others if len(others) == 1 else []):
            told = any(p.entity is entity for p in context.draft.placements)
            if entity.moving_vehicle and not told and entity.heading is None:
                basis = Basis(danger.basis.i, danger.basis.j, "the turn leads across its way")
                context.draft.place(entity, None, {Approach.OPPOSITE}, basis)


def overtaken(clause: Clause, context: Context) -> None:
    """``an oncoming van overtakes a bus``: both come the same way.

    Args:
        clause: what happens.
        context: the scenario in the making.
    """
    if clause.event.name not in {"overtake", "pass", "bypass"} or clause.event.negated:
        return
    called = [e for e in clause.targets if "opposite" in e.dirs]
    for known, others in ((clause.drivers, clause.targets), (called, clause.drivers)):
        if not any(context.oncoming(e) for e in known):
            continue
        basis = Basis(
            clause.event.i, clause.event.j, "one that comes from the front passes another"
        )
        for entity in others:
            seen = [p for p in context.draft.placements if p.entity is entity and by_the_ego(p)]
            if entity.moving_vehicle and not entity.ego and not seen:
                context.draft.place(entity, None, {Approach.OPPOSITE}, basis)


def faced(clause: Clause, context: Context) -> None:
    """``in the opposite lane, the ego is confronted with a van``: it comes head-on.

    Args:
        clause: what happens.
        context: the scenario in the making.
    """
    event = clause.event
    egos = [e for e in clause.actors + clause.targets if e.ego]
    across = any(
        d.kind is HazardKind.ONCOMING_LANE and any(e.ego for e in d.by)
        for d in context.draft.dangers
    )
    passing = across or any(Maneuver.OVERTAKE in e.maneuvers for e in egos)
    meets = event.name == "encounter" or event.lemma == "meet"
    if not meets or event.negated or not egos or not passing:
        return
    others = [p.target for p in event.pps if p.value in {"with", "by"}]
    found = [e for m in others if isinstance(m, Mention) for e in m.entities]
    for entity in [*clause.actors, *clause.targets, *found]:
        seen = any(p.entity is entity for p in context.draft.placements)
        slow = any(entity in d.by and d.kind in _SLOWER for d in context.draft.dangers)
        if entity.moving_vehicle and not (entity.ego or seen or slow):
            basis = Basis(event.i, event.j, "who is met in the oncoming lane comes head-on")
            context.draft.place(entity, None, {Approach.OPPOSITE}, basis)


def met(clause: Clause, context: Context) -> None:
    """``uses the oncoming lane once the approaching van has gone by``: the van is met there.

    Args:
        clause: what happens.
        context: the scenario in the making.
    """
    event = clause.event
    if event.name not in {"approach", "move"} or event.object is not None or event.negated:
        return
    meets = context.junction.crossing or context.draft.crossing_implied is not None
    leaves = any(
        d.kind is HazardKind.ONCOMING_LANE and any(e.ego for e in d.by)
        for d in context.draft.dangers
    )
    described = event.premod_of is not None and event.name == "approach"
    if meets or not (leaves or described):
        return
    basis = Basis(event.i, event.j, "who approaches on an open road comes from the front")
    for entity in clause.drivers:
        seen = [p for p in context.draft.placements if p.entity is entity or p.reference is entity]
        if not entity.ego and not seen and entity.heading is None and not entity.maneuvers:
            context.draft.place(entity, None, {Approach.OPPOSITE}, basis)


def by_the_ego(placement: Placement) -> bool:
    """Whether it says where somebody is as the ego sees it.

    Args:
        placement: a position.
    """
    return placement.reference is None or placement.reference.ego


def from_behind(clause: Clause, context: Context) -> None:
    """``while a motorcycle overtakes``: the ego, if nobody else is named.

    Args:
        clause: what happens.
        context: the scenario in the making.
    """
    if clause.event.name != "overtake" or clause.targets or clause.event.negated:
        return
    others = [e for e in clause.drivers if not e.ego]
    if len(others) < len(clause.drivers) or not any(e.ego for e in context.draft.entities):
        return
    if any(context.oncoming(e) for e in context.draft.entities):
        return  # it may be one of those that it overtakes
    for entity in others:
        if entity.heading is None and not any(p.entity is entity for p in context.draft.placements):
            basis = Basis(clause.event.i, clause.event.j, "who overtakes comes from behind")
            context.draft.place(entity, None, {Approach.BEHIND}, basis)


def _from_the_front(entity: Entity, context: Context) -> bool:
    return context.oncoming(entity) or any(
        p.entity is entity
        and p.approaches == {Approach.OPPOSITE}
        and p.reference is not None
        and p.reference.ego
        for p in context.draft.placements
    )


def unseen(context: Context) -> None:
    """``an oncoming truck hides the lane beside it, from which a van comes``: from the front.

    Args:
        context: the scenario in the making.
    """
    draft = context.draft
    for danger in draft.dangers:
        hidden = [e for e in danger.by if e.moving_vehicle and not e.ego]
        if danger.kind is not HazardKind.OCCLUSION or not hidden:
            continue
        others = [e for e in draft.entities if e.moving_vehicle and e not in hidden and not e.ego]
        if not others or not all(_from_the_front(e, context) for e in others):
            continue
        for entity in hidden:
            if not any(p.entity is entity for p in draft.placements):
                basis = Basis(danger.basis.i, danger.basis.j, "what hides it comes from the front")
                draft.place(entity, None, {Approach.OPPOSITE}, basis)

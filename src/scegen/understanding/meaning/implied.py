"""Positions that follow from what happens: who is driven up to is ahead."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding.chunks import Event, Mention, Place, Prep
from scegen.understanding.draft import Basis, Danger, Entity
from scegen.understanding.meaning.reactions import into_rear
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.rows import say
from scegen.understanding.semantics.ways import head_on
from scegen.understanding.words.terms import Term

_CLOSING = frozenset({"approach", "encounter", "collide", "move", "brake", "hard_brake", "slow",
                      "speed", "accelerate", "dash"})  # fmt: skip
_COMING = frozenset({"move", "approach", "enter", "speed", "accelerate", "collide", "overtake"})
_TOWARDS = frozenset({"to", "into", "in", "for", "with"})
_HEAD_ON = frozenset({"towards", "toward"})
_SLOWER = frozenset({HazardKind.STOPPING, HazardKind.SLOW_DRIVING})


def positions(clauses: list[Clause], context: Context) -> None:
    """Places who is driven up to, and who comes out of the next lane or the oncoming one."""
    for clause in clauses:  # "meets a van that comes towards it": before who is met is ahead
        if clause.event.lemma == "come" and any(e.ego for e in clause.targets):
            for driver in clause.drivers if not clause.event.negated else []:
                _comes_towards(clause, driver, context)
    for clause in clauses:
        say("positions.any", clause, context)
        _driven_up_to(clause, context)
    _turned_across(context)
    for danger in context.draft.dangers:
        if danger.kind is HazardKind.ONCOMING_LANE:
            _face_to_face(danger, context)


def _only_other(clause: Clause, context: Context) -> list[Entity]:
    """``a man walks along the road, the ego approaches from behind``: the man is approached."""
    others = [e for e in context.draft.entities if e not in clause.actors]
    rear = any(p.value == "behind" and p.outer == "from" for p in clause.event.pps)
    ego = all(e.ego for e in clause.drivers)
    if not (rear and ego and clause.event.name == "approach" and len(others) == 1):
        return []
    basis = Basis(clause.event.i, clause.event.j, "it is approached from behind")
    if not any(p.entity is others[0] for p in context.draft.placements):
        context.draft.place(others[0], None, {Approach.AHEAD}, basis)
    return []


def _driven_up_to(clause: Clause, context: Context) -> None:
    """``closes in on a stopped van``, ``encounters a slow tractor``: it is ahead."""
    event = clause.event
    if event.name not in _CLOSING or event.negated or not clause.drivers:
        return
    targets = list(clause.targets)
    for prep in event.pps:
        towards = prep.value in _TOWARDS or context.tokens[prep.word.i].low == "on"
        rear = _queue(prep.target) or _from_the_rear(clause, context)
        towards = towards or (prep.value == "of" and rear)
        if towards and isinstance(prep.target, Mention):
            targets += [e for e in prep.target.entities if e not in clause.actors]
    ends = [event.object, *(p.target for p in event.pps)]
    owners = [c.owner for c in ends if isinstance(c, Place) and "rear" in c.dirs and c.owner]
    targets += [e for m in owners for e in m.entities if e not in (*clause.actors, *targets)]
    struck = event.object
    if _from_the_rear(clause, context) and isinstance(struck, Place) and struck.owner is not None:
        targets += [e for e in struck.owner.entities if e not in clause.actors]
    driver = clause.drivers[0]
    targets += _only_other(clause, context) if not targets else []
    if any(e.ego for e in targets):
        for other in clause.drivers:
            _comes_towards(clause, other, context)
        targets = [e for e in targets if not e.ego or _from_the_rear(clause, context)]
    elif _own(event, context) & _HEAD_ON and event.lemma == "come":
        _comes_to_meet(clause, context)
        return
    certain = _from_the_rear(clause, context) or _along_the_road(clause, context)
    late = [d for d in context.draft.dangers if d.kind is HazardKind.DELAYED_BRAKING]
    certain = certain or any(driver in d.by for d in late)  # "failed to stop and hit the bus"
    for target in targets:
        slower = certain or _slower(target, context)
        if target.moving_vehicle and _on_the_wrong_side(driver, context):
            basis = Basis(event.i, event.j, "who drives on the wrong side comes head-on")
            context.draft.place(driver, target, {Approach.OPPOSITE}, basis)
            continue
        crosses = Maneuver.CROSS in target.maneuvers
        if target.is_vehicle and slower and not crosses and not _placed(target, driver, context):
            reason = "who is driven up to is ahead"
            context.ahead([target], [driver], Basis(event.i, event.j, reason))


def _queue(target: object) -> bool:
    """``approaches the tail of a queue``."""
    head = target.head if isinstance(target, Mention) else None
    return head is not None and "mass" in head.data


def _on_the_wrong_side(entity: Entity, context: Context) -> bool:
    dangers = [d for d in context.draft.dangers if d.kind is HazardKind.ONCOMING_LANE]
    passing = Maneuver.OVERTAKE in entity.maneuvers
    return not passing and any(entity in d.by for d in dangers)


def _comes_towards(clause: Clause, driver: Entity, context: Context) -> None:
    """``drives towards the ego``: head-on, unless it comes from somewhere else."""
    towards = [p.word.j for p in clause.event.pps if context.tokens[p.word.i].low in _HEAD_ON]
    towards += [p.word.j for p in clause.event.pps if _at_the_ego(p, clause, context)]
    towards += [clause.event.j for t in _own(clause.event, context) if t in _HEAD_ON]
    ego = next(e for e in context.draft.entities if e.ego)
    if towards and not _placed(driver, ego, context):
        basis = Basis(clause.event.i, towards[0], "comes towards the ego")
        context.draft.place(driver, None, {Approach.OPPOSITE}, basis)
        for place in clause.places():
            if head_on(clause, place, context):
                words = Basis(place.i, place.j)
                context.draft.hazard(HazardKind.ONCOMING_LANE, words, [driver], [ego])


def _comes_to_meet(clause: Clause, context: Context) -> None:
    """``comes towards it``: towards one who drives, or past one who stands, from the front."""
    met = next((e for e in clause.targets if e.moving_vehicle and not e.still), None)
    for driver in clause.drivers:
        if met is None or not _placed(driver, met, context):
            basis = Basis(clause.event.i, clause.event.j, "comes the other way")
            context.draft.place(driver, met, {Approach.OPPOSITE}, basis)


def _at_the_ego(prep: Prep, clause: Clause, context: Context) -> bool:
    """``comes straight at the ego``."""
    goal = context.tokens[prep.word.i].low == "at" and isinstance(prep.target, Mention)
    return goal and clause.event.name in {"move", "speed", "approach"}


def meet_head_on(term: Term, clause: Clause, context: Context) -> None:
    """``a motorcycle approaches head-on``: who collides so has come from the front, too.

    Args:
        term: the words for it.
        clause: what happens.
        context: the scenario in the making.
    """
    coming = clause.event.name in _COMING
    if len(clause.drivers) > 1 and not clause.targets:
        for entity in clause.drivers:
            entity.opposed |= {e.index for e in clause.drivers} - {entity.index}
        return  # "two trucks meet head-on"
    for entity in clause.drivers if coming else []:
        to = next((e for e in clause.targets if e.moving_vehicle), None)
        context.draft.place(entity, to, {Approach.OPPOSITE}, Basis(term.i, term.j))


def _own(event: Event, context: Context) -> set[str]:
    return {t.low for t in context.tokens[event.i : event.j]}


def _from_the_rear(clause: Clause, context: Context) -> bool:
    """``rear-ends``, ``runs into the back of``."""
    return clause.event.name == "collide" and into_rear(clause.event, context)


def _along_the_road(clause: Clause, context: Context) -> bool:
    """Closing in on another where no roads meet: in the same lane."""
    meet = context.junction.crossing or context.draft.crossing_implied is not None
    towards = any(context.tokens[p.word.i].low in _HEAD_ON for p in clause.event.pps)
    if _own(clause.event, context) & _HEAD_ON:
        return False  # "comes towards them"
    return not meet and (clause.event.name == "approach" or towards)


def _slower(entity: Entity, context: Context) -> bool:
    """Whether somebody stands or drives slowly, so that others close in from behind."""
    return entity.still or any(entity in d.by and d.kind in _SLOWER for d in context.draft.dangers)


def _placed(entity: Entity, observer: Entity, context: Context) -> bool:
    """Whether something is already said of where one is, seen from the other or from the ego."""
    across = {Approach.LEFT, Approach.RIGHT, Approach.OPPOSITE, Approach.AHEAD, Approach.BEHIND}
    return any(
        (p.entity is entity and p.reference in {None, observer})
        or (p.entity is observer and (p.reference is entity or (entity.ego and not p.reference)))
        for p in context.draft.placements
        if p.approaches & across
    )


def _face_to_face(danger: Danger, context: Context) -> None:
    """Who drives in the lane of oncoming traffic and who suffers it come towards each other."""
    victims = danger.to or [e for e in context.draft.entities if e.ego and e not in danger.by]
    for culprit in danger.by:
        for victim in victims:
            both = culprit.moving_vehicle and victim.moving_vehicle
            if (
                both
                and not _placed(culprit, victim, context)
                and not _placed(victim, culprit, context)
            ):
                basis = Basis(danger.basis.i, danger.basis.j, "they use the same lane head-on")
                context.draft.place(culprit, victim, {Approach.OPPOSITE}, basis)


def _turned_across(context: Context) -> None:
    """``the ego turns left across the path of a motorcyclist``: who comes towards it."""
    for danger in context.draft.dangers:
        if danger.kind is not HazardKind.UNPROTECTED_LEFT_TURN or not any(e.ego for e in danger.by):
            continue
        others = [e for e in context.draft.entities if e.moving_vehicle and not e.ego]
        for entity in danger.to or (others if len(others) == 1 else []):
            told = any(p.entity is entity for p in context.draft.placements)
            if entity.moving_vehicle and not told and entity.heading is None:
                basis = Basis(danger.basis.i, danger.basis.j, "the turn leads across its way")
                context.draft.place(entity, None, {Approach.OPPOSITE}, basis)

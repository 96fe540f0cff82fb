"""What is said not to happen, or not to be done in time."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, Control, HazardKind, Maneuver
from scegen.understanding.chunks import Mention, Thing
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.meaning import breaches
from scegen.understanding.meaning.ruled_out import rule_out
from scegen.understanding.semantics.context import Clause, Context

_SIGNED = frozenset({Control.STOP, Control.ALL_WAY_STOP})
_SIGNS = frozenset({"stop_sign", "stop_line", "yield_sign"})
_SEEING = frozenset({"encounter", "overlook"})
_BRAKING = frozenset({"stop", "brake", "slow"})
_STOPPING = frozenset({"stop", "brake", "wait", "slow"})
_TO_BRAKE_FOR = frozenset({HazardKind.HARD_BRAKING, HazardKind.STOPPING, HazardKind.OBSTACLE,
                          HazardKind.SLOW_DRIVING, HazardKind.CROSSING_PEDESTRIAN,
                          HazardKind.CROSSING_CYCLIST, HazardKind.CUT_IN})  # fmt: skip
_CROSSING = frozenset({HazardKind.CROSSING_PEDESTRIAN, HazardKind.CROSSING_CYCLIST})
"""What concerns those who come from the front, too."""
_NEAR = 12
_PHRASE = 5
_REACTING = frozenset({"brake", "react", "slow", "swerve", "avoid", "reply"})
_LEEWAY = frozenset({"time", "chance", "room", "space", "distance", "hope"})
_HARMLESS = frozenset({"light", "inert", "return", "move", "encounter", "try"})


def not_done(clause: Clause, context: Context) -> None:
    """Not stopping, yielding or braking is a danger; other things that do not happen are noted.

    Args:
        clause: the event that does not take place.
        context: the scenario in the making.
    """
    event = clause.event
    basis = Basis(event.i, event.j)
    if _nobody_reacts(clause, context):
        return
    if event.unable:
        _unable(clause, context)
    elif (
        rule_out(clause, context)
        or _no_distance(clause, context)
        or _overlooks(clause, context)
        or (event.name in _SEEING and breaches.breach(clause, context))
    ):
        return
    elif event.name == "yield" or (event.name in {"stop", "wait"} and _for_people(clause)):
        breaches.fail_to_yield(clause, context)
    elif event.name == "obey":
        breaches.breach(clause, context)
    elif event.name in _STOPPING and _at_signals(clause, context) and not _rear(clause, context):
        context.draft.hazard(HazardKind.RED_LIGHT_RUNNING, basis, clause.drivers)
    elif event.name in _BRAKING and clause.drivers and _behind_or_late(clause, context):
        context.draft.hazard(HazardKind.DELAYED_BRAKING, basis, clause.drivers)
    elif event.name in _STOPPING and _has_to_wait(clause, context):
        context.draft.hazard(HazardKind.FAILURE_TO_YIELD, basis, clause.drivers)
    elif clause.drivers and _answer_is_due(clause, context):
        context.draft.hazard(HazardKind.DELAYED_BRAKING, basis, clause.drivers)
    elif event.name == "encounter" and any(0 < event.i - i < _NEAR for i in context.screens):
        context.draft.hazard(HazardKind.OCCLUSION, basis, [])
    elif event.name not in _HARMLESS | {"collide"}:
        context.draft.note(event.i, event.j, "said not to happen; left out")


def _answer_is_due(clause: Clause, context: Context) -> bool:
    """``does not see the car ahead``, ``does not brake`` for somebody who is no oncoming one."""
    name = clause.event.name
    if name in _SEEING:
        return _late(clause) or _ahead(clause, context)
    if name not in _BRAKING | {"react"}:
        return False
    return (name != "slow" and not _oncoming(clause, context)) or _due(clause, context)


def _nobody_reacts(clause: Clause, context: Context) -> bool:
    """``neither brakes``, ``nobody stops`` where no rule says that they must: nothing is done."""
    subjects = {m.pronoun for m in clause.event.subject}
    if not subjects & {"everybody", "neither", "nobody"}:
        return False
    bound = _for_people(clause) or _at_signals(clause, context) or _has_to_wait(clause, context)
    return clause.event.name in _REACTING or (clause.event.name == "stop" and not bound)


def _late(clause: Clause) -> bool:
    """``did not notice it in time``, ``did not see it and struck its rear``."""
    return clause.event.late or clause.how("late") is not None


def _unable(clause: Clause, context: Context) -> None:
    """``cannot stop in time``, ``could not see the car because of the van``."""
    event = clause.event
    basis = Basis(event.i, event.j)
    if event.name in {"brake", "stop", "slow"} and clause.drivers:
        skids = any(
            d.kind is HazardKind.LOSS_OF_CONTROL and e in d.by
            for d in context.draft.dangers
            for e in clause.drivers
        )
        signed = any(p.kind in _SIGNS | {"signal"} for p in clause.places())
        if not (skids or signed or _too_near(event.i, context)):
            context.draft.hazard(HazardKind.DELAYED_BRAKING, basis, clause.drivers)
    elif event.name == "encounter" and not any(m.cat == "noted" for m in event.mods):
        context.draft.hazard(HazardKind.OCCLUSION, basis, _in_the_way(clause, context))
    elif event.name not in _HARMLESS:
        context.draft.note(event.i, event.j, "said not to happen; left out")


def _no_distance(clause: Clause, context: Context) -> bool:
    """``does not keep a safe distance``."""
    after = {t.low for t in context.tokens[clause.event.j : clause.event.j + _PHRASE]}
    named = isinstance(clause.event.object, Thing) and bool(after & {"distance", "gap"})
    if clause.event.name not in {"move", "match"} or not named or not clause.drivers:
        return False
    context.draft.hazard(HazardKind.TAILGATING, clause.words, clause.drivers)
    return True


def _overlooks(clause: Clause, context: Context) -> bool:
    """``overlooks a van coming from the right``: has to give way where that has priority."""
    right = context.junction.control is Control.PRIORITY_TO_RIGHT
    due = [e for e in clause.targets if context.placed(e, Approach.RIGHT)]
    if clause.event.name != "overlook" or not right or not due or not clause.drivers:
        return False
    context.draft.hazard(HazardKind.FAILURE_TO_YIELD, clause.words, clause.drivers, due)
    return True


def _too_near(i: int, context: Context) -> bool:
    """``has no chance to stop``, ``with no time left to brake``: nobody's fault but the other's."""
    before = {t.low for t in context.tokens[max(0, i - _PHRASE) : i]}
    return bool(before & _LEEWAY) and bool(before & {"no", "not", "little", "without"})


def _in_the_way(clause: Clause, context: Context) -> list[Entity]:
    """Who is said to keep somebody from seeing; else the one that is parked there."""
    named = [
        e
        for p in clause.event.pps
        if isinstance(p.target, Mention) and p.value in {"due", "with", "for", "by"}
        for e in p.target.entities
        if e.is_vehicle and not e.ego
    ]
    parked = [e for e in context.draft.entities if e.parked and e not in clause.targets]
    return named or (parked if len(parked) == 1 else [])


def _for_people(clause: Clause) -> bool:
    """``does not stop for him``: people on foot who have to be let across."""
    waited = [p.target for p in clause.event.pps if p.value in {"for", "to"}]
    people = [e for t in waited if isinstance(t, Mention) for e in t.entities if not e.is_vehicle]
    return bool(people and clause.drivers)


def _at_signals(clause: Clause, context: Context) -> bool:
    named = any(p.kind == "signal" for p in clause.places())
    regulated = clause.event.name == "stop" and context.junction.control is Control.SIGNALS
    follows = all(context.placed(e, Approach.BEHIND) for e in clause.drivers)
    return named or (regulated and not (follows and clause.drivers))


def _rear(clause: Clause, context: Context) -> bool:
    """``the car behind it did not stop in time``: for the one in front, not for the light."""
    named = any(p.kind == "signal" for p in clause.places())
    behind = bool(clause.drivers) and all(
        context.placed(e, Approach.BEHIND) for e in clause.drivers
    )
    return (behind or not named) and _behind_or_late(clause, context)


def _due(clause: Clause, context: Context) -> bool:
    """``does not slow down``: whether there is something to slow down for."""
    oncoming = _oncoming(clause, context)
    owed = _TO_BRAKE_FOR & _CROSSING if oncoming else _TO_BRAKE_FOR
    return any(
        d.kind in owed and not any(e in clause.drivers for e in d.by) for d in context.draft.dangers
    ) or (not oncoming and _ahead(clause, context))


def _oncoming(clause: Clause, context: Context) -> bool:
    return bool(clause.drivers) and all(context.oncoming(e) for e in clause.drivers)


def _ahead(clause: Clause, context: Context) -> bool:
    """Whether what is overlooked drives in front."""
    overlooked = clause.targets or [e for e in context.draft.entities if e not in clause.actors]
    return any(context.placed(e, Approach.AHEAD) for e in overlooked)


def _behind_or_late(clause: Clause, context: Context) -> bool:
    """``does not brake in time``: for whoever is in front, not for a sign."""
    if any(p.kind in _SIGNS for p in clause.places()):
        return False
    late = any(context.tokens[m.j - 1].low == "time" for m in clause.event.mods)
    late = late or clause.event.late
    crosses = any(Maneuver.CROSS in e.maneuvers or context.crosses(e) for e in clause.drivers)
    behind = all(context.placed(e, Approach.BEHIND) for e in clause.drivers)
    return late or (behind and not crosses)


def _has_to_wait(clause: Clause, context: Context) -> bool:
    """A sign, another road, or a crossing that is driven over "without stopping"."""
    if any(p.kind in _SIGNS for p in clause.places()):
        return True
    if clause.event.name not in {"stop", "slow", "brake", "wait"}:
        return False
    if context.junction.control in _SIGNED:
        return True
    if any(context.comes_across(e) for e in clause.drivers):
        return True
    awaited = any(p.value == "for" and isinstance(p.target, Mention) for p in clause.event.pps)
    awaited = awaited and clause.event.name == "wait"
    parent = clause.event.parent
    onto = parent is not None and parent.name in {"enter", "pull_out", "cross", "move"}
    onto = onto and any(p.value == "into" for p in (parent.pps if parent else []))
    if clause.event.link == "ing" and (onto or (parent and parent.name == "pull_out")):
        return True  # "rides onto the road without stopping"
    joins = context.junction.crossing or context.draft.access is not None
    joins = joins or context.junction.control is not None
    return (clause.event.link == "ing" or awaited) and joins

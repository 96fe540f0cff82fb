"""What an event says about where a participant goes."""

from __future__ import annotations

from collections.abc import Callable

from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.chunks import Event, Mention, Place, Thing
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.semantics import ways
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.rows import say

_BETWEEN_LANES = "nobody drives between two lanes here, only in one"


def overtake(clause: Clause, context: Context) -> None:
    """Overtaking, or passing something that stands in the lane."""
    event = clause.event
    _whom(clause, context)
    if event.name == "bypass" and event.object is None and not event.passive:
        by = context.tokens[event.j - 1].low == "past"
        behind = any(context.placed(e, Approach.BEHIND) for e in clause.drivers)
        if (by or event.pps) and not behind:
            say("movements.move", clause, context)  # "waits for the bus to go past"
            return
    dodges = isinstance(event.object, Thing) and any(context.oncoming(e) for e in clause.drivers)
    if event.name == "bypass" and (isinstance(event.object, Place) or dodges):
        if isinstance(event.object, Place) and event.object.kind == "lane":
            context.draft.note(event.i, event.object.j, _BETWEEN_LANES)
        return  # "an oncoming moped swerves round a pothole"
    if not ways.overtaking(clause, context) or ways.past_the_roadside(clause, context):
        say("movements.move", clause, context)
        return
    basis = Basis(event.i, event.j)
    means = event.parent if event.link == "inf" else None
    if not (means is not None and _changes_lane(means)):
        say("movements.overtakes", clause, context)
    if any(entity.moving_vehicle for entity in clause.targets):
        draft = context.draft
        draft.passing_implied = draft.passing_implied or basis
    egos = [e for e in clause.targets if e.ego]
    stated = {
        p.entity.index
        for p in context.draft.placements
        if p.reference in clause.targets
        or (p.reference is None and (egos or p.approaches != {Approach.ADJACENT}))
    }
    if not any(e.index in stated for e in clause.actors):
        context.ahead(clause.targets, clause.actors, basis)


def _whom(clause: Clause, context: Context) -> None:
    """``drives behind a tractor and overtakes``, ``passes``: who is ahead, or goes the same way."""
    event = clause.event
    goes_on = event.name == "pass" and not any(
        p.value != "with" and not isinstance(p.target, Thing) for p in event.pps
    )
    goes_on = goes_on and not (context.junction.crossing or event.nominal or event.negated)
    if not (event.name == "overtake" or goes_on):
        return
    if clause.targets or event.object is not None or event.passive:
        return
    leaders = [
        p.entity
        for p in context.draft.placements
        if p.approaches == {Approach.AHEAD}
        and (p.reference in clause.actors or p.reference is None)
    ]
    one = [e for e in dict.fromkeys(leaders) if e.moving_vehicle and e not in clause.actors]
    one = one or ([] if goes_on else _same_way(clause, context))
    together = len({(e.basis.i, e.basis.j) for e in one}) == 1  # "two cyclists ride …"
    if together and any(e.ego for e in clause.actors):
        clause.targets = one


def _same_way(clause: Clause, context: Context) -> list[Entity]:
    """``a cyclist rides along the road, the ego overtakes``: who is named before and drives on."""
    if context.junction.crossing:
        return []
    elsewhere = {
        p.entity.index
        for p in context.draft.placements
        if (p.reference is None or p.reference in clause.actors)
        and Approach.AHEAD not in p.approaches
    }
    return [
        e
        for e in context.draft.entities
        if e not in clause.actors
        and e.moving_vehicle
        and (e.basis.i is not None and e.basis.i < clause.event.i)
        and e.index not in elsewhere
        and "opposite" not in e.dirs
        and Maneuver.CROSS not in e.maneuvers
        and e.heading is None
        and not e.entries
    ]


def pull_around(clause: Clause, context: Context) -> None:
    """``pulls out around a parked van``: past it; onto a road to one side, a turn."""
    say("movements.onto_a_road", clause, context)
    for prep in clause.event.pps:
        around = context.tokens[prep.word.i].low in {"around", "round", "past"}
        passed = prep.target.entities if isinstance(prep.target, Mention) else []
        if around and passed:
            overtake(Clause(clause.event, clause.actors, list(passed)), context)
            return


def _changes_lane(event: Event) -> bool:
    """``changes lanes to get past``: the change of lane is the movement, the rest its purpose."""
    return event.name == "lane_change" or any(c.name == "lane_change" for c in event.children)


def undertake(clause: Clause, context: Context) -> None:
    """Overtaking on the near side, if it is done to somebody."""
    if clause.targets:
        overtake(clause, context)


def follow_movement(clause: Clause, context: Context) -> None:
    """Where a clause says that those who act go."""
    rule = _RULES.get(clause.event.name)
    if rule is not None:
        rule(clause, context)
    say(f"movements.{clause.event.name}", clause, context)


_RULES: dict[str, Callable[[Clause, Context], None]] = {
    "overtake": overtake,
    "undertake": undertake,
    "bypass": overtake,
    "pass": overtake,
    "pull_out": pull_around,
}

"""Whether somebody does what a clause tells: that it is not prevented, wished or over already."""

from __future__ import annotations

from collections.abc import Callable

from scegen.scenario.vocabulary import Control, Maneuver
from scegen.understanding.chunks import Event
from scegen.understanding.entity import Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context

_PREVENTED = frozenset({"fail", "avoid", "prevent", "delay", "encounter"})
_ALL_STOP = frozenset({Control.STOP, Control.ALL_WAY_STOP})
_PASSING = frozenset({"overtake", "bypass", "pass", "undertake"})


def by_then(event: Event, context: Context) -> bool:
    """``once it has stopped``, ``after a bus has gone by``: over before what is told with it."""
    who = min((m.i for m in event.subject), default=0)
    opened = context.lows(who - 1, who)
    return event.perfect and not word_list("once").isdisjoint(opened)


def _rests_there(clause: Clause, _: Context) -> bool:
    """``has stopped in the lane``: where everybody who acts is, nothing that they do."""
    return bool(clause.actors) and all(_rests(e, clause.event.i) for e in clause.actors)


def _rests(entity: Entity, i: int) -> bool:
    said = [b for b in (entity.stands, entity.held, *entity.rests) if b is not None]
    stays = entity.parked or (entity.stands is not None and entity.sets_off < 0)
    return stays or any(b.i == i for b in said)


def _from_rest(clause: Clause, _: Context) -> bool:
    """``accelerates from standstill``."""
    return any(e.stands is not None and e.sets_off >= clause.event.i for e in clause.actors)


def _moves_over(clause: Clause, _: Context) -> bool:
    """Whether it is this verb that says that somebody changes lanes."""
    event = clause.event
    moved = [e for e in clause.actors if Maneuver.LANE_CHANGE in e.maneuvers]
    told = [e.maneuver_basis for e in moved if e.maneuver_basis is not None]
    return event.name not in _PASSING and any(b.i == event.i or b.j == event.j for b in told)


def _may_cross(entity: Entity, _: Context) -> bool:
    """Whoever is said to, or is on foot and not said to keep along the road."""
    afoot = not entity.is_vehicle and entity.maneuvers != {Maneuver.STRAIGHT}
    return afoot or Maneuver.CROSS in entity.maneuvers


FACTS: dict[str, Callable[[Clause, Context], bool]] = {
    "by_then": lambda clause, c: by_then(clause.event, c),
    "rests_there": _rests_there,
    "braked_before": lambda clause, _: any(
        e.brakes_from is not None and e.brakes_from < clause.event.i for e in clause.actors
    ),
    "from_rest": _from_rest,
    "moves_over": _moves_over,
}
"""Words of conditions that ask whether something is done."""
ENTITY: dict[str, Callable[[Entity, Context], bool]] = {
    "may_cross": _may_cross,
    "stood": lambda e, _: e.pulls_out or e.was_parked is not None or e.stands is not None,
    "stood_free": lambda e, c: e.is_vehicle and e.stands is not None and c.junction.control is None,
    "braked": lambda e, c: (
        e.is_vehicle and e.brakes_from is not None and c.junction.control not in _ALL_STOP
    ),
    "lets_by": lambda e, c: e in c.letting,
}
"""What a row may ask of those who act."""

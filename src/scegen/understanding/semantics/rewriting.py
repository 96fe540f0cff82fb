"""What rows change in a clause: a side that is a turn, a phrase that is whom one gets past."""

from __future__ import annotations

from collections.abc import Callable

from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.chunks import Event, Mention, Prep, Thing, Word
from scegen.understanding.draft import Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.words.terms import Term


def _side_to_verb(clause: Clause, _: Context) -> None:
    """``hangs a right``: turns right."""
    event, side = clause.event, clause.event.object
    ways = [m for m in side.mods if m.cat == "dir" and m.value in {"left", "right"}] if side else []
    turned = [m for m in event.mods if m.value != "straight"]  # "hangs a right, straight across"
    event.mods, event.object = [*turned, *ways], None


def _round(clause: Clause, context: Context) -> tuple[Prep, list[Entity]] | None:
    """The phrase that names what somebody gets past, with the vehicles in it."""
    for prep in clause.event.pps if clause.event.object is None else []:
        passed = prep.target
        if context.tokens[prep.word.i].low not in word_list("past"):
            continue
        thing = isinstance(passed, Thing) and passed.kind in {"object", "obstacle"}
        who = passed.entities if isinstance(passed, Mention) else []
        vehicles = [e for e in who if e.is_vehicle and e not in clause.actors]
        if thing or vehicles:
            return prep, vehicles
    return None


def passes_round(clause: Clause, context: Context) -> bool:
    """``edges round the parked van``: whether a phrase says what is passed."""
    return _round(clause, context) is not None


def _take_round(clause: Clause, context: Context) -> None:
    """What is passed becomes the object of the verb."""
    found, event = _round(clause, context), clause.event
    if found is not None and not isinstance(found[0].target, Event):
        event.object, clause.targets = found[0].target, found[1]
        event.pps = [p for p in event.pps if p is not found[0]]


def _lane_left(clause: Clause, _: Context) -> None:
    """``leaves the ego's lane``: that lane is where it comes from, not where it goes."""
    event, lane = clause.event, clause.event.object
    source = Word(Term("prep", "from", event.i, event.i + 1))
    event.pps, event.object = [*event.pps, Prep(source, lane)], None


def _who_is_passed(clause: Clause, context: Context) -> None:
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


REWRITES: dict[str, Callable[[Clause, Context], None]] = {
    "side_to_verb": _side_to_verb,
    "take_round": _take_round,
    "lane_left": _lane_left,
    "who_is_passed": _who_is_passed,
}
"""Rewrite -> what it does to the clause."""

"""What rows change in a clause: a side that is a turn, a phrase that is whom one gets past."""

from __future__ import annotations

from collections.abc import Callable

from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.chunks import Mention, Prep, Thing
from scegen.understanding.entity import Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.words.terms import Term


def _side_to_verb(clause: Clause, _: Context) -> None:
    """``hangs a right``: turns right."""
    event, side = clause.event, clause.event.object
    ways = [m for m in side.mods if m.cat == "dir" and m.value in {"left", "right"}] if side else []
    turned = [m for m in event.mods if m.value != "straight"]  # "hangs a right, straight across"
    event.mods, event.object = [*turned, *ways], None


def _round(clause: Clause, context: Context) -> tuple[Prep, Thing | Mention, list[Entity]] | None:
    """The phrase that names what somebody gets past, with that, and the vehicles in it."""
    for prep in clause.event.pps if clause.event.object is None else []:
        passed = prep.target
        if context.tokens[prep.word.i].low not in word_list("past"):
            continue
        if isinstance(passed, Thing) and passed.lies_there:
            return prep, passed, []
        who = passed.entities if isinstance(passed, Mention) else []
        vehicles = [e for e in who if e.is_vehicle and e not in clause.actors]
        if vehicles and isinstance(passed, Mention):
            return prep, passed, vehicles
    return None


def passes_round(clause: Clause, context: Context) -> bool:
    """``edges round the parked van``: whether a phrase says what is passed."""
    return _round(clause, context) is not None


def _take_round(clause: Clause, context: Context) -> None:
    """What is passed becomes the object of the verb."""
    found, event = _round(clause, context), clause.event
    if found is not None:
        phrase, event.object, clause.targets = found
        event.pps = [p for p in event.pps if p is not phrase]


def _lane_left(clause: Clause, _: Context) -> None:
    """``leaves the ego's lane``: that lane is where it comes from, not where it goes."""
    event, lane = clause.event, clause.event.object
    source = Term("prep", "from", event.i, event.i + 1)
    event.pps, event.object = [*event.pps, Prep(source, lane)], None


def _who_is_passed(clause: Clause, context: Context) -> None:
    """``drives behind a tractor and overtakes``, ``passes``: who is ahead, or goes the same way."""
    event = clause.event
    if clause.targets or event.object is not None or event.passive:
        return
    there = any(p.value != "with" and not isinstance(p.target, Thing) for p in event.pps)
    there = there or context.junction.crossing or event.nominal or event.negated
    if event.name != "overtake" and (event.name != "pass" or there):
        return
    seen = [p for p in context.draft.placements if p.reference in (None, *clause.actors)]
    leaders = dict.fromkeys(p.entity for p in seen if p.approaches == {Approach.AHEAD})
    one = [e for e in leaders if e.moving_vehicle and e not in clause.actors]
    if not one and event.name == "overtake" and not context.junction.crossing:
        elsewhere = [p.entity for p in seen if Approach.AHEAD not in p.approaches]
        others = [e for e in context.draft.entities if e not in (*elsewhere, *clause.actors)]
        one = [e for e in others if _goes_the_same_way(e, event.i)]
    together = len({(e.basis.i, e.basis.j) for e in one}) == 1  # "two cyclists ride …"
    if together and any(e.ego for e in clause.actors):
        clause.targets = one


def _goes_the_same_way(entity: Entity, i: int) -> bool:
    """``a cyclist rides along the road, the ego overtakes``: who is named before and drives on."""
    named = entity.basis.i is not None and entity.basis.i < i
    comes = "opposite" in entity.dirs or entity.heading is not None or bool(entity.entries)
    crosses = Maneuver.CROSS in entity.maneuvers
    return named and entity.moving_vehicle and not comes and not crosses


REWRITES: dict[str, Callable[[Clause, Context], None]] = {
    "side_to_verb": _side_to_verb,
    "take_round": _take_round,
    "lane_left": _lane_left,
    "who_is_passed": _who_is_passed,
}
"""Rewrite -> what it does to the clause."""

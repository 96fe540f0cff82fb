"""Roads that vehicles come out of: at the side, from a driveway, from everywhere."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach
from scegen.understanding.chunks import Event, Place, Prep
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.on_sides import each_side
from scegen.understanding.semantics.context import Clause, Context

_LEAVING = frozenset({"reverse", "pull_out", "leave", "unpark"})
_COMING = frozenset({"move", "approach", "appear", "enter", "cross"})


def side_road(prep: Prep, event: Event, whom: list[Entity], context: Context) -> None:
    """``a bus comes from the left``: there must be a road on the left.

    Args:
        prep: a phrase of place.
        event: the event that it belongs to.
        whom: whom it places.
        context: the scenario in the making.
    """
    place = prep.target
    side = isinstance(place, Place) and place.kind == "side" and bool(place.dirs)
    side = side and set(place.dirs) <= {"left", "right"} if place is not None else False
    motor = [e for e in whom if e.moving_vehicle and not context.is_cyclist(e)]
    if prep.value == "from" and side and motor and event.name in _COMING:
        reason = "a vehicle comes from the side"
        end = place.j if place is not None else prep.word.j
        context.draft.side_road = context.draft.side_road or Basis(prep.word.i, end, reason)


def access(clause: Clause, context: Context) -> None:
    """A vehicle that comes out of a side road needs that road."""
    described = [
        p.target
        for m in clause.event.subject
        for p in m.pps
        if p.value in {"from", "in"} and isinstance(p.target, Place) and p.target.kind == "access"
    ]  # "a van from a side road nudges out"
    within = {
        id(p.target)
        for p in clause.event.pps
        if context.tokens[p.word.i].low in word_list("within")
    }
    for place in (*clause.places(), *described):
        if place.kind == "lane" and "adjacent" in place.dirs:
            basis = Basis(place.i, place.j)
            context.lanes_implied(basis, "there is a lane beside")
        waits = clause.event.name == "wait" and context.tokens[place.j - 1].low in word_list(
            "roads"
        )
        if id(place) in within and not waits:
            continue  # "reverses in a car park": in it, not out of it
        left = place.kind in {"bus_stop", "parking"} and clause.event.name in _LEAVING
        aside = place.kind == "sidewalk" and place is clause.event.object
        if place.kind == "access" or left or aside:
            _from_access(place, clause, context)
        if left and clause.drivers and not context.junction.crossing:
            context.draft.from_kerb = True
        if place.kind == "access" and clause.drivers and context.draft.access is None:
            context.draft.access = Basis(place.i, place.j)


def _from_access(place: Place, clause: Clause, context: Context) -> None:
    """``backs out of a driveway on the right``: it comes from there."""
    sides = {Approach(d) for d in place.dirs if d in {"left", "right"}}
    goal = any(p.target is place and p.value in {"to", "into"} for p in clause.event.pps)
    if sides and not goal:
        for entity in clause.actors:
            context.draft.place(entity, None, sides, Basis(place.i, place.j))


def spread(prep: Prep, actors: list[Entity], context: Context) -> None:
    """One vehicle to each arm.

    Args:
        prep: the phrase ("from all directions").
        actors: the vehicles.
        context: the scenario in the making.
    """
    target = prep.target
    end = target.j if target is not None else prep.word.j
    arms = context.junction.arms or max(len(actors), 1)
    if each_side(prep):
        for entity, side in zip(actors, (Approach.LEFT, Approach.RIGHT), strict=False):
            context.draft.place(entity, None, {side}, Basis(prep.word.i, end))
        return
    for number, entity in enumerate(actors):
        entity.entries = {number % arms}
        entity.entry_basis = Basis(prep.word.i, end)

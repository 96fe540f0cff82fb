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
_MEETING = frozenset({"collide", "overlook"})
"""What tells nothing of the ways that meet: they are as who takes part comes."""


def side_road(prep: Prep, event: Event, whom: list[Entity], context: Context) -> None:
    """``a bus comes from the left``: there must be a road on the left.

    Args:
        prep: a phrase of place.
        event: the event that it belongs to.
        whom: whom it places.
        context: the scenario in the making.
    """
    motor = [e for e in whom if e.moving_vehicle and not context.is_cyclist(e)]
    if event.name in _COMING:
        _from_the_side(prep, motor, context)


def met_from_the_side(clause: Clause, context: Context) -> None:
    """``a car from the left hits the ego``: so who is named after where it comes from."""
    event = clause.event
    along = event.lemma in word_list("along_the_side")
    if event.name not in _MEETING or event.passive or along:
        return
    for mention in event.subject:
        for prep in mention.pps:
            _from_the_side(prep, [e for e in clause.actors if e.moving_vehicle], context)
    for prep in event.pps:
        named = [] if prep.on_mention is None else prep.on_mention.entities
        whom = [e for e in named if e in clause.targets and e.moving_vehicle]
        _from_the_side(prep, whom, context)


def _from_the_side(prep: Prep, whom: list[Entity], context: Context) -> None:
    place = prep.target
    if not isinstance(place, Place) or place.kind != "side" or not place.dirs:
        return
    if prep.value == "from" and set(place.dirs) <= {"left", "right"} and whom:
        reason = "a vehicle comes from the side"
        context.draft.side_road = context.draft.side_road or Basis(prep.word.i, place.j, reason)


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
    if place.kind == "parking" and clause.event.name == "reverse":
        sides = sides or {Approach(context.draft.kerb)}  # "backs out of a bay"
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

"""Whom somebody drives up to, and whether anything is said of where the two are."""

from __future__ import annotations

from itertools import zip_longest

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding.chunks import Event, Mention, Place
from scegen.understanding.entity import Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context

_TOWARDS = frozenset({"to", "into", "in", "for", "with"})
_REAR = frozenset({"rear", "back"})
_ACROSS = frozenset({Approach.LEFT, Approach.RIGHT, Approach.OPPOSITE, Approach.AHEAD,
                     Approach.BEHIND})  # fmt: skip


def into_rear(event: Event, context: Context) -> bool:
    """``rear-ends``, ``runs into the back of``, ``hits from behind``."""
    rear = any(isinstance(c, Place) and "rear" in c.dirs for c in event.nouns())
    return rear or from_the_rear(event, context)


def from_the_rear(event: Event, context: Context) -> bool:
    """``rear-ends``, ``hits from behind``, ``… from the rear``: without naming a part."""
    behind = any(p.value == "behind" and p.outer == "from" for p in event.pps)
    places = [p.place for p in event.pps if p.value == "from" and p.place is not None]
    behind = behind or any("rear" in place.dirs for place in places)
    return behind or _rear_inside(event, context)


def _rear_inside(event: Event, context: Context) -> bool:
    """``rear-ends``, ``drives into its rear``: the verb itself tells the rear.

    Not so "rolls back into it".
    """
    said = context.lows(event.i, event.j + 1)
    own = zip_longest(said[: event.j - event.i], said[1:])
    return any(low in _REAR and then != "into" for low, then in own)


def _rear_ends(clause: Clause, context: Context) -> bool:
    """Whether somebody hits another from behind."""
    return clause.event.name == "collide" and into_rear(clause.event, context)


def driven_up_to(clause: Clause, context: Context) -> list[Entity]:
    """``closes in on a stopped van``, ``encounters a slow tractor``, ``hits its rear``."""
    event, rear = clause.event, _rear_ends(clause, context)
    found = list(clause.targets)
    for prep in event.pps:
        whom = prep.target
        if isinstance(whom, Mention):
            queue = whom.head is not None and "mass" in whom.head.data  # "the tail of a queue"
            if prep.value in _TOWARDS or (prep.value == "of" and (queue or rear)):
                found += whom.entities
    ends = clause.places()
    owned = [c for c in ends if "rear" in c.dirs or (rear and c is event.object)]
    found += [e for c in owned if c.owner is not None for e in c.owner.entities]
    its = any(_its(c, event) for c in ends)
    its = its or (_rear_inside(event, context) and not event.passive)
    if rear and not found and its:
        others = [e for e in context.draft.entities if e not in clause.actors]
        found += [e for e in others if e.ego or len(others) == 1]  # "hits its rear"
    return [e for e in dict.fromkeys(found) if e not in clause.actors]


def _its(part: Place, event: Event) -> bool:
    own = part.possessed and part.owner is None
    met = {"", "into", *(["with"] if event.lemma == "collide" else [])}
    met |= {"in"} if event.lemma in word_list("ending_up") else set()
    return own and "rear" in part.dirs and part.opening in met


def apart(entity: Entity, observer: Entity, context: Context) -> bool:
    """Whether nothing is said yet of where one is, seen from the other or from the ego."""
    return not any(
        (p.entity is entity and p.reference in {None, observer})
        or (p.entity is observer and (p.reference is entity or (entity.ego and not p.reference)))
        for p in context.draft.placements
        if p.approaches & _ACROSS
    )


def on_the_wrong_side(entity: Entity, context: Context) -> bool:
    """Whether it drives where others come towards it, and passes nobody."""
    strays = entity in context.draft.causing(HazardKind.ONCOMING_LANE)
    return strays and Maneuver.OVERTAKE not in entity.maneuvers


def _stand_to_each_other(clause: Clause, context: Context) -> bool:
    """Whether it is said how one who acts stands to those on whom it is done."""
    egos = any(e.ego for e in clause.targets)
    return any(
        p.reference in clause.targets
        or (p.reference is None and (egos or p.approaches != {Approach.ADJACENT}))
        for entity in clause.actors
        for p in context.draft.placements_of(entity)
    )


def _was_ahead(clause: Clause, context: Context) -> bool:
    """Whether one who acts is told before to be ahead of the ego, and in no other lane."""
    told = [p for e in clause.drivers for p in context.draft.placements_of(e)]
    ahead = any(
        p.approaches == {Approach.AHEAD}
        and p.reference in {None, context.draft.ego}
        and (p.basis.i or 0) < clause.event.i
        for p in told
    )
    return ahead and not any(Approach.ADJACENT in p.approaches for p in told)


FACTS = {
    "stand_to_each_other": _stand_to_each_other,
    "was_ahead": _was_ahead,
    "rear_ends": _rear_ends,
}
"""Words of conditions that ask for a meeting."""

"""What is said of several towards each other: "face each other", "meet one another"."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach
from scegen.understanding.chunks import Event, Mention
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.semantics.context import Context

_MUTUAL = frozenset({"each", "one"})
_TOWARDS = frozenset({"approach", "move", "collide", "speed"})


def towards_each_other(events: list[Event], context: Context) -> None:
    """Places those who face each other, or stand next to each other."""
    for event in events:
        members = [e for m in event.subject for e in m.entities]
        mutual = [event.object, *(p.target for p in event.pps)]
        towards = any(_mutual(m, context) for m in mutual)
        racing = event.name == "speed" and _mutual(event.object, context)
        towards = towards and not racing
        met = event.name in _TOWARDS and not context.junction.crossing and towards
        if met or (towards and _faces(event)):
            _place(members, Approach.OPPOSITE, Basis(event.i, event.j), context)


def _mutual(noun: object, context: Context) -> bool:
    reflexive = isinstance(noun, Mention) and noun.pronoun == "reflexive"
    return reflexive and isinstance(noun, Mention) and context.tokens[noun.i].low in _MUTUAL


def _faces(event: Event) -> bool:
    return event.lemma == "face"


def _place(members: list[Entity], approach: Approach, basis: Basis, context: Context) -> None:
    vehicles = [e for e in members if e.moving_vehicle]
    for other in vehicles[1:]:
        context.draft.place(other, vehicles[0], {approach}, basis)

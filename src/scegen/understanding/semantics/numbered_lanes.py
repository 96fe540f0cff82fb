"""Lanes called by number: who drives in lane 1 is beside who drives in lane 2."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach
from scegen.understanding.chunks import Chunk, Event, Mention, Place, Prep
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.numbers import number_at
from scegen.understanding.words.tokens import Token

_WITHIN = frozenset({"in", "from"})
_UNSETTLED = "from which side lanes are counted is not said, so the number names none"


def note_lanes(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """Notes the lane in which somebody is said to drive at first."""
    phrases: list[tuple[list[Entity], Prep]] = [
        (c.entities, p) for c in chunks if isinstance(c, Mention) for p in c.pps
    ]
    phrases += [
        ([e for m in event.subject for e in m.entities], p)
        for event in events
        for p in event.pps
        if p.on_mention is None
    ]
    for entities, prep in phrases:
        number = _number(prep, tokens)
        for entity in entities if number is not None else []:
            if entity.lane is None and not entity.parked:
                ends = prep.target.j if prep.target is not None else prep.word.j
                entity.lane, entity.lane_basis = number, Basis(prep.word.i, ends)


def _number(prep: Prep, tokens: list[Token]) -> int | None:
    place = prep.target
    if prep.value not in _WITHIN or not isinstance(place, Place) or place.kind != "lane":
        return None
    if place.head is not None and "number" in place.head.data:
        return int(place.head.data["number"])
    last = number_at(tokens, place.j - 1)
    named = place.head is not None and place.j > place.head.j
    return int(last.value) if last is not None and named else None


def leaves_it(event: Event, entities: list[Entity], tokens: list[Token]) -> bool:
    """``a lorry in lane 1 moves out``: into the next one.

    Args:
        event: a movement.
        entities: who moves.
        tokens: the tokens of the text.
    """
    aside = event.j < len(tokens) and tokens[event.j].low in word_list("sideways")
    out_of = any(p.value == "from" and _number(p, tokens) is not None for p in event.pps)
    aside = aside or (out_of and tokens[event.j].low == "in")  # "moves in from lane 2"
    known = bool(entities) and all(e.lane is not None for e in entities)
    return event.name == "move" and aside and known and event.object is None


def beside(draft: Draft, ego: Entity) -> None:
    """Places those in the lane with the number before or after the ego's next to it.

    From which side lanes are counted differs, so that a number alone says nothing: it is reported.
    """
    for entity in [e for e in draft.entities if e.lane is not None and e.start_lane is None]:
        others = [e.lane for e in draft.entities if e is not entity and e.lane is not None]
        away = abs((entity.lane or 0) - (ego.lane or 0)) if ego.lane is not None else None
        if entity is not ego and not entity.approaches and away == 1:
            entity.approaches, entity.approach_basis = {Approach.ADJACENT}, entity.lane_basis
        basis = entity.lane_basis
        said = others and (entity is ego or away is None or away <= 1)
        if not said and basis is not None and basis.i is not None:
            draft.note(basis.i, basis.j or basis.i, _UNSETTLED)

"""Lanes called by number: who drives in lane 1 is beside who drives in lane 2."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach
from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Prep
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.numbers import number_at
from scegen.understanding.words.ordinals import POSITIONS
from scegen.understanding.words.tokens import Token

EITHER = "either"
"""The side from which lanes are counted where that is not said."""
_WITHIN, _INTO = frozenset({"in", "from"}), frozenset({"to", "into", "for"})
_OF_OWN = frozenset({"leave", "keep"})
"""What one does with the lane in which one is."""
_GOAL = "a change of lane has no number; which lane it leads into is open, or said by its side"
_MOST = 6
_FROM_SIDE = 3


def note_lanes(chunks: list[Chunk], events: list[Event], tokens: list[Token], draft: Draft) -> None:
    """Notes the lane in which somebody is said to drive at first."""
    phrases: list[tuple[list[Entity], Prep]] = [
        (c.entities, p) for c in chunks if isinstance(c, Mention) for p in c.pps
    ]
    for event in events:
        who = [e for m in event.subject for e in m.entities]
        named = [p for p in event.pps if p.on_mention is None]
        own: list[NounPhrase | Event | None] = []
        own += [event.object] if event.lemma in _OF_OWN else []
        own += [p.target for p in named if event.lemma == "keep"]
        for place in own:
            if (number := _number(place, tokens)) is not None:
                _drives_in(who, number, event.i, place, tokens, draft)
        phrases += [(who, p) for p in named if p.target not in own]
    for entities, prep in phrases:
        number = _number(prep.target, tokens)
        if number is None or prep.target is None:
            continue
        if prep.value in _WITHIN:
            _drives_in(entities, number, prep.word.i, prep.target, tokens, draft)
        elif prep.value in _INTO:
            draft.note(prep.word.i, prep.target.j, _GOAL)


def _drives_in(
    entities: list[Entity], number: int, i: int, place: NounPhrase | Event | None,
    tokens: list[Token], draft: Draft,
) -> None:  # fmt: skip
    """Notes it of those of whom no lane is known yet; ``i``: where its words begin."""
    if not isinstance(place, Place):
        return
    side = _counted_from(place.j, tokens)
    basis = Basis(i, place.j + (0 if side is EITHER else _FROM_SIDE))
    ranked = place.head is not None and "number" in place.head.data
    for entity in entities:
        if entity.lane is not None or entity.parked:
            continue
        entity.lane, entity.lane_basis = number, basis
        if entity.start_lane is None:
            entity.start_lane = (f"{number}" if ranked else f"{number} from {side}", basis)
        implied = Basis(basis.i, basis.j, "one of several lanes is named")
        draft.lanes_implied = draft.lanes_implied or implied


def _number(place: NounPhrase | Event | None, tokens: list[Token]) -> int | None:
    if not isinstance(place, Place) or place.kind != "lane" or place.head is None:
        return None
    if "number" in place.head.data:
        return int(place.head.data["number"])
    last = number_at(tokens, place.j - 1)
    if last is not None and place.j > place.head.j and 0 < last.value <= _MOST:
        return int(last.value)
    first = POSITIONS.get(tokens[place.head.i].low, -1)
    return first + 1 if first >= 0 else None  # "the third lane"


def _counted_from(j: int, tokens: list[Token]) -> str:
    """``the third lane from the right``."""
    after = [t.low for t in tokens[j : j + _FROM_SIDE]]
    return after[-1] if after[:2] == ["from", "the"] and after[-1] in {"left", "right"} else EITHER


def leaves_it(event: Event, entities: list[Entity], tokens: list[Token]) -> bool:
    """``a lorry in lane 1 moves out``: into the next one.

    Args:
        event: a movement.
        entities: who moves.
        tokens: the tokens of the text.
    """
    aside = event.j < len(tokens) and tokens[event.j].low in word_list("sideways")
    out_of = any(p.value == "from" and _number(p.target, tokens) for p in event.pps)
    aside = aside or (out_of and tokens[event.j].low == "in")  # "moves in from lane 2"
    known = bool(entities) and all(e.lane is not None for e in entities)
    return event.name == "move" and aside and known and event.object is None


def beside(draft: Draft, ego: Entity) -> None:
    """Places those in the lane with the number before or after the ego's next to it."""
    for entity in [e for e in draft.entities if e.lane is not None and e is not ego]:
        away = abs((entity.lane or 0) - ego.lane) if ego.lane is not None else None
        if not entity.approaches and away == 1:
            entity.approaches, entity.approach_basis = {Approach.ADJACENT}, entity.lane_basis

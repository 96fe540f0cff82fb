"""Driving on although the light is red: "although its light is red, the van enters"."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind
from scegen.understanding.chunks import Chunk, Event, Mention, Place, Word
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import BOUNDARIES
from scegen.understanding.semantics.context import Context

_SAYING = frozenset({"turn", "light", "encounter", "inert", "unknown", "stay", "move"})
"""Verbs that say of a light which colour it shows."""
HALTING = frozenset({"stop", "slow", "brake", "wait"})
GOING = frozenset({"enter", "cross", "move", "turn", "accelerate", "speed", "pull_out", "approach",
                    "sharp_turn", "cut_in"})  # fmt: skip


def on_red(chunks: list[Chunk], events: list[Event], context: Context) -> None:
    """Finds out who goes although their light is said to be red."""
    for k, chunk in enumerate(chunks):
        if not (isinstance(chunk, Place) and chunk.kind == "signal"):
            continue
        if not any(t.low == "red" for t in context.tokens[chunk.i : chunk.j]):
            continue
        event = (
            _whose_light(k, chunks, events, context)
            or _conceded(k, chunks, events, context)
            or _of_the_cross_street(k, chunks, events, context)
        )
        drivers = _drivers(event) if event is not None else []
        if event is not None and drivers and (not event.negated or event.name in HALTING):
            basis = Basis(min(event.i, chunk.i), max(event.j, chunk.j))
            context.draft.hazard(HazardKind.RED_LIGHT_RUNNING, basis, drivers)


def _drivers(event: Event) -> list[Entity]:
    return [e for m in event.subject for e in m.entities if e.moving_vehicle]


def _goes(event: Event) -> bool:
    return event.name in GOING and not event.nominal and bool(_drivers(event))


def _whose_light(
    k: int, chunks: list[Chunk], events: list[Event], context: Context
) -> Event | None:
    """``a van whose light is red drives on``, ``a van facing a red light drives on``."""
    owner: Mention | None = None
    facing = next((e for e in events if e.object is chunks[k] and e.name == "encounter"), None)
    if facing is not None and facing.subject:
        owner = facing.subject[-1]
    for m in range(k - 1, max(-1, k - 6), -1):
        word, before = chunks[m], chunks[m - 1] if m else None
        whose = context.tokens[word.i].low == "whose"
        if whose and isinstance(before, Mention):
            owner = before
    if owner is None:
        return None
    who = set(map(id, owner.entities))
    after = (e for e in events if e.i > chunks[k].i and e is not facing)
    own = [e for e in after if who & set(map(id, _drivers(e)))]
    return next((e for e in own if _goes(e) or (e.negated and e.name in HALTING)), None)


def _of_the_cross_street(
    k: int, chunks: list[Chunk], events: list[Event], context: Context
) -> Event | None:
    """``red for the cross street. But a van from the left …``: who comes from there goes on."""
    marker, place = (chunks[m] if m < len(chunks) else None for m in (k + 1, k + 2))
    known = isinstance(marker, Word) and marker.value in {"for", "to", "against", "in"}
    if known and isinstance(place, Mention) and place.entities:
        who = set(map(id, place.entities))
        told = [e for e in events if e.i > place.i and who & set(map(id, _drivers(e)))]
        halts = any(e.name in HALTING and not e.negated for e in told)
        return next((e for e in told if not halts and not e.negated and _goes(e)), None)
    if not known or not isinstance(place, Place | Mention) or not _crossing(place):
        return None
    sides = (Approach.LEFT, Approach.RIGHT)
    later = [e for e in events if e.i > place.i and not e.negated and _goes(e)]
    return next(
        (
            e
            for e in later
            if any(context.placed(d, side) for d in _drivers(e) for side in sides)
            or any("lateral" in m.dirs for m in e.subject)
        ),
        None,
    )


def _crossing(noun: Place | Mention) -> bool:
    """``the cross street``, ``cross traffic``, ``traffic from the right``."""
    sides = {"lateral", "left", "right"}
    from_there = [p.target for p in noun.pps if isinstance(p.target, Place)]
    side_road = isinstance(noun, Place) and noun.kind == "access"
    return side_road or any(sides & set(n.dirs) for n in (noun, *from_there))


def _conceded(k: int, chunks: list[Chunk], events: list[Event], context: Context) -> Event | None:
    """``enters although the light is red``, ``the light is red, but the van enters``."""
    m = _marker(k, chunks, context)
    begins, ends = _sentence(k, chunks)
    later = [e for e in events if chunks[k].i < e.i < ends and e.finite and _goes(e)]
    if m is None:
        return _in_spite(k, chunks, later) if _opens_sentence(k, chunks, begins) else None
    before = chunks[m - 1] if m else None
    fronted = chunks[m].i == begins or (isinstance(before, Word) and before.value == ",")
    earlier = [e for e in events if begins <= e.i < chunks[m].i and not e.nominal and _goes(e)]
    if fronted and later:
        return later[0]
    return earlier[-1] if earlier else None


def _marker(k: int, chunks: list[Chunk], context: Context) -> int | None:
    """The conjunction or preposition that opens the phrase in which the light is named."""
    for m in range(k - 1, -1, -1):
        chunk = chunks[m]
        if isinstance(chunk, Mention) or (isinstance(chunk, Event) and chunk.name not in _SAYING):
            return None
        if isinstance(chunk, Word):
            if chunk.cat == "punct":
                return None
            opens = chunk.cat in {"sub", "prep"}
            if (
                opens
                and context.tokens[chunk.i].low in word_list("conceding")
                and chunk.value != "in"
            ):
                return m
    return None


def _sentence(k: int, chunks: list[Chunk]) -> tuple[int, int]:
    """The first token of the sentence around a chunk, and the one after its last."""
    marks = [c.i for c in chunks if isinstance(c, Word) and c.value in BOUNDARIES]
    here = chunks[k].i
    begins = max((i + 1 for i in marks if i < here), default=0)
    return begins, min((i for i in marks if i > here), default=chunks[-1].j + 1)


def _opens_sentence(k: int, chunks: list[Chunk], begins: int) -> bool:
    """Whether the sentence begins by saying that the light is red."""
    before = [c for c in chunks[:k] if c.i >= begins]
    acts = any(
        isinstance(c, Mention) or (isinstance(c, Event) and c.name not in _SAYING) for c in before
    )
    return bool(before) and not acts


def _in_spite(k: int, chunks: list[Chunk], later: list[Event]) -> Event | None:
    """The verb after "but"."""
    for chunk in chunks[k + 1 :]:
        if isinstance(chunk, Word) and (chunk.value == "but" or chunk.value in BOUNDARIES):
            joins = chunk.value == "but"
            return next((e for e in later if joins and e.i > chunk.i), None)
    return None

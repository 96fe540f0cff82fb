"""Who is on the road that has the sign, and who on the one that has priority."""

from __future__ import annotations

from scegen.scenario.control import controlled_arms
from scegen.scenario.functional import Junction
from scegen.scenario.vocabulary import Control, HazardKind, JunctionKind, Maneuver
from scegen.understanding.chunks import Chunk, Mention, Place, Prep, Word
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context

_SIGNS = frozenset({"stop_sign", "stop_line", "yield_sign"})
_ONTO = frozenset({"into", "to"})
_ROADS = frozenset({"road", "access"})
_ALL_ALIKE = frozenset({Control.SIGNALS, Control.ALL_WAY_STOP})


def note_roads(chunks: list[Chunk], clauses: list[Clause], context: Context) -> None:
    """``stops at the stop sign``, ``a van from the side road``, ``drives on the main road``.

    Args:
        chunks: the chunks of the text, mentions resolved.
        clauses: what happens.
        context: the scenario in the making.
    """
    for k, chunk in enumerate(chunks):
        if isinstance(chunk, Mention):
            _by_phrases(chunk.pps, chunk.entities, context)
        elif isinstance(chunk, Place) and chunk.kind in _SIGNS and _opens(chunks, k):
            who = next((c for c in chunks[k + 1 : k + 3] if not _comma(c)), None)
            if isinstance(who, Mention):  # "at a stop sign, the ego waits"
                _note(who.entities, minor=True, basis=Basis(chunk.i, chunk.j))
    for clause in clauses:
        event = clause.event
        for place in clause.places() if event.name != "hide" else []:
            if place.kind in _SIGNS:
                _note(clause.actors, minor=True, basis=Basis(place.i, place.j))
        own = [p for p in event.pps if p.on_mention is None or p.on_mention in event.subject]
        _by_phrases(own, clause.actors, context)
    if context.junction.control is Control.STOP:  # who has the sign stops at it, in nobody's way
        context.draft.dangers[:] = [
            d
            for d in context.draft.dangers
            if d.kind is not HazardKind.STOPPING or not d.by or not all(map(_stops_there, d.by))
        ]


def _stops_there(entity: Entity) -> bool:
    return entity.on_minor is not None and entity.on_minor[0] and entity.stands is None


def _opens(chunks: list[Chunk], k: int) -> bool:
    at = chunks[k - 1] if k else None
    before = chunks[k - 2] if k > 1 else None
    led = isinstance(at, Word) and (at.cat, at.value) == ("prep", "in")
    return led and (before is None or (isinstance(before, Word) and before.cat == "punct"))


def _comma(chunk: Chunk) -> bool:
    return isinstance(chunk, Word) and chunk.value == ","


def _by_phrases(preps: list[Prep], whom: list[Entity], context: Context) -> None:
    for prep in preps:
        place = prep.target
        if not isinstance(place, Place):
            continue
        basis = Basis(prep.word.i, place.j)
        if place.kind in _SIGNS and prep.value not in {"with", "without"}:
            _note(whom, minor=True, basis=basis)
        words = {t.low for t in context.tokens[place.i : place.j]}
        main, onto = bool(words & word_list("major")), prep.value in _ONTO
        side = place.kind == "access" or bool(words & word_list("minor"))
        if place.kind in _ROADS and (main or (side and not onto)):
            past = context.tokens[prep.word.i].low in word_list("past")
            _note(whom, minor=(side or onto) and not past, basis=basis)


def _note(whom: list[Entity], *, minor: bool, basis: Basis) -> None:
    for entity in whom:
        if entity.is_vehicle:
            entity.on_minor = entity.on_minor or (minor, basis)


def settle_roads(draft: Draft, junction: Junction) -> None:
    """Lets who has the sign enter where it stands, and who has priority elsewhere.

    Args:
        draft: the scenario in the making.
        junction: the junction as it is built; a T without signs has a side road, too.
    """
    signed = junction.control in {Control.YIELD, Control.STOP}
    stem = junction.kind is JunctionKind.T and junction.control not in _ALL_ALIKE
    if not (signed or stem):
        return
    minor = controlled_arms(
        junction if signed else junction.model_copy(update={"control": Control.YIELD})
    )
    for entity in draft.entities:
        if entity.on_minor is None or entity.entries or not entity.moving_vehicle:
            continue
        if Maneuver.CROSS in entity.maneuvers:
            continue  # a cyclist who crosses a road has none of its arms to come in by
        on_minor, basis = entity.on_minor
        arms = minor if on_minor else frozenset(range(junction.arms)) - minor
        entity.entries, entity.entry_basis = set(arms), basis

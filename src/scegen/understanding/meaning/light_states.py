"""How somebody meets its light: what that shows as it goes, and what it does as it changes."""

from __future__ import annotations

from collections.abc import Iterator

from scegen.scenario.vocabulary import AtLight, HazardKind
from scegen.understanding.chunks import Chunk, Event, Mention, Place, Word
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.meaning.red_lights import GOING, HALTING
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.rows import say

_TURNS = "nothing says what anybody does as the light changes; it changes by its plan"
_NOBODYS = "nothing says who goes or waits by it"
_AMBER = "nothing says who goes over the line on amber"
_COLOURS = {
    "green": AtLight.GREEN,
    "red": AtLight.RED,
    "amber": AtLight.AMBER,
    "yellow": AtLight.AMBER,
}
_COMES = frozenset({"approach", "encounter", "inert"})
_SETS_OFF = GOING | {"leave", "try", "walk", "dash"}


def read_states(clauses: list[Clause], chunks: list[Chunk], context: Context) -> None:
    """Notes it of everybody; what is said of lights and of nobody is reported.

    Args:
        clauses: what happens, dangers understood.
        chunks: the chunks of the text.
        context: the scenario in the making.
    """
    changes = [clause for clause in clauses if _changes(clause, context)]
    for clause in clauses:
        if clause not in changes:
            say("movements.past_a_light", clause, context)
    for change in changes:
        _answer(change, clauses, context)
    _has(chunks, clauses, context)
    _report(clauses, chunks, changes, context)


def _colour(thing: object, context: Context) -> AtLight | None:
    if not isinstance(thing, Place) or thing.kind != "signal":
        return None
    words = (t.low for t in context.tokens[thing.i : thing.j])
    return next((_COLOURS[word] for word in words if word in _COLOURS), None)


def _shown(clause: Clause, context: Context) -> AtLight | None:
    found = (_colour(place, context) for place in clause.places())
    return next((colour for colour in found if colour is not None), None)


def _changes(clause: Clause, context: Context) -> bool:
    """``the light turns red``, ``as soon as it gets green``."""
    event = clause.event
    told = event.lemma in word_list("light_changes") and not event.nominal and not event.negated
    of_a_light = not clause.actors or event.name == "inert" or event.lemma == "get"
    return told and of_a_light and _shown(clause, context) is not None


def _answer(change: Clause, clauses: list[Clause], context: Context) -> None:
    """What somebody does as a light changes: before it in its sentence, after it, or in the next.

    ``sets off when the light turns green``; ``when the light turns green, it sets off``.
    """
    colour, event = _shown(change, context), change.event
    others = [
        c for c in clauses
        if c is not change and c.actors and not c.event.negated and c.event.name not in _COMES
    ]  # fmt: skip
    whose = change.actors or [
        e for p in event.pps if isinstance(p.target, Mention) for e in p.target.entities
    ]
    if whose:
        others = [c for c in others if any(e in whose for e in c.actors)]
    here = [c for c in others if c.event.sentence == event.sentence]
    before = [c for c in here if c.event.i < event.i][-1:]
    after = [c for c in here if c.event.i > event.i]
    after += [c for c in others if c.event.sentence == event.sentence + 1][:1]
    linked = before and _link(before[0], change, context) is not None
    for clause in [*before, *after] if linked else after:
        light = _meets(colour, clause, change, context)
        if light is not None:
            for entity in clause.actors:
                _note(entity, light, _joined(change, clause), context)
            return
    for entity in whose if colour is AtLight.GREEN else []:
        _note(entity, AtLight.WAITS if entity.held else AtLight.GREEN, change.words, context)
    coming = [c for c in clauses if c.event.name == "approach" and not c.event.negated]
    for clause in coming if colour is AtLight.RED else []:  # who keeps the rules stops there
        if clause.event.sentence == event.sentence and _link(clause, change, context) != "after":
            for entity in clause.drivers:
                _note(entity, AtLight.STOPS, _joined(change, clause), context)


def _link(clause: Clause, change: Clause, context: Context) -> str | None:
    """The conjunction by which a change hangs on what is told right before it."""
    between = [t.low for t in context.tokens[clause.event.j : change.event.i]]
    links = [k for k, word in enumerate(between) if word in word_list("at_a_change")]
    apart = links and {"and", "but", ",", ";"} & set(between[: links[-1]])
    return between[links[-1]] if links and not apart else None


def _meets(
    colour: AtLight | None, clause: Clause, change: Clause, context: Context
) -> AtLight | None:
    """How who acts meets a light that changes to a colour; after it has turned red one runs it."""
    name, link = clause.event.name, None
    if clause.event.i < change.event.i:
        link = _link(clause, change, context)
    if colour is AtLight.GREEN:
        waits = name in _SETS_OFF or (name in HALTING and link in {"until", "till"})
        return AtLight.WAITS if waits else None
    if name in HALTING | {"hard_brake"}:
        return AtLight.STOPS
    if name not in _SETS_OFF or (link is None and colour is AtLight.RED):
        return None
    return AtLight.RED if link == "after" else AtLight.AMBER


def _joined(one: Clause, two: Clause) -> Basis:
    return Basis(min(one.event.i, two.event.i), max(one.event.j, two.event.j))


def _note(entity: Entity, light: AtLight, basis: Basis, context: Context) -> None:
    """Who is on foot goes at green or red; who drives at red has that danger."""
    if light is AtLight.RED and entity.is_vehicle:
        context.draft.hazard(HazardKind.RED_LIGHT_RUNNING, basis, [entity])
        return
    runs = any(
        d.kind is HazardKind.RED_LIGHT_RUNNING and entity in d.by for d in context.draft.dangers
    )
    if entity.light is None and not runs:
        entity.light = light, basis


def _has(chunks: list[Chunk], clauses: list[Clause], context: Context) -> None:
    """``which has green``, ``the ego's light is green``, ``green for the ego``: whose it is."""
    for k, chunk, colour in _told_apart(chunks, clauses, context):
        if colour is AtLight.RED:
            continue
        whose = _for(chunks, k) or _before(chunks, k)
        for entity in whose.entities if whose is not None else []:
            if entity.is_vehicle:
                _note(entity, colour, Basis(chunk.i, chunk.j), context)


def _told_apart(
    chunks: list[Chunk], clauses: list[Clause], context: Context
) -> Iterator[tuple[int, Chunk, AtLight]]:
    """Lights of a colour that no clause names: where among the chunks, and which colour."""
    named = {id(place) for clause in clauses for place in clause.places()}
    for k, chunk in enumerate(chunks):
        colour = _colour(chunk, context)
        if colour is not None and id(chunk) not in named:
            yield k, chunk, colour


def _for(chunks: list[Chunk], k: int) -> Mention | None:
    marker, who = [*chunks[k + 1 : k + 3], None, None][:2]
    told = isinstance(marker, Word) and marker.value == "for"
    return who if told and isinstance(who, Mention) else None


def _before(chunks: list[Chunk], k: int) -> Mention | None:
    """The last one named before it with no verb between."""
    for chunk in reversed(chunks[:k]):
        if isinstance(chunk, Mention):
            return chunk
        if isinstance(chunk, Place) and chunk.owner is not None:
            return chunk.owner
        if isinstance(chunk, Event) or (isinstance(chunk, Word) and chunk.value in {".", ";"}):
            return None
    return None


def _report(
    clauses: list[Clause], chunks: list[Chunk], changes: list[Clause], context: Context
) -> None:
    """What is said of a light, and of nobody who passes it."""
    told = [e.light[1] for e in context.draft.entities if e.light is not None]
    told += [d.basis for d in context.draft.dangers if d.kind is HazardKind.RED_LIGHT_RUNNING]
    held = [e for e in context.draft.entities if e.held or e.stands is not None]
    for _, chunk, _ in () if told or held else _told_apart(chunks, clauses, context):
        context.draft.note(chunk.i, chunk.j, _NOBODYS)
    for clause in clauses:
        event = clause.event
        if any(b.i is not None and b.i <= event.i < (b.j or 0) for b in told):
            continue
        place = next((p for p in clause.places() if _colour(p, context) is not None), None)
        if place is None:
            continue
        begins, ends = min(event.i, place.i), max(event.j, place.j)
        if clause in changes:
            context.draft.note(begins, ends, _TURNS)
        elif _colour(place, context) is AtLight.AMBER and clause.actors:
            context.draft.note(place.i, place.j, _AMBER)

"""What lights show: whose they are, what they turn to, who goes by them; blue ones and sirens."""

from collections.abc import Iterator
from dataclasses import dataclass

from scegen.scenario.signals import AtLight
from scegen.scenario.vocabulary import HazardKind, ParticipantKind
from scegen.understanding.chunks import Chunk, Event, Mention, Place
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import BOUNDARIES, chunk_at, value_at
from scegen.understanding.road import absent
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.rows import say
from scegen.understanding.words.terms import Term

_TURNS = "nothing says what anybody does as the light changes; it changes by its plan"
_NOBODYS = "nothing says who goes or waits by it"
_AMBER = "nothing says who goes over the line on amber"
_COLOURS = {"green": AtLight.GREEN, "red": AtLight.RED, "amber": AtLight.AMBER,
            "yellow": AtLight.AMBER}  # fmt: skip
_HALTING = frozenset({"stop", "slow", "brake", "wait", "hard_brake"})
_GOING = frozenset({"enter", "cross", "move", "turn", "accelerate", "speed", "pull_out", "approach",
                    "sharp_turn", "cut_in"})  # fmt: skip
_SETS_OFF = _GOING | {"leave", "try", "walk", "dash", "breach"}
_COMES = frozenset({"approach", "encounter", "inert"})
_SIDES = frozenset({"lateral", "left", "right"})


@dataclass(frozen=True, slots=True)
class _Light:
    """A light that shows, or turns to, a colour without anybody who passes it in that clause."""

    place: Place
    colour: AtLight
    whose: list[Entity]
    """For whom it is said to show that; nobody: it is not said."""
    change: Clause | None


def read_lights(clauses: list[Clause], chunks: list[Chunk], context: Context) -> None:
    """Notes of everybody how they meet their light; what is said of nobody is reported."""
    lights = list(_lights(clauses, chunks, context))
    changes = [light.change for light in lights if light.change is not None]
    red = [light for light in lights if light.colour is AtLight.RED]
    run = [light for light in red if _runs(light, clauses, context)]
    for clause in [c for c in clauses if c not in changes]:
        say("movements.past_a_light", clause, context)
    for light in [light for light in lights if light not in run]:
        if light.change is not None:
            _answer(light, light.change, clauses, context)
        elif light.colour is not AtLight.RED:
            for entity in [e for e in light.whose if e.is_vehicle]:
                _note(entity, light.colour, Basis(light.place.i, light.place.j), context)
    if any(token.low == "green" for token in context.tokens):  # "stands at a red light", until then
        for entity in context.draft.entities:
            if entity.light is None and "held" in entity.told and "stays_put" not in entity.told:
                _note(entity, AtLight.WAITS, entity.told["held"], context)
    _report(clauses, lights, changes, context)


def _lights(clauses: list[Clause], chunks: list[Chunk], context: Context) -> Iterator[_Light]:
    for k, place in enumerate(chunks):
        colour = _colour(place, context)
        if colour is None or not isinstance(place, Place):
            continue
        told = [c for c in clauses if any(p is place for p in c.places())]
        change = next((c for c in told if _changes(c)), None)
        faced = [e for c in told if c.event.name == "encounter" for e in c.actors]
        whose = _for(chunks, k, context) or place.owned_by
        if change is not None:
            yield _Light(place, colour, change.actors or whose, change)
        elif faced and colour is AtLight.RED:
            yield _Light(place, colour, faced, None)
        elif not any(c.actors for c in told):
            yield _Light(place, colour, whose or _before(chunks[:k]), None)


def _colour(thing: object, context: Context) -> AtLight | None:
    if not isinstance(thing, Place) or thing.kind != "signal":
        return None
    words = (t.low for t in context.tokens[thing.i : thing.j])
    return next((_COLOURS[word] for word in words if word in _COLOURS), None)


def _changes(clause: Clause) -> bool:
    """``the light turns red``, ``as soon as it gets green``."""
    event = clause.event
    told = event.lemma in word_list("light_changes") and not event.nominal and not event.negated
    return told and (not clause.actors or event.name == "inert")


def _for(chunks: list[Chunk], k: int, context: Context) -> list[Entity]:
    """``red for the ego``; ``for the cross street``: for those who come from the side."""
    noun = chunk_at(chunks, k + 2)
    if value_at(chunks, k + 1) != "for":
        return []
    if isinstance(noun, Mention) and noun.entities:
        return list(noun.entities)
    beside = isinstance(noun, Place) and noun.kind == "access"
    beside = beside or (isinstance(noun, Place | Mention) and bool(_SIDES & set(noun.dirs)))
    return [e for e in context.draft.entities if beside and context.from_the_side(e)]


def _before(chunks: list[Chunk]) -> list[Entity]:
    """``which has green``: the last one named before it with no verb between."""
    for chunk in reversed(chunks):
        if isinstance(chunk, Mention):
            return list(chunk.entities)
        if isinstance(chunk, Place) and chunk.owner is not None:
            return chunk.owned_by
        if isinstance(chunk, Event) or (chunk.value in BOUNDARIES):
            break
    return []


def _runs(light: _Light, clauses: list[Clause], context: Context) -> bool:
    """Finds who goes although the light is red: whose it is, or who is said to do so in spite."""
    at = light.place.i
    told = [c for c in clauses if c.drivers and not c.event.nominal]
    if light.whose:
        told = [c for c in told if any(e in light.whose for e in c.drivers)]
    later = [c for c in told if c.event.i > at and light.whose]
    if any(c.event.name in _HALTING and not c.event.negated for c in later):
        return False
    found = next((c for c in later if _goes(c)), None)
    found = found or _in_spite(at, [c for c in told if _goes(c)], context)
    if found is not None:
        words = _joined(found.event, light.place)
        context.draft.hazard(HazardKind.RED_LIGHT_RUNNING, words, found.drivers)
    return found is not None


def _goes(clause: Clause) -> bool:
    return clause.event.name in (_HALTING if clause.event.negated else _GOING)


def _in_spite(at: int, going: list[Clause], context: Context) -> Clause | None:
    """``although the light is red, the van enters``, ``… is red. Yet the van enters``."""
    low = [token.low for token in context.tokens]
    begins = max((k + 1 for k in range(at) if low[k] in BOUNDARIES), default=0)
    later = [c for c in going if c.event.i > at]
    marks = [k for k in range(begins, at) if low[k] in word_list("conceding") - {"in"}]
    if marks and not any(marks[-1] < c.event.i < at for c in going):
        opens = marks[-1] - (low[marks[-1] - 1] == "even")
        fronted = opens == begins or low[opens - 1] == ","
        earlier = [c for c in going if begins <= c.event.i < opens]
        return next(iter([*(later if fronted else []), *reversed(earlier)]), None)
    return next((c for c in later if word_list("still") & set(low[at : c.event.i])), None)


def _answer(light: _Light, change: Clause, clauses: list[Clause], context: Context) -> None:
    """What somebody does as a light changes: before it in its sentence, after it, or in the next.

    ``sets off when the light turns green``; ``when the light turns green, it sets off``.
    """
    event, colour = change.event, light.colour
    others = [
        c for c in clauses
        if c is not change and c.actors and not c.event.negated and c.event.name not in _COMES
        if not light.whose or any(e in light.whose for e in c.actors)
    ]  # fmt: skip
    before = [c for c in others if c.event.sentence == event.sentence and c.event.i < event.i][-1:]
    after = [c for c in others if c.event.sentence == event.sentence and c.event.i > event.i]
    after += [c for c in others if c.event.sentence == event.sentence + 1][:1]
    for clause in [*(c for c in before if _link(c, change, context)), *after]:
        meets = _meets(colour, clause, _link(clause, change, context))
        if meets is not None:
            for entity in clause.actors:
                _note(entity, meets, _joined(event, clause.event), context)
            return
    for entity in light.whose if colour is AtLight.GREEN else []:
        meets = AtLight.WAITS if "held" in entity.told else AtLight.GREEN
        _note(entity, meets, change.words, context)
    here = [c for c in clauses if c.event.sentence == event.sentence and not c.event.negated]
    for clause in here if colour is AtLight.RED else []:  # who keeps the rules stops there
        if clause.event.name == "approach" and _link(clause, change, context) != "after":
            for entity in clause.drivers:
                _note(entity, AtLight.STOPS, _joined(event, clause.event), context)


def _link(clause: Clause, change: Clause, context: Context) -> str | None:
    """The conjunction by which a change, or one that is over, hangs on what is told before it."""
    between = [t.low for t in context.tokens[clause.event.j : change.event.i]]
    over = "after" if change.event.perfect and between and clause.event.name not in _COMES else None
    return next((word for word in between[::-1] if word in word_list("at_a_change")), over)


def _meets(colour: AtLight, clause: Clause, link: str | None) -> AtLight | None:
    """How who acts meets a light that changes to a colour; after it has turned red one runs it."""
    name = clause.event.name
    if colour is AtLight.GREEN:
        waits = name in _SETS_OFF or (name in _HALTING and link in word_list("until"))
        return AtLight.WAITS if waits else None
    if name in _HALTING:
        return AtLight.STOPS
    if name not in _SETS_OFF or (link is None and colour is AtLight.RED):
        return None
    return AtLight.RED if link == "after" else AtLight.AMBER


def _joined(one: Event, two: Event | Place) -> Basis:
    return Basis(min(one.i, two.i), max(one.j, two.j))


def _note(entity: Entity, light: AtLight, basis: Basis, context: Context) -> None:
    """Who is on foot goes at green or red; who drives at red has that danger."""
    if light is AtLight.RED and entity.is_vehicle:
        context.draft.hazard(HazardKind.RED_LIGHT_RUNNING, basis, [entity])
        return
    red = [d for d in context.draft.dangers if d.kind is HazardKind.RED_LIGHT_RUNNING]
    if entity.light is None and not any(entity in d.by for d in red):
        entity.light = light, basis


def _report(
    clauses: list[Clause], lights: list[_Light], changes: list[Clause], context: Context
) -> None:
    """What is said of a light, and of nobody who passes it."""
    draft = context.draft
    told = [e.light[1] for e in draft.entities if e.light is not None]
    told += [d.basis for d in draft.dangers if d.kind is HazardKind.RED_LIGHT_RUNNING]
    held = any("held" in e.told or e.stands is not None for e in draft.entities)
    for light in [] if told or held else lights:
        if light.change is None:
            draft.note(light.place.i, light.place.j, _NOBODYS)
    for clause in clauses:
        event = clause.event
        place = next((p for p in clause.places() if _colour(p, context) is not None), None)
        if place is None or any(b.i is not None and b.i <= event.i < (b.j or 0) for b in told):
            continue
        if clause in changes:
            draft.note_at(_joined(event, place), _TURNS)
        elif _colour(place, context) is AtLight.AMBER and clause.actors:
            draft.note(place.i, place.j, _AMBER)


def read_calls(terms: list[Term], draft: Draft) -> None:
    """Put on call whose siren or blue lights are on: the emergency vehicle named last before."""
    able = [e for e in draft.entities if e.kind is ParticipantKind.EMERGENCY_VEHICLE]
    for k, term in enumerate(terms):
        if "on_call" not in term.data or absent.negated(terms, k) or not able:
            continue
        before = [e for e in able if e.basis.i is not None and e.basis.i <= term.i]
        whose = max(before, key=lambda e: e.basis.i or 0, default=able[0])
        whose.on_call = whose.on_call or Basis(term.i, term.j)

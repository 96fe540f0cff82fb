"""What rows do: to the clause, to participants, to the road."""

from collections.abc import Callable, Collection, Iterable
from itertools import product
from typing import Any, TypeAlias

from scegen.scenario.acts import ActKind
from scegen.scenario.signals import AtLight
from scegen.scenario.vocabulary import (
    Approach,
    HazardKind,
    JunctionKind,
    Maneuver,
    ParticipantKind,
)
from scegen.understanding.chunks import NounPhrase, Prep
from scegen.understanding.draft import IMPLIED
from scegen.understanding.entity import Basis
from scegen.understanding.happenings import Doing
from scegen.understanding.semantics.context import Clause, Context, span
from scegen.understanding.semantics.marks import MARKS, REWRITES, Mark, first
from scegen.understanding.semantics.met import apart
from scegen.understanding.semantics.patterns import end, noun, people, phrases
from scegen.understanding.semantics.seen import Site
from scegen.understanding.semantics.sites import PUTS
from scegen.understanding.semantics.ways import VALUES, WORDS
from scegen.understanding.semantics.who import who

Effect: TypeAlias = Callable[[Clause, Context], None]
Words: TypeAlias = Callable[[Clause, Context], Basis]


def _words(expression: str, reason: str | None) -> Words:
    """What a row rests on.

    Args:
        expression: ``event``; ``how VALUE…``, where that is said; ``phrase PATTERN`` or ``at
            PATTERN``, a phrase or place; ``to PATTERN`` and ``upto PATTERN``, from the verb to the
            end of one; ``danger KIND``, those of a danger; ``way WHO``, those of what they do;
            ``noted MARK``, those of a mark; one of `VALUES` or `WORDS`.
        reason: why, where the words do not say it themselves.
    """
    name, _, rest = expression.partition(" ")
    find = phrases(rest) if name in {"to", "phrase"} else lambda _clause, _context: []
    named = noun(rest.split())
    movers = who(rest) if name == "way" else lambda _clause, _context: []

    def basis(clause: Clause, context: Context) -> Basis:
        found: Basis | None = None
        if name == "how":
            found = clause.how(*rest.split())
        elif name in {"to", "phrase"}:
            for phrase in find(clause, context)[:1]:
                found = Basis(clause.event.i if name == "to" else phrase.word.i, end(phrase))
        elif name == "danger":
            found = next((d.basis for d in context.draft.dangers if d.kind == rest), None)
        elif name == "noted":
            told = (e.told for e in context.draft.entities)
            found = next((notes[rest] for notes in told if rest in notes), None)
        elif name == "way":
            found = next((e.maneuver_basis for e in movers(clause, context)), None)
        elif name in {"upto", "at"}:
            for place in [p for p in clause.places() if named(p, context)][:1]:
                begins = clause.words.i if name == "upto" else place.i
                found = Basis(begins, max(clause.event.j if name == "upto" else 0, place.j))
        elif name in WORDS:
            found = WORDS[name](clause, context)
        elif name in VALUES:
            found = next(iter(VALUES[name](clause, context).values()), None)
        found = found or clause.words
        return Basis(found.i, found.j, reason) if reason is not None else found

    return basis


def _causing(row: dict[str, Any]) -> str:
    by: str = row.get("by", "drivers")
    return by.removeprefix("maybe ")


def _hazard(kind: HazardKind, row: dict[str, Any], words: Words) -> Effect:
    culprits, victims = who(_causing(row)), who(row.get("to", "nobody"))

    def effect(clause: Clause, context: Context) -> None:
        basis, suffer = words(clause, context), victims(clause, context)
        met = [p for p in clause.event.pps if p.word.cat == "locus" and suffer]
        for phrase in met:  # "pulls out in front of a bus": in whose way
            if any(e in suffer for e in people([phrase])):
                basis = span(clause.event, phrase.word.i, end(phrase))
        context.draft.hazard(kind, basis, culprits(clause, context), suffer)

    return effect


def _ways(said: str) -> Callable[[Clause, Context], Collection[Maneuver]]:
    """Maneuvers by name, or what words of the clause name."""
    if said in VALUES:
        return VALUES[said]
    named = {Maneuver(value) for value in said.split()}
    return lambda _clause, _context: named


def _maneuver(said: str, of: str, words: Words) -> Effect:
    whom, ways = who(of), _ways(said)

    def effect(clause: Clause, context: Context) -> None:
        basis, values = words(clause, context), set(ways(clause, context))
        for entity in list(whom(clause, context)) if values else []:
            later = context.in_order(entity.maneuver_basis, clause.event)
            context.draft.maneuver(entity, values, basis, clause.alternative, later=later)

    return effect


def _place(approaches: set[Approach], row: dict[str, Any], of: str, words: Words) -> Effect:
    whom, reference = who(of), who(row["from"]) if "from" in row else None

    def effect(clause: Clause, context: Context) -> None:
        basis = words(clause, context)
        seen_by = reference(clause, context) if reference is not None else [None]
        for entity, observer in product(whom(clause, context), seen_by):
            if "unsaid" not in row or observer is None or apart(entity, observer, context):
                context.draft.place(entity, observer, set(approaches), basis)

    return effect


def _add(approach: Approach, words: Words) -> Effect:
    """Another vehicle does it, or it is done to another, whom the text does not name."""

    def effect(clause: Clause, context: Context) -> None:
        basis = words(clause, context).because("the other one is not named; here it is a car")
        added = [context.draft.add(ParticipantKind.CAR, basis)]
        clause.actors, clause.targets = clause.actors or added, clause.targets or added
        context.draft.place(added[0], None, {approach}, basis)

    return effect


def _drop(kind: HazardKind, of: str) -> Effect:
    whom, kinds = who(of), {kind}
    if kind is HazardKind.CROSSING_PEDESTRIAN:
        kinds.add(HazardKind.CROSSING_ANIMAL)  # as the draft has it of animals

    def effect(clause: Clause, context: Context) -> None:
        found = whom(clause, context)
        context.draft.dangers[:] = [
            d
            for d in context.draft.dangers
            if d.kind not in kinds or not d.by or any(e not in found for e in d.by)
        ]

    return effect


def _unplace(approach: Approach, of: str) -> Effect:
    whom = who(of)

    def effect(clause: Clause, context: Context) -> None:
        found = whom(clause, context)
        placed = context.draft.placements
        placed[:] = [p for p in placed if p.entity not in found or p.approaches != {approach}]

    return effect


def _mark(mark: Mark, of: str, words: Words) -> Effect:
    whom = who(of)

    def effect(clause: Clause, context: Context) -> None:
        basis = words(clause, context)
        for entity in list(whom(clause, context)):
            mark(entity, basis)

    return effect


def _put(name: str, where: str, of: str) -> Effect:
    whom, put = who(of), PUTS[name]
    kind, _, rest = where.partition(" ")
    named, find = noun(rest.split()), phrases(where)

    def effect(clause: Clause, context: Context) -> None:
        event = clause.event
        found: list[tuple[Prep | None, object]] = []
        if kind in {"object", "subject"}:
            nouns = [event.object] if kind == "object" else event.subject[:1]
            found += [(None, noun) for noun in nouns if named(noun, context)]
        else:
            found += [(p, p.target) for p in find(clause, context)]
        for prep, place in found:
            if isinstance(place, NounPhrase):
                begins = min(event.i, place.i) if prep is None else prep.word.i
                site = Site(place, prep, Basis(begins, place.j), clause, context)
                for entity in list(whom(clause, context)):
                    put(entity, site)

    return effect


def _act(row: dict[str, Any], of: str, words: Words) -> Effect:
    whom, kind, always = who(of), ActKind(row["act"]), bool(row.get("always"))
    to = who(row["into"]) if "into" in row else lambda _clause, _context: [None]

    def effect(clause: Clause, context: Context) -> None:
        event, basis = clause.event, words(clause, context)
        for entity, into in product(whom(clause, context), to(clause, context)):
            doing = Doing(kind, entity, basis, event.i, always=always, nominal=event.nominal)
            doing.into, doing.into_basis = into, basis if into is not None else None
            context.acts.append(doing)

    return effect


def _parts(row: dict[str, Any]) -> Effect:
    targets, actors = who(row.get("targets", "targets")), who(row.get("actors", "actors"))

    def effect(clause: Clause, context: Context) -> None:
        clause.targets, clause.actors = targets(clause, context), actors(clause, context)

    return effect


def _rule_out(said: str) -> Effect:
    ways = _ways(said)

    def effect(clause: Clause, context: Context) -> None:
        for entity in clause.drivers:
            entity.excluded.update(ways(clause, context))
            entity.excluded_basis = clause.words

    return effect


def _imply(name: str, words: Words) -> Effect:
    if name not in (*IMPLIED, JunctionKind.ROUNDABOUT):
        raise KeyError(name)

    def effect(clause: Clause, context: Context) -> None:
        if name == JunctionKind.ROUNDABOUT:
            junction = context.junction
            junction.kind, junction.kind_basis = JunctionKind(name), words(clause, context)
            return
        context.draft.implied.setdefault(name, words(clause, context))

    return effect


def _changed(change: Effect) -> Effect:
    def effect(clause: Clause, context: Context) -> None:
        change(clause, context)
        clause.cues = None

    return effect


EFFECTS: dict[str, Callable[[Any, dict[str, Any], str, Words], Effect]] = {
    "rewrite": lambda said, *_: _changed(REWRITES[said]),
    "as": lambda said, *_: _changed(lambda clause, _: setattr(clause.event, "name", said)),
    "lanes": lambda said, row, *_: _imply("lanes", _words(row.get("words", "event"), said)),
    "crossing": lambda said, row, *_: _imply("crossing", _words(row.get("words", "event"), said)),
    "rules_out": lambda said, *_: _rule_out(said),
    "drop": lambda said, _row, of, _words: _drop(HazardKind(said), of),
    "unplace": lambda said, _row, of, _words: _unplace(Approach(said), of),
    "marks": lambda said, _row, of, words: _mark(MARKS[said], of, words),
    "puts": lambda said, row, of, _words: _put(said, row["where"], of),
    "maneuver": lambda said, _row, of, words: _maneuver(said, of, words),
    "light": lambda said, _row, of, words: _mark(first("light", AtLight(said)), of, words),
    "hazard": lambda said, row, _of, words: _hazard(HazardKind(said), row, words),
    "act": lambda _said, row, of, words: _act(row, of, words),
    "place": lambda said, row, of, words: _place(set(map(Approach, said.split())), row, of, words),
    "implies": lambda said, _row, _of, words: _imply(said, words),
    "adds": lambda said, _row, _of, words: _add(Approach(said), words),
    "note": lambda said, _row, _of, words: (
        lambda clause, c: c.draft.note_at(words(clause, c), said)
    ),
}
"""Key of a row -> what it does, by what stands there; in the order in which it is done."""


def effects_of(row: dict[str, Any]) -> Iterable[Effect]:
    """All that a row does, but the families to which it leads.

    Raises:
        KeyError: names a word that means nothing here.
    """
    words = _words(row.get("words", "event"), row.get("reason"))
    of = row.get("of", _causing(row))
    if "targets" in row or "actors" in row:
        yield _parts(row)
    for key, effect in EFFECTS.items():
        told = row.get(key, [])
        for said in told if isinstance(told, list) else [told]:
            yield effect(said, row, of, words)

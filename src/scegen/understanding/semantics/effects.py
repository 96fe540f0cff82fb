"""What rows do: to the clause, to participants, to the road."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from itertools import product
from typing import Any, TypeAlias

from scegen.scenario.acts import ActKind
from scegen.scenario.signals import AtLight
from scegen.scenario.vocabulary import Approach, HazardKind, JunctionKind, Maneuver
from scegen.understanding.chunks import NounPhrase, Prep
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import Doing
from scegen.understanding.semantics.context import Clause, Context, span
from scegen.understanding.semantics.marks import MARKS, Mark, first
from scegen.understanding.semantics.met import apart
from scegen.understanding.semantics.patterns import end, noun, people, phrases
from scegen.understanding.semantics.rewriting import REWRITES
from scegen.understanding.semantics.seen import Site
from scegen.understanding.semantics.sites import PUTS
from scegen.understanding.semantics.ways import VALUES, WORDS
from scegen.understanding.semantics.who import who

Effect: TypeAlias = Callable[[Clause, Context], None]
Words: TypeAlias = Callable[[Clause, Context], Basis]


def _words(expression: str, reason: str | None) -> Words:
    """What a row rests on.

    Args:
        expression: ``event``; ``sudden`` or ``how VALUE…``, where that is said; ``phrase
            PATTERN`` or ``at PATTERN``, a phrase or place; ``to PATTERN`` and ``upto PATTERN``,
            from the verb to the end of one; ``danger KIND``, those of a danger; ``way WHO``, those
            of what they do; one of `VALUES` or `WORDS`.
        reason: why, where the words do not say it themselves.
    """
    name, _, rest = expression.partition(" ")
    find = phrases(rest) if name in {"to", "phrase"} else lambda _clause, _context: []
    named = noun(rest.split())
    movers = who(rest) if name == "way" else lambda _clause, _context: []

    def basis(clause: Clause, context: Context) -> Basis:
        found: Basis | None = None
        if name == "sudden":
            found = clause.sudden
        elif name == "how":
            found = clause.how(*rest.split())
        elif name in {"to", "phrase"}:
            for phrase in find(clause, context)[:1]:
                found = Basis(clause.event.i if name == "to" else phrase.word.i, end(phrase))
        elif name == "danger":
            found = next((d.basis for d in context.draft.dangers if d.kind == rest), None)
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


def _hazard(kind: HazardKind, by: str, to: str, words: Words) -> Effect:
    culprits, victims = who(by), who(to)

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


def _place(
    approaches: set[Approach], of: str, seen_from: str | None, words: Words, *, unsaid: bool
) -> Effect:
    whom, reference = who(of), who(seen_from) if seen_from is not None else None

    def effect(clause: Clause, context: Context) -> None:
        basis = words(clause, context)
        observer = next(iter(reference(clause, context)), None) if reference is not None else None
        seen = reference is None or observer is not None
        for entity in list(whom(clause, context)) if seen else []:
            if not unsaid or observer is None or apart(entity, observer, context):
                context.draft.place(entity, observer, set(approaches), basis)

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
    to = who(row.get("into", "nobody"))

    def effect(clause: Clause, context: Context) -> None:
        event, basis = clause.event, words(clause, context)
        others: list[Entity | None] = [*to(clause, context)] or [None]
        for entity, into in product(whom(clause, context), others):
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
    def effect(clause: Clause, context: Context) -> None:
        if name == JunctionKind.ROUNDABOUT:
            junction = context.junction
            junction.kind, junction.kind_basis = JunctionKind(name), words(clause, context)
            return
        known = getattr(context.draft, name)
        setattr(context.draft, name, known or (name == "from_kerb") or words(clause, context))

    return effect


def _changes(row: dict[str, Any]) -> Iterable[Effect]:
    """What a row does to the clause itself."""
    if "targets" in row or "actors" in row:
        yield _parts(row)
    if "rewrite" in row:
        yield REWRITES[row["rewrite"]]
    if "as" in row:
        yield lambda clause, _: setattr(clause.event, "name", row["as"])


def _statements(row: dict[str, Any], by: str, of: str, words: Words) -> Iterable[Effect]:
    """What a row says of participants."""
    if "rules_out" in row:
        yield _rule_out(row["rules_out"])
    if "drop" in row:
        yield _drop(HazardKind(row["drop"]), of)
    if "unplace" in row:
        yield _unplace(Approach(row["unplace"]), of)
    for name in row.get("marks", ()):
        yield _mark(MARKS[name], of, words)
    for name in row.get("puts", ()):
        yield _put(name, row["where"], of)
    if "maneuver" in row:
        yield _maneuver(row["maneuver"], of, words)
    if "light" in row:
        yield _mark(first("light", AtLight(row["light"])), of, words)
    if "hazard" in row:
        yield _hazard(HazardKind(row["hazard"]), by, row.get("to", "nobody"), words)
    if "act" in row:
        yield _act(row, of, words)
    if "place" in row:
        approaches = set(map(Approach, row["place"].split()))
        unsaid = bool(row.get("unsaid"))
        yield _place(approaches, of, row.get("from"), words, unsaid=unsaid)


def effects_of(row: dict[str, Any]) -> Iterable[Effect]:
    """All that a row does, but the families to which it leads.

    Raises:
        KeyError: names a word that means nothing here.
    """
    words = _words(row.get("words", "event"), row.get("reason"))
    by = row.get("by", "drivers").removeprefix("maybe ")
    yield from _changes(row)
    if "lanes" in row:
        yield lambda clause, c: c.lanes_implied(words(clause, c), row["lanes"])
    if "crossing" in row:
        yield lambda clause, c: c.crossing_implied(words(clause, c), row["crossing"])
    yield from _statements(row, by, row.get("of", by), words)
    if "implies" in row:
        yield _imply(row["implies"], words)
    if "note" in row:
        yield lambda clause, c: c.draft.note_at(words(clause, c), row["note"])

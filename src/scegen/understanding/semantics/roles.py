"""Finds the participants of an event, or of a noun with its phrases."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Prep, Word
from scegen.understanding.clauses.dependents import chain
from scegen.understanding.draft import Entity
from scegen.understanding.semantics.context import Clause


def clause_of(event: Event) -> Clause:
    """Who acts in an event, and on whom, passives turned round.

    Args:
        event: the event, mentions resolved.
    """
    actors = [e for m in event.subject for e in m.entities]
    direct = event.object
    targets = [e for m in chain(direct) for e in m.entities] if isinstance(direct, Mention) else []
    if event.passive:
        agents = [
            e
            for p in event.pps
            if p.value == "by" and isinstance(p.target, Mention)
            for e in p.target.entities
        ]
        if not agents and isinstance(direct, Mention):
            agents = targets  # "is passed by a bus": the verb has taken the "by"
        if event.name != "hide":
            return Clause(event, agents, actors)
        return Clause(event, actors, [])
    if not targets and event.name in {"yield", "merge", "follow", "collide"}:
        targets = [
            e
            for p in event.pps
            if p.value in {"to", "with", "in", "into", "against"} and isinstance(p.target, Mention)
            for e in p.target.entities
        ]
    return Clause(event, actors, [e for e in targets if e not in actors])


def clause_of_noun(noun: Mention) -> Clause:
    """``a van from the left``: what the phrases after a noun say of it, a clause without a verb.

    Args:
        noun: the noun, resolved.
    """
    event = Event("", noun.i, noun.j, "", mods=noun.mods, subject=[noun], pps=noun.pps)
    return Clause(event, list(noun.entities), [])


def without_nouns(clause: Clause) -> Clause:
    """The clause without the phrases that say of one on whom it is done where that one is."""
    event = clause.event
    own = [
        p
        for p in event.pps
        if p.on_mention is None or p.on_mention.is_ego or p.on_mention in event.subject
    ]
    return replace(clause, event=replace(event, pps=own))


def clauses_of_fronted(chunks: list[Chunk]) -> Iterator[Clause]:
    """``at a stop sign, the ego …``: what opens a sentence says where the noun after it is."""
    marks = [None, None, *chunks]
    for (k, place), before in zip(enumerate(chunks), marks, strict=False):
        led = isinstance(place, Place) and place.prep is not None and place.prep.value == "in"
        opens = before is None or (isinstance(before, Word) and before.cat == "punct")
        if not (led and opens) or not isinstance(place, Place) or place.prep is None:
            continue
        after = [c for c in chunks[k + 1 : k + 3] if getattr(c, "value", "") != ","][:1]
        for noun in after:
            if isinstance(noun, Mention):
                fronted = [Prep(place.prep, place)]
                event = Event("", place.prep.i, place.j, "", subject=[noun], pps=fronted)
                yield Clause(event, list(noun.entities), [])


def clause_of_everybody(entities: list[Entity]) -> Clause:
    """The text as a whole: a clause without words in which everybody takes part."""
    return Clause(Event("", 0, 0, ""), list(entities), [])

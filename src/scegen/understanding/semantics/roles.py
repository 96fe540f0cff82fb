"""Finds the participants of an event, or of a noun with its phrases."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Prep
from scegen.understanding.clauses.dependents import chain
from scegen.understanding.entity import Entity
from scegen.understanding.semantics.context import Clause


def clause_of(event: Event) -> Clause:
    """Who acts in an event, and on whom, passives turned round."""
    actors = [e for m in event.subject for e in m.entities]
    direct = event.object
    targets = [e for m in chain(direct) for e in m.entities] if isinstance(direct, Mention) else []
    if event.passive:
        # "is passed by a bus": the verb has taken the "by"
        agents = event.whom("by") or targets
        return Clause(event, actors, []) if event.name == "hide" else Clause(event, agents, actors)
    if not targets and event.name in {"yield", "merge", "follow", "collide"}:
        targets = event.whom("to", "with", "in", "into", "against")
    return Clause(event, actors, [e for e in targets if e not in actors])


def clause_of_noun(noun: Mention) -> Clause:
    """``a van from the left``: what the phrases after a noun say of it, a clause without a verb."""
    event = Event("", noun.i, noun.j, "", mods=noun.mods, subject=[noun], pps=noun.pps)
    event.negated = noun.negated
    return Clause(event, list(noun.entities), [])


def without_nouns(clause: Clause) -> Clause:
    """The clause without the phrases that say of one on whom it is done where that one is."""
    event = clause.event
    own = [
        p
        for p in event.pps
        if p.on_mention is None or p.on_mention.is_ego or p.on_mention in event.subject
    ]
    same = len(own) == len(event.pps)
    return clause if same else replace(clause, event=replace(event, pps=own))


def stray_clauses(chunks: list[Chunk], clauses: list[Clause]) -> Iterator[Clause]:
    """Phrases of place that belong to no noun or verb which names anybody.

    ``At a stop sign, the ego …`` says it of the noun that follows, ``its way round the van`` of
    whose way it is; of others nobody is named.
    """
    taken = {id(p) for c in clauses if c.actors for p in c.places()}
    for k, noun in enumerate(chunks):
        before, after = chunks[max(0, k - 3) : k], chunks[k + 1 : k + 3]
        if not isinstance(noun, NounPhrase) or noun.prep is None:
            continue
        ways = [c for c in before[-3:] if isinstance(c, Place) and c.kind == "path"]
        if ways:
            who = ways[-1].owner
        elif not isinstance(noun, Place) or id(noun) in taken:
            continue
        else:
            opens = all(getattr(c, "cat", "") == "punct" for c in before[-2:-1])
            heads = [c for c in after if getattr(c, "value", "") != ","][:1] if opens else []
            who = next((c for c in heads if isinstance(c, Mention)), None)
        event = Event("", noun.prep.i, noun.j, "", pps=[Prep(noun.prep, noun)])
        yield Clause(event, list(who.entities) if who is not None else [], [])


def clause_of_everybody(entities: list[Entity]) -> Clause:
    """The text as a whole: a clause without words in which everybody takes part."""
    return Clause(Event("", 0, 0, ""), list(entities), [])

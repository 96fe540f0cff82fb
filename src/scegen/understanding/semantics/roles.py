"""Finds the participants of an event."""

from __future__ import annotations

from scegen.understanding.chunks import Event, Mention
from scegen.understanding.clauses.dependents import chain
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

"""What leaves a participant on its course: following, keeping a lane, waiting."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind, JunctionKind
from scegen.understanding.chunks import Chunk, Mention, Place, Prep
from scegen.understanding.draft import Basis, Danger
from scegen.understanding.semantics.context import Clause, Context


def circulate(chunks: list[Chunk], clauses: list[Clause], context: Context) -> None:
    """``already circulating``, ``is in the roundabout``: there before the others come.

    Args:
        chunks: the chunks of the text.
        clauses: what happens.
        context: the scenario in the making.
    """
    for mention in (c for c in chunks if isinstance(c, Mention)):
        inside = any(_inside(p, context) for p in mention.pps)
        for entity in mention.entities if inside else []:
            entity.circulates = entity.circulates or Basis(mention.i, mention.j)
    for clause in clauses:
        event = clause.event
        words = context.tokens[event.i : event.j]
        lemma = words[0].forms[-1][0] if words else None
        rounds = lemma in {"circulate", "circle"}
        gone = [t.low for t in words[1:]] in (["round"], ["around"]) and event.object is None
        rounds |= gone and not any(e.ego for e in clause.drivers)
        within = next((p for p in event.pps if _inside(p, context)), None)
        if event.negated or not (rounds or within) or event.name in {"enter", "approach"}:
            continue
        for entity in clause.drivers:
            entity.circulates = entity.circulates or clause.words
        road = context.junction
        if lemma == "circulate" and not (road.crossing or road.road):
            reason = "who circulates is in a roundabout"
            road.kind = JunctionKind.ROUNDABOUT
            road.kind_basis = Basis(event.i, event.j, reason)
    context.draft.dangers[:] = [d for d in context.draft.dangers if not _comes_first(d)]


def _comes_first(danger: Danger) -> bool:
    """Who goes round already owes no way to those who come in, however close it passes them."""
    yields = danger.kind is HazardKind.FAILURE_TO_YIELD
    return yields and bool(danger.by) and all(e.circulates for e in danger.by)


def _inside(prep: Prep, context: Context) -> bool:
    """``in the roundabout``, not "at" or "into" it."""
    place = prep.target
    if not isinstance(place, Place) or place.kind != "junction" or place.head is None:
        return False
    named = place.head.data.get("kind") == "roundabout"
    return named and context.tokens[prep.word.i].low in {"in", "inside", "on", "within", "round"}

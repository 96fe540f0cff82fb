"""What leaves a participant on its course: following, keeping a lane, waiting."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind
from scegen.understanding.chunks import Chunk, Mention, Place, Prep
from scegen.understanding.draft import Basis
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
        rounds = bool(words) and words[0].forms[-1][0] in {"circulate", "circle"}
        within = next((p for p in event.pps if _inside(p, context)), None)
        if event.negated or not (rounds or within) or event.name in {"enter", "approach"}:
            continue
        for entity in clause.drivers:
            entity.circulates = entity.circulates or clause.words


def _inside(prep: Prep, context: Context) -> bool:
    """``in the roundabout``, not "at" or "into" it."""
    place = prep.target
    if not isinstance(place, Place) or place.kind != "junction" or place.head is None:
        return False
    named = place.head.data.get("kind") == "roundabout"
    return named and context.tokens[prep.word.i].low in {"in", "inside", "on", "within", "round"}


def move_off(clause: Clause, context: Context) -> None:
    """``a parked van drives off``: whoever comes along has to be let through.

    Args:
        clause: what happens.
        context: the scenario in the making.
    """
    event = clause.event
    if event.negated or event.passive or event.premod_of is not None:
        return
    words = {t.low for t in context.tokens[event.i : event.j]}
    parking = any(p.kind in {"parking", "sidewalk", "shoulder"} for p in clause.places())
    away = event.name == "leave" and (parking or bool(words & {"off", "away"}))
    others = [e for e in clause.drivers if e.pulls_out and not e.ego]
    if away and others:
        context.draft.hazard(HazardKind.FAILURE_TO_YIELD, clause.words, others)


def park(clause: Clause, _context: Context) -> None:
    """``is parked``: the vehicle stands for the whole scenario."""
    if clause.event.form != "ed":
        return
    for entity in clause.actors:
        if entity.is_vehicle and not entity.ego and entity.sets_off < clause.event.i:
            entity.parked = True
            entity.parked_basis = Basis(clause.event.i, clause.event.j)
        entity.pulls_out = entity.pulls_out or entity.sets_off > clause.event.i

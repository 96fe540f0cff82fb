"""What leaves a participant on its course: following, keeping a lane, waiting."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind, JunctionKind
from scegen.understanding.chunks import Chunk, Mention, Place, Prep
from scegen.understanding.draft import Basis, Danger
from scegen.understanding.lexicon import word_list
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
        gone = [t.low for t in words[1:]] in (["round"], ["around"]) and (
            event.object is None or (event.form == "ing" and _named(event.object))
        )
        rounds |= gone and not any(e.ego for e in clause.drivers)
        within = any(_inside(p, context) and _of_the_verb(p, clause, context) for p in event.pps)
        if event.negated or not (rounds or within):
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


def _of_the_verb(prep: Prep, clause: Clause, context: Context) -> bool:
    """Not "enters in the roundabout", "waits for a car in the roundabout"."""
    before = context.tokens[prep.word.i - 1].low
    comes = clause.event.name in {"enter", "approach"} and before not in word_list("being_there")
    noun = prep.on_mention
    own = noun is None or not noun.heads or noun.is_ego or noun in clause.event.subject
    return own and not comes


def _inside(prep: Prep, context: Context) -> bool:
    """``in the roundabout``, ``already on it``, not "at" or "into" it."""
    if context.tokens[prep.word.i].low not in word_list("on_the_ring"):
        return False
    it = isinstance(prep.target, Mention) and prep.target.pronoun == "it"
    already = context.tokens[prep.word.i - 1].low in word_list("being_there")
    round_it = it and already and context.junction.kind is JunctionKind.ROUNDABOUT
    return round_it or _named(prep.target)


def _named(place: object) -> bool:
    """``the roundabout``."""
    head = place.head if isinstance(place, Place) and place.kind == "junction" else None
    return head is not None and head.data.get("kind") == "roundabout"

"""Motion that ends at somebody: "rolls into the ego's front", "slides into a parked car"."""

from __future__ import annotations

from scegen.understanding.chunks import Mention, NounPhrase, Place, Thing
from scegen.understanding.entity import Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.words.tokens import low_at

_BODY = frozenset({"side", "flank"})
_MOTION = frozenset({"move", "walk", "speed", "enter", "reverse", "turn", "sharp_turn", "swerve",
                     "lose_control", "pull_out", "accelerate", "brake", "slow", "dash", "cross",
                     "lane_change", "pull_over", "return", "collide", "unknown"})  # fmt: skip

_NOBODY = frozenset({"nobody", "neither"})
_ROADWARDS = frozenset({"turn", "sharp_turn", "pull_out"})
"""What is done into a road, so that "it" may be one."""


def goal_of_contact(clause: Clause, context: Context) -> NounPhrase | None:
    """Whom, or whose part, somebody moves into: themselves, not their way or their lane."""
    event, tokens = clause.event, context.tokens
    part = event.object  # "plants its bonnet in a van"
    own = isinstance(part, Place) and part.kind in _BODY and part.has("possessive", "its")
    if (event.name not in _MOTION and not own) or event.nominal:
        return None
    opening = {"into", *(["in"] if own or event.lemma in word_list("ending_up") else [])}
    if event.name not in {"turn", "sharp_turn"}:  # "turns left against oncoming traffic"
        opening.add("against")
    goals: list[object] = [p.target for p in event.pps if tokens[p.word.i].low in opening]
    goals += [event.object] if tokens[event.j - 1].low == "into" else []
    nouns = (g for g in goals if isinstance(g, NounPhrase))
    # "bores into its side": somebody's part, not a lane or a car park
    if event.name == "unknown" and not own:
        nouns = (g for g in nouns if isinstance(g, Place))
    return next((g for g in nouns if _touched(g, clause, context)), None)


def _touched(goal: NounPhrase, clause: Clause, context: Context) -> bool:
    if isinstance(goal, Thing):
        return lies_there(goal, context)
    if isinstance(goal, Mention):
        mass = clause.event.lemma not in word_list("ramming")  # "pulls out into the traffic"
        mass = mass and any("mass" in h.data for h in goal.heads)
        road = goal.pronoun == "it" and clause.event.name in _ROADWARDS
        free = not (mass or road or goal.possessor)
        nobody = goal.negated or goal.pronoun in _NOBODY
        return free and (nobody or lies_there(goal, context) or bool(goal.entities))
    if not isinstance(goal, Place) or goal.kind not in _BODY:
        return False
    end = bool({"front", "rear"} & set(goal.dirs))
    owned = goal.owner is not None or goal.possessed
    named = goal.head is not None and (bool(goal.dirs) or goal.owner is not None)
    rests = clause.event.lemma in word_list("ending_up")  # "in its side"; "into its side" of a road
    rams = clause.event.lemma in word_list("ramming") and low_at(context.tokens, goal.j) != "of"
    return end or (owned and (named or rests or rams))


def lies_there(noun: object, context: Context) -> bool:
    """Whether it is something in the way, or may be: ``a crate lies there …, drives into it``."""
    lying = context.draft.lying
    it = isinstance(noun, Mention) and noun.pronoun == "it" and bool(lying)
    return it or any(noun is thing for thing in lying)


def touched(goal: NounPhrase | None, clause: Clause, context: Context) -> list[Entity]:
    """Who it is that is touched: ``ends up in my boot``, ``runs into the back of the bus``."""
    if goal is None:
        return []
    whom = goal if isinstance(goal, Mention) else goal.owner
    if whom is not None:
        return [e for e in whom.entities if e not in clause.actors]
    egos = [e for e in context.draft.entities if e.ego and e not in clause.actors]
    return egos if goal.possessed else []

"""Whom somebody drives up to, or touches, and whether anything is said of where the two are."""

from itertools import zip_longest

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding.chunks import Event, Mention, NounPhrase, Place, Thing
from scegen.understanding.entity import Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.words.tokens import low_at

_TOWARDS = frozenset({"to", "into", "in", "for", "with"})
_ACROSS = frozenset({Approach.LEFT, Approach.RIGHT, Approach.OPPOSITE, Approach.AHEAD,
                     Approach.BEHIND})  # fmt: skip


def into_rear(event: Event, context: Context) -> bool:
    """``rear-ends``, ``runs into the back of``, ``hits from behind``."""
    rear = any(isinstance(c, Place) and "rear" in c.dirs for c in event.nouns())
    return rear or from_the_rear(event, context)


def from_the_rear(event: Event, context: Context) -> bool:
    """``rear-ends``, ``hits from behind``, ``… from the rear``: without naming a part."""
    behind = any(p.value == "behind" and p.outer == "from" for p in event.pps)
    places = [p.place for p in event.pps if p.value == "from" and p.place is not None]
    behind = behind or any("rear" in place.dirs for place in places)
    return behind or _rear_inside(event, context)


def _rear_inside(event: Event, context: Context) -> bool:
    """``rear-ends``, ``drives into its rear``: the verb itself tells the rear.

    Not so "rolls back into it".
    """
    said = context.lows(event.i, event.j + 1)
    own = zip_longest(said[: event.j - event.i], said[1:])
    return any(low in {"rear", "back"} and then != "into" for low, then in own)


def _rear_ends(clause: Clause, context: Context) -> bool:
    """Whether somebody hits another from behind."""
    return clause.event.name == "collide" and into_rear(clause.event, context)


def driven_up_to(clause: Clause, context: Context) -> list[Entity]:
    """``closes in on a stopped van``, ``encounters a slow tractor``, ``hits its rear``."""
    event, rear = clause.event, _rear_ends(clause, context)
    towards = _TOWARDS - ({"with"} if event.name == "move" else set())  # "drives with a van behind"
    found = list(clause.targets)
    for prep in event.pps:
        whom = prep.target
        if isinstance(whom, Mention):
            queue = whom.head is not None and "mass" in whom.head.data  # "the tail of a queue"
            if prep.value in towards or (prep.value == "of" and (queue or rear)):
                found += whom.entities
    ends = clause.places()
    owned = [c for c in ends if "rear" in c.dirs or (rear and c is event.object)]
    found += [e for c in owned for e in c.owned_by]
    its = any(_its(c, event) for c in ends)
    its = its or (_rear_inside(event, context) and not event.passive)
    if rear and not found and its:
        others = [e for e in context.draft.entities if e not in clause.actors]
        found += [e for e in others if e.ego or len(others) == 1]  # "hits its rear"
    return [e for e in dict.fromkeys(found) if e not in clause.actors]


def _its(part: Place, event: Event) -> bool:
    own = part.has("possessive") and part.owner is None
    met = {"", "into", *(["with"] if event.lemma == "collide" else [])}
    met |= {"in"} if event.lemma in word_list("ending_up") else set()
    return own and "rear" in part.dirs and part.opening in met


def apart(entity: Entity, observer: Entity, context: Context) -> bool:
    """Whether nothing is said yet of where one is, seen from the other or from the ego."""
    return not any(
        (p.entity is entity and p.reference in {None, observer})
        or (p.entity is observer and (p.reference is entity or (entity.ego and not p.reference)))
        for p in context.draft.placements
        if p.approaches & _ACROSS
    )


def on_the_wrong_side(entity: Entity, context: Context) -> bool:
    """Whether it drives where others come towards it, and passes nobody."""
    strays = entity in context.draft.causing(HazardKind.ONCOMING_LANE)
    return strays and Maneuver.OVERTAKE not in entity.maneuvers


def _stand_to_each_other(clause: Clause, context: Context) -> bool:
    """Whether it is said how one who acts stands to those on whom it is done."""
    egos = any(e.ego for e in clause.targets)
    return any(
        p.reference in clause.targets
        or (p.reference is None and (egos or p.approaches != {Approach.ADJACENT}))
        for entity in clause.actors
        for p in context.draft.placements_of(entity)
    )


def _was_ahead(clause: Clause, context: Context) -> bool:
    """Whether one who acts is told before to be ahead of the ego, and in no other lane."""
    told = [p for e in clause.drivers for p in context.draft.placements_of(e)]
    ahead = any(
        p.approaches == {Approach.AHEAD}
        and p.reference in {None, context.draft.ego}
        and (p.basis.i or 0) < clause.event.i
        for p in told
    )
    return ahead and not any(Approach.ADJACENT in p.approaches for p in told)


FACTS = {
    "stand_to_each_other": _stand_to_each_other,
    "was_ahead": _was_ahead,
    "rear_ends": _rear_ends,
}
"""Words of conditions that ask for a meeting."""


_BODY = frozenset({"side", "flank"})

_ROADWARDS = frozenset({"turn", "sharp_turn", "pull_out"})
"""What is done into a road, so that "it" may be one."""


def goal_of_contact(clause: Clause, context: Context) -> NounPhrase | None:
    """Whom, or whose part, somebody moves into: themselves, not their way or their lane."""
    event, tokens = clause.event, context.tokens
    part = event.object  # "plants its bonnet in a van"
    own = isinstance(part, Place) and part.kind in _BODY and part.has("possessive", "its")
    if (event.name not in word_list("in_motion") and not own) or event.nominal:
        return None
    opening = {"into", *(["in"] if own or event.lemma in word_list("ending_up") else [])}
    if event.name not in {"turn", "sharp_turn"}:  # "turns left against oncoming traffic"
        opening.add("against")
    preps = [p for p in event.pps if p.word.cat == "prep"]  # not "in front of the bus"
    goals: list[object] = [p.target for p in preps if tokens[p.word.i].low in opening]
    goals += [event.object] if tokens[event.j - 1].low == "into" else []
    # "bores into its side": somebody's part, not a lane or a car park
    kind = Place if event.name == "unknown" and not own else NounPhrase
    nouns = (g for g in goals if isinstance(g, kind))
    return next((g for g in nouns if _touched(g, clause, context)), None)


def _touched(goal: NounPhrase, clause: Clause, context: Context) -> bool:
    if isinstance(goal, Thing):
        return lies_there(goal, context)
    if isinstance(goal, Mention):
        mass = clause.event.lemma not in word_list("ramming")  # "pulls out into the traffic"
        mass = mass and any("mass" in h.data for h in goal.heads)
        changes = clause.event.lemma in word_list("changing")  # "changes into it": that lane
        road = goal.pronoun == "it" and (changes or clause.event.name in _ROADWARDS)
        free = not (mass or road or goal.possessor)
        nobody = goal.negated or goal.pronoun in {"nobody", "neither"}
        return free and (nobody or lies_there(goal, context) or bool(goal.entities))
    if not isinstance(goal, Place) or goal.kind not in _BODY:
        return False
    end = bool({"front", "rear"} & set(goal.dirs))
    owned = goal.owner is not None or goal.has("possessive")
    sure = bool(goal.dirs) or goal.owner is not None or goal.kind == "flank"
    named = goal.head is not None and sure
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
    return egos if goal.has("possessive") else []

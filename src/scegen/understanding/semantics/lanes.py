"""What places tell: how one is seen, into which lane and into whose a movement leads."""

from collections.abc import Callable

from scegen.scenario.vocabulary import Approach
from scegen.understanding.chunks import Event, Place
from scegen.understanding.entity import Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.words.numbers import POSITIONS, number_at
from scegen.understanding.words.tokens import Token


def into_lane(event: Event) -> Place | None:
    """The lane or path that a movement ends in ("into the ego's path")."""
    goals = [p.target for p in event.pps if p.value in {"into", "to", "for"}]
    lanes = (g for g in (*goals, event.object) if isinstance(g, Place))
    return next((lane for lane in lanes if lane.kind in {"lane", "path"}), None)


def _from_the_next(clause: Clause, context: Context) -> bool:
    """``the van next to it drifts into the same lane``: from beside, whatever lane it is."""
    event, lane = clause.event, into_lane(clause.event)
    who = [e for m in event.subject for e in m.entities]
    entered = any(p.target is lane and p.value == "into" for p in event.pps)
    entered = entered or (event.name == "enter" and event.object is lane)
    named = lane is not None and lane.kind == "lane" and "opposite" not in lane.dirs
    if lane is not None and lane.owner is not None:  # "the ego moves into the lane of the van"
        who += lane.owner.entities
    return named and entered and any(context.placed(e, Approach.ADJACENT) for e in who)


def _against(entity: Entity, place: Place | None) -> bool:
    """Whether a lane leads the other way than somebody is headed ("the northbound lane")."""
    if place is None or place.kind != "lane":
        return False
    return place.has("compass", FACING.get(entity.heading or "", ""))


def owners(lane: Place | None, clause: Clause, context: Context) -> list[Entity]:
    """Whose lane it is; "its lane" is the ego's for everybody who moves into it."""
    if lane is None:
        return []
    if lane.owner is not None:
        return lane.owned_by
    others = [e for e in context.draft.entities if e.moving_vehicle and e not in clause.actors]
    named = [d for d in lane.dirs if d in SIDES]
    number = lane_number(lane, context.tokens)  # "the ego in lane 1 …, a van changes to lane 1"
    there = [e for e in others if e.ego and e.start_lane and e.start_lane[0] in named]
    there = there or [e for e in others if number is not None and e.lane == number]
    if there and lane.kind == "lane":
        return there  # "the ego in the right lane …, a car changes to the right lane"
    his = context.tokens[lane.i].low in word_list("somebodys")  # "came into his lane"
    meant = [e for e in others if lane.kind == "path" or (his and "somebody" in e.named_by)]
    its = [e for e in others if e.ego] or (meant if len(others) == 1 else [])
    return its if lane.has("possessive") and "same" not in {m.value for m in lane.mods} else []


def _head_on(clause: Clause, place: Place | None, context: Context) -> bool:
    """``an oncoming van drifts into the ego's lane``: it has no business there."""
    if place is None or not owners(place, clause, context):
        return False
    words = context.tokens
    egos = place.has("possessive", "first_person") or any(e.ego for e in place.owned_by)
    oncoming = any(context.oncoming(e) and not e.ego for e in clause.drivers)
    if place.kind == "side" and not place.dirs:  # "comes onto its side", "ends up on my side"
        entered = place is clause.event.object and words[clause.event.j - 1].low == "onto"
        onto = (p.target is place and words[p.word.i].low == "onto" for p in clause.event.pps)
        return entered or any(onto) or (egos and oncoming)
    kept = clause.event.lemma in word_list("keeping")  # "keeps its lane"
    entered = (place is clause.event.object and not kept) or any(
        p.target is place and p.value == "into" for p in clause.event.pps
    )
    if place.kind != "lane" or not (entered or place.owner is not None):
        return False  # "stays in its lane"
    sideways = any(t.value in SIDES for t in clause.event.dirs) and not egos
    return not sideways and oncoming


def _head_on_somewhere(clause: Clause, context: Context) -> bool:
    """Whether any place of a clause leads the other way, or is another's.

    Not the one it leaves, nor one that a turn leads across.
    """
    turns = clause.event.name in {"turn", "sharp_turn"}
    left = {
        id(p.target)
        for p in clause.event.pps
        if p.value in {"from", "against"} or (turns and context.tokens[p.word.i].low == "across")
    }
    return any(
        _head_on(clause, place, context) or any(_against(e, place) for e in clause.drivers)
        for place in clause.places()
        if id(place) not in left
    )


FACTS: dict[str, Callable[[Clause, Context], bool]] = {
    "from_the_next": _from_the_next,
    "against_lane": lambda clause, _: any(
        _against(e, into_lane(clause.event)) for e in clause.drivers
    ),
    "head_on_somewhere": _head_on_somewhere,
    "head_on": lambda clause, c: _head_on(clause, into_lane(clause.event), c),
}
"""Words of conditions that ask for a lane."""


EITHER = "either"
"""The side from which lanes are counted where that is not said."""
FROM_SIDE = 3
"""Words of "from the left"."""
_MOST = 6


def lane_number(place: object, tokens: list[Token]) -> int | None:
    """``lane 2``, ``the third lane``, ``exit 2``; None for what has no number."""
    if not isinstance(place, Place) or place.kind not in {"lane", "exit"} or place.head is None:
        return None
    last = number_at(tokens, place.j - 1)
    if last is not None and place.j > place.head.j and 0 < last.value <= _MOST:
        return int(last.value)
    named = place if place.kind == "exit" else place.head
    first = max(POSITIONS.get(token.low, -1) for token in tokens[named.i : named.j])
    return first + 1 if first >= 0 else None


def counted_from(j: int, tokens: list[Token]) -> str:
    """``the third lane from the right``."""
    after = [t.low for t in tokens[j : j + FROM_SIDE]]
    return after[-1] if after[:2] == ["from", "the"] and after[-1] in {"left", "right"} else EITHER


BY_DIR: dict[str, frozenset[Approach]] = {
    "opposite": frozenset({Approach.OPPOSITE}),
    "lateral": frozenset({Approach.LEFT, Approach.RIGHT}),
    "ahead": frozenset({Approach.AHEAD}),
    "behind": frozenset({Approach.BEHIND}),
    "adjacent": frozenset({Approach.ADJACENT}),
    "rear": frozenset({Approach.BEHIND}),
    "front": frozenset({Approach.AHEAD}),
    "same": frozenset({Approach.AHEAD, Approach.BEHIND, Approach.ADJACENT}),
}
INVERSE = {a: a for a in Approach} | {
    Approach.AHEAD: Approach.BEHIND,
    Approach.BEHIND: Approach.AHEAD,
    Approach.LEFT: Approach.RIGHT,
    Approach.RIGHT: Approach.LEFT,
}
"""How one sees another, by how the other sees the one."""
FACING = {"north": "south", "south": "north", "east": "west", "west": "east"}
"""Heading -> the opposite one."""
SIDES = {"left": Approach.LEFT, "right": Approach.RIGHT}
_PLACES = frozenset({"side", "direction", "lane", "sidewalk", "road", "shoulder", "bike_lane",
                     "path", "leg"})  # fmt: skip
_OFF_THE_ROAD = {"access": ("from", "in"), "bus_stop": ("in",), "parking": ("in",)}


def adjective_approaches(dirs: list[str]) -> frozenset[Approach]:
    """What "oncoming", "leading", "crossing" … before a noun say."""
    return next((BY_DIR[value] for value in dirs if value in BY_DIR), frozenset())


def place_approaches(place: Place, prep: str) -> frozenset[Approach]:
    """What "from the right", "in the next lane", "on the pavement" say."""
    if prep in _OFF_THE_ROAD.get(place.kind, ()):
        return frozenset(SIDES[d] for d in place.dirs if d in SIDES)
    if place.kind not in _PLACES:
        return frozenset()
    dirs = place.dirs
    if prep in word_list("past") and {"front", "rear"} & set(dirs):
        return frozenset()  # "runs around its front": past it, not there
    sides = {SIDES[d] for d in dirs if d in SIDES}
    other = any((m.cat, m.value) == ("det", "other") for m in place.mods)
    if place.kind == "direction" and other:
        return BY_DIR["opposite"]
    if place.kind in {"lane", "bike_lane"}:
        if "opposite" in dirs:
            return BY_DIR["opposite"]
        if "lateral" in dirs:
            return BY_DIR["lateral"]
        beside = sides or "adjacent" in dirs
        return BY_DIR["adjacent"] if beside and prep in {"in", "from", ""} else frozenset()
    if sides:
        return frozenset(sides)
    if "front" in dirs:
        return frozenset({Approach.OPPOSITE if prep == "from" else Approach.AHEAD})
    from_a_side = prep == "from" or (other and prep == "in")  # "stands on the other side"
    if place.kind == "side" and not dirs and from_a_side and place.head is not None:
        return BY_DIR["opposite" if other else "lateral"]
    if "same" in dirs and prep != "from":
        return frozenset()  # "in the same direction" is the way of those on one road anyway
    return next((BY_DIR[d] for d in dirs if d in BY_DIR), frozenset())

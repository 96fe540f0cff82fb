"""On which side a place lies: said right after it."""

from __future__ import annotations

from scegen.understanding.chunks import Event, Mention, NounPhrase, Place, Thing
from scegen.understanding.clauses.state import State
from scegen.understanding.phrases.lookahead import is_word

_BESIDE_THE_ROAD = frozenset({"access", "bus_stop", "parking", "feature"})
_ARMS = frozenset({"leg", "road"})
_BY_ROAD = frozenset({"from", "into"})
_LEADING = frozenset({"in", "into", "to", "for"})
_ASIDE = frozenset({"in", "to"})


def side_of_place(noun: NounPhrase, state: State) -> bool:
    """``a driveway on the right``, ``the lane to its right``: the side at which it lies.

    Returns:
        Whether it is the side of the place before it.
    """
    place = state.at(-2)
    if not isinstance(noun, Place) or noun.kind != "side":
        return False
    if isinstance(place, Thing) and set(noun.dirs) & {"left", "right"}:
        if place.prep is None or place.prep.cat != "locus":
            return place.has("quantity")  # "with 50 % overlap on the left side"
    elif isinstance(place, Place):
        arm = place.kind in _ARMS and place.stands_after(*_BY_ROAD) and place.owner is None
        arm = arm and bool({"left", "right"} & set(noun.dirs)) and noun.stands_after("in", "to")
        beside = arm or place.kind in _BESIDE_THE_ROAD or _lane_beside(place, noun, state)
        if not beside:
            return False
        place.j = noun.j
    else:
        return False
    place.mods = [*place.mods, *(m for m in noun.mods if m.cat == "dir")]
    return True  # "a driveway on the right", "from behind a hedge on the right"


def _lane_beside(lane: Place, side: Place, state: State) -> bool:
    """``in the lane to the right of the bus``: no movement to the right."""
    along = lane.kind in {"lane", "bike_lane", "sidewalk", "shoulder"}
    ways = _LEADING | ({"from"} if lane.kind == "lane" else set())
    within = along and (lane.prep is None or lane.prep.value in ways)
    if not within or not set(side.dirs) & {"left", "right"}:
        return False
    whose, who = state.at(1), state.at(2)
    owned = is_word(whose, "of") and isinstance(who, Mention)
    if owned and isinstance(who, Mention):
        lane.beside = who
    verb = state.at(-3)  # "enters the lane to the left"
    gone_to = isinstance(verb, Event) and verb.name != "leave"
    there = lane.kind == "lane" and (gone_to or lane.prep is not None or "adjacent" in lane.dirs)
    there = there and side.stands_after(*_ASIDE)
    there = there and lane.owner is None and not lane.possessed
    return owned or there or side.possessed

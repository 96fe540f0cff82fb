"""How one sees another, by words of direction and place."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach
from scegen.understanding.chunks import Place
from scegen.understanding.lexicon import word_list

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
INVERSE = {
    Approach.AHEAD: Approach.BEHIND,
    Approach.BEHIND: Approach.AHEAD,
    Approach.LEFT: Approach.RIGHT,
    Approach.RIGHT: Approach.LEFT,
    Approach.OPPOSITE: Approach.OPPOSITE,
    Approach.ADJACENT: Approach.ADJACENT,
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

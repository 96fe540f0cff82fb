"""Things of a description: what stands or lies about without taking part in traffic."""

from typing import Annotated

from scegen.scenario.definitions import Word
from scegen.scenario.model import FrozenModel, Identifier, Interval, between
from scegen.scenario.vocabulary import Side

SIZES_M = (0.1, 30.0)
"""The smallest and the largest side of a thing."""
Size = Annotated[Interval, between(*SIZES_M)]


class ThingKind(Word):
    """What a thing is; ``obstacle`` and ``screen`` where the text does not say more."""

    OBSTACLE = (
        "obstacle",
        "something in the way of which no more is said",
        "a vehicle (a participant)",
        "an object on the road",
    )
    BOX = "box", "a box or crate", "", "a cardboard box"
    PLANK = "plank", "a plank, ladder or pipe", "", "a ladder"
    BRANCH = "branch", "a branch or log", "`tree`, which stands", "a fallen branch"
    MATTRESS = "mattress", "a mattress or piece of furniture", "", "a sofa"
    DEBRIS = (
        "debris",
        "scattered parts or lost cargo",
        "`obstacle`, one thing",
        "debris after a crash",
    )
    ROCK = "rock", "a rock or stone", "", "a boulder"
    TYRE = "tyre", "a tyre or wheel on the road", "", "a lost wheel"
    ANIMAL = "animal", "an animal, which stands", "", "a deer in the lane"
    CONE = "cone", "a traffic cone", "`roadworks`", "pylons"
    WARNING_TRIANGLE = "warning_triangle", "a warning triangle", "", "a warning triangle"
    BARRIER = "barrier", "a barrier or fence across or beside the lane", "`wall`", "a crash barrier"
    ROADWORKS = "roadworks", "a building site on the road", "`cone` alone", "roadworks"
    SCREEN = (
        "screen",
        "something that hides, of which no more is said",
        "`obstacle`, in the way",
        "an obstruction to the view",
    )
    HEDGE = "hedge", "a hedge or bush", "`tree`", "shrubs"
    TREE = "tree", "a tree that stands", "`branch`", "a tree trunk at the kerb"
    COLUMN = "column", "a column or advertising pillar", "`pole`, which hides less", "a pillar"
    POLE = "pole", "a thin pole", "`column`", "a lamp post"
    BUS_SHELTER = "bus_shelter", "a bus shelter", "`bus`, the vehicle", "a bus stop's shelter"
    KIOSK = "kiosk", "a kiosk or stall beside the road", "", "a food stall"
    BUILDING = "building", "a building at the road", "", "a corner house"
    WALL = "wall", "a wall beside the road", "`barrier`", "a stone wall"
    CONTAINER = "container", "a container or skip", "", "a skip at the kerb"
    BIN = "bin", "a bin, of a person's height or less", "`container`", "a rubbish bin"
    VENDING_MACHINE = (
        "vending_machine",
        "a vending machine or box for switches or post",
        "",
        "a ticket machine",
    )
    BENCH = "bench", "a bench at the kerb", "", "a park bench"
    TRAILER = (
        "trailer",
        "a trailer without its vehicle",
        "`truck`, a participant",
        "a parked caravan",
    )


class Thing(FrozenModel):
    """A thing: in whose way it lies, or whom it hides from the ego, and on which side of the road.

    ``side`` is seen in the ego's direction; ``called`` is what the text calls it, for people only.
    ``width_m`` is its size across the road, ``length_m`` along it; a plank and what else lies
    across has its length there. None where it is as large as its kind usually is.
    """

    id: Identifier
    kind: ThingKind
    in_way_of: Identifier | None = None
    hides: tuple[Identifier, ...] = ()
    side: Side | None = None
    called: str | None = None
    length_m: Size | None = None
    width_m: Size | None = None

"""Things of a description: what stands or lies about without taking part in traffic."""

from __future__ import annotations

from enum import StrEnum

from scegen.scenario.model import FrozenModel, Identifier
from scegen.scenario.vocabulary import Side


class ThingKind(StrEnum):
    """What a thing is; ``obstacle`` and ``screen`` where the text does not say more."""

    OBSTACLE = "obstacle"
    BOX = "box"
    PLANK = "plank"
    BRANCH = "branch"
    MATTRESS = "mattress"
    DEBRIS = "debris"
    ROCK = "rock"
    TYRE = "tyre"
    ANIMAL = "animal"
    CONE = "cone"
    WARNING_TRIANGLE = "warning_triangle"
    BARRIER = "barrier"
    ROADWORKS = "roadworks"
    SCREEN = "screen"
    HEDGE = "hedge"
    TREE = "tree"
    COLUMN = "column"
    POLE = "pole"
    BUS_SHELTER = "bus_shelter"
    KIOSK = "kiosk"
    BUILDING = "building"
    WALL = "wall"
    CONTAINER = "container"
    BIN = "bin"
    VENDING_MACHINE = "vending_machine"
    BENCH = "bench"
    TRAILER = "trailer"


class Thing(FrozenModel):
    """A thing: in whose way it lies, or whom it hides from the ego, and on which side of the road.

    ``side`` is seen in the ego's direction; ``called`` is what the text calls it, for people only.
    """

    id: Identifier
    kind: ThingKind
    in_way_of: Identifier | None = None
    hides: tuple[Identifier, ...] = ()
    side: Side | None = None
    called: str | None = None

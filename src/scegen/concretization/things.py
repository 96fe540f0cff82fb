"""What objects are and how large: the things that descriptions name, as data.

Sizes are plausible outer boxes of our own choice: length along the road, width across it, height
(m), and mass (kg). What hides a person is taken at least as wide as hides one. The props are those
of CARLA 0.9.16's catalogue; where it has none of the kind, the nearest in shape stands in.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace

from scegen.scenario.bodies import Body
from scegen.scenario.objects import ObjectCategory

_O, _W, _B = ObjectCategory.OBSTACLE, ObjectCategory.BARRIER, ObjectCategory.BUILDING
_P, _T, _V = ObjectCategory.POLE, ObjectCategory.TREE, ObjectCategory.VEGETATION


@dataclass(frozen=True, slots=True)
class Thing:
    """A kind of thing: what it is called, its category, its box, its prop.

    ``long``: it can be as long as needed, as a hedge or a wall can.
    """

    what: str
    category: ObjectCategory
    length_m: float
    width_m: float
    height_m: float
    mass_kg: float
    prop: str
    long: bool = False

    @property
    def body(self) -> Body:
        """Its box; it goes nowhere."""
        return Body(self.length_m, self.width_m, self.height_m, 0.0, 0.0, self.prop, 0.0, 0.0, 0.0)

    @property
    def blueprint(self) -> str:
        """The name of the prop in CARLA."""
        return f"static.prop.{self.prop}"


OBSTACLE = Thing("obstacle", _O, 1.0, 1.0, 1.0, 50, "box01")
SCREEN = Thing("wall", _W, 4.0, 1.0, 2.5, 5000, "streetbarrier", long=True)
"""Where the words do not say what it is."""

_ON_THE_ROAD: dict[str, Thing] = {
    "box|crate|cargo|load|package|parcel|suitcase": Thing("box", _O, 0.8, 0.8, 0.8, 40, "box01"),
    "pallet|plank|ladder|log|wood|pipe|beam": Thing("plank", _O, 1.0, 2.0, 0.3, 30, "ironplank"),
    "branch|fallen tree": Thing("branch", _V, 1.2, 2.2, 1.0, 80, "dirtdebris01"),
    "mattress|sofa": Thing("mattress", _O, 1.0, 2.0, 0.5, 30, "creasedbox01"),
    "debris|rubble|wreck|load|landslide": Thing("debris", _O, 1.5, 1.5, 0.6, 80, "dirtdebris02"),
    "rock|boulder|stone": Thing("rock", _O, 1.2, 1.2, 0.9, 900, "brokentile01"),
    "tyre|tire|pothole|ball|bucket": Thing("tyre", _O, 0.7, 0.7, 0.5, 12, "dirtdebris03"),
    "animal|deer|dog|cow|sheep|boar": Thing("animal", _O, 0.6, 1.2, 1.0, 60, "haybale"),
    "cone": Thing("cone", _O, 0.8, 0.8, 0.9, 5, "trafficcone01"),
    "warning triangle": Thing("warning triangle", _O, 0.5, 0.8, 0.7, 2, "warningaccident"),
    "barrier": Thing("barrier", _W, 0.8, 2.2, 1.1, 120, "streetbarrier"),
    "construction|roadwork|road work|roadworks|work zone|lane closure|crash site|accident": Thing(
        "roadworks", _W, 6.0, 2.5, 1.2, 800, "warningconstruction"
    ),
    "wheelie bin|dustbin|bin": Thing("bin", _O, 0.8, 0.8, 1.2, 30, "bin"),
}
_BESIDE_IT: dict[str, Thing] = {
    "hedge|bush|shrub|hedgerow|vegetation": Thing(
        "hedge", _V, 6.0, 1.2, 2.2, 500, "plantpot04", long=True
    ),
    "tree|trees": Thing("tree", _T, 1.4, 1.4, 6.0, 900, "plantpot05"),
    "advertising column|monument|statue": Thing("column", _P, 1.8, 1.8, 3.5, 2000, "advertisement"),
    "pole|post|lamp|lamppost|pillar|column|sign|mast": Thing(
        "pole", _P, 0.8, 0.8, 5.0, 300, "streetsign"
    ),
    "bus shelter|bus stop|shelter": Thing("bus shelter", _B, 4.0, 1.6, 2.6, 900, "busstop"),
    "kiosk|newsstand|stall|booth|stand|tent": Thing("kiosk", _B, 3.0, 2.2, 2.8, 1500, "kiosk_01"),
    "building|house|shop|corner": Thing(
        "building", _B, 12.0, 8.0, 8.0, 100000, "kiosk_01", long=True
    ),
    "wall|fence|hoarding|billboard|advertisement|scaffolding|barrier|snow bank": Thing(
        "wall", _W, 6.0, 1.0, 2.5, 5000, "streetbarrier", long=True
    ),
    "container|containers|dumpster|skip": Thing("container", _O, 4.0, 1.8, 1.9, 1500, "container"),
    "bin|bins|trash can|garbage can|litter bin": Thing("bin", _O, 1.4, 1.0, 1.7, 60, "bin"),
    "mailbox|cabinet|vending machine|phone box|telephone box|utility box|atm": Thing(
        "vending machine", _O, 1.2, 1.0, 2.0, 300, "vendingmachine"
    ),
    "bench": Thing("bench", _O, 2.0, 0.8, 1.0, 90, "bench01"),
    "trailer": Thing("trailer", _O, 8.0, 2.5, 3.5, 6000, "container"),
}


def obstacle_named(texts: Iterable[str]) -> Thing | None:
    """The thing on the road that these words name; None if they name none that is known."""
    return _named(texts, _ON_THE_ROAD)


def screen_named(texts: Iterable[str]) -> Thing | None:
    """The thing beside the road that these words name; None if they name none that is known."""
    return _named(texts, _BESIDE_IT)


def _named(texts: Iterable[str], table: dict[str, Thing]) -> Thing | None:
    for text in texts:
        for words, thing in table.items():
            found = re.search(rf"\b(?:{words})(?:s|es)?\b", text.lower())
            if found is not None:
                return replace(thing, what=found[0])
    return None

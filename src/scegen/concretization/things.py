"""Things: how large they are by kind, and those of a description as objects with a place.

Outer boxes are plausible ones of our own choice: length along the road, width across it, height
(m), and mass (kg). What hides a person is taken at least as wide as hides one. The props are those
of CARLA 0.9.16's catalogue; where it has none of the kind, the nearest in shape stands in.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace
from math import degrees

from scegen.concretization.tale import SIDEWAYS
from scegen.road.geometry import Pose
from scegen.scenario.bodies import Body
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.model import middles
from scegen.scenario.objects import ObjectCategory, StaticObject
from scegen.scenario.things import Thing, ThingKind
from scegen.scenario.vocabulary import HazardKind

_O, _W, _B = ObjectCategory.OBSTACLE, ObjectCategory.BARRIER, ObjectCategory.BUILDING
_P, _T, _V = ObjectCategory.POLE, ObjectCategory.TREE, ObjectCategory.VEGETATION


@dataclass(frozen=True, slots=True)
class Shape:
    """The box of a kind of thing, its category, its prop.

    ``long``: it can be as long as needed, as a hedge or a wall can.
    """

    kind: ThingKind
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
        size = self.length_m, self.width_m, self.height_m
        return Body(*size, 0.0, 0.0, self.prop, 0.0, 0.0, 0.0, self.mass_kg)

    def sized(self, length_m: float | None, width_m: float | None) -> Shape:
        """So long and so wide (None: as usual), mass in proportion.

        One that is as wide as long stays so; one that lies across the road has its length there.
        """
        if length_m is None and width_m is None:
            return self
        if width_m is None and self.width_m >= self.length_m:
            length_m, width_m = (length_m if self.width_m == self.length_m else None, length_m)
        elif length_m is None and self.width_m == self.length_m:
            length_m = width_m
        along, across = length_m or self.length_m, width_m or self.width_m
        heavier = along * across / (self.length_m * self.width_m)
        mass = round(self.mass_kg * heavier, 1)
        return replace(self, length_m=along, width_m=across, mass_kg=mass)


_K = ThingKind
SHAPES: dict[ThingKind, Shape] = {
    shape.kind: shape
    for shape in (
        Shape(_K.OBSTACLE, _O, 1.0, 1.0, 1.0, 50, "box01"),
        Shape(_K.BOX, _O, 0.8, 0.8, 0.8, 40, "box01"),
        Shape(_K.PLANK, _O, 1.0, 2.0, 0.3, 30, "ironplank"),
        Shape(_K.BRANCH, _V, 1.2, 2.2, 1.0, 80, "dirtdebris01"),
        Shape(_K.MATTRESS, _O, 1.0, 2.0, 0.5, 30, "creasedbox01"),
        Shape(_K.DEBRIS, _O, 1.5, 1.5, 0.6, 80, "dirtdebris02"),
        Shape(_K.ROCK, _O, 1.2, 1.2, 0.9, 900, "brokentile01"),
        Shape(_K.TYRE, _O, 0.7, 0.7, 0.5, 12, "dirtdebris03"),
        Shape(_K.ANIMAL, _O, 0.6, 1.2, 1.0, 60, "haybale"),
        Shape(_K.CONE, _O, 0.8, 0.8, 0.9, 5, "trafficcone01"),
        Shape(_K.WARNING_TRIANGLE, _O, 0.5, 0.8, 0.7, 2, "warningaccident"),
        Shape(_K.BARRIER, _W, 0.8, 2.2, 1.1, 120, "streetbarrier"),
        Shape(_K.ROADWORKS, _W, 6.0, 2.5, 1.2, 800, "warningconstruction"),
        Shape(_K.SCREEN, _W, 4.0, 1.0, 2.5, 5000, "streetbarrier", long=True),
        Shape(_K.HEDGE, _V, 6.0, 1.2, 2.2, 500, "plantpot04", long=True),
        Shape(_K.TREE, _T, 1.4, 1.4, 6.0, 900, "plantpot05"),
        Shape(_K.COLUMN, _P, 1.8, 1.8, 3.5, 2000, "advertisement"),
        Shape(_K.POLE, _P, 0.8, 0.8, 5.0, 300, "streetsign"),
        Shape(_K.BUS_SHELTER, _B, 4.0, 1.6, 2.6, 900, "busstop"),
        Shape(_K.KIOSK, _B, 3.0, 2.2, 2.8, 1500, "kiosk_01"),
        Shape(_K.BUILDING, _B, 12.0, 8.0, 8.0, 100000, "kiosk_01", long=True),
        Shape(_K.WALL, _W, 6.0, 1.0, 2.5, 5000, "streetbarrier", long=True),
        Shape(_K.CONTAINER, _O, 4.0, 1.8, 1.9, 1500, "container"),
        Shape(_K.BIN, _O, 1.4, 1.0, 1.7, 60, "bin"),
        Shape(_K.VENDING_MACHINE, _O, 1.2, 1.0, 2.0, 300, "vendingmachine"),
        Shape(_K.BENCH, _O, 2.0, 0.8, 1.0, 90, "bench01"),
        Shape(_K.TRAILER, _O, 8.0, 2.5, 3.5, 6000, "container"),
    )
}
SCREEN = SHAPES[ThingKind.SCREEN]
"""What hides somebody where the text does not say what does."""
THINGS_APART_M = 0.5
"""Between things in one's way that lie one behind the other."""


def shape_of(thing: Thing) -> Shape:
    """The box of a thing: as large as is said, else as its kind usually is."""
    return SHAPES[thing.kind].sized(*middles(thing.length_m, thing.width_m))


def causing_it(functional: FunctionalScenario, hazard: Hazard) -> list[Thing]:
    """The things that cause a danger: those that are named, else one that does such a thing."""
    things = functional.objects
    if hazard.by:
        return [thing for thing in things if thing.id in hazard.by]
    if hazard.kind is HazardKind.OCCLUSION:
        return [thing for thing in things if thing.hides][:1]
    if hazard.kind is HazardKind.OBSTACLE:
        return [thing for thing in things if thing.in_way_of is not None][:1]
    return []


def caused_by_nobody(functional: FunctionalScenario, hazard: Hazard) -> bool:
    """Whether no participant causes a danger: a thing does."""
    people = {p.id for p in functional.participants}
    return not people & {*hazard.by}


def lying_in_the_way(
    functional: FunctionalScenario, logical: LogicalScenario, drivers: Collection[str]
) -> list[tuple[Hazard, Thing]]:
    """The things that dangers need which nobody causes, each in the way of one of the drivers."""
    found: list[tuple[Hazard, Thing]] = []
    for hazard in functional.hazards:
        if hazard.kind is not HazardKind.OBSTACLE:
            continue
        things = causing_it(functional, hazard)
        if not things and not (found or logical.standings) and caused_by_nobody(functional, hazard):
            name = free_name(functional, ThingKind.OBSTACLE, {*drivers})
            things = [Thing(id=name, kind=ThingKind.OBSTACLE)]
        known = {thing.id for _, thing in found}
        for thing in (each for each in things if each.id not in known):
            # Else of who does something that one does because of a thing in its way; or the ego's.
            acting = [h.by[0] for h in functional.hazards if h.by and HAZARDS[h.kind].acts]
            aside = [d.participant for d in logical.drives if d.maneuver in SIDEWAYS]
            names = (thing.in_way_of, *hazard.to, *acting, *aside)
            who = next((name for name in names if name in drivers), functional.ego.id)
            found.append((hazard, thing.but(in_way_of=who)))
    return found


def made_of(name: str, shape: Shape, called: str | None, pose: Pose) -> StaticObject:
    """The object of a shape with its middle at a pose."""
    return StaticObject(
        id=name,
        category=shape.category,
        what=called or shape.kind.value.replace("_", " "),
        x_m=round(pose.x_m, 3),
        y_m=round(pose.y_m, 3),
        heading_deg=round((degrees(pose.heading_rad) + 180) % 360 - 180, 3),
        length_m=round(shape.length_m, 3),
        width_m=round(shape.width_m, 3),
        height_m=shape.height_m,
        mass_kg=shape.mass_kg,
        blueprint=f"static.prop.{shape.prop}",
    )


def free_name(functional: FunctionalScenario, kind: ThingKind, taken: set[str]) -> str:
    """A name for a thing that the text implies and does not name."""
    known = taken | {p.id for p in functional.participants} | {o.id for o in functional.objects}
    number = next(n for n in range(1, len(known) + 2) if f"{kind}_{n}" not in known)
    return f"{kind}_{number}"

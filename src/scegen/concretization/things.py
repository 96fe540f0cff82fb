"""How large things are: plausible outer boxes of our own choice, by kind.

Length along the road, width across it, height (m), and mass (kg). What hides a person is taken at
least as wide as hides one. The props are those of CARLA 0.9.16's catalogue; where it has none of
the kind, the nearest in shape stands in.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from scegen.scenario.bodies import Body
from scegen.scenario.objects import ObjectCategory
from scegen.scenario.things import ThingKind

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

    @property
    def blueprint(self) -> str:
        """The name of the prop in CARLA."""
        return f"static.prop.{self.prop}"


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
OBSTACLE, SCREEN = SHAPES[ThingKind.OBSTACLE], SHAPES[ThingKind.SCREEN]
"""Where the text does not say what it is."""

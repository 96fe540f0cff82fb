"""Bodies of participants: sizes, masses and physical limits by kind.

The reference point of a vehicle is the middle of its rear axle on the ground, as in
OpenSCENARIO; ``centre_ahead_m`` is how far the box's centre lies before it. A pedestrian's
reference point is its centre. Sizes of cars and pedestrians follow the CARLA blueprints named;
limits are plausible upper bounds on dry road, for checks, not for dynamics.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

from scegen.scenario.vocabulary import ParticipantKind

LENGTHS_M = (0.1, 25.25)
"""The shortest and the longest participant: the longest road train that EU Directive 96/53 lets
cross a border."""
WIDTHS_M = (0.1, 4.0)


@dataclass(frozen=True, slots=True)
class Body:
    """Size (m), reference point, CARLA blueprint, limits (SI), and mass with driver or rider (kg).

    ``unprotected`` is who sits or walks without a hull. Masses are typical of these sizes; they
    only weigh how two crashing bodies share the change of velocity.
    """

    length_m: float
    width_m: float
    height_m: float
    centre_ahead_m: float
    wheelbase_m: float
    blueprint: str
    top_speed_mps: float
    max_acceleration_mps2: float
    max_deceleration_mps2: float
    mass_kg: float
    unprotected: bool = False

    def sized(self, length_m: float | None, width_m: float | None) -> Body:
        """So long and so wide (None: as it is), axles and mass in proportion."""
        return _sized(self, length_m or self.length_m, width_m or self.width_m)

    @property
    def front_m(self) -> float:
        """Distance from the reference point to the front bumper."""
        return self.centre_ahead_m + self.length_m / 2

    @property
    def rear_m(self) -> float:
        """Distance from the reference point to the rear bumper."""
        return self.length_m / 2 - self.centre_ahead_m


@lru_cache(maxsize=256, typed=True)
def _sized(usual: Body, length_m: float, width_m: float) -> Body:
    """One body for all who ask for the same size, again and again."""
    longer, wider = length_m / usual.length_m, width_m / usual.width_m
    return replace(
        usual,
        length_m=length_m,
        width_m=width_m,
        centre_ahead_m=round(usual.centre_ahead_m * longer, 3),
        wheelbase_m=round(usual.wheelbase_m * longer, 3),
        mass_kg=round(usual.mass_kg * longer * wider, 1),
    )


BODIES: dict[ParticipantKind, Body] = {
    ParticipantKind.CAR: Body(4.79, 2.16, 1.49, 1.40, 2.90, "vehicle.tesla.model3", 60, 5, 9, 1850),
    ParticipantKind.VAN: Body(
        5.92, 2.25, 2.50, 1.85, 3.70, "vehicle.mercedes.sprinter", 45, 3, 8, 2600
    ),
    ParticipantKind.TRUCK: Body(
        7.90, 2.50, 3.30, 2.20, 4.60, "vehicle.carlamotors.carlacola", 35, 2, 7, 12000
    ),
    ParticipantKind.BUS: Body(
        10.27, 2.55, 3.40, 3.00, 5.80, "vehicle.mitsubishi.fusorosa", 34, 2, 7, 11000
    ),
    ParticipantKind.MOTORCYCLE: Body(
        2.20, 0.86, 1.50, 0.70, 1.45, "vehicle.yamaha.yzf", 70, 7, 9, 290, unprotected=True
    ),
    ParticipantKind.BICYCLE: Body(
        1.65, 0.60, 1.70, 0.52, 1.05, "vehicle.bh.crossbike", 14, 2, 6, 95, unprotected=True
    ),
    ParticipantKind.PEDESTRIAN: Body(
        0.38, 0.38, 1.80, 0.0, 0.0, "walker.pedestrian.0001", 8, 3, 6, 75, unprotected=True
    ),
    # CARLA has no animals: its players show a walker in their place.
    ParticipantKind.ANIMAL: Body(
        0.90, 0.30, 0.60, 0.0, 0.0, "walker.pedestrian.0001", 14, 6, 8, 25, unprotected=True
    ),
    ParticipantKind.LARGE_ANIMAL: Body(
        1.60, 0.50, 1.30, 0.0, 0.0, "walker.pedestrian.0001", 18, 5, 8, 70, unprotected=True
    ),
    ParticipantKind.EMERGENCY_VEHICLE: Body(
        5.90, 2.30, 2.70, 1.85, 3.70, "vehicle.ford.ambulance", 50, 3, 8, 3500
    ),
    # Its length lies along its way, the arc on which it swings. CARLA shows who gets out by it.
    ParticipantKind.DOOR: Body(0.10, 1.00, 1.20, 0.0, 0.0, "walker.pedestrian.0001", 3, 10, 10, 30),
}

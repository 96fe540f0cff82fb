"""Bodies of participants: sizes and physical limits by kind.

The reference point of a vehicle is the middle of its rear axle on the ground, as in
OpenSCENARIO; ``centre_ahead_m`` is how far the box's centre lies before it. A pedestrian's
reference point is its centre. Sizes of cars and pedestrians follow the CARLA blueprints named;
limits are plausible upper bounds on dry road, for checks, not for dynamics.
"""

from __future__ import annotations

from dataclasses import dataclass

from scegen.scenario.vocabulary import ParticipantKind


@dataclass(frozen=True, slots=True)
class Body:
    """Size (m), reference point, CARLA blueprint and limits (SI) of a kind."""

    length_m: float
    width_m: float
    height_m: float
    centre_ahead_m: float
    wheelbase_m: float
    blueprint: str
    top_speed_mps: float
    max_acceleration_mps2: float
    max_deceleration_mps2: float

    @property
    def front_m(self) -> float:
        """Distance from the reference point to the front bumper."""
        return self.centre_ahead_m + self.length_m / 2

    @property
    def rear_m(self) -> float:
        """Distance from the reference point to the rear bumper."""
        return self.length_m / 2 - self.centre_ahead_m


BODIES: dict[ParticipantKind, Body] = {
    ParticipantKind.CAR: Body(4.79, 2.16, 1.49, 1.40, 2.90, "vehicle.tesla.model3", 60, 5, 9),
    ParticipantKind.VAN: Body(5.92, 2.25, 2.50, 1.85, 3.70, "vehicle.mercedes.sprinter", 45, 3, 8),
    ParticipantKind.TRUCK: Body(
        7.90, 2.50, 3.30, 2.20, 4.60, "vehicle.carlamotors.carlacola", 35, 2, 7
    ),
    ParticipantKind.BUS: Body(
        10.27, 2.55, 3.40, 3.00, 5.80, "vehicle.mitsubishi.fusorosa", 33, 2, 7
    ),
    ParticipantKind.MOTORCYCLE: Body(2.20, 0.86, 1.50, 0.70, 1.45, "vehicle.yamaha.yzf", 70, 7, 9),
    ParticipantKind.BICYCLE: Body(1.65, 0.60, 1.70, 0.52, 1.05, "vehicle.bh.crossbike", 14, 2, 6),
    ParticipantKind.PEDESTRIAN: Body(0.38, 0.38, 1.80, 0.0, 0.0, "walker.pedestrian.0001", 8, 3, 6),
    # CARLA has no animals: its players show a walker in their place.
    ParticipantKind.ANIMAL: Body(0.90, 0.30, 0.60, 0.0, 0.0, "walker.pedestrian.0001", 14, 6, 8),
    ParticipantKind.LARGE_ANIMAL: Body(
        1.60, 0.50, 1.30, 0.0, 0.0, "walker.pedestrian.0001", 18, 5, 8
    ),
    ParticipantKind.EMERGENCY_VEHICLE: Body(
        5.90, 2.30, 2.70, 1.85, 3.70, "vehicle.ford.ambulance", 50, 3, 8
    ),
    # Its length lies along its way, the arc on which it swings. CARLA shows who gets out by it.
    ParticipantKind.DOOR: Body(0.10, 1.00, 1.20, 0.0, 0.0, "walker.pedestrian.0001", 3, 10, 10),
}

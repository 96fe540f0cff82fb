"""Those who cross or stand, in the making."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from scegen.claims.boxes import Boxes
from scegen.concretization.limits import starting_mps2
from scegen.motion.model import Array, Path
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import CrossingMotion, SpeedPhase, StandingMotion, Travelled, Trigger
from scegen.scenario.logical import Crossing, Standing
from scegen.scenario.vocabulary import HazardKind, ParticipantKind

_STOPS_SHORT_M = 0.15
_ABREAST_M = 0.9
_CROSSES = {
    ParticipantKind.PEDESTRIAN: HazardKind.CROSSING_PEDESTRIAN,
    ParticipantKind.BICYCLE: HazardKind.CROSSING_CYCLIST,
    ParticipantKind.ANIMAL: HazardKind.CROSSING_ANIMAL,
    ParticipantKind.LARGE_ANIMAL: HazardKind.CROSSING_ANIMAL,
}


def gained(speed_mps: float, rate_mps2: float, since_s: Array) -> tuple[Array, Array]:
    """(way, speed) of one who gains speed from rest, by the time since it was to go."""
    since = np.maximum(since_s, 0.0)
    gaining = np.minimum(since, speed_mps / rate_mps2)
    way = rate_mps2 * gaining**2 / 2 + speed_mps * (since - gaining)
    return way, rate_mps2 * gaining


def abreast_m(number: int) -> float:
    """How far aside the next of several walks: 0, one to the left, one to the right, and so on."""
    return (number + 1) // 2 * _ABREAST_M * (1 if number % 2 else -1)


@dataclass
class Walker:
    """One who goes across a road, on foot or by bicycle, at a steady pace from where it starts."""

    id: str
    kind: ParticipantKind
    body: Body
    crossing: Crossing
    speed_mps: float

    @property
    def rate_mps2(self) -> float:
        """How fast it gains speed, and loses it."""
        return starting_mps2(self.kind)

    @property
    def gains_m(self) -> float:
        """How far it goes until it has its pace."""
        return self.speed_mps**2 / (2 * self.rate_mps2)

    def runs_s(self, way_m: float) -> float:
        """How long it takes from setting off until so much way is behind it."""
        return way_m / self.speed_mps + self.speed_mps / (2 * self.rate_mps2)

    def program_to(
        self, trigger: Trigger, length_m: float, act: str | None, *, stops: bool
    ) -> tuple[SpeedPhase, SpeedPhase]:
        """Set off, and come to rest just before the end of its way; ``stops``: in somebody's."""
        end = max(0.0, length_m - self.gains_m - _STOPS_SHORT_M)
        return (
            SpeedPhase(
                trigger=trigger,
                target_speed_mps=round(self.speed_mps, 4),
                rate_mps2=self.rate_mps2,
                hazard=_CROSSES.get(self.kind),
                act=act,
            ),
            SpeedPhase(
                trigger=Travelled(participant=self.id, distance_m=round(end, 3)),
                target_speed_mps=0.0,
                rate_mps2=self.rate_mps2,
                hazard=HazardKind.STOPPING if stops else None,
            ),
        )


@dataclass
class Walk(Walker):
    """One who goes across an open road: at ``x_m`` of it, ``sets_off_s`` after the start.

    ``setback_m`` is how far outside the carriageway it starts, ``arrives_s`` when it is in the way
    of whom it meets, ``stops_after_m`` where its way ends if it does not go across, ``from_y_m``
    where it starts, to the ego's left of the centre line.
    """

    from_left: bool
    meets: str
    x_m: float = 0.0
    setback_m: float = 0.0
    sets_off_s: float = 0.0
    arrives_s: float = 0.0
    stops_after_m: float | None = None
    timed: bool = False
    act: str | None = None
    from_y_m: float = 0.0

    def track(self, times_s: Array) -> tuple[Boxes, Array]:
        """Its boxes over time, and its speeds."""
        way, speed = gained(self.speed_mps, self.rate_mps2, times_s - self.sets_off_s)
        way = way if self.stops_after_m is None else np.minimum(way, self.stops_after_m)
        into = -1.0 if self.from_left else 1.0
        x, cos, sin = (np.full_like(way, value) for value in (self.x_m, 0.0, into))
        y = self.from_y_m + into * (way + self.body.centre_ahead_m)
        return Boxes(x, y, cos, sin, self.body.length_m / 2, self.body.width_m / 2), speed


@dataclass
class WalkDraft(Walker):
    """One who crosses an arm, in the making."""

    motion: CrossingMotion
    path: Path
    program: tuple[SpeedPhase, ...] = ()

    @property
    def stops(self) -> bool:
        """Whether it stops in somebody's way."""
        return self.motion.stops_after_m is not None


@dataclass
class StandDraft:
    """One who stands, in the making."""

    id: str
    kind: ParticipantKind
    body: Body
    standing: Standing
    motion: StandingMotion
    path: Path

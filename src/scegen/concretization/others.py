"""Those who cross, stand or pull out, in the making."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from scegen.concretization.limits import WALKING_START_MPS2
from scegen.motion.model import Array, Path
from scegen.motion.polyline import LaidDrive
from scegen.scenario.bodies import BODIES, Body
from scegen.scenario.concrete import CrossingMotion, DriveMotion, SpeedPhase, StandingMotion
from scegen.scenario.logical import Crossing, Standing
from scegen.scenario.vocabulary import HazardKind, ParticipantKind


def gained(speed_mps: float, rate_mps2: float, since_s: Array) -> tuple[Array, Array]:
    """(way, speed) of one who gains speed from rest, by the time since it was to go."""
    since = np.maximum(since_s, 0.0)
    gaining = np.minimum(since, speed_mps / rate_mps2)
    way = rate_mps2 * gaining**2 / 2 + speed_mps * (since - gaining)
    return way, rate_mps2 * gaining


@dataclass
class WalkDraft:
    """One who crosses an arm, in the making; it starts ``back_m`` farther out than it was laid."""

    id: str
    kind: ParticipantKind
    crossing: Crossing
    speed_mps: float
    motion: CrossingMotion
    path: Path
    back_m: float = 0.0
    program: list[SpeedPhase] = field(default_factory=list)

    @property
    def body(self) -> Body:
        """Its size."""
        return BODIES[self.kind]

    @property
    def stops(self) -> bool:
        """Whether it stops in somebody's way."""
        return self.motion.stops_after_m is not None

    @property
    def rate_mps2(self) -> float:
        """How fast it gains speed, and loses it."""
        return min(WALKING_START_MPS2, self.body.max_acceleration_mps2)


@dataclass
class StandDraft:
    """One who stands, in the making."""

    id: str
    kind: ParticipantKind
    standing: Standing
    motion: StandingMotion
    path: Path

    @property
    def body(self) -> Body:
        """Its size."""
        return BODIES[self.kind]


@dataclass
class PullDraft:
    """One who is parked and pulls out, in the making; lengths are along its path.

    It is in the lane ``in_lane_m`` from where it stands, ``takes_s`` after it sets off, when
    ``waits_for`` is at ``place_m`` of its own path.
    """

    id: str
    kind: ParticipantKind
    motion: DriveMotion
    laid: LaidDrive
    speed_mps: float
    rate_mps2: float
    in_lane_m: float
    hazard: HazardKind | None = None
    waits_for: str | None = None
    place_m: float = 0.0
    takes_s: float = 0.0
    program: list[SpeedPhase] = field(default_factory=list)

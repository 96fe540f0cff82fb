"""Those who do not drive, in the making: who crosses, who stands, what lies in the way."""

from __future__ import annotations

from dataclasses import dataclass, field

from scegen.motion.concretization.things import Thing
from scegen.motion.model import Path
from scegen.scenario.bodies import BODIES, Body
from scegen.scenario.concrete import CrossingMotion, SpeedPhase, StandingMotion
from scegen.scenario.functional import Hazard
from scegen.scenario.logical import Crossing, Standing
from scegen.scenario.vocabulary import ParticipantKind


@dataclass
class WalkDraft:
    """One who crosses an arm, in the making."""

    id: str
    kind: ParticipantKind
    crossing: Crossing
    speed_mps: float
    motion: CrossingMotion
    path: Path
    program: list[SpeedPhase] = field(default_factory=list)

    @property
    def body(self) -> Body:
        """Its size."""
        return BODIES[self.kind]


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


@dataclass(frozen=True, slots=True)
class Expected:
    """A danger that a thing is to cause, what it is, and in whose way it lies."""

    hazard: Hazard
    thing: Thing
    who: str

"""Hand-made scenarios on hand-made paths, for the tests of verdicts and reactivity."""

from __future__ import annotations

from by_hand import by_hand

from scegen.scenario.concrete import (
    ConcreteParticipant,
    DriveMotion,
    SpeedPhase,
)
from scegen.scenario.vocabulary import ParticipantKind, Role

DRIVE = DriveMotion(
    entry=0, entry_lane=1, exit=1, exit_lane=1, start_m=0, turning_starts_m=50, turning_ends_m=50
)


def participant(name, kind="car", speed=0.0, program=(), *, parked=False):
    return ConcreteParticipant(
        id=name,
        kind=ParticipantKind(kind),
        role=Role.EGO if name == "ego" else Role.OTHER,
        parked=parked,
        speed_mps=speed,
        motion=DRIVE,
        speed_program=tuple(program),
    )


def phase(trigger, speed, rate):
    return SpeedPhase(trigger=trigger, target_speed_mps=speed, rate_mps2=rate)


def scenario(*people, duration_s=12.0, hazards=()):
    return by_hand(*people, duration_s=duration_s, hazards=tuple(hazards))

"""Hand-made scenarios on hand-made paths, for the tests of verdicts and reactivity."""

from __future__ import annotations

from scegen.scenario.concrete import (
    ArmRoad,
    ConcreteParticipant,
    ConcreteScenario,
    DriveMotion,
    RoadParameters,
    SpeedPhase,
)
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.vocabulary import JunctionKind, ParticipantKind, Role

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
    arms = tuple(
        ArmRoad(
            id=i,
            length_m=200,
            angle_deg=180 * i,
            angle_to_previous_deg=180,
            lanes_in=1,
            lanes_out=1,
            speed_limit_mps=14,
        )
        for i in (0, 1)
    )
    return ConcreteScenario(
        name="case",
        description="by hand",
        seed=0,
        logical=LogicalScenario(index=0, slug="x", pattern=(1,), assignments=()),
        road=RoadParameters(kind=JunctionKind.STRAIGHT, arms=arms),
        participants=people,
        hazards=tuple(hazards),
        duration_s=duration_s,
    )

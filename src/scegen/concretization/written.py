"""What was chosen as it stands in the files, rounded."""

from __future__ import annotations

from collections.abc import Sequence

from scegen.concretization.profile import SpeedChange
from scegen.concretization.tale import Tale, slug_name
from scegen.scenario.concrete import (
    ConcreteParticipant,
    ConcreteScenario,
    Motion,
    RoadParameters,
    SpeedPhase,
    Trigger,
)
from scegen.scenario.functional import Hazard
from scegen.scenario.model import middles
from scegen.scenario.objects import StaticObject
from scegen.scenario.signals import SignalPlan


def written(
    tale: Tale,
    name: str,
    motion: Motion,
    *,
    speed_mps: float = 0.0,
    program: tuple[SpeedPhase, ...] = (),
    parked: bool = False,
) -> ConcreteParticipant:
    """Somebody with its way and its speed program."""
    participant = tale.functional.participant(name)
    length, width = middles(participant.length_m, participant.width_m)
    return ConcreteParticipant(
        id=name,
        kind=participant.kind,
        role=participant.role,
        parked=parked,
        speed_mps=round(speed_mps, 4),
        motion=motion,
        speed_program=program,
        length_m=length,
        width_m=width,
    )


def written_phase(tale: Tale, change: SpeedChange, trigger: Trigger) -> SpeedPhase:
    """A change of speed with what sets it off; acts that are only implied are not named."""
    value = round(getattr(trigger, trigger.measured), 3)
    told = any(act.id == change.act for act in tale.functional.acts)
    return SpeedPhase(
        trigger=trigger.model_copy(update={trigger.measured: value}),
        target_speed_mps=round(change.target_mps, 4),
        rate_mps2=round(change.rate_mps2, 4),
        hazard=change.hazard,
        act=change.act if told else None,
    )


def written_scenario(
    tale: Tale,
    road: RoadParameters,
    people: Sequence[ConcreteParticipant],
    objects: Sequence[StaticObject],
    hazards: tuple[Hazard, ...],
    *,
    seed: int,
    duration_s: float,
    signals: SignalPlan | None = None,
) -> ConcreteScenario:
    """The whole, with who set which parameter and why."""
    return ConcreteScenario(
        name=slug_name(tale.logical),
        description=tale.functional.description,
        seed=seed,
        logical=tale.logical,
        road=road,
        participants=tuple(people),
        objects=tuple(objects),
        environment=tale.functional.environment,
        hazards=hazards,
        duration_s=round(duration_s * 20) / 20,
        signals=signals,
        provenance=tuple(tale.changes),
    )

"""What was chosen as it stands in the files, rounded, and what sets it off.

Triggers are read off the scenario as it was laid, so that it also reacts.
"""

import re
from collections.abc import Iterable, Sequence

from scegen.concretization.profile import Mover, SpeedChange
from scegen.concretization.tale import Tale
from scegen.motion.trigger_steps import just_before_step_s
from scegen.scenario.concrete import (
    AtTime,
    ConcreteParticipant,
    ConcreteScenario,
    Motion,
    SpeedPhase,
    Travelled,
    Trigger,
)
from scegen.scenario.functional import Hazard
from scegen.scenario.model import middles
from scegen.scenario.objects import StaticObject
from scegen.scenario.road_parameters import RoadParameters
from scegen.scenario.signals import SignalPlan

_MOVES_MPS, _SURE_S = 2.0, 1.0
"""How far one has come tells no moment if it is slower: some centimetres are long then. Nor does it
if it is so a moment later: who comes to rest does so some centimetres short where steps are taken.
"""


def as_they_come(whose: Iterable[Mover], moment_s: float) -> Trigger:
    """How far the first of them who drives on has come at a moment; that moment if nobody does."""
    moment_s = just_before_step_s(moment_s)
    for who in whose:
        if all(who.speed_at_mps(moment_s + s) > _MOVES_MPS for s in (0.0, _SURE_S)):
            return Travelled(participant=who.id, distance_m=round(who.gone_m(moment_s), 3))
    return AtTime(time_s=round(moment_s, 3))


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
        trigger=trigger.but(**{trigger.measured: value}),
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
    logical = tale.logical
    return ConcreteScenario(
        name=re.sub(r"[^A-Za-z0-9_-]", "-", f"{logical.index:03d}-{logical.slug}")[:100],
        description=tale.functional.description,
        seed=seed,
        logical=logical,
        road=road,
        participants=tuple(people),
        objects=tuple(objects),
        environment=tale.functional.environment,
        hazards=hazards,
        duration_s=round(duration_s * 20) / 20,
        signals=signals,
        provenance=tuple(tale.changes),
    )

"""What the two levels above ask for, where several parts need it alike."""

from __future__ import annotations

import re

from scegen.scenario.acts import Act, ActKind
from scegen.scenario.bodies import BODIES
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.speed_limits import limit_for_kind_mps
from scegen.scenario.vocabulary import HazardKind, ParticipantKind, Side

_HAZARDS_OF = {
    ActKind.BRAKE: (HazardKind.HARD_BRAKING, HazardKind.STOPPING, HazardKind.LOSS_OF_CONTROL),
    ActKind.STOP: (HazardKind.HARD_BRAKING, HazardKind.STOPPING),
    ActKind.ACCELERATE: (HazardKind.SUDDEN_ACCELERATION,),
    ActKind.CHANGE_LANE: (
        HazardKind.CUT_IN,
        HazardKind.MERGING_CONFLICT,
        HazardKind.FAILURE_TO_YIELD,
        HazardKind.ONCOMING_LANE,
        HazardKind.SUDDEN_TURN,
    ),
    ActKind.SWERVE: (
        HazardKind.SWERVING,
        HazardKind.LOSS_OF_CONTROL,
        HazardKind.ONCOMING_LANE,
        HazardKind.SUDDEN_TURN,
    ),
    ActKind.OVERTAKE: (HazardKind.OVERTAKING, HazardKind.ONCOMING_LANE),
}
"""The dangers that an act may be."""


def dangers(functional: FunctionalScenario, logical: LogicalScenario) -> tuple[Hazard, ...]:
    """The dangers of a logical scenario; of one made by hand, as the description has them."""
    return logical.hazards or functional.hazards


def outward(functional: FunctionalScenario, side: Side) -> int:
    """1 if that side of one who drives is towards the kerb, -1 if towards the centre line."""
    return 1 if side.value == functional.junction.driving_side.value else -1


def allowed(logical: LogicalScenario, name: str, speed_mps: float) -> float:
    """The nearest speed that the logical scenario allows."""
    for parameter in logical.parameters:
        if parameter.name == f"{name}.speed_mps":
            return min(max(speed_mps, parameter.low), parameter.high)
    return speed_mps


def endangering_mps(
    asked: tuple[Hazard, ...], name: str, kind: ParticipantKind, limit_mps: float
) -> float | None:
    """The usual speed of one whose danger is its speed; None of others."""
    for hazard in asked:
        share = HAZARDS[hazard.kind].speed_share
        if name in hazard.by and share is not None:
            return min(share[2] * limit_for_kind_mps(kind, limit_mps), BODIES[kind].top_speed_mps)
    return None


def hazard_of(asked: tuple[Hazard, ...], act: Act) -> HazardKind | None:
    """The danger that an act is, of those asked for, if it is one."""
    kinds = [hazard.kind for hazard in asked if act.participant in hazard.by]
    return next((kind for kind in _HAZARDS_OF.get(act.kind, ()) if kind in kinds), None)


def contact_wanted(functional: FunctionalScenario, first: str, second: str) -> bool:
    """Whether the text says that these two touch."""
    outcome = functional.outcome
    if outcome is None or outcome.kind is not OutcomeKind.COLLISION:
        return False
    if outcome.between:
        return {first, second} == {*outcome.between}
    return functional.ego.id in {first, second}


def slug_name(logical: LogicalScenario) -> str:
    """The name of a scenario: number and slug of the logical one."""
    return re.sub(r"[^A-Za-z0-9_-]", "-", f"{logical.index:03d}-{logical.slug}")[:100]

"""What the two levels above ask for, where several parts need it alike."""

from __future__ import annotations

from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.vocabulary import Side


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

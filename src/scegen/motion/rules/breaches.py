"""Who is said to break a rule: whoever causes a danger that is a breach, and nobody else."""

from collections.abc import Iterator

from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.hazards import HAZARDS, RoadRule
from scegen.scenario.logical import LogicalScenario


def told_hazards(functional: FunctionalScenario, logical: LogicalScenario) -> tuple[Hazard, ...]:
    """The dangers, with everybody named where the logical scenario names them."""
    return logical.hazards or functional.hazards


def breaks(
    functional: FunctionalScenario, logical: LogicalScenario, rule: RoadRule
) -> frozenset[str]:
    """Those who are said to break a rule."""
    return frozenset(
        name
        for hazard in told_hazards(functional, logical)
        if HAZARDS[hazard.kind].breaks is rule
        for name in hazard.by
    )


def endangered(
    functional: FunctionalScenario, logical: LogicalScenario
) -> Iterator[tuple[str, str]]:
    """(who causes a danger, who suffers it): everybody else, where that is not said."""
    everybody = [p.id for p in functional.participants]
    for hazard in told_hazards(functional, logical):
        for by in hazard.by:
            for to in hazard.to or everybody:
                if by != to:
                    yield by, to

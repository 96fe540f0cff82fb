"""What a concrete scenario says by itself, where no description came with it."""

from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.junction import Junction


def described_by(concrete: ConcreteScenario) -> FunctionalScenario:
    """Its road, its participants and its dangers; no speeds, spacings, acts or outcome."""
    road = concrete.road
    return FunctionalScenario(
        description=concrete.description,
        junction=Junction(
            kind=road.kind,
            arms=len(road.arms),
            driving_side=road.driving_side,
            control=road.control,
        ),
        participants=tuple(
            Participant(id=p.id, kind=p.kind, role=p.role, parked=p.parked)
            for p in concrete.participants
        ),
        environment=concrete.environment,
    )

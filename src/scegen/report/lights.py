"""What the lights show: the same in still and moving pictures."""

from __future__ import annotations

from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.signals import SignalState


def shown(concrete: ConcreteScenario, arm: int, until_s: float) -> list[tuple[float, SignalState]]:
    """What the light of an arm shows from 0 on: (since when, state); nothing where it is dark."""
    plan = concrete.signals
    group = None if plan is None else plan.group_of(arm)
    return [] if plan is None or group is None else list(plan.changes(group, until_s))


def state_at(concrete: ConcreteScenario, arm: int, time_s: float) -> SignalState | None:
    """What the light of an arm shows at a time; None where it is dark."""
    plan = concrete.signals
    group = None if plan is None else plan.group_of(arm)
    return None if plan is None or group is None else plan.state(group, time_s)

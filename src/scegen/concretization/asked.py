"""What the two levels above ask for, where several parts need it alike."""

from __future__ import annotations

import re

from scegen.scenario.bodies import BODIES
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.speed_limits import limit_for_kind_mps
from scegen.scenario.vocabulary import Approach, ParticipantKind, Side


def as_meant(functional: FunctionalScenario, logical: LogicalScenario) -> FunctionalScenario:
    """What is described, with dangers and acts as the logical scenario has them.

    One made by hand may have none: there they are as described.
    """
    hazards, acts = logical.hazards or functional.hazards, logical.acts or functional.acts
    return functional.model_copy(update={"hazards": hazards, "acts": acts})


def outward(functional: FunctionalScenario, side: Side) -> int:
    """1 if that side of one who drives is towards the kerb, -1 if towards the centre line."""
    return 1 if side.value == functional.junction.driving_side.value else -1


def words_between(functional: FunctionalScenario, name: str, reference: str) -> frozenset[Approach]:
    """Where somebody is said to be, seen from another; nothing is said of things."""
    found: frozenset[Approach] = frozenset()
    if reference == functional.ego.id:
        found = found.union(*(p.approaches for p in functional.participants if p.id == name))
    for relation in functional.relations:
        if (relation.participant, relation.reference) == (name, reference):
            found |= relation.approaches
    return found


def side_of(functional: FunctionalScenario, name: str, reference: str) -> Side | None:
    """On which side of another somebody is said to be, None if on neither or on both."""
    sides = words_between(functional, name, reference) & {Approach.LEFT, Approach.RIGHT}
    return Side(next(iter(sides)).value) if len(sides) == 1 else None


def may_endanger(functional: FunctionalScenario, pair: set[str]) -> bool:
    """Whether one of two causes a danger that the other suffers, or that nobody is said to."""
    return any(
        pair & {*hazard.by} and (pair <= {*hazard.by, *hazard.to} or not hazard.to)
        for hazard in functional.hazards
    )


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


def slug_name(logical: LogicalScenario) -> str:
    """The name of a scenario: number and slug of the logical one."""
    return re.sub(r"[^A-Za-z0-9_-]", "-", f"{logical.index:03d}-{logical.slug}")[:100]

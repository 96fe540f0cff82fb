"""What the two levels above ask for, where several parts need it alike."""

from __future__ import annotations

import re

from scegen.enumeration.ranges import speed_range
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.parameters import ParameterRange
from scegen.scenario.vocabulary import Approach, Side

_ROUNDING_MPS = 1e-3


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


def pace_of(functional: FunctionalScenario, logical: LogicalScenario, name: str) -> ParameterRange:
    """How fast somebody may be who moves; of a logical scenario made by hand, as of one listed."""
    listed = (p for p in logical.parameters if p.name == f"{name}.speed_mps")
    pace = next(listed, None) or speed_range(functional, logical.assignment(name))
    said = functional.participant(name).speed_mps
    if said is None or abs(said.middle - pace.default) > _ROUNDING_MPS:
        return pace
    exact = {"low": said.low, "high": said.high, "default": said.middle}
    return pace.model_copy(update=exact)


def slug_name(logical: LogicalScenario) -> str:
    """The name of a scenario: number and slug of the logical one."""
    return re.sub(r"[^A-Za-z0-9_-]", "-", f"{logical.index:03d}-{logical.slug}")[:100]

"""All claims of a scenario: every statement of its functional and its logical level."""

from collections.abc import Callable, Iterator
from dataclasses import replace

from scegen.claims.claim import Claim
from scegen.claims.statements import (
    acts,
    approaches,
    assignments,
    backing_out,
    bodies,
    dangers,
    endings,
    giving_way,
    maneuvers,
    objects,
    openings,
    outcomes,
    resting,
    roads,
    rules,
    sizes,
    spacings,
    speeds,
    steady,
    strips,
)
from scegen.claims.told import Told
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.outcome import Outcome, OutcomeKind

STATEMENTS: tuple[Callable[[Told], Iterator[Claim]], ...] = (
    roads.claims,
    approaches.claims,
    assignments.claims,
    backing_out.claims,
    strips.claims,
    maneuvers.claims,
    resting.claims,
    speeds.claims,
    steady.claims,
    spacings.claims,
    acts.claims,
    rules.claims,
    giving_way.claims,
    giving_way.said,
    dangers.claims,
    objects.claims,
    sizes.claims,
    outcomes.claims,
    openings.claims,
    endings.claims,
    bodies.claims,
)
"""Every kind of statement, in the order in which they are told."""


def claims_of(
    functional: FunctionalScenario,
    logical: LogicalScenario,
    *,
    touching: tuple[str, ...] | None = (),
    brought_together: tuple[str, ...] = (),
) -> tuple[Claim, ...]:
    """What must be seen when one of a description's scenarios runs.

    Args:
        functional: what the description says.
        logical: one of its scenarios: who enters and leaves where.
        touching: two who are to touch, whatever the description says; None where no danger was
            sought: what the description does not say of the end is then open.
        brought_together: two of whom a measure was asked for: they need not give way.
    """
    if touching and (
        functional.outcome is None or functional.outcome.kind is not OutcomeKind.COLLISION
    ):
        asked = Outcome(kind=OutcomeKind.COLLISION, between=touching)
        functional = functional.but(outcome=asked)
    if logical.acts:
        # With the sides and lanes that the text leaves open.
        functional = functional.but(acts=logical.acts)
    told = Told(functional, logical, open_end=touching is None, brought_together=brought_together)
    return tuple(
        replace(claim, words=told.words(claim.field))
        for statement in STATEMENTS
        for claim in statement(told)
    )

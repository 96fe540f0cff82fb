"""What the command line says of a search for danger, and of what was said."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from scegen.scenario.functional import FunctionalScenario
    from scegen.scenario.proof import Proof


def proof_lines(proof: Proof, functional: FunctionalScenario | None) -> Iterator[str]:
    """A line on the target, one on all statements, and one for each that does not hold."""
    measure = proof.of(proof.measure)
    values = "" if measure is None else f" ({measure.in_words})"
    pair = " and ".join(proof.pair)
    if proof.in_band:
        yield f"{proof.target} of {pair}: {proof.measure}{values}"
    elif not pair:
        yield f"TARGET NOT REACHED: {proof.target}: {proof.blocked_by or 'there is no pair'}"
    else:
        why = f"; {proof.blocked_by}" if proof.blocked_by else ""
        yield f"TARGET NOT REACHED: {proof.target} of {pair}: {proof.measure}{values}{why}"
    if proof.claims:
        unjudged = functional.unjudged if functional is not None else None
        yield f"{proof.held}; {unjudged}" if unjudged else proof.held
    for claim in proof.missed:
        words = f' ("{claim.words}")' if claim.words else ""
        yield f"DOES NOT HOLD: {claim.statement}{words}: {claim.found}"
        yield f"  what would help: {claim.helps}"

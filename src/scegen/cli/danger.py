"""What the command line says of a search for danger."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from scegen.scenario.proof import Proof


def proof_lines(proof: Proof) -> Iterator[str]:
    """A line on the target, and one for every danger that does not happen."""
    measure = proof.of(proof.measure)
    values = ""
    if measure is not None:
        values = f" ({_value(measure.before)} → {_value(measure.after)} {measure.unit})"
    pair = " and ".join(proof.pair)
    happened = ""
    if proof.hazards:
        happened = f"; {proof.hazards_happened} of {len(proof.hazards)} dangers happen"
    if proof.in_band:
        yield f"{proof.target} of {pair}: {proof.measure}{values}{happened}"
    elif not pair:
        why = proof.blocked_by or "there is no pair"
        yield f"TARGET NOT REACHED: {proof.target}: {why}{happened}"
    else:
        yield (
            f"TARGET NOT REACHED: {proof.target} of {pair}: {proof.measure}{values}{happened}; "
            f"the scenario stays as it was. {proof.blocked_by or ''}".rstrip()
        )
    for hazard in proof.hazards:
        if not hazard.happened:
            said = hazard.note or f"{_value(hazard.margin)} {hazard.unit} short of its threshold"
            yield f"DOES NOT HAPPEN: {hazard.kind} by {', '.join(hazard.by) or 'nobody'} ({said})"


def _value(value: float | None) -> str:
    return "–" if value is None else f"{value:.2f}"

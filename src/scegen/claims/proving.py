"""Claims judged on one movement, for files and people."""

from collections.abc import Sequence
from math import isfinite

from scegen.claims.claim import NEVER, Claim
from scegen.claims.view import View
from scegen.scenario.proof import ClaimProof


def prove(claims: Sequence[Claim], *views: View) -> tuple[ClaimProof, ...]:
    """How every claim holds in the first candidate of a view; of several, where it holds least."""
    return tuple(_proof(claim, views) for claim in claims)


def _proof(claim: Claim, views: Sequence[View]) -> ClaimProof:
    found = [[float(values[0]) for values in claim.judge(view)] for view in views]
    margin, measured, time_s = min(found, key=lambda judged: judged[0])
    return ClaimProof(
        id=claim.id,
        kind=claim.kind.value,
        statement=claim.statement,
        field=claim.field,
        words=claim.words,
        holds=margin >= 0.0,
        measured=_number(measured),
        unit=claim.unit,
        margin=_number(margin),
        tolerance=round(claim.tolerance, 4),
        time_s=_number(time_s),
        fixed=claim.fixed,
    )


def _number(value: float) -> float | None:
    """A value as written to files; None where there is none."""
    return round(value, 4) + 0.0 if isfinite(value) and abs(value) < NEVER else None

"""Dangers: their predicates, for those who are meant to cause and to suffer them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from scegen.claims.claim import Claim, ClaimKind, Judged
from scegen.claims.hazards.judging import decisive
from scegen.claims.told import Told, plain
from scegen.claims.view import View
from scegen.scenario.functional import Hazard


def claims(told: Told) -> Iterator[Claim]:
    """One for every danger."""
    for number, hazard in enumerate(told.hazards):
        by = f" by {' and '.join(hazard.by)}" if hazard.by else ""
        to = f" to {' and '.join(hazard.to)}" if hazard.to else ""
        yield Claim(
            id=f"hazard.{number}.{hazard.kind}",
            kind=ClaimKind.HAZARD,
            statement=f"{plain(hazard.kind)}{by}{to} happens",
            field=f"hazards.{hazard.kind}",
            unit="1",
            test=partial(_happens, hazard),
        )


def _happens(hazard: Hazard, view: View) -> Judged:
    """Margins are relative to the scale of the weakest condition."""
    margin, time_s = decisive(view, hazard)
    return Judged(margin, margin, time_s)

"""Tailgating: following closely for some time."""

from __future__ import annotations

from scegen.claims.hazards import thresholds as limits
from scegen.claims.hazards.predicate import Part, Predicate, at_most
from scegen.claims.series import lasting
from scegen.claims.view import View


def tailgating(view: View, by: str, to: str) -> list[Part]:
    """Keeps less than the least gap of adaptive cruise control, for a second."""
    steps = round(limits.TAILGATING_FOR_S / view.dt_s)
    held = lasting(view.headway_s(by, to), steps)
    return [at_most("headway", held.min(axis=1), limits.TAILGATING, view.when(-held))]


TAILGATING = Predicate(tailgating)

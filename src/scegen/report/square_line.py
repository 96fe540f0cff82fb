"""The way of one that backs straight out, in the sketch of a junction."""

from __future__ import annotations

from scegen.report.plan import REACH, Plan, Point
from scegen.scenario.logical import Drive
from scegen.scenario.vocabulary import JunctionKind

_AT = 0.3 * REACH


def square_line(plan: Plan, drive: Drive) -> list[Point]:
    """Out of its arm and across, or from beside a road without a junction across the lanes."""
    if plan.kind is JunctionKind.STRAIGHT:
        edge = plan.half(drive.entry)
        beside, beyond = plan.side * (edge + plan.lane), -plan.side * edge
        return [plan.at(drive.entry, _AT, beside), plan.at(drive.entry, _AT, beyond)]
    out = -plan.side * plan.aside(drive.entry, 1)
    away = (plan.inner + _AT, -plan.half(drive.entry))
    return [plan.at(drive.entry, distance, out) for distance in away]

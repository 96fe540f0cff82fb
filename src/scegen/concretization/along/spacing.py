"""Spacings as places: where one starts so that a measure to another has a value at a moment."""

from __future__ import annotations

from dataclasses import dataclass

from scegen.concretization.along.runner import Runner, gap_m
from scegen.scenario.spacings import Measure

LEAST_CLOSING_MPS = 0.1
LENGTHWISE = frozenset({Measure.GAP_M, Measure.HEADWAY_S, Measure.TTC_S})
"""Measures along the road."""


@dataclass(frozen=True, slots=True)
class GapAt:
    """The ``measure`` of two is ``value`` at ``time_s``; ``ahead``: ``who`` is ahead of ``other``.

    ``said`` tells a statement of the text from what is usual.
    """

    who: str
    other: str
    measure: Measure
    value: float
    time_s: float
    ahead: bool
    said: bool


def wanted_gap_m(tie: GapAt, who: Runner, other: Runner) -> float:
    """The free length along the road that the measure means at that moment."""
    front, back = (who, other) if tie.ahead else (other, who)
    speed = back.speed_at_mps(tie.time_s)
    if tie.measure is Measure.HEADWAY_S:
        return tie.value * speed
    if tie.measure is Measure.TTC_S:
        ahead = front.speed_at_mps(tie.time_s) * (1 if front.forward == back.forward else -1)
        return tie.value * max(speed - ahead, LEAST_CLOSING_MPS)
    return tie.value


def place(tie: GapAt, who: Runner, other: Runner) -> float:
    """Where ``who`` starts so that the tie holds; ``other`` has its place."""
    wanted = wanted_gap_m(tie, who, other)
    who.at_m = 0.0
    low, high = who.ends_m(tie.time_s)
    other_low, other_high = other.ends_m(tie.time_s)
    # Ahead as ``other`` drives: in its direction.
    before = tie.ahead == other.forward
    return other_high + wanted - low if before else other_low - wanted - high


def level(who: Runner, other: Runner, time_s: float) -> float:
    """Where ``who`` starts so that the middles of both are level at a moment."""
    who.at_m = 0.0
    return sum(other.ends_m(time_s)) / 2 - sum(who.ends_m(time_s)) / 2


def measured(measure: Measure, first: Runner, second: Runner, time_s: float) -> float:
    """A measure between two at a moment; the one behind counts the speed."""
    gap = gap_m(first, second, time_s)
    if measure is Measure.GAP_M:
        return gap
    ahead_first = (first.x_m(time_s) - second.x_m(time_s)) * second.sign > 0
    front, back = (first, second) if ahead_first else (second, first)
    speed = back.speed_at_mps(time_s)
    if measure is Measure.HEADWAY_S:
        return gap / max(speed, LEAST_CLOSING_MPS)
    along = front.speed_at_mps(time_s) * (1 if front.forward == back.forward else -1)
    closing = speed - along
    return gap / closing if closing > LEAST_CLOSING_MPS else float("inf")

"""Spacings as places: where one starts so that a measure to another has a value at a moment."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from scegen.concretization.along.runner import Runner
from scegen.concretization.measures import missing_m
from scegen.scenario.spacings import Measure

_FAR_M = 1e4
"""Farther than anybody drives."""


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


def place(tie: GapAt, who: Runner, other: Runner) -> float:
    """Where ``who`` starts so that the tie holds; ``other`` has its place."""
    # Ahead as ``other`` drives: in its direction.
    away = _FAR_M if tie.ahead == other.forward else -_FAR_M
    at = np.array([tie.time_s])
    who.at_m = away
    missing = missing_m(tie.measure, tie.value, other.track(at), who.track(at))
    return away - float(missing[0]) * (1 if away > 0 else -1)


def level(who: Runner, other: Runner, time_s: float) -> float:
    """Where ``who`` starts so that the middles of both are level at a moment."""
    who.at_m = 0.0
    return sum(other.ends_m(time_s)) / 2 - sum(who.ends_m(time_s)) / 2

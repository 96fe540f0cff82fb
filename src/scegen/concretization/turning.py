"""Ordinary speed along a way: slow down for bends and stop lines, speed up after them."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

from scegen.concretization.profile import Sort, SpeedChange
from scegen.motion.polyline import LaidDrive
from scegen.scenario.concrete import AtTime, Travelled

_WORTH_IT = 0.98
_REACTION_M = 1.0
_SHORT_OF_LINE_M = 1.0
"""From the front bumper of one who stops to the stop line."""


@dataclass(frozen=True, slots=True)
class Bend:
    """From ``start_s_m`` to ``end_s_m`` of the path no more than ``speed_mps`` is comfortable."""

    start_s_m: float
    end_s_m: float
    speed_mps: float


@dataclass(frozen=True, slots=True)
class Stop:
    """A stop before the line that the front reaches at ``line_s_m``, for so long or until then."""

    line_s_m: float
    stands_s: float
    goes_at: AtTime | Travelled | None = None


def bend_of(laid: LaidDrive, cruise_mps: float, lateral_mps2: float) -> Bend | None:
    """The bends of a way that are too tight for ``cruise_mps``, as one; None if there is none.

    The comfortable speed is sqrt(lateral acceleration * radius) of the lane driven.
    """
    found = [
        Bend(start_s_m, end_s_m, speed)
        for start_s_m, end_s_m, radius_m in laid.bends
        if (speed := sqrt(lateral_mps2 * radius_m)) < cruise_mps * _WORTH_IT
    ]
    if not found:
        return None
    return Bend(found[0].start_s_m, found[-1].end_s_m, min(bend.speed_mps for bend in found))


def turning_changes(
    laid: LaidDrive,
    cruise_mps: float,
    *,
    lateral_mps2: float,
    stop: Stop | None,
    slowing_mps2: float,
    faster_mps2: float,
) -> list[SpeedChange]:
    """The marks of a drive along a way at ``cruise_mps``.

    ``stop`` is where it stands for a while.
    """
    bend = bend_of(laid, cruise_mps, lateral_mps2)
    marks: list[SpeedChange] = []
    if stop is not None:
        # The reaction is before the braking: here it comes to rest exactly there.
        rest = stop.line_s_m - _SHORT_OF_LINE_M + _REACTION_M
        on = SpeedChange(
            bend.speed_mps if bend else cruise_mps,
            faster_mps2,
            sort=Sort.GOES_ON,
            then_s=stop.stands_s,
            trigger=stop.goes_at,
        )
        marks.append(_slow_before(rest, cruise_mps, 0.0, slowing_mps2, on))
    elif bend:
        marks.append(_slow_before(bend.start_s_m, cruise_mps, bend.speed_mps, slowing_mps2))
    if bend:
        marks.append(SpeedChange(cruise_mps, faster_mps2, s_m=bend.end_s_m, sort=Sort.FREES))
    return marks


def _slow_before(
    s_m: float, from_mps: float, to_mps: float, rate_mps2: float, then: SpeedChange | None = None
) -> SpeedChange:
    distance = (from_mps**2 - to_mps**2) / (2 * rate_mps2)
    by_m = s_m - _REACTION_M
    place = max(0.0, by_m - distance)
    return SpeedChange(to_mps, rate_mps2, s_m=place, sort=Sort.SLOWS, then=then, by_m=by_m)

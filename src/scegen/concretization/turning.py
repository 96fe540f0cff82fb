"""Ordinary speed along a way: slow down for bends and stop lines, speed up after them."""

from __future__ import annotations

from math import sqrt

from scegen.concretization.profile import Sort, SpeedChange
from scegen.motion.polyline import LaidDrive

_WORTH_IT = 0.98
_SHORT_M = 1.0
"""From the front bumper of one who stops to the stop line, and as early before a bend."""


def turning_changes(
    laid: LaidDrive,
    cruise_mps: float,
    *,
    lateral_mps2: float,
    stop: tuple[float, float] | None,
    slowing_mps2: float,
    faster_mps2: float,
) -> list[SpeedChange]:
    """The marks of a drive along a way at ``cruise_mps``.

    ``stop`` is where its front comes to a line before which it stands (m), and for how long (s).
    The comfortable speed in a bend is sqrt(lateral acceleration * radius) of the lane driven; from
    the first to the last bend that is too narrow for ``cruise_mps`` the least of these is kept.
    """
    limits = [(begin, end, sqrt(lateral_mps2 * radius_m)) for begin, end, radius_m in laid.bends]
    bend = [limit for limit in limits if limit[2] < cruise_mps * _WORTH_IT]
    speed = min((limit for _, _, limit in bend), default=cruise_mps)
    marks: list[SpeedChange] = []
    if stop is not None:
        on = SpeedChange(speed, faster_mps2, sort=Sort.GOES_ON, then_s=stop[1])
        marks.append(_slow_before(stop[0], cruise_mps, 0.0, slowing_mps2, on))
    elif bend:
        marks.append(_slow_before(bend[0][0], cruise_mps, speed, slowing_mps2))
    if bend:
        marks.append(SpeedChange(cruise_mps, faster_mps2, s_m=bend[-1][1], sort=Sort.FREES))
    return marks


def _slow_before(
    s_m: float, from_mps: float, to_mps: float, rate_mps2: float, then: SpeedChange | None = None
) -> SpeedChange:
    distance = (from_mps**2 - to_mps**2) / (2 * rate_mps2)
    by_m = s_m - _SHORT_M
    begins_m = max(0.0, by_m - distance)
    return SpeedChange(to_mps, rate_mps2, s_m=begins_m, sort=Sort.SLOWS, then=then, by_m=by_m)

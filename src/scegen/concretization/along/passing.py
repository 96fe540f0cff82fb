"""How near two come as they pass, with their boxes as they are turned, and just missing another."""

from __future__ import annotations

from collections.abc import Callable
from math import hypot, sqrt

from scegen.concretization.along.runner import Move, Runner, gap_m
from scegen.concretization.along.spacing import GapAt, level, place
from scegen.scenario.spacings import Measure

JUST_M = 0.5
"""The room that is left between two of whom one just misses the other."""
_LOOK_S, _DELTA_S = 0.05, 0.02
_ROUNDS = 16
_AROUND_S = 3.0
_NEVER_MPS = 0.5


def apart_m(first: Runner, second: Runner, time_s: float) -> float:
    """How far the boxes of two are apart, at least; negative where they overlap."""
    gap = gap_m(first, second, time_s)
    if gap > 2 * JUST_M:
        return gap
    (x1, y1, c1, s1), (x2, y2, c2, s2) = _box(first, time_s), _box(second, time_s)
    dx, dy = x2 - x1, y2 - y1
    a, b = first.body, second.body
    cos, sin = abs(c1 * c2 + s1 * s2), abs(c1 * s2 - s1 * c2)
    al, aw, bl, bw = a.length_m / 2, a.width_m / 2, b.length_m / 2, b.width_m / 2
    return max(
        abs(dx * c1 + dy * s1) - al - bl * cos - bw * sin,
        abs(dx * s1 - dy * c1) - aw - bl * sin - bw * cos,
        abs(dx * c2 + dy * s2) - bl - al * cos - aw * sin,
        abs(dx * s2 - dy * c2) - bw - al * sin - aw * cos,
    )


def _box(runner: Runner, time_s: float) -> tuple[float, float, float, float]:
    """The middle of a box, and the cosine and sine of its heading."""
    y = runner.y_m(time_s)
    aside = runner.y_m(time_s + _DELTA_S) - runner.y_m(time_s - _DELTA_S)
    speed = runner.speed_at_mps(time_s)
    sin = aside / (2 * _DELTA_S) / speed if speed > _NEVER_MPS else 0.0
    sin = max(-0.9, min(0.9, -sin if runner.backs else sin))
    cos = runner.sign * sqrt(1.0 - sin * sin)
    ahead = runner.body.centre_ahead_m
    return runner.x_m(time_s) + ahead * cos, y + ahead * sin, cos, sin


def leap_s(first: Runner, second: Runner, way_m: float, step_s: float) -> float:
    """How long two need at least to come nearer by so much, in whole steps; one step at least."""
    fastest = first.fastest_mps, second.fastest_mps
    closing = hypot(*fastest) if first.towards == second.towards else sum(fastest)
    return max(1.0, way_m // (max(closing, _NEVER_MPS) * step_s)) * step_s


def least_apart_m(first: Runner, second: Runner, from_s: float, to_s: float) -> float:
    """How near two come within a time."""
    times = [from_s + _LOOK_S * n for n in range(int((to_s - from_s) / _LOOK_S) + 1)]
    return min(apart_m(first, second, max(t, 0.0)) for t in times)


def _least(holds: Callable[[float], bool], low: float, high: float) -> float:
    """The least value from which on something holds, by halves."""
    for _ in range(_ROUNDS):
        middle = (low + high) / 2
        low, high = (low, middle) if holds(middle) else (middle, high)
    return high


def place_just_missed(
    who: Runner, front: Runner, back: Runner, move: Move, room_m: float = JUST_M
) -> None:
    """Place one of two so that the one behind, which moves aside, just misses the one ahead."""
    other = back if who is front else front
    until_s = move.ends_s + _AROUND_S

    def missed(gap: float) -> bool:
        tie = GapAt(
            who.id, other.id, Measure.GAP_M, gap, move.begins_s, ahead=who is front, said=False
        )
        who.at_m = place(tie, who, other)
        return least_apart_m(front, back, move.begins_s, until_s) >= room_m

    closing = max(back.speed_at_mps(move.begins_s) - front.speed_at_mps(move.begins_s), 1.0)
    missed(_least(missed, 0.0, closing * move.lasts_s))


def just_missed_s(who: Runner, other: Runner, back: Move) -> float:
    """When one on its way back is level with another that comes towards it: it just misses it."""
    kept = who.at_m

    def missed(moment_s: float) -> bool:
        who.at_m = level(who, other, moment_s)
        return least_apart_m(who, other, moment_s - _AROUND_S / 2, moment_s + _AROUND_S / 2) >= (
            JUST_M
        )

    found = _least(missed, back.begins_s, back.ends_s + 1.0)
    who.at_m = kept
    return found

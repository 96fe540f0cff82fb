"""Dangers that one driver makes alone: speed, acceleration, braking, standing still."""

from math import inf

import numpy as np

from scegen.claims.hazards import thresholds as limits
from scegen.claims.hazards.in_line import leads, leads_once
from scegen.claims.hazards.predicate import Part, Predicate, at_least, at_most
from scegen.claims.series import at, greatest, least_lasting, longest_run
from scegen.claims.view import View
from scegen.motion.friction import GRAVITY_MPS2
from scegen.scenario.speed_limits import limit_for_kind_mps

_MOVING_MPS = 0.5
_AT_END_M = 0.05
_LEAST_ROOM_M = 0.5
_HARSH_MPS2 = 3.0
"""More than comfortable braking; where this begins, the driver has seen the danger."""


def speeding(view: View, by: str, _: str) -> list[Part]:
    """Drives clearly faster than its roads allow."""
    way, (fastest, step) = view.ways[by], greatest(view.speed_mps(by))
    bound = limits.SPEEDING.value * limit_for_kind_mps(way.participant.kind, way.limit_mps)
    return [at_least("speed", fastest, limits.SPEEDING, view.time_of(step), bound)]


def slow_driving(view: View, by: str, _: str) -> list[Part]:
    """Moves far below the limit for some seconds, on its approach if there is a junction."""
    way, speed = view.ways[by], view.speed_mps(by)
    counts = speed > _MOVING_MPS
    if way.turn_end_m > way.turn_start_m:
        counts &= view.place_m(by) < way.turn_start_m
    steps = round(limits.SLOW_FOR_S / view.dt_s)
    slow, begins = least_lasting(np.where(counts, speed, np.inf), steps)
    bound = limits.SLOW.value * way.limit_mps
    return [at_most("speed", slow, limits.SLOW, view.time_of(begins), bound)]


def possible(view: View, limit: limits.Threshold, best_mps2: float = inf) -> float:
    """The threshold, or most of what a body and the road allow where that is less."""
    best = min(best_mps2, view.friction * GRAVITY_MPS2)
    return min(limit.value, limits.OF_WHAT_IS_POSSIBLE * best)


def braking_part(view: View, by: str, limit: limits.Threshold) -> Part:
    """It brakes as hard as that."""
    braking = -view.acceleration_mps2(by, limits.MEASURED_OVER_S)
    # One who reaches the end of its way is taken off its feet, which is no braking.
    ends = view.place_m(by)[:, -braking.shape[1] :] >= view.ways[by].path.length_m - _AT_END_M
    hardest, step = greatest(np.where(ends, 0.0, braking))
    bound = possible(view, limit, view.body(by).max_deceleration_mps2)
    return at_least("deceleration", hardest, limit, view.time_of(step), bound)


def sudden_acceleration(view: View, by: str, _: str) -> list[Part]:
    """Accelerates harshly."""
    gain, step = greatest(view.acceleration_mps2(by, limits.MEASURED_OVER_S))
    bound = possible(view, limits.ACCELERATION, view.body(by).max_acceleration_mps2)
    return [at_least("acceleration", gain, limits.ACCELERATION, view.time_of(step), bound)]


def hard_braking(view: View, by: str, _: str) -> list[Part]:
    """Brakes as in an emergency."""
    return [braking_part(view, by, limits.HARD_BRAKING)]


def delayed_braking(view: View, by: str, to: str) -> list[Part]:
    """Begins to brake only where comfort no longer does, and brakes hard.

    What it needs is the deceleration to stop before the ground that the other's way covers (or
    behind the other) from where its hard braking begins.
    """
    braking = braking_part(view, by, limits.LATE_BRAKING)
    harsh = -view.acceleration_mps2(by, limits.MEASURED_OVER_S) >= _HARSH_MPS2
    begins = harsh.argmax(axis=1)
    speed, room = at(view.speed_mps(by), begins), at(view.room_m(by, to), begins)
    needed = speed**2 / (2.0 * np.maximum(room, _LEAST_ROOM_M))
    needed = np.where((room > 0.0) & harsh.any(axis=1), needed, np.nan)
    time_s = view.time_of(begins)
    return [at_least("needed when it brakes", needed, limits.LATE_BRAKING, time_s), braking]


def stopping(view: View, by: str, _: str) -> list[Part]:
    """Stands in the way after having moved, until it sets off, or blocks a lane all along."""
    way, place = view.ways[by], view.place_m(by)
    stands = view.speed_mps(by) < limits.STANDS_MPS
    all_along = stands.all(axis=1, keepdims=True)
    if not way.sets_off or way.laid is None:  # who waits at the kerb is in nobody's way
        stands &= all_along | (place > place[:, :1] + _MOVING_MPS)
    if way.laid is not None:
        # Waiting at the end of the road is the end of the scenario, no danger.
        stands &= all_along | (place < way.path.length_m - _AT_END_M)
    longest, begins = longest_run(stands)
    held = view.time_of(longest)
    return [at_least("standstill", held, limits.STANDS, view.time_of(begins))]


SPEEDING = Predicate(speeding, pairwise=False, conflict=True)
SLOW_DRIVING = Predicate(slow_driving, pairwise=False, order=leads_once)
SUDDEN_ACCELERATION = Predicate(sudden_acceleration, pairwise=False, conflict=True)
HARD_BRAKING = Predicate(hard_braking, pairwise=False, order=leads)
DELAYED_BRAKING = Predicate(delayed_braking)
STOPPING = Predicate(stopping, pairwise=False, order=leads)

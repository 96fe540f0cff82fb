"""Dangers of two whose ways cross or merge: how close in time they come.

Closeness is PET, where it exists, or TTC of those who really come close: a TTC alone is weak at
crossings. For one who brakes before the other's way PET says nothing and TTC does.
"""

import numpy as np

from scegen.claims.hazards import thresholds as limits
from scegen.claims.hazards.in_line import merges_ahead
from scegen.claims.hazards.predicate import Part, Predicate, at_least, at_most, part
from scegen.claims.series import least
from scegen.claims.view import View
from scegen.motion.batch.arrays import Floats
from scegen.scenario.concrete import CrossingMotion

_BEFORE_LINE_M = 15.0
_IN_M = 1.0
_SET_OFF_M = 3.0
_FROM, _UNTIL = 0.3, 0.7
_OF_ITS_PACE = 0.7


def closeness(view: View, by: str, to: str) -> Part:
    """The time between the two, in s: the smaller of PET and a TTC that counts.

    Of one who stands it is the distance.
    """
    if (view.speed_mps(to) < limits.STANDS_MPS).all():
        apart, time_s = view.of_pair("distance_m", by, to), view.of_pair("closest_s", by, to)
        return at_most("distance", apart, limits.NEAR, time_s)
    pet = view.of_pair("pet_s", by, to)
    ttc = view.of_pair("ttc_s", by, to)
    apart = view.of_pair("distance_m", by, to)
    # Beyond the distance a TTC fades out by 1 s per metre, so that a search finds the way in.
    ttc = ttc + np.maximum(0.0, apart - limits.CONFLICT_WITHIN_M)
    value, time_s = np.fmin(pet, ttc), view.of_pair("closest_s", by, to)
    limit = limits.CONFLICT
    return part("PET or TTC", value, limit.value, limit, limit.value - value, time_s)


def conflict(view: View, by: str, to: str) -> list[Part]:
    """Both want to be in the same place at nearly the same time."""
    return [closeness(view, by, to)]


def before(view: View, by: str, to: str) -> list[Part]:
    """The same, and who causes it comes before the other, or is hit: not behind it."""
    return [closeness(view, by, to), *_in_time(view, by, to)]


def _in_time(view: View, by: str, to: str) -> list[Part]:
    """It comes onto the ground that both use before the other has left it, if there is any."""
    areas = view.areas(by, to)
    if not areas:
        return []
    comes = np.array([view.reaches_s(by, area.enter_m) for area in areas])
    leaves = np.array([view.reaches_s(to, area.other_leaves_m) for area in areas])
    there = np.isfinite(comes)
    ahead: Floats = np.where(there, leaves - np.where(there, comes, 0.0), -np.inf).max(axis=0)
    return [at_least("there before the other has left", ahead, limits.IN_TIME, comes.min(axis=0))]


def drives_on(view: View, by: str, to: str) -> list[Part]:
    """The same, by one who should have stopped and does not.

    What the light shows meanwhile is a claim of its own, on the rule that is broken.
    """
    way, place = view.ways[by], view.place_m(by)
    bound = limits.DRIVES_ON.value
    if isinstance(way.participant.motion, CrossingMotion):
        # Who crosses sets off from rest and ends at rest: what counts is the middle of its way.
        near = (place > _FROM * way.path.length_m) & (place < _UNTIL * way.path.length_m)
        paces = [phase.target_speed_mps for phase in way.participant.speed_program]
        bound = min(bound, _OF_ITS_PACE * max(paces, default=0.0))
    elif way.sets_off:
        # Who sets off from rest does not stop again before it is in the other's way.
        near = (place > place[:, :1] + _SET_OFF_M) & (place < place[:, :1] + _BEFORE_LINE_M)
    elif way.path.backwards:
        # One that stops beyond the line, to reverse, has passed it all the same.
        near = (place > way.turn_start_m - _BEFORE_LINE_M) & (place < way.turn_start_m)
    else:
        # One who comes to the ground that both use has driven on, even if it stops there.
        shared = [area.enter_m for area in view.areas(by, to)] if by != to else []
        until = max(min(shared), way.turn_start_m + _IN_M) if shared else way.turn_end_m
        near = (place > way.turn_start_m - _BEFORE_LINE_M) & (place < until)
    speed, step = least(np.where(near, view.speed_mps(by), np.inf))
    at_line, time_s = "slowest speed at the line", view.time_of(step)
    passes = at_least(at_line, speed, limits.DRIVES_ON, time_s, bound)
    return [passes] if by == to else [closeness(view, by, to), passes]


def does_not_yield(view: View, by: str, to: str) -> list[Part]:
    """It drives on, before the other."""
    return [*drives_on(view, by, to), *(_in_time(view, by, to) if by != to else ())]


MERGING = Predicate(conflict, order=merges_ahead)
BEFORE = Predicate(before)
DRIVES_ON = Predicate(drives_on, before_nobody=True)
DOES_NOT_YIELD = Predicate(does_not_yield, before_nobody=True)

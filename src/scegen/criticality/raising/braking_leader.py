"""What a driver would do where the text names no danger: the one ahead brakes, then drives on.

Two who follow each other at steady speeds never come nearer. Where a search finds nothing for that
reason, the leader gets two phases more: it brakes once the one behind is so many seconds short of
where it is itself, and takes up its speed again, so that the search can bring the two together.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations
from math import sqrt

import numpy as np

from scegen.claims.hazards.scenes import Pair
from scegen.claims.hazards.table import PREDICATES
from scegen.claims.view import View
from scegen.claims.ways import paths_of
from scegen.criticality.reactivity.rendezvous import waits_until
from scegen.criticality.search.proving import Evidence, examine
from scegen.criticality.target import Target
from scegen.motion import simulate
from scegen.motion.friction import GRAVITY_MPS2
from scegen.motion.model import Trace
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import (
    ArrivalBelow,
    Change,
    ConcreteParticipant,
    ConcreteScenario,
    DriveMotion,
    SpeedPhase,
    Travelled,
)
from scegen.scenario.vocabulary import HazardKind

REASON = "added: the leader brakes, since nothing in the description brings the two together"
_BEGINS_S = 2.5
"""The leader brakes no earlier than this, well after the lead-in."""
_BRAKING_MPS2 = 5.0
"""Between comfortable and emergency braking; the search goes from 0.7 to 1.25 times that."""
_RESUMING_MPS2 = 2.0
_OF_FRICTION = 0.9
_HOLD_S = 0.5
_SLOWEST = 0.15
_NEAR_M = 0.5
_THROUGH_M = -1.5
_STEADY_MPS = 3.0
_FARTHEST_M = 80.0
_SAME_MPS = 1e-3
_DECIMALS = 3


def braking_leaders(
    found: Evidence, network: RoadNetwork, target: Target, pairs: Sequence[Pair], friction: float
) -> Iterator[tuple[Pair, ConcreteScenario]]:
    """Scenarios in which one brakes ahead of another, and the pair it is about; the ego's first.

    None for a pair of which the text names somebody as the cause of a danger, nor where something
    is asked for that braking does not change. Of ``pairs`` the most important comes first;
    ``friction`` is the coefficient between tyre and road.
    """
    concrete = found.concrete
    if all(choice[0].measure == "pet" for choice in target.choices):
        return
    drives = [p.id for p in concrete.participants if isinstance(p.motion, DriveMotion)]
    named = {
        name
        for hazard in concrete.hazards
        if hazard.kind in PREDICATES and PREDICATES[hazard.kind].conflict
        for name in hazard.by
    }
    free = [p for p in pairs if set(p) <= set(drives) and not set(p) & named]
    if not free:
        return
    # Everybody against everybody: somebody else may drive in between.
    view = examine(concrete, network, list(combinations(drives, 2)), friction).view
    traces = simulate(concrete, paths_of(view.ways), dt_s=view.dt_s)
    ego = concrete.ego.id
    ordered = sorted(((f, a) for p in free for f, a in (p, p[::-1])), key=lambda c: c[0] != ego)
    for follower, leader in ordered:
        begins = _follows_from(view, follower, leader, drives)
        if begins is None:
            continue
        gap_m = float(view.gap_m(follower, leader)[0, begins])
        nearest = _THROUGH_M if target.contact else _NEAR_M
        pair, closing_m = (follower, leader), gap_m - nearest
        made = _with_phases(concrete, view, traces, pair, begins, closing_m, friction)
        if made is not None:
            yield pair, made


def _follows_from(view: View, follower: str, leader: str, drives: Sequence[str]) -> int | None:
    """The step from which one drives right behind the other, both steadily; None if never."""
    gap = view.gap_m(follower, leader)[0]
    usable = np.isfinite(gap) & (gap < _FARTHEST_M)
    usable[: round(_BEGINS_S / view.dt_s)] = False
    for name in (follower, leader):
        usable &= view.speed_mps(name)[0] >= _STEADY_MPS
        way = view.ways[name]  # along a plain road there is no place that one must reach
        usable &= view.place_m(name)[0] < (way.goal_m if way.goal_m > 0 else way.path.length_m)
    for other in drives:
        if other not in {follower, leader}:
            usable &= ~(view.gap_m(follower, other)[0] < gap)
    return int(usable.argmax()) if usable.any() else None


def _with_phases(
    concrete: ConcreteScenario,
    view: View,
    traces: Mapping[str, Trace],
    pair: Pair,
    begins: int,
    closing_m: float,
    friction: float,
) -> ConcreteScenario | None:
    """The scenario in which the leader brakes at that step; None where it is busy otherwise.

    ``closing_m`` is what the follower is to gain on it, if both were equally fast before.
    """
    follower, leader = pair
    participant = concrete.participant(leader)
    body, trace = participant.body, traces[leader]
    most = _OF_FRICTION * friction * GRAVITY_MPS2
    rate = round(min(_BRAKING_MPS2, body.max_deceleration_mps2, most), _DECIMALS)
    resuming = round(min(_RESUMING_MPS2, body.max_acceleration_mps2, most), _DECIMALS)
    speed = float(trace.speed_mps[begins])
    by, hold_s = _slows_by(closing_m, speed, rate, resuming)
    slow = speed - by
    goes_on_m = float(trace.s_m[begins]) + (speed + slow) / 2 * by / rate + slow * hold_s
    over_m = goes_on_m + (speed + slow) / 2 * by / resuming
    place = _place_in_program(participant, trace, begins, over_m)
    if place is None:
        return None
    trigger: ArrivalBelow | Travelled
    if participant is concrete.ego:
        trigger = Travelled(participant=leader, distance_m=_rounded(trace.s_m[begins]))
    else:
        behind_s = closing_m / max(float(traces[follower].speed_mps[begins]), 1.0)
        at_s = begins * view.dt_s
        path = view.ways[follower].path
        waits = waits_until(traces[follower], path, at_s, at_s + max(behind_s, 0.5))
        if waits is None:
            return None
        trigger = ArrivalBelow(participant=follower, place_m=waits[0], time_s=waits[1])
    brakes = SpeedPhase(trigger=trigger, target_speed_mps=_rounded(slow), rate_mps2=rate,
                        hazard=HazardKind.HARD_BRAKING)  # fmt: skip
    later = Travelled(participant=leader, distance_m=_rounded(goes_on_m))
    resumes = SpeedPhase(trigger=later, target_speed_mps=_rounded(speed), rate_mps2=resuming)
    phases, program = (brakes, resumes), participant.speed_program
    braking = participant.but(speed_program=(*program[:place], *phases, *program[place:]))
    told = zip(phases, (REASON, f"{REASON}; then it drives on"), strict=True)
    changes = [
        Change(parameter=f"{leader}.speed_program.{n}.{name}", by="search", after=value, reason=why)
        for n, (phase, why) in enumerate(told, start=place)
        for name, value in phase.numbers.items()
    ]
    later_s = closing_m / speed + 1.0
    people = concrete.with_participant(braking).participants
    ends_s = round((concrete.duration_s + later_s) * 20) / 20
    return concrete.changed(people, changes, duration_s=ends_s)


def _slows_by(closing_m: float, speed: float, rate: float, resuming: float) -> tuple[float, float]:
    """By how much the leader slows down (m/s), and for how long (s), to lose ``closing_m``."""
    share = 0.5 / rate + 0.5 / resuming
    by = (sqrt(_HOLD_S**2 + 4.0 * share * max(closing_m, 1.0)) - _HOLD_S) / (2.0 * share)
    most = (1.0 - _SLOWEST) * speed
    if by <= most:
        return by, _HOLD_S
    return most, max(_HOLD_S, (closing_m - share * most**2) / most)


def _place_in_program(
    participant: ConcreteParticipant, trace: Trace, begins: int, over_m: float
) -> int | None:
    """Where in its program the new phases belong; None where it has others meanwhile."""
    places = [
        phase.trigger.distance_m
        for phase in participant.speed_program
        if isinstance(phase.trigger, Travelled) and phase.trigger.participant == participant.id
    ]
    if len(places) < len(participant.speed_program):
        return None
    n = sum(place <= trace.s_m[begins] for place in places)
    wanted = participant.speed_program[n - 1].target_speed_mps if n else participant.speed_mps
    steady = abs(float(trace.speed_mps[begins]) - wanted) < _SAME_MPS
    return n if steady and all(place >= over_m for place in places[n:]) else None


def _rounded(value: float) -> float:
    return round(float(value), _DECIMALS)

"""Marks: a speed program tied to places of the path, before the start is known.

Once the start is known, a mark becomes a phase triggered by the distance travelled. A mark may
hold its speed for a while and then resume; the time of resuming is known from the timeline.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from scegen.motion.model import Array
from scegen.scenario.concrete import ArrivalBelow, SpeedPhase, StoodStill, Travelled, Trigger
from scegen.scenario.vocabulary import HazardKind

STEP_S = 0.05
_LONGEST_S = 240.0


@dataclass(frozen=True, slots=True)
class Mark:
    """At ``s_m`` of the path (from the outer end), change speed to ``target_mps``.

    With ``hold_s``, that long after the target is reached the speed changes to ``resume_mps``.
    ``waits_for`` is what it waits for instead, once that is known; ``resume_hazard`` the danger
    that going on serves.
    """

    s_m: float
    target_mps: float
    rate_mps2: float
    hazard: HazardKind | None = None
    hold_s: float | None = None
    resume_mps: float = 0.0
    resume_rate_mps2: float = 2.0
    resume_hazard: HazardKind | None = None
    waits_for: ArrivalBelow | None = None


@dataclass(frozen=True)
class Timeline:
    """When a lone vehicle that starts at the outer end of its path is where, at which speed.

    ``resumes_s`` maps the index of a holding mark to the time at which it resumes.
    """

    time_s: Array
    s_m: Array
    speed_mps: Array
    resumes_s: dict[int, float] = field(default_factory=dict)

    def time_at(self, s_m: float) -> float:
        """When it first reaches ``s_m``; before its start and behind its end at steady speed."""
        last = float(self.s_m[-1])
        if s_m > last:
            return float(self.time_s[-1]) + (s_m - last) / max(float(self.speed_mps[-1]), 0.5)
        if s_m < 0:
            return s_m / max(float(self.speed_mps[0]), 0.5)
        return float(np.interp(s_m, self.s_m, self.time_s))

    def times_at(self, s_m: Array) -> Array:
        """The same for places on the path."""
        return np.interp(s_m, self.s_m, self.time_s)

    def s_at(self, time_s: float) -> float:
        """Where it is at a time; before the start it approaches at its first speed."""
        if time_s < 0:
            return time_s * float(self.speed_mps[0])
        return float(np.interp(time_s, self.time_s, self.s_m))

    def speed_at(self, s_m: float) -> float:
        """Its speed where it first reaches ``s_m``."""
        return float(np.interp(self.time_at(s_m), self.time_s, self.speed_mps))


def timeline(marks: Sequence[Mark], speed_mps: float, length_m: float) -> Timeline:
    """Drive alone along a path of ``length_m`` from its outer end, by the simulator's laws."""
    times, places, speeds = [0.0], [0.0], [speed_mps]
    resumes: dict[int, float] = {}
    t, s, v, fired = 0.0, 0.0, speed_mps, 0
    target, rate = v, 1.0
    waiting: Mark | None = None
    reached_s: float | None = None
    while s < length_m and t < _LONGEST_S:
        t += STEP_S
        step = rate * STEP_S
        v = target if abs(target - v) <= step else v + (step if target > v else -step)
        s += v * STEP_S
        times.append(t)
        places.append(s)
        speeds.append(v)
        if waiting is not None and waiting.hold_s is not None:
            if reached_s is None and v == target:
                reached_s = t
            if reached_s is not None and t >= reached_s + waiting.hold_s:
                target, rate = waiting.resume_mps, waiting.resume_rate_mps2
                resumes[fired - 1] = t
                waiting, reached_s = None, None
        elif fired < len(marks) and s >= marks[fired].s_m:
            mark = marks[fired]
            target, rate = mark.target_mps, mark.rate_mps2
            waiting = mark if mark.hold_s is not None else None
            fired += 1
        elif v == 0.0 and target == 0.0:
            break
    # Strictly rising places, so that the time at a place is the first one.
    s_all = np.array(places)
    first = np.concatenate(([True], np.diff(s_all) > 0))
    first[-1] = True
    return Timeline(np.array(times)[first], s_all[first], np.array(speeds)[first], resumes)


def compile_marks(
    who: str, marks: Sequence[Mark], course: Timeline, start_m: float
) -> tuple[float, tuple[SpeedPhase, ...]]:
    """Initial speed and phases of a vehicle that starts at ``start_m`` of its course."""
    speed = course.speed_at(start_m)
    phases: list[SpeedPhase] = []
    begun = [i for i, mark in enumerate(marks) if mark.s_m <= start_m]
    for index, mark in enumerate(marks):
        over = mark.s_m <= start_m and index != begun[-1]
        reached = mark.s_m <= start_m and abs(speed - mark.target_mps) < 1e-3
        if over or reached:
            continue
        phases.append(
            SpeedPhase(
                trigger=Travelled(participant=who, distance_m=max(0.0, mark.s_m - start_m)),
                target_speed_mps=mark.target_mps,
                rate_mps2=mark.rate_mps2,
                hazard=mark.hazard,
            )
        )
        if index in course.resumes_s and mark.hold_s is not None:
            trigger: Trigger = StoodStill(participant=who, duration_s=mark.hold_s)
            if mark.waits_for is not None:
                trigger = mark.waits_for
            elif mark.target_mps > 0.0:
                resumes_m = course.s_at(course.resumes_s[index]) - start_m
                trigger = Travelled(participant=who, distance_m=max(0.0, resumes_m))
            phases.append(
                SpeedPhase(
                    trigger=trigger,
                    target_speed_mps=mark.resume_mps,
                    rate_mps2=mark.resume_rate_mps2,
                    hazard=mark.resume_hazard,
                )
            )
    return speed, tuple(phases)

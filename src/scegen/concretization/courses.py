"""Marks: a speed program tied to places of the path, before the start is known.

Once the start is known, a mark becomes a phase triggered by the distance travelled. A mark may
hold its speed for a while and then resume, or come so long after the one before it.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np

from scegen.concretization.profile import NEVER_S, Profile, Sort, SpeedChange
from scegen.motion.model import Array

_LONGEST_S, _LEAST_MPS = 240.0, 0.5
_SAME_MPS = 1e-3
_KEPT = 256
"""Courses that are kept: the same are driven for every place in line that is tried."""


@dataclass(frozen=True, eq=False)
class Course:
    """When a lone vehicle that starts at the outer end of its path is where, at which speed."""

    phases: tuple[SpeedChange, ...]
    profile: Profile
    length_m: float

    @cached_property
    def ends_s(self) -> float:
        """When it is at the end of its path, or at rest for good."""
        there_s = self.profile.time_s(self.length_m)
        return min(there_s if there_s < NEVER_S else self.profile.times_s[-1], _LONGEST_S)

    @cached_property
    def ends_m(self) -> float:
        """Where it is then."""
        return self.profile.way_m(self.ends_s)

    @cached_property
    def fastest_mps(self) -> float:
        """The greatest of its speeds: those at which its phases begin and end."""
        return max(map(self.speed_then, (*self.profile.times_s, self.ends_s)))

    def time_at(self, s_m: float) -> float:
        """When it first reaches ``s_m``; before its start and behind its end at steady speed."""
        beyond = max(s_m - self.ends_m, 0.0) / max(self.speed_then(self.ends_s), _LEAST_MPS)
        return float(self.times_at(np.array(s_m))) + beyond

    def times_at(self, s_m: Array) -> Array:
        """The same for many places up to its end."""
        before = np.minimum(s_m, 0.0) / max(self.speed_then(0.0), _LEAST_MPS)
        return self.profile.times_at(np.clip(s_m, 0.0, self.ends_m)) + before

    def s_at(self, time_s: float) -> float:
        """Where it is at a time; before the start it approaches at its first speed."""
        if time_s < 0:
            return time_s * self.speed_then(0.0)
        return min(self.profile.way_m(time_s), self.ends_m)

    def speed_at(self, s_m: float) -> float:
        """Its speed where it first reaches ``s_m``."""
        return self.speed_then(self.time_at(s_m))

    def speed_then(self, time_s: float) -> float:
        """Its speed at a time."""
        return self.profile.speed_mps(min(max(time_s, 0.0), self.ends_s))

    def from_then(self, time_s: float) -> list[SpeedChange]:
        """The change of speed under way at a time, and those to come."""
        begun = [phase for phase in self.phases if phase.begins_s <= time_s]
        ready = not begun or abs(self.speed_then(time_s) - begun[-1].target_mps) < _SAME_MPS
        return [*([] if ready else begun[-1:]), *self.phases[len(begun) :]]

    @property
    def going_on(self) -> SpeedChange | None:
        """Its first setting off again after a stop."""
        return next((phase for phase in self.phases if phase.sort is Sort.GOES_ON), None)

    @property
    def stop(self) -> SpeedChange | None:
        """Its first slowing down to a stop."""
        return next((phase for phase in self.phases if phase.target_mps == 0.0), None)

    def phase_of(self, act: str) -> SpeedChange | None:
        """The phase that an act of the text is, if it is carried out."""
        return next((phase for phase in self.phases if phase.act == act), None)


class _Driving:
    """A lone drive while it is being worked out: what is wanted, and what a bend allows."""

    def __init__(self, speed_mps: float) -> None:
        self.profile = Profile(speed_mps)
        self.phases: list[SpeedChange] = []
        self.target = speed_mps
        self.ready_s = 0.0
        self.wanted: float | None = None
        self.bend: float | None = None

    def fire(self, mark: SpeedChange, time_s: float) -> None:
        """Carry a mark out."""
        target = mark.target_mps
        if mark.sort is Sort.ACT:
            self.wanted = target
        if mark.sort is Sort.SLOWS:
            self.bend = (mark.then or mark).target_mps
        elif mark.sort is Sort.FREES:
            self.bend = None
        by_road = mark.sort in {Sort.SLOWS, Sort.FREES}
        if self.wanted is not None and mark.sort is not Sort.DANGER:
            bend = self.bend if mark.then is None else target
            target = min(self.wanted, self.wanted if bend is None else bend)
            if by_road and abs(target - self.target) < _SAME_MPS:
                return
        self._change(mark, time_s, target)
        if mark.then is not None:
            again = self.profile.settles_s(time_s) + (mark.then.then_s or 0.0)
            onward = mark.then.target_mps
            if mark.sort is Sort.SLOWS and self.wanted is not None:
                onward = min(onward, self.wanted)
            self._change(mark.then, again, onward)

    def place_m(self, mark: SpeedChange, others: Sequence[SpeedChange]) -> float:
        """Where a mark is carried out, as fast as it is by then.

        The road does not slow down whom an act that is to come makes slow enough in time.
        """
        if mark.sort is not Sort.SLOWS:
            return mark.s_m
        change = max(self.target**2 - mark.target_mps**2, 0.0)
        for act in others:
            slower = act.sort is Sort.ACT and act.target_mps <= mark.target_mps
            if slower and act.s_m + change / (2 * act.rate_mps2) <= mark.by_m:
                return mark.by_m
        return max(mark.by_m - change / (2 * mark.rate_mps2), self._gaining_m(mark))

    def _gaining_m(self, mark: SpeedChange) -> float:
        """Where one who still gains speed must begin to slow down; 0 if it does not."""
        if not self.phases:
            return 0.0
        speed, place = self.profile.speed_mps(self.ready_s), self.profile.way_m(self.ready_s)
        gains, slows = self.phases[-1].rate_mps2, mark.rate_mps2
        if self.target <= speed + _SAME_MPS:
            return 0.0
        left = 2 * slows * (mark.by_m - place) - speed**2 + mark.target_mps**2
        further = max(0.0, left / (2 * (gains + slows)))
        gained = (self.target**2 - speed**2) / (2 * gains)
        return place + further if further < gained else 0.0

    def _change(self, mark: SpeedChange, begins_s: float, target_mps: float) -> None:
        speed, rate = self.profile.speed_mps(begins_s), mark.rate_mps2
        stood_s = mark.then_s if speed < _SAME_MPS else None
        if mark.sort is Sort.SLOWS and target_mps > speed and self.phases:
            rate = self.phases[-1].rate_mps2  # one who still gains speed gains it as before
        self.profile.change(begins_s, target_mps, rate)
        place, self.target, self.ready_s = self.profile.way_m(begins_s), target_mps, begins_s
        self.phases.append(
            replace(
                mark, rate_mps2=rate, begins_s=begins_s, s_m=place, target_mps=target_mps,
                then_s=stood_s,
            )
        )  # fmt: skip


@lru_cache(maxsize=_KEPT)
def course_of(marks: tuple[SpeedChange, ...], speed_mps: float, length_m: float) -> Course:
    """Drive alone along a path of ``length_m`` from its outer end."""
    drive = _Driving(speed_mps)
    placed = [mark for mark in marks if mark.then_s is None]
    chained = [mark for mark in marks if mark.then_s is not None]
    acted = False
    while placed or (chained and acted):
        soon = [
            (max(drive.profile.time_s(drive.place_m(mark, placed)), drive.ready_s), mark)
            for mark in placed
        ]
        if chained and acted:
            ends = drive.profile.settles_s(drive.ready_s)
            soon.append((ends + (chained[0].then_s or 0.0), chained[0]))
        time_s, mark = min(soon, key=lambda each: each[0])
        if time_s >= NEVER_S:
            break
        (placed if mark.then_s is None else chained).remove(mark)
        drive.fire(mark, time_s)
        acted |= mark.sort is Sort.ACT
    return Course(tuple(drive.phases), drive.profile, length_m)

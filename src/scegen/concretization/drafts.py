"""What is known of a scenario while its numbers are being chosen."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from math import sqrt
from typing import NamedTuple

from scegen.concretization.courses import Course, course_of
from scegen.concretization.limits import (
    COMFORTABLE_ACCELERATION_MPS2,
    COMFORTABLE_BRAKING_MPS2,
    CREEP_MPS,
    LATERAL_MPS2,
    STOPS_FOR_S,
)
from scegen.concretization.profile import Sort, SpeedChange
from scegen.motion.friction import GRAVITY_MPS2
from scegen.motion.model import Path
from scegen.motion.paths import lay_towards
from scegen.motion.polyline import LaidDrive
from scegen.motion.trigger_steps import just_before_step_s
from scegen.road.model import RoadNetwork
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import DriveMotion, LaneChange
from scegen.scenario.logical import Drive
from scegen.scenario.reversing import BacksOut, Reversal
from scegen.scenario.vocabulary import Maneuver

_SIDEWAYS = 0.9
"""The share of the grip that a bend may take."""
_WORTH_IT, _ENDS_M, _NEAR_S = 0.98, 1.0, 3.0
_SHORT_M = 1.0
"""From the front bumper of one who stops to the stop line, and as early before a bend."""


class Wait(NamedTuple):
    """How long one stands at its line, at red or until ``lets_by`` has passed.

    Below 0: it goes on before it has come to rest.
    """

    time_s: float
    lets_by: str | None = None


@dataclass(eq=False)
class DriveDraft:
    """A vehicle's drive in the making.

    ``speed_mps`` is its speed away from turns, ``joins_mps`` after them where that is faster;
    ``marks`` what dangers add to its program, ``steps`` what the text says that it does; ``laid``
    and ``course`` its way and its timeline from the outer end of the entry arm; ``start_m`` where
    on that path it starts at time 0. It keeps ``offset_m`` to its own left of the middle of its
    lane.
    ``grip_mps2`` is what the tyres hold on this road, ``halts_s_m`` where a thing in its way ends
    it, ``parked_s_m`` where it stood beside the road at first.
    ``reversal`` is a part driven backwards; one that backs out (of arm ``from_arm``, if not from
    beside the road) joins its drive at station ``joins_m``. Within ``alone_s_m`` of its path only
    the marks of dangers count. ``backs_to`` is somebody who crosses behind it. ``waits`` at
    its line, or ``queues_m`` before it, behind who does so there. ``offset_s`` is how late it is
    against its course.
    """

    id: str
    body: Body
    drive: Drive
    speed_mps: float
    entry_lane: int = 1
    exit_lane: int = 1
    ring_lane: int | None = None
    joins_mps: float = 0.0
    lateral_mps2: float = LATERAL_MPS2
    stops_at_line: bool = False
    lane_changes: list[LaneChange] = field(default_factory=list)
    marks: list[SpeedChange] = field(default_factory=list)
    steps: list[SpeedChange] = field(default_factory=list)
    offset_m: float = 0.0
    start_m: float = 0.0
    offset_s: float = 0.0
    grip_mps2: float = GRAVITY_MPS2
    halts_s_m: float | None = None
    parked_s_m: float | None = None
    reversal: Reversal | None = None
    joins_m: float = 0.0
    from_arm: int | None = None
    backs_to: str | None = None
    alone_s_m: tuple[float, float] | None = None
    laid_: LaidDrive | None = None
    waits: Wait | None = None
    queues_m: float = 0.0

    def braking_mps2(self, wanted_mps2: float) -> float:
        """How hard it brakes if it wants to so much: as hard as its brakes and tyres can."""
        return min(wanted_mps2, self.body.max_deceleration_mps2, self.grip_mps2)

    def acceleration_mps2(self, wanted_mps2: float) -> float:
        """The same for speeding up."""
        return min(wanted_mps2, self.body.max_acceleration_mps2, self.grip_mps2)

    def timing(self) -> Callable[[SpeedChange, float], SpeedChange]:
        """What puts a step where it is at a moment, as it drives now."""
        course, late_s = self.course, self.offset_s
        return lambda step, time_s: replace(
            step, s_m=course.s_at(just_before_step_s(time_s) - late_s)
        )

    def after(self, step: SpeedChange, then_s: float) -> SpeedChange:
        """A step that comes so long after the one before it is over."""
        return replace(step, then_s=then_s)

    @property
    def laid(self) -> LaidDrive:
        """Its way from the outer end of its entry arm."""
        if self.laid_ is None:
            msg = f"{self.id} has not been laid out"
            raise RuntimeError(msg)
        return self.laid_

    @property
    def path(self) -> Path:
        """Its line."""
        return self.laid.path

    @property
    def course(self) -> Course:
        """When it is where if it starts at the outer end of its entry arm."""
        first_mps = CREEP_MPS if self.backs_out else self.speed_mps
        return course_of(tuple(self.speed_changes()), first_mps, self.path.length_m)

    @property
    def junction_s_m(self) -> float:
        """Arc length at the inner end of the entry arm."""
        return self.laid.path_s_m(self.laid.turning_starts_m)

    @property
    def stop_line_s_m(self) -> float:
        """Arc length at the stop line of the entry arm."""
        return self.junction_s_m - self.laid.stretches[0].road.stop_line_m

    @property
    def waits_s_m(self) -> float:
        """Arc length where it waits for green, or before it goes over the line."""
        return self.stop_line_s_m - self.body.front_m - self.queues_m

    @property
    def arrives_s_m(self) -> float:
        """Where its approach ends: at the junction, or before a thing in its way."""
        return self.junction_s_m if self.halts_s_m is None else self.halts_s_m

    def motion(self, start_m: float = 0.0) -> DriveMotion:
        """The drive as written to files."""
        laid = self.laid_
        start_m = self.joins_m if self.backs_out else start_m
        return DriveMotion(
            entry=self.drive.entry,
            entry_lane=self.entry_lane,
            exit=self.drive.exit,
            exit_lane=self.exit_lane,
            ring_lane=self.ring_lane,
            start_m=round(start_m, 3),
            offset_m=round(self.offset_m, 3),
            turning_starts_m=round(laid.turning_starts_m, 3) if laid else 0.0,
            turning_ends_m=round(laid.turning_ends_m, 3) if laid else 0.0,
            lane_changes=tuple(self.lane_changes),
            reversal=self.reversal,
        )

    def gone_m(self, time_s: float) -> float:
        """How far it has come at a time of the scenario."""
        return self.course.s_at(time_s - self.offset_s) - self.start_m

    def speed_at_mps(self, time_s: float) -> float:
        """Its speed at a time of the scenario; 0 at the end of its way."""
        left_m = self.path.length_m - self.start_m - self.gone_m(time_s)
        return self.course.speed_then(time_s - self.offset_s) if left_m > _ENDS_M else 0.0

    @property
    def stands(self) -> bool:
        """Whether it is said to stand all the time."""
        return self.drive.maneuver is Maneuver.STAY

    @property
    def start_s(self) -> float:
        """When it starts, on the clock of its course."""
        return 0.0 if self.backs_out else max(0.0, -self.offset_s)

    @property
    def backs_out(self) -> bool:
        """Whether it starts beside the road or on a side arm, to come out backwards."""
        return isinstance(self.reversal, BacksOut)

    def lay(self, network: RoadNetwork) -> None:
        """Lay the drive out anew, after lanes or lane changes have changed."""
        self.lane_changes.sort(key=lambda change: change.position_m)
        motion = self.motion()
        self.laid_, self.exit_lane = lay_towards(network, motion, self.id)

    def hold(self, mark: SpeedChange, holds_s: float) -> None:
        """Add a mark of a danger; held for so long, the speed in force there is resumed."""
        speed = self.speed_mps
        for each in self.road_changes():
            if each.s_m <= mark.s_m:
                speed = (each.then or each).target_mps
        faster = self.acceleration_mps2(COMFORTABLE_ACCELERATION_MPS2)
        on = SpeedChange(speed, faster, sort=Sort.GOES_ON, then_s=holds_s)
        self.marks.append(replace(mark, then=on))

    def road_changes(self) -> list[SpeedChange]:
        """Slowing down for bends and at stop lines (red, a sign), and speeding up after them.

        The comfortable speed in a bend is sqrt(lateral acceleration * radius) of the lane driven;
        through bends that are too narrow for ``speed_mps``, and near each other, the least of
        these is kept.
        """
        lateral = min(self.lateral_mps2, _SIDEWAYS * self.grip_mps2)
        faster = self.acceleration_mps2(COMFORTABLE_ACCELERATION_MPS2)
        limits = ((begin, end, sqrt(lateral * radius)) for begin, end, radius in self.laid.bends)
        narrow: list[tuple[float, float, float]] = []
        for begin, end, speed in limits:
            if speed >= self.speed_mps * _WORTH_IT:
                continue
            near = narrow and begin - narrow[-1][1] < _NEAR_S * self.speed_mps
            first, _, slowest = narrow.pop() if near else (begin, end, speed)
            narrow.append((first, end, min(speed, slowest)))
        marks = [self._slow_before(begin, speed) for begin, _, speed in narrow]
        if self.stops_at_line or self.waits is not None:
            stands_s = STOPS_FOR_S if self.waits is None else self.waits.time_s
            speed = narrow[0][2] if narrow else self.speed_mps
            on = SpeedChange(speed, faster, sort=Sort.GOES_ON, then_s=stands_s)
            marks[:1] = [self._slow_before(self.waits_s_m, 0.0, on)]
        on_mps = max(self.speed_mps, self.joins_mps)
        marks += [SpeedChange(on_mps, faster, s_m=end, sort=Sort.FREES) for _, end, _ in narrow]
        return marks

    def _slow_before(
        self, s_m: float, to_mps: float, then: SpeedChange | None = None
    ) -> SpeedChange:
        rate, by_m = min(COMFORTABLE_BRAKING_MPS2, self.grip_mps2), s_m - _SHORT_M
        begins_m = max(0.0, by_m - (self.speed_mps**2 - to_mps**2) / (2 * rate))
        return SpeedChange(to_mps, rate, s_m=begins_m, sort=Sort.SLOWS, then=then, by_m=by_m)

    def speed_changes(self) -> list[SpeedChange]:
        """All marks in the order of the path."""
        low, high = self.alone_s_m or (1.0, 0.0)
        ordinary = [mark for mark in self.road_changes() if not low <= mark.s_m <= high]
        return sorted([*ordinary, *self.marks, *self.steps], key=lambda mark: mark.s_m)

"""The reference simulator: one obvious loop that follows esmini's laws.

In every step the speeds change first and the positions move by the new speed times dt; then the
conditions are looked at. An action whose condition holds for the first time at a step changes the
state from the next step on. At most one phase of a participant fires in a step.
"""

from collections.abc import Mapping
from dataclasses import astuple, dataclass, field
from math import hypot, inf, radians

import numpy as np

from scegen.motion.footprints import box_corners
from scegen.motion.model import NEGLIGIBLE, STANDING_MPS, Array, Path, Trace
from scegen.road.geometry import Pose
from scegen.scenario.concrete import (
    ArrivalBelow,
    AtTime,
    ConcreteParticipant,
    ConcreteScenario,
    OnContact,
    SpeedPhase,
    StoodStill,
    Travelled,
    Trigger,
)

_ROUNDING = 1e-9


@dataclass
class _Mover:
    """A participant while it moves; ``s_log`` and ``v_log`` hold one value per step."""

    participant: ConcreteParticipant
    path: Path
    speed_mps: float
    s_m: float = 0.0
    fired: int = 0
    stands_since_s: float = inf
    active: SpeedPhase | OnContact | None = None
    s_log: list[float] = field(default_factory=list)
    v_log: list[float] = field(default_factory=list)

    def __post_init__(self) -> None:
        if self.path.length_m == 0.0:
            self.speed_mps = 0.0

    def record(self, time_s: float) -> None:
        self.s_log.append(self.s_m)
        self.v_log.append(self.speed_mps)
        standing = self.speed_mps < STANDING_MPS
        self.stands_since_s = min(self.stands_since_s, time_s) if standing else inf

    def move(self, dt_s: float) -> None:
        """Change speed, then position; stop for good at the end of the path."""
        if self.active is not None:
            target = 0.0 if isinstance(self.active, OnContact) else self.active.target_speed_mps
            step = self.active.rate_mps2 * dt_s
            gap = target - self.speed_mps
            self.speed_mps = target if abs(gap) <= step else self.speed_mps + np.sign(gap) * step
        self.s_m += self.speed_mps * dt_s
        if self.s_m >= self.path.length_m:
            self.s_m, self.speed_mps, self.active = self.path.length_m, 0.0, None
            self.fired = len(self.participant.speed_program)

    @property
    def here(self) -> Pose:
        return self.path.pose(self.s_m)

    @property
    def box(self) -> Array:
        """The corners of its box where it is."""
        return box_corners(self.participant.body, *astuple(self.here))


@dataclass
class _Guest(_Mover):
    """One who is moved from outside: ``after`` is its pose and speed (m/s) after the next step."""

    after: tuple[Pose, float] | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        self._pose = self.path.pose(0.0)
        self.fired = len(self.participant.speed_program)

    def move(self, dt_s: float) -> None:
        if self.after is None:
            super().move(dt_s)
            self._pose = self.path.pose(self.s_m)
            return
        before = self._pose
        self._pose, self.speed_mps = self.after
        self.s_m += hypot(self._pose.x_m - before.x_m, self._pose.y_m - before.y_m)
        self.after = None

    @property
    def here(self) -> Pose:
        return self._pose


def simulate(
    concrete: ConcreteScenario, paths: Mapping[str, Path], *, dt_s: float = 0.05
) -> dict[str, Trace]:
    """Run a scenario from 0 to ``duration_s``; the traces have the same times.

    A participant that reaches the end of its path stops there with speed 0.

    Args:
        concrete: the scenario.
        paths: its paths by participant, as :func:`scegen.motion.build_paths` makes them.
        dt_s: the time step.
    """
    steps = Steps(concrete, paths, dt_s=dt_s)
    for _ in range(round(concrete.duration_s / dt_s)):
        steps.advance()
    return steps.traces()


class Steps:
    """A scenario that is simulated step by step, from time 0 on; one may be moved from outside."""

    def __init__(
        self,
        concrete: ConcreteScenario,
        paths: Mapping[str, Path],
        *,
        dt_s: float = 0.05,
        outside: str | None = None,
    ) -> None:
        self.dt_s = dt_s
        self._step = 0
        self._movers = {
            p.id: (_Guest if p.id == outside else _Mover)(p, paths[p.id], p.speed_mps)
            for p in concrete.participants
        }
        self._things = {
            o.id: box_corners(o.body, o.x_m, o.y_m, radians(o.heading_deg))
            for o in concrete.objects
        }
        self._look()

    @property
    def time_s(self) -> float:
        """The present time."""
        return self._step * self.dt_s

    def placed(self) -> dict[str, tuple[Pose, float]]:
        """Pose of the reference point and speed (m/s) of everybody."""
        return {name: (mover.here, mover.speed_mps) for name, mover in self._movers.items()}

    def put(self, name: str, pose: Pose, speed_mps: float) -> None:
        """Say where the one who is moved from outside is after the next step.

        Raises:
            KeyError: nobody of this name is moved from outside.
        """
        mover = self._movers[name]
        if not isinstance(mover, _Guest):
            raise KeyError(name)
        mover.after = pose, speed_mps

    def advance(self) -> None:
        """Go one step on: speeds, then places, then what follows from them."""
        self._step += 1
        for mover in self._movers.values():
            mover.move(self.dt_s)
        self._look()

    def traces(self) -> dict[str, Trace]:
        """Everybody's movement until now; one who is moved from outside keeps to its path."""
        times = np.arange(self._step + 1, dtype=np.float64) * self.dt_s
        return {name: _trace(mover, times) for name, mover in self._movers.items()}

    def _look(self) -> None:
        """What everybody sees, all at the same moment."""
        for mover in self._movers.values():
            mover.record(self.time_s)
        for mover in self._movers.values():
            self._collide(mover)
            program = mover.participant.speed_program
            if mover.fired < len(program):
                phase = program[mover.fired]
                if _holds(phase.trigger, mover, self._movers, self.time_s):
                    mover.active = phase
                    mover.fired += 1

    def _collide(self, mover: _Mover) -> None:
        """Whom a collision brings to rest does nothing else from then on."""
        struck = mover.participant.on_contact
        if struck is None or isinstance(mover.active, OnContact) or isinstance(mover, _Guest):
            return
        other = self._movers.get(struck.participant)
        boxes = mover.box, other.box if other is not None else self._things[struck.participant]
        if _touch(*boxes):
            mover.active = struck
            mover.fired = len(mover.participant.speed_program)


def _holds(trigger: Trigger, owner: _Mover, movers: Mapping[str, _Mover], time_s: float) -> bool:
    """Whether a phase's condition is true in the present state."""
    if isinstance(trigger, AtTime):
        return time_s >= trigger.time_s - _ROUNDING
    other = movers[trigger.participant]
    if isinstance(trigger, Travelled):
        return other.s_m >= trigger.distance_m - _ROUNDING
    if isinstance(trigger, StoodStill):
        return time_s - other.stands_since_s >= trigger.duration_s - _ROUNDING
    here = other.here
    if isinstance(trigger, ArrivalBelow):
        place = other.path.pose(trigger.place_m)
        return bool(arrivals_s(here, other.speed_mps, place) < trigger.time_s)
    return hypot(owner.here.x_m - here.x_m, owner.here.y_m - here.y_m) < trigger.distance_m


def _touch(one: Array, other: Array) -> bool:
    """Whether two rectangles share a point: seen along no side of either they lie apart."""
    for box in (one, other):
        for side in (box[1] - box[0], box[3] - box[0]):
            first, second = one @ side, other @ side
            if first.max() < second.min() or second.max() < first.min():
                return False
    return True


def arrivals_s(who: Pose | Trace, speed_mps: Array | float, place: Pose) -> Array:
    """When one who is there is at a place if it goes straight to it at its speed; inf: never."""
    dx, dy = place.x_m - who.x_m, place.y_m - who.y_m
    away = np.hypot(dx, dy)
    ahead = dx * np.cos(who.heading_rad) + dy * np.sin(who.heading_rad) > 0.0
    defined = ahead & (away >= NEGLIGIBLE) & (np.asarray(speed_mps) >= NEGLIGIBLE)
    return np.where(defined, away / np.maximum(speed_mps, NEGLIGIBLE), np.inf)


def _trace(mover: _Mover, times: Array) -> Trace:
    who, s = mover.participant, np.array(mover.s_log)
    return Trace(who.id, who.body, times, s, *mover.path.places(s), np.array(mover.v_log))

"""Who is along the road, as a movement in time: speed in steps, and moves to the side.

One axis runs along the road in the ego's direction (``x``, m), one to the ego's left of the centre
line (``y``, m). Times count from the start of the scenario (s).
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import lru_cache
from itertools import takewhile
from math import pi

import numpy as np

from scegen.claims.boxes import Boxes, around
from scegen.concretization.profile import Profile, SpeedChange
from scegen.motion.model import Array
from scegen.scenario.bodies import Body
from scegen.scenario.junction import MAX_LANES
from scegen.scenario.roadway import LANE_WIDTH_M
from scegen.scenario.vocabulary import HazardKind, ParticipantKind

FORTH_M, FORTH_MPS = 0.4, 0.5
"""One that reverses goes so far forwards first, at most so fast: esmini takes a trajectory's sense
from how it begins."""
_TURNS_MPS, _MOST_TURNED = 0.5, 0.9
"""Who is slower does not turn its body to the side; the greatest sine of its angle to the road."""


@dataclass(frozen=True, slots=True)
class Move:
    """From ``begins_s`` on, for ``lasts_s``, into ``lane``, ``offset_m`` left of its centre."""

    begins_s: float
    lasts_s: float
    lane: int
    offset_m: float = 0.0
    act: str | None = None
    hazard: HazardKind | None = None

    @property
    def ends_s(self) -> float:
        """When it is there."""
        return self.begins_s + self.lasts_s


@dataclass
class Runner:
    """One along the road, of any kind: driving, walking or standing.

    ``at_m`` is where its reference point starts, None while that is open; ``lane`` counts from the
    centre line outwards in its own direction (0: the oncoming lane), ``offset_m`` is to its own
    left of the lane's centre. ``thing``: it is no participant, ``keeps_left`` the side of the
    traffic, ``inner_m`` how far the lanes lie from the centre line (half a median),
    ``lane_width_m`` and ``lane_count`` how wide and how many they are and ``strips_m`` how far
    beyond them the middles of the strips lie whose numbers follow theirs.
    One that ``backs`` reverses from the start on, after the ``FORTH_M`` by which players know which
    way it faces. From ``appears_s`` on it is in the way: a door that opens.
    """

    id: str
    kind: ParticipantKind
    body: Body
    forward: bool
    lane: int
    speed_mps: float
    offset_m: float = 0.0
    at_m: float | None = None
    steps: list[SpeedChange] = field(default_factory=list)
    moves: list[Move] = field(default_factory=list)
    thing: bool = False
    keeps_left: bool = False
    inner_m: float = 0.0
    lane_width_m: float = LANE_WIDTH_M
    lane_count: int = MAX_LANES
    strips_m: tuple[float, ...] = ()
    backs: bool = False
    appears_s: float = 0.0

    @property
    def sign(self) -> int:
        """1 in the ego's direction, -1 against it."""
        return 1 if self.forward else -1

    @property
    def towards(self) -> int:
        """1 if it moves in the ego's direction, -1 if against it."""
        return -self.sign if self.backs else self.sign

    @property
    def leading_m(self) -> float:
        """From its reference point to the end of its box that comes first."""
        return self.body.rear_m if self.backs else self.body.front_m

    @property
    def opens(self) -> bool:
        """Whether it is the door of one who is parked."""
        return self.kind is ParticipantKind.DOOR

    @property
    def stands(self) -> bool:
        """Whether it never moves."""
        return self.speed_mps == 0.0 and not self.steps

    @property
    def fastest_mps(self) -> float:
        """The greatest speed that it ever has."""
        return max([self.speed_mps, *(step.target_mps for step in self.steps)])

    def timing(self) -> Callable[[SpeedChange, float], SpeedChange]:
        """What lets a step begin at a moment."""
        return lambda step, time_s: replace(step, begins_s=time_s)

    def after(self, step: SpeedChange, then_s: float) -> SpeedChange:
        """A step that comes so long after the others are over."""
        ends_s = max((self.profile.settles_s(s.begins_s) for s in self.steps), default=0.0)
        return replace(step, begins_s=ends_s + then_s)

    def shift(self, left_m: float) -> None:
        """Go so far to its left of what it did until it first leaves its lane."""
        self.offset_m += left_m
        own = sum(1 for _ in takewhile(lambda move: move.lane == self.lane, self.moves))
        moved = [replace(move, offset_m=move.offset_m + left_m) for move in self.moves[:own]]
        self.moves = [*moved, *self.moves[own:]]

    @property
    def profile(self) -> Profile:
        """Its way over time."""
        return _profile(self.speed_mps, tuple(sorted(self.steps, key=lambda s: s.begins_s)))

    def track(self, times_s: Array) -> tuple[Boxes, Array]:
        """Its boxes over time, turned as it moves to the side, and its speeds."""
        way, speed = self.profile.at_times(times_s)
        y, aside, lost = self._sideways(times_s)
        x = self._place_m(way - lost)
        turned = np.where(speed > _TURNS_MPS, aside / np.maximum(speed, _TURNS_MPS), 0.0)
        sin = np.clip(-turned if self.backs else turned, -_MOST_TURNED, _MOST_TURNED)
        cos = self.sign * np.sqrt(1.0 - sin * sin)
        return around(self.body, x, y, cos, sin), speed

    def x_m(self, time_s: float) -> float:
        """Where its reference point is."""
        lost = self._sideways(np.asarray(time_s))[2]
        return float(self._place_m(self.profile.way_m(time_s) - lost))

    def _place_m(self, way_m: Array) -> Array:
        forth = np.minimum(way_m, 2 * FORTH_M - way_m) if self.backs else way_m
        return (self.at_m or 0.0) + self.sign * forth

    def _sideways(self, times_s: Array) -> tuple[Array, Array, Array]:
        """Where its middle is across the road, how fast it goes there, and the way lost to that.

        The arc of a cosine is longer than the road beside it.
        """
        before = self._across_m(self.lane, self.offset_m)
        place = np.full_like(times_s, before, dtype=float)
        rate, lost = np.zeros_like(place), np.zeros_like(place)
        for move in self.moves:
            goal = self._across_m(move.lane, move.offset_m)
            way = self.profile.way_m(move.ends_s) - self.profile.way_m(move.begins_s)
            done = np.clip((times_s - move.begins_s) / move.lasts_s, 0.0, 1.0)
            place += (goal - before) * (1 - np.cos(pi * done)) / 2
            rate += (goal - before) * pi / (2 * move.lasts_s) * np.sin(pi * done)
            bend = (pi * (goal - before)) ** 2 / (8 * max(way, 1.0))
            lost += bend * (done / 2 - np.sin(2 * pi * done) / (4 * pi))
            before = goal
        return place, rate, lost

    def ends_m(self, time_s: float) -> tuple[float, float]:
        """The rear and the front of its box along the road, the lower first."""
        x = self.x_m(time_s)
        front, rear = x + self.sign * self.body.front_m, x - self.sign * self.body.rear_m
        return min(front, rear), max(front, rear)

    @property
    def on_left(self) -> bool:
        """Whether it is on the ego's left of the centre line at first."""
        return self.y_m(0.0) > 0.0

    def middle_m(self, time_s: float) -> float:
        """Where the middle of its box is along the road."""
        return sum(self.ends_m(time_s)) / 2

    def speed_at_mps(self, time_s: float) -> float:
        """Its speed."""
        return self.profile.speed_mps(time_s)

    def gone_m(self, time_s: float) -> float:
        """How far it has come."""
        return self.profile.way_m(time_s)

    def lane_at(self, time_s: float) -> int:
        """The lane it is in, or moves into."""
        lanes = [self.lane, *(m.lane for m in self.moves if m.begins_s <= time_s)]
        return lanes[-1]

    def y_m(self, time_s: float) -> float:
        """Where its middle is across the road, to the ego's left of the centre line."""
        return float(self._sideways(np.asarray(time_s))[0])

    def lane_y_m(self, lane: int) -> float:
        """Where the middle of a lane is across the road."""
        return self._across_m(lane, 0.0)

    def _across_m(self, lane: int, offset_m: float) -> float:
        outward = 1 if self.keeps_left else -1
        inner_m = self.inner_m if lane >= 1 else -self.inner_m
        beyond = lane - self.lane_count
        aside = (lane - 0.5) * self.lane_width_m
        if beyond > 0 and self.strips_m:
            aside = self.lane_count * self.lane_width_m + self.strips_m[beyond - 1]
        return self.sign * (offset_m + outward * (aside + inner_m))


@lru_cache(maxsize=256)
def _profile(speed_mps: float, steps: tuple[SpeedChange, ...]) -> Profile:
    profile = Profile(speed_mps)
    for step in steps:
        profile.change(step.begins_s, step.target_mps, step.rate_mps2)
    return profile

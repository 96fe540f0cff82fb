"""What claims look at: movements of many candidates and their measures.

All series are arrays (candidate, time); all results (candidate,).
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass, field, replace
from functools import wraps
from math import nan
from typing import Concatenate, ParamSpec, TypeVar, cast

import numpy as np

from scegen.claims.series import filled, first
from scegen.claims.straightened import axis_of, straightened
from scegen.claims.ways import Way
from scegen.measures.distance import distances_at
from scegen.measures.evaluation import Summary, measure
from scegen.measures.following import gaps_behind
from scegen.measures.grounds import Ground
from scegen.measures.tables import Tables
from scegen.motion.batch.arrays import HEADING, SPEED, BatchTraces, Floats, Ints, S, X, Y
from scegen.motion.model import Path
from scegen.road.geometry import Pose
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import ConcreteScenario

P = ParamSpec("P")
T = TypeVar("T")


def kept(function: Callable[Concatenate[View, P], T]) -> Callable[Concatenate[View, P], T]:
    """A function of a view, worked out only the first time that the same is asked of it."""

    @wraps(function)
    def answer(view: View, /, *args: P.args, **kwargs: P.kwargs) -> T:
        key = (function, *args, *kwargs.items())
        return view.once(key, lambda: function(view, *args, **kwargs))

    return answer


@dataclass(frozen=True)
class View:
    """Movements, measures and ways of one batch; ``friction`` as in ``build_tables``.

    ``ends_s`` (c,) is when each candidate is over, None where all movements count. What several
    ask for is worked out ``once``.
    """

    concrete: ConcreteScenario
    ways: Mapping[str, Way]
    scene: Tables
    traces: BatchTraces
    summary: Summary
    index: Mapping[str, int]
    pairs: Mapping[tuple[int, int], int]
    friction: float
    ends_s: Floats | None = None
    _known: dict[Hashable, object] = field(default_factory=dict, compare=False)

    def once(self, key: Hashable, make: Callable[[], T]) -> T:
        """What ``make`` gives, which is called the first time only."""
        if key not in self._known:
            self._known[key] = make()
        return cast("T", self._known[key])

    @property
    def dt_s(self) -> float:
        """The time step."""
        return self.traces.dt_s

    @property
    def count(self) -> int:
        """The number of candidates."""
        return int(self.traces.tracks.shape[0])

    @property
    def steps(self) -> int:
        """The number of time steps."""
        return int(self.traces.tracks.shape[3])

    @property
    def last_step(self) -> Ints:
        """The step in which each candidate is over (c,)."""
        last = self.steps - 1
        if self.ends_s is None:
            return np.full(self.count, last)
        return np.minimum(np.rint(self.ends_s / self.dt_s), last).astype(np.int64)

    def time_of(self, step: Ints) -> Floats:
        """The time of steps, s."""
        return np.asarray(step * self.dt_s, dtype=np.float64)

    def step_of(self, time_s: Floats) -> Ints:
        """The step nearest to a time; the first where the time is undefined."""
        return np.asarray(np.rint(filled(time_s, 0.0) / self.dt_s), dtype=np.int64)

    def body(self, name: str) -> Body:
        """The body of a participant or a thing."""
        number, people = self.index[name], self.concrete.participants
        if number < len(people):
            return people[number].body
        return self.concrete.objects[number - len(people)].body

    def at_first(self) -> View:
        """The same at the first step alone."""
        first = self.traces._replace(tracks=self.traces.tracks[..., :1].copy())
        return replace(self, traces=first, _known={})

    @property
    def laid(self) -> Floats:
        """The tracks in the frame of the road: where it bends, as on a straight one."""
        axis = self.once("axis", lambda: axis_of(self.concrete))
        tracks = self.traces.tracks
        return tracks if axis is None else self.once("laid", lambda: straightened(axis, tracks))

    def path(self, name: str) -> Path:
        """The way of a participant; that of a thing is the place where it lies."""
        if name in self.ways:
            return self.ways[name].path
        return Path.at(Pose(*(float(self.row(name, row)[0, 0]) for row in (X, Y, HEADING))))

    def row(self, name: str, row: int) -> Floats:
        """A row of a participant's track (see ``BatchTraces``)."""
        return self.traces.tracks[:, self.index[name], row]

    def place_m(self, name: str) -> Floats:
        """Positions along its path."""
        return self.row(name, S)

    @kept
    def speed_mps(self, name: str) -> Floats:
        """Speeds, forwards or backwards."""
        return np.abs(self.row(name, SPEED))

    def of_pair(self, field: str, first: str, second: str) -> Floats:
        """A measure of a pair; nan if it is not measured."""
        found = self.pair(first, second)
        if found is None:
            return np.full(self.count, nan)
        values: Floats = getattr(self.summary, field)[:, found[0]]
        return values if values.ndim == 1 else values[:, found[1]]

    def distance_m(self, first: str, second: str, steps: Ints) -> Floats:
        """The distance of two at some steps of each candidate (c, n)."""
        pair = np.array([self.index[first], self.index[second]])
        return distances_at(self.traces.tracks, self.scene.bodies, pair, steps)

    def pair(self, first: str, second: str) -> tuple[int, int] | None:
        """(number of the pair, which of it is ``first``); None if it is not measured."""
        i, j = self.index[first], self.index[second]
        if (i, j) in self.pairs:
            return self.pairs[i, j], 0
        if (j, i) in self.pairs:
            return self.pairs[j, i], 1
        return None

    def names_of(self, pair: int) -> tuple[str, str]:
        """Who the two of a pair are."""
        first, second = (self.concrete.entities[i].id for i in self.scene.pairs[pair])
        return first, second

    def touching(self, candidate: int = 0) -> list[int]:
        """The pairs that touch in a candidate."""
        return np.flatnonzero(~np.isnan(self.summary.contact_s[candidate])).tolist()

    def rows_behind(self, follower: str, leader: str) -> int:
        """Where the rows of these two begin (see ``FollowTable``); -1: they share no corridor."""
        found = self.pair(follower, leader)
        return -1 if found is None else int(self.scene.following.first[found])

    def gap_m(self, follower: str, leader: str) -> Floats:
        """Clear gap along the follower's path; nan where the leader is not ahead in its lane."""
        first, front_m = self.rows_behind(follower, leader), self.body(follower).front_m
        two, rear_m = (self.index[follower], self.index[leader]), self.scene.following.rear_m
        return gaps_behind(self.traces.tracks, *two, front_m, rear_m, first)

    def headway_s(self, follower: str, leader: str) -> Floats:
        """Time headway; inf where there is none (no leader, or the follower stands)."""
        gap, speed = self.gap_m(follower, leader), self.speed_mps(follower)
        return np.where((gap >= 0.0) & (speed >= 1.0), gap / np.maximum(speed, 1.0), np.inf)

    def room_m(self, name: str, other: str) -> Floats:
        """Way left until the other's: the next conflict area or the other's rear; nan: neither."""
        room = self.gap_m(name, other)
        for area in self.areas(name, other):
            left = area.enter_m - self.place_m(name)
            room = np.fmin(room, np.where(left >= 0.0, left, np.nan))
        return room

    @kept
    def reaches_s(self, name: str, place_m: float) -> Floats:
        """When somebody first reaches a place on its path; inf: never (c,)."""
        step = self.beyond(name, np.nextafter(place_m, -np.inf))
        return np.where(step < self.steps, self.time_of(step), np.inf)

    def beyond(self, name: str, place_m: Floats | float, ahead_m: float = 0.0) -> Ints:
        """The first step in which what lies so far ahead of it is beyond a place of its path (c,).

        All steps where it never is.
        """
        return first(self.place_m(name) + ahead_m > np.full(self.count, place_m)[:, None])

    def areas(self, name: str, other: str) -> list[Ground]:
        """The grounds that two use, in the order of the paths."""
        found, table = self.pair(name, other), self.scene.areas
        if found is None:
            return []
        (p, i), j = found, 1 - found[1]
        rows = slice(int(table.first[p]), int(table.first[p + 1]))
        edges = zip(table.enter_m[rows].tolist(), table.leave_m[rows].tolist(), strict=True)
        return [Ground(come[i], go[i], come[j], go[j]) for come, go in edges]

    def acceleration_mps2(self, name: str, over_s: float) -> Floats:
        """Mean accelerations over a time."""
        n = max(1, round(over_s / self.dt_s))
        speed = self.speed_mps(name)
        return (speed[:, n:] - speed[:, :-n]) / (n * self.dt_s)

    def lateral_mps2(self, name: str) -> Floats:
        """Lateral accelerations on the path."""
        return self.speed_mps(name) ** 2 * self.ways[name].curvature_1pm(self.place_m(name))


def view_of(
    concrete: ConcreteScenario,
    ways: Mapping[str, Way],
    scene: Tables,
    traces: BatchTraces,
    friction: float,
) -> View:
    """What predicates look at, from movements."""
    summary: Summary = measure(traces, scene)
    return View(
        concrete=concrete,
        ways=ways,
        scene=scene,
        traces=traces,
        summary=summary,
        index={entity.id: i for i, entity in enumerate(concrete.entities)},
        pairs={(int(a), int(b)): n for n, (a, b) in enumerate(scene.pairs)},
        friction=friction,
    )

"""Arrays of the batch simulator: what all candidates share, what each varies, what comes out.

They are named tuples, because kernels can read those. Indices: c candidate, t time step,
i participant, k phase (the phases of all participants one after another), v vertex (likewise).
"""

from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]


class TriggerKind(IntEnum):
    """What the trigger of a phase looks at, and its OpenSCENARIO condition.

    TIME: simulation time >= value s (SimulationTimeCondition).
    TRAVELLED: the subject has travelled >= value m (TraveledDistanceCondition).
    DISTANCE_BELOW: straight distance between the reference points of owner and subject < value m
        (RelativeDistanceCondition, euclidian, freespace off).
    ARRIVAL_BELOW: straight distance of the subject to a point ahead of it, divided by its speed,
        < value s (TimeToCollisionCondition with a position as target, freespace off). esmini and
        scenario_runner both use the straight distance, not the one along the road; esmini's is
        undefined once the point lies behind, and below 1e-6 m or m/s.
    STOOD_STILL: the subject has stood for >= value s (StandStillCondition).
    """

    TIME = 0
    TRAVELLED = 1
    DISTANCE_BELOW = 2
    ARRIVAL_BELOW = 3
    STOOD_STILL = 4


class PathTable(NamedTuple):
    """The polylines of all participants; vertices ``first[i]`` to ``first[i+1] - 1`` are i's.

    ``s_m``, ``x_m``, ``y_m``, ``heading_rad``, ``cos`` and ``sin`` of the heading: (v,).
    ``backwards`` (n, 3) are parts that are driven backwards: whose, from and to (m).
    """

    first: Ints
    s_m: Floats
    x_m: Floats
    y_m: Floats
    heading_rad: Floats
    cos: Floats
    sin: Floats
    backwards: Floats


class PhaseTable(NamedTuple):
    """Structure of the speed programs; phases ``first[i]`` to ``first[i+1] - 1`` are i's.

    ``kind`` (a :class:`TriggerKind`), ``subject`` (the participant that the trigger looks at; the
    owner for TIME), and the point of ARRIVAL_BELOW in the world, m: (k,).
    """

    first: Ints
    kind: Ints
    subject: Ints
    point_x_m: Floats
    point_y_m: Floats


class ContactTable(NamedTuple):
    """Whom a collision with whom brings to rest: ``other`` (i,), -1 for nobody.

    ``rate_mps2`` (i,) is how; ``half_length_m``, ``half_width_m`` and ``ahead_m`` (i,), how far the
    box's centre lies before the reference point, are everybody's bodies.
    """

    other: Ints
    rate_mps2: Floats
    half_length_m: Floats
    half_width_m: Floats
    ahead_m: Floats


class Program(NamedTuple):
    """All that candidates share: paths, the structure of the speed programs, collisions."""

    paths: PathTable
    phases: PhaseTable
    contacts: ContactTable


class Candidates(NamedTuple):
    """What varies. Start along the path (m) and initial speed (m/s): (c, i).

    Trigger value (s or m), target speed (m/s) and rate (m/s², > 0) of the phases: (c, k).
    """

    start_m: Floats
    speed_mps: Floats
    trigger: Floats
    target_speed_mps: Floats
    rate_mps2: Floats


S, X, Y, HEADING, COS, SIN, SPEED = range(7)
"""Rows of a track; see :class:`BatchTraces`."""
TRACK_ROWS = 7


class BatchTraces(NamedTuple):
    """Movements; the time of step t is ``t * dt_s``.

    ``tracks`` (c, i, row, t) holds a participant's time series one after another in memory,
    because measures walk along them; kernels take single tracks, (row, t). Everybody else reads
    the properties, arrays (c, t, i) that are views of it. They belong to the reference point
    (rear axle; a pedestrian's centre). Speeds are along the heading: below 0 where somebody
    reverses; positions never fall. ``fired_step`` (c, k) is the step in which a phase's
    trigger came true, -1 for never; the speed changes one step later.
    """

    dt_s: float
    tracks: Floats
    fired_step: Ints

    def _series(self, row: int) -> Floats:
        return self.tracks[:, :, row].swapaxes(1, 2)

    @property
    def time_s(self) -> Floats:
        """Times of the steps, s: (t,)."""
        return np.arange(self.tracks.shape[3], dtype=np.float64) * self.dt_s

    @property
    def s_m(self) -> Floats:
        """Positions from the first vertex of the path, m: a candidate starts at ``start_m``."""
        return self._series(S)

    @property
    def x_m(self) -> Floats:
        """East, m."""
        return self._series(X)

    @property
    def y_m(self) -> Floats:
        """North, m."""
        return self._series(Y)

    @property
    def heading_rad(self) -> Floats:
        """Heading, counter-clockwise from east, unwrapped, rad."""
        return self._series(HEADING)

    @property
    def speed_mps(self) -> Floats:
        """Speed along the heading, m/s; below 0 backwards."""
        return self._series(SPEED)


def empty_traces(
    candidates: int, steps: int, participants: int, phases: int, dt_s: float
) -> BatchTraces:
    """Room for the movements of so many candidates, steps and participants; not initialised."""
    return BatchTraces(
        dt_s=float(dt_s),
        tracks=np.empty((candidates, participants, TRACK_ROWS, steps)),
        fired_step=np.full((candidates, phases), -1, dtype=np.int64),
    )


def mark_backwards(traces: BatchTraces, backwards: Floats) -> None:
    """Turn speeds along the paths into speeds along the headings (see ``PathTable.backwards``)."""
    for who, begins_m, ends_m in backwards:
        track = traces.tracks[:, int(who)]
        track[:, SPEED][(track[:, S] > begins_m) & (track[:, S] <= ends_m)] *= -1.0

"""Arrays of the batch simulator: what all candidates share, what each varies, what comes out.

They are named tuples, because kernels can read those. Indices: c candidate, t time step,
i participant, k phase (the phases of all participants one after another), v vertex (likewise).
"""

from __future__ import annotations

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
    """

    TIME = 0
    TRAVELLED = 1
    DISTANCE_BELOW = 2
    ARRIVAL_BELOW = 3


class PathTable(NamedTuple):
    """The polylines of all participants; vertices ``first[i]`` to ``first[i+1] - 1`` are i's.

    ``s_m``, ``x_m``, ``y_m``, ``heading_rad``, ``cos`` and ``sin`` of the heading: (v,).
    """

    first: Ints
    s_m: Floats
    x_m: Floats
    y_m: Floats
    heading_rad: Floats
    cos: Floats
    sin: Floats


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


class Program(NamedTuple):
    """All that candidates share: paths and the structure of the speed programs."""

    paths: PathTable
    phases: PhaseTable


class Candidates(NamedTuple):
    """What varies. Start along the path (m) and initial speed (m/s): (c, i).

    Trigger value (s or m), target speed (m/s) and rate (m/s², > 0) of the phases: (c, k).
    """

    start_m: Floats
    speed_mps: Floats
    trigger: Floats
    target_speed_mps: Floats
    rate_mps2: Floats


class BatchTraces(NamedTuple):
    """Movements; arrays (c, t, i), the time of step t is ``t * dt_s``.

    ``s_m`` counts from the first vertex of the path, so it starts at the candidate's ``start_m``.
    ``x_m``, ``y_m`` (m), ``heading_rad``, its ``cos`` and ``sin`` and ``speed_mps`` belong to the
    reference point (rear axle; a pedestrian's centre). ``fired_step`` (c, k) is the step in which
    a phase's trigger came true, -1 for never; the speed changes one step later.

    In memory a participant's time series is contiguous, because measures walk along it.
    """

    dt_s: float
    s_m: Floats
    x_m: Floats
    y_m: Floats
    heading_rad: Floats
    cos: Floats
    sin: Floats
    speed_mps: Floats
    fired_step: Ints


def empty_traces(
    candidates: int, steps: int, participants: int, phases: int, dt_s: float
) -> BatchTraces:
    """Room for the movements of so many candidates, steps and participants; not initialised."""

    def room() -> Floats:
        return np.empty((candidates, participants, steps)).transpose(0, 2, 1)

    return BatchTraces(
        dt_s=float(dt_s),
        s_m=room(),
        x_m=room(),
        y_m=room(),
        heading_rad=room(),
        cos=room(),
        sin=room(),
        speed_mps=room(),
        fired_step=np.empty((candidates, phases), dtype=np.int64),
    )

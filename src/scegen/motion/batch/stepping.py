"""One candidate, step by step: the kernel that every batch run consists of.

Same laws and same order as the reference simulator (``scegen.motion.simulation``): speeds first,
positions by the new speed times dt, then the triggers, whose effect begins in the next step.
"""
# ruff: noqa: PLR0917 -- kernels take numbers, not bundles: bundles cost them registers.

from __future__ import annotations

from math import cos, sin, sqrt

import numpy as np

from scegen.motion.batch.arrays import (
    BatchTraces,
    Candidates,
    Floats,
    PathTable,
    PhaseTable,
    Program,
)
from scegen.motion.batch.kernels import kernel

_ROUNDING = 1e-9
"""A time or distance that misses its value by less counts as reached (as in the reference)."""
_NEGLIGIBLE = 1e-6
"""esmini's SMALL_NUMBER: below this distance (m) or speed (m/s) no time to arrival exists."""
_TIME, _TRAVELLED, _DISTANCE_BELOW = 0, 1, 2  # TriggerKind; the last kind is the else branch


@kernel
def run_candidate(
    program: Program, candidates: Candidates, c: int, traces: BatchTraces, row: int
) -> None:
    """Simulate candidate ``c`` and write its movement into ``row`` of the traces."""
    paths, phases = program
    participants = paths.first.shape[0] - 1
    dt = traces.dt_s
    # Travelled distance, speed, target speed, rate (0: no phase active), length left at start.
    state = np.zeros((participants, 5))
    # Vertex at or behind the position, next phase to fire.
    marks = np.zeros((participants, 2), dtype=np.int64)
    for i in range(participants):
        state[i, 4] = paths.s_m[paths.first[i + 1] - 1] - candidates.start_m[c, i]
        state[i, 1] = candidates.speed_mps[c, i] if state[i, 4] > 0.0 else 0.0
        marks[i, 0] = paths.first[i]
        marks[i, 1] = phases.first[i]
    traces.fired_step[row, :] = -1
    for t in range(traces.s_m.shape[1]):
        for i in range(participants):
            if t > 0:
                _move(state, i, dt)
                if state[i, 0] >= state[i, 4]:
                    state[i, 0], state[i, 1], state[i, 3] = state[i, 4], 0.0, 0.0
                    marks[i, 1] = phases.first[i + 1]
            traces.speed_mps[row, t, i] = state[i, 1]
            if t > 0 and state[i, 1] == 0.0 and traces.speed_mps[row, t - 1, i] == 0.0:
                _stay(traces, row, t, i)
            else:
                s = candidates.start_m[c, i] + max(state[i, 0], 0.0)
                traces.s_m[row, t, i] = s
                marks[i, 0] = _place(paths, i, marks[i, 0], s, traces, row, t)
        for i in range(participants):
            k = marks[i, 1]
            if k < phases.first[i + 1] and _holds(
                phases, candidates.trigger[c, k], k, i, state, traces, row, t
            ):
                state[i, 2] = candidates.target_speed_mps[c, k]
                state[i, 3] = candidates.rate_mps2[c, k]
                marks[i, 1] = k + 1
                traces.fired_step[row, k] = t


@kernel
def _move(state: Floats, i: int, dt: float) -> None:
    """Change the speed of participant i towards its target, then its travelled distance."""
    if state[i, 3] > 0.0:
        step = state[i, 3] * dt
        gap = state[i, 2] - state[i, 1]
        if abs(gap) <= step:
            state[i, 1] = state[i, 2]
        elif gap > 0.0:
            state[i, 1] += step
        else:
            state[i, 1] -= step
    state[i, 0] += state[i, 1] * dt


@kernel
def _stay(traces: BatchTraces, row: int, t: int, i: int) -> None:
    """Participant i has not moved in this step."""
    traces.s_m[row, t, i] = traces.s_m[row, t - 1, i]
    traces.x_m[row, t, i] = traces.x_m[row, t - 1, i]
    traces.y_m[row, t, i] = traces.y_m[row, t - 1, i]
    traces.heading_rad[row, t, i] = traces.heading_rad[row, t - 1, i]
    traces.cos[row, t, i] = traces.cos[row, t - 1, i]
    traces.sin[row, t, i] = traces.sin[row, t - 1, i]


@kernel
def _place(
    paths: PathTable, i: int, vertex: int, s: float, traces: BatchTraces, row: int, t: int
) -> int:
    """Write the pose at ``s`` on i's path; returns the vertex at or behind it.

    ``vertex`` is where the search begins: positions only grow.
    """
    last = paths.first[i + 1] - 1
    while vertex < last and paths.s_m[vertex + 1] <= s:
        vertex += 1
    if vertex == last or s <= paths.s_m[vertex]:
        traces.x_m[row, t, i] = paths.x_m[vertex]
        traces.y_m[row, t, i] = paths.y_m[vertex]
        traces.heading_rad[row, t, i] = paths.heading_rad[vertex]
        traces.cos[row, t, i] = paths.cos[vertex]
        traces.sin[row, t, i] = paths.sin[vertex]
        return vertex
    p = (s - paths.s_m[vertex]) / (paths.s_m[vertex + 1] - paths.s_m[vertex])
    traces.x_m[row, t, i] = paths.x_m[vertex] + p * (paths.x_m[vertex + 1] - paths.x_m[vertex])
    traces.y_m[row, t, i] = paths.y_m[vertex] + p * (paths.y_m[vertex + 1] - paths.y_m[vertex])
    turn = paths.heading_rad[vertex + 1] - paths.heading_rad[vertex]
    heading = paths.heading_rad[vertex] + p * turn
    traces.heading_rad[row, t, i] = heading
    # On straights the vertex already knows; sine and cosine are a third of the work.
    traces.cos[row, t, i] = paths.cos[vertex] if turn == 0.0 else cos(heading)
    traces.sin[row, t, i] = paths.sin[vertex] if turn == 0.0 else sin(heading)
    return vertex


@kernel
def _holds(
    phases: PhaseTable,
    value: float,
    k: int,
    i: int,
    state: Floats,
    traces: BatchTraces,
    row: int,
    t: int,
) -> bool:
    """Whether the trigger of phase k, owned by i, is true after step t."""
    kind, j = phases.kind[k], phases.subject[k]
    if kind == _TIME:
        return t * traces.dt_s >= value - _ROUNDING
    if kind == _TRAVELLED:
        return state[j, 0] >= value - _ROUNDING
    x, y = traces.x_m[row, t, j], traces.y_m[row, t, j]
    if kind == _DISTANCE_BELOW:
        dx, dy = traces.x_m[row, t, i] - x, traces.y_m[row, t, i] - y
        return sqrt(dx * dx + dy * dy) < value
    dx, dy = phases.point_x_m[k] - x, phases.point_y_m[k] - y
    ahead = dx * traces.cos[row, t, j] + dy * traces.sin[row, t, j] > 0.0
    away, speed = sqrt(dx * dx + dy * dy), state[j, 1]
    return bool(ahead and away >= _NEGLIGIBLE and speed >= _NEGLIGIBLE and away / speed < value)

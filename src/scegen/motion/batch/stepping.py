"""One candidate, step by step: the kernel that every batch run consists of.

The laws of esmini. In every step the speeds change first and the positions move by the new speed
times dt; then the triggers are looked at: an action whose condition holds for the first time at a
step changes the state from the next step on. At most one phase of a participant fires in a step.
"""

from math import cos, sin, sqrt

import numpy as np

from scegen.motion.batch.arrays import (
    COS,
    HEADING,
    SIN,
    SPEED,
    Candidates,
    Floats,
    Ints,
    PathTable,
    PhaseTable,
    Program,
    S,
    X,
    Y,
)
from scegen.motion.batch.kernels import inner_kernel, kernel
from scegen.motion.batch.touching import collided
from scegen.motion.model import NEGLIGIBLE, STANDING_MPS

_ROUNDING = 1e-9
"""A time or distance that misses its value by less counts as reached."""
_ROUGHLY = 1.0 + 1e-9
"""Squares that differ by more need no root to be told apart."""
_COS = (-1 / 2, 1 / 24, -1 / 720, 1 / 40320)
_SIN = (-1 / 6, 1 / 120, -1 / 5040, 1 / 362880)
"""Taylor coefficients; up to 0.1 rad the terms left out are below 1e-16."""
_TIME, _TRAVELLED, _DISTANCE_BELOW, _STOOD_STILL = 0, 1, 2, 4
"""Of TriggerKind; ARRIVAL_BELOW is the else branch."""


@kernel
def run_candidate(
    program: Program,
    candidates: Candidates,
    c: int,
    dt_s: float,
    tracks: Floats,
    fired_step: Ints,
    outside: int,
) -> None:
    """Simulate candidate ``c``.

    Args:
        program: paths and structure of the speed programs.
        candidates: the numbers that differ.
        c: which candidate.
        dt_s: time step, s.
        tracks: output, (participant, track row, step), see ``BatchTraces``.
        fired_step: output, (phase,).
        outside: who is moved from outside, -1: nobody; its track, from step 1 on, is no output.
    """
    paths, phases, contacts = program
    participants = paths.first.shape[0] - 1
    # Travelled distance, speed, target speed, rate (0: no phase active), length left at start,
    # first step of standing (-1: moves).
    state = np.zeros((participants, 6))
    # Vertex at or behind the position, next phase to fire, with whom a collision is yet to come.
    marks = np.zeros((participants, 3), dtype=np.int64)
    for i in range(participants):
        length = paths.s_m[paths.first[i + 1] - 1]
        state[i, 4] = max(length - candidates.start_m[c, i], 0.0)
        state[i, 1] = candidates.speed_mps[c, i] if state[i, 4] > 0.0 else 0.0
        marks[i, 0] = paths.first[i]
        marks[i, 1] = phases.first[i]
        marks[i, 2] = contacts.other[i]
        state[i, 5] = -1.0
    if outside >= 0:
        marks[outside, 1], marks[outside, 2] = phases.first[outside + 1], -1
    fired_step[:] = -1
    for t in range(tracks.shape[2]):
        for i in range(participants):
            given = t > 0 and i == outside
            if given:
                state[i, 0] = tracks[i, S, t] - tracks[i, S, 0]
                state[i, 1] = tracks[i, SPEED, t]
            elif t > 0 and _move(state, i, dt_s):
                marks[i, 1] = phases.first[i + 1]
            tracks[i, SPEED, t] = state[i, 1]
            state[i, 5] = _stands_since(state, i, t)
            if not given and t > 0 and state[i, 1] == 0.0 and tracks[i, SPEED, t - 1] == 0.0:
                tracks[i, :, t] = tracks[i, :, t - 1]
            elif not given:
                s = candidates.start_m[c, i] + state[i, 0]
                tracks[i, S, t] = s
                marks[i, 0] = _place(paths, i, marks[i, 0], s, tracks, t)
        for i in range(participants):
            if marks[i, 2] >= 0 and collided(contacts, tracks, i, t):
                state[i, 2], state[i, 3] = 0.0, contacts.rate_mps2[i]
                marks[i, 1], marks[i, 2] = phases.first[i + 1], -1
            k = marks[i, 1]
            if k < phases.first[i + 1] and _holds(
                phases, candidates.trigger[c, k], k, i, state, tracks, t, dt_s
            ):
                state[i, 2] = candidates.target_speed_mps[c, k]
                state[i, 3] = candidates.rate_mps2[c, k]
                marks[i, 1] = k + 1
                fired_step[k] = t


@inner_kernel
def _move(state: Floats, i: int, dt: float) -> bool:
    """Change the speed of participant i towards its target, then its travelled distance.

    Whether it has come to the end of its path, where it stops.
    """
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
    if state[i, 0] < state[i, 4]:
        return False
    state[i, 0], state[i, 1], state[i, 3] = state[i, 4], 0.0, 0.0
    return True


@inner_kernel
def _stands_since(state: Floats, i: int, t: int) -> float:
    """The first step of those in which participant i has stood up to t; -1: it moves."""
    if state[i, 1] >= STANDING_MPS:
        return -1.0
    return float(state[i, 5] if state[i, 5] >= 0.0 else t)


@inner_kernel
def _place(paths: PathTable, i: int, vertex: int, s: float, tracks: Floats, t: int) -> int:
    """Write the pose at ``s`` on i's path; returns the vertex at or behind it.

    ``vertex`` is where the search begins: positions only grow.
    """
    last, vertex = paths.first[i + 1] - 1, max(vertex, 0)  # no index counts from the end
    while vertex < last and paths.s_m[vertex + 1] <= s:
        vertex += 1
    if vertex == last or s <= paths.s_m[vertex]:
        tracks[i, X, t] = paths.x_m[vertex]
        tracks[i, Y, t] = paths.y_m[vertex]
        tracks[i, HEADING, t] = paths.heading_rad[vertex]
        tracks[i, COS, t] = paths.cos[vertex]
        tracks[i, SIN, t] = paths.sin[vertex]
        return vertex
    p = (s - paths.s_m[vertex]) / (paths.s_m[vertex + 1] - paths.s_m[vertex])
    tracks[i, X, t] = paths.x_m[vertex] + p * (paths.x_m[vertex + 1] - paths.x_m[vertex])
    tracks[i, Y, t] = paths.y_m[vertex] + p * (paths.y_m[vertex + 1] - paths.y_m[vertex])
    turn = p * (paths.heading_rad[vertex + 1] - paths.heading_rad[vertex])
    tracks[i, HEADING, t] = paths.heading_rad[vertex] + turn
    c, s = paths.cos[vertex], paths.sin[vertex]
    if turn != 0.0:
        # By addition theorem: the vertex knows the rest of the angle.
        dc, ds = _cos_sin(turn)
        c, s = c * dc - s * ds, s * dc + c * ds
    tracks[i, COS, t], tracks[i, SIN, t] = c, s
    return vertex


@inner_kernel
def _cos_sin(turn: float) -> tuple[float, float]:
    """Cosine and sine, to rounding; quick for the small angles between two vertices, rad."""
    if abs(turn) > 0.1:
        return cos(turn), sin(turn)
    q = turn * turn
    c = 1.0 + q * (_COS[0] + q * (_COS[1] + q * (_COS[2] + q * _COS[3])))
    return c, turn * (1.0 + q * (_SIN[0] + q * (_SIN[1] + q * (_SIN[2] + q * _SIN[3]))))


@inner_kernel
def _holds(
    phases: PhaseTable,
    value: float,
    k: int,
    i: int,
    state: Floats,
    tracks: Floats,
    t: int,
    dt_s: float,
) -> bool:
    """Whether the trigger of phase k, owned by i, is true after step t."""
    kind, j = phases.kind[k], phases.subject[k]
    if kind == _TIME:
        return bool(t * dt_s >= value - _ROUNDING)
    if kind == _TRAVELLED:
        return bool(state[j, 0] >= value - _ROUNDING)
    if kind == _STOOD_STILL:
        return bool(state[j, 5] >= 0.0 and (t - state[j, 5]) * dt_s >= value - _ROUNDING)
    x, y = tracks[j, X, t], tracks[j, Y, t]
    if kind == _DISTANCE_BELOW:
        dx, dy = tracks[i, X, t] - x, tracks[i, Y, t] - y
        squared = dx * dx + dy * dy
        return bool(squared < _ROUGHLY * value * value and sqrt(squared) < value)
    dx, dy = phases.point_x_m[k] - x, phases.point_y_m[k] - y
    squared, speed = dx * dx + dy * dy, state[j, 1]
    soon = value * speed
    if speed < NEGLIGIBLE or squared >= _ROUGHLY * soon * soon:
        return False
    ahead = dx * tracks[j, COS, t] + dy * tracks[j, SIN, t] > 0.0
    away = sqrt(squared)
    return bool(ahead and away >= NEGLIGIBLE and away / speed < value)

"""When a driver can see that another becomes dangerous.

The rule is conservative: it must not let a driver brake for what nobody could have known, nor for
what never becomes a danger. At a step, another is a perceivable danger to the ego if all hold:

1. It would touch the ego within the horizon if it kept its velocity and heading, the ego its path
   and speed: what the eye extrapolates.
2. It would touch the ego within the horizon on the way that it really takes, at its present speed.
   This keeps chance alignments in bends from counting.
3. It lies ahead of the ego's reference point: what comes from behind is no reason to brake.
4. It lies in the ego's corridor, or has come at least ``WANDERING_M`` nearer to the ego's path than
   it was before: within its lane, a vehicle wanders by so much without meaning anything
   (UN R157, Annex 3: 0.375 m).
5. No third body hides it (centre and corners) from the ego at this step.

Indicators, brake lights, signals and rules of priority are not looked at.
"""

from collections.abc import Sequence
from math import inf

import numpy as np

from scegen.measures.bodies import body_of
from scegen.measures.distance import distance_series
from scegen.measures.nearest import nearest_points
from scegen.measures.occlusion import occlusion_series
from scegen.motion.batch.arrays import COS, HEADING, SIN, SPEED, TRACK_ROWS, Bools, Floats, S, X, Y
from scegen.motion.model import Path

WANDERING_M = 0.375
"""Lateral wandering within a lane that says nothing yet; UN R157, Annex 3."""
LOOK_STEP_S = 0.1
_FINE_M = 0.5


def perceivable_dangers(
    tracks: Floats, bodies: Floats, paths: Sequence[Path], ego: int, horizon_s: Floats
) -> Bools:
    """Whether each participant is a perceivable danger to the ego, at each step: (i, t).

    ``tracks`` are those of one candidate, (i, track row, t), ``bodies`` as
    :func:`scegen.measures.bodies.body_table` makes them, ``paths`` one per participant.
    ``horizon_s`` (t,) is how far ahead the driver looks at each step, s. The ego is no danger to
    itself.
    """
    out = np.zeros((tracks.shape[0], tracks.shape[2]), dtype=np.bool_)
    look = np.arange(0.0, float(horizon_s.max()) + LOOK_STEP_S, LOOK_STEP_S)
    within = look[None, :] <= horizon_s[:, None]
    ahead = _on_way(tracks[ego], paths[ego], look)
    for other in range(tracks.shape[0]):
        if other == ego:
            continue
        steps = np.flatnonzero(_evident(tracks, bodies, paths[ego], ego, other))
        for guess in (_straight_on, _on_way):
            if steps.size:
                guessed = guess(tracks[other][:, steps], paths[other], look)
                touching = _touching(ahead[steps], guessed, bodies[[ego, other]])
                steps = steps[(touching & within[steps]).any(axis=1)]
        out[other, steps] = True
        if steps.size:
            out[other] &= ~_hidden(tracks, bodies, ego, other)
    return out


def _evident(tracks: Floats, bodies: Floats, way: Path, ego: int, other: int) -> Bools:
    """Rules 3 and 4: ahead, and in the corridor or evidently on the way there; by step."""
    own, track = tracks[ego], tracks[other]
    body, mine = body_of(bodies, other), body_of(bodies, ego)
    x = track[X] + body.ahead_m * track[COS]
    y = track[Y] + body.ahead_m * track[SIN]
    in_front: Bools = (x - own[X]) * own[COS] + (y - own[Y]) * own[SIN] > 0.0
    s = np.linspace(0.0, way.length_m, max(2, int(way.length_m / _FINE_M)))
    px, py, _ = way.places(s)
    # Once it is behind for good, nothing more is asked of it.
    asked = slice(int(in_front.nonzero()[0].max(initial=-1)) + 1)
    _, aside = nearest_points(x[asked], y[asked], px, py, inf)
    in_corridor = aside < mine.half_width_m + body.half_width_m
    nearer = np.maximum.accumulate(aside) - aside >= WANDERING_M
    in_front[asked] &= in_corridor | nearer
    return in_front


def _straight_on(track: Floats, _: Path, look: Floats) -> Floats:
    """Tracks of one who keeps velocity and heading from each step on: (t, row, look)."""
    away = track[SPEED][:, None] * look
    rows = np.repeat(track.T[:, :, None], len(look), axis=2)
    rows[:, X] += away * track[COS][:, None]
    rows[:, Y] += away * track[SIN][:, None]
    return rows


def _on_way(track: Floats, way: Path, look: Floats) -> Floats:
    """Tracks of one who keeps its speed on its path from each step on: (t, row, look)."""
    s = np.minimum(track[S][:, None] + np.abs(track[SPEED])[:, None] * look, way.length_m)
    rows = np.empty((s.shape[0], TRACK_ROWS, s.shape[1]))
    rows[:, S], rows[:, SPEED] = s, track[SPEED][:, None]
    rows[:, X], rows[:, Y], rows[:, HEADING] = way.places(s)
    rows[:, COS], rows[:, SIN] = np.cos(rows[:, HEADING]), np.sin(rows[:, HEADING])
    return rows


def _touching(one: Floats, two: Floats, bodies: Floats) -> Bools:
    """Whether two guessed movements touch: (t, look)."""
    pair = np.array([[0, 1]], dtype=np.int64)
    found: Bools = distance_series(np.stack((one, two), axis=1), bodies, pair)[:, :, 0] == 0.0
    return found


def _hidden(tracks: Floats, bodies: Floats, ego: int, other: int) -> Bools:
    """Whether a third body hides another from the ego, by step."""
    thirds = [n for n in range(tracks.shape[0]) if n not in {ego, other}]
    triples = np.array([(ego, other, third) for third in thirds], dtype=np.int64).reshape(-1, 3)
    hidden: Bools = occlusion_series(tracks[None], bodies, triples)[0].any(axis=1)
    return hidden

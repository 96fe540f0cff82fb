"""Lines of sight that are cut: how long somebody is hidden from another, and until when."""

from typing import NamedTuple

import numpy as np

from scegen.claims.view import View, kept
from scegen.measures.occlusion import hidden_at
from scegen.motion.batch.arrays import Floats, Ints
from scegen.motion.batch.kernels import kernel


class Hidden(NamedTuple):
    """How long before two come nearest, when last, and how long one sees the other then (c,), s."""

    total_s: Floats
    last_s: Floats
    seen_s: Floats


@kept
def hidden(view: View, observer: str, target: str, *hiders: str) -> Hidden:
    """How any of these hides a target from an observer, up to the moment when the two are nearest.

    Two in a row hide longer than one.
    """
    a, b = view.index[observer], view.index[target]
    rows = np.array([[a, b, view.index[name]] for name in hiders], dtype=np.int64)
    nearest = view.of_pair("closest_s", observer, target)
    nearest = np.where(np.isnan(nearest), view.time_of(view.last_step), nearest)
    found = _hidden_before(view.traces.tracks, view.scene.bodies, rows, nearest, view.dt_s)
    total_s, last_s = map(view.time_of, found)
    return Hidden(total_s, last_s, nearest - last_s)


@kernel
def _hidden_before(
    tracks: Floats, bodies: Floats, occlusions: Ints, before_s: Floats, dt_s: float
) -> tuple[Ints, Ints]:
    """In how many steps before a time (c,) one is hidden by anybody, and which is the last (c,).

    ``occlusions`` (q, 3): observer, target, occluder.
    """
    count, last = np.zeros((2, tracks.shape[0]), dtype=np.int64)
    for c in range(tracks.shape[0]):
        for t in range(tracks.shape[3]):
            if not t * dt_s < before_s[c]:
                break
            for q in range(occlusions.shape[0]):
                if hidden_at(tracks[c], bodies, occlusions[q], t):
                    count[c], last[c] = count[c] + 1, t
                    break
    return count, last

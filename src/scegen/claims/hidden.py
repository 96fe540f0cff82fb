"""Lines of sight that are cut: how long somebody is hidden from another, and until when."""

from typing import NamedTuple

import numpy as np

from scegen.claims.view import View, kept
from scegen.measures.occlusion import occlusion_series
from scegen.motion.batch.arrays import Floats


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
    cut = occlusion_series(view.traces.tracks, view.scene.bodies, rows).any(axis=2)
    time_s = view.time_of(np.arange(view.steps))
    cut &= time_s < nearest[:, None]
    last_s = np.where(cut, time_s, 0.0).max(axis=1)
    return Hidden(view.time_of(cut.sum(axis=1)), last_s, nearest - last_s)

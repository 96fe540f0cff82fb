"""Lines of sight that are cut: how long somebody is hidden from another, and until when."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from scegen.claims.view import View
from scegen.measures.occlusion import occlusion_series
from scegen.motion.batch.arrays import Floats


class Hidden(NamedTuple):
    """How long before two come nearest, when last, and how long one sees the other then (c,), s."""

    total_s: Floats
    last_s: Floats
    seen_s: Floats


def hidden(view: View, observer: str, target: str, hiders: Sequence[str]) -> Hidden:
    """How any of these hides a target from an observer, up to the moment when the two are nearest.

    Two in a row hide longer than one.
    """
    key = ("hidden", observer, target, *hiders)
    return view.once(key, lambda: _hidden(view, observer, target, hiders))


def _hidden(view: View, observer: str, target: str, hiders: Sequence[str]) -> Hidden:
    a, b = view.index[observer], view.index[target]
    rows = np.array([[a, b, view.index[name]] for name in hiders], dtype=np.int64)
    nearest = view.of_pair("closest_s", observer, target)
    nearest = np.where(np.isnan(nearest), view.time_of(view.last_step), nearest)
    flags = occlusion_series(view.traces.tracks, view.scene.bodies, rows).any(axis=2)
    time = np.arange(view.steps) * view.dt_s
    flags &= time < nearest[:, None]
    last = np.where(flags, time, 0.0).max(axis=1)
    return Hidden(flags.sum(axis=1) * view.dt_s, last, nearest - last)

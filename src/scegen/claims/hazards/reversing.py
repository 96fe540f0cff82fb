"""Reversing: somebody drives backwards into another's way, close to it."""

import numpy as np

from scegen.claims.hazards import thresholds as limits
from scegen.claims.hazards.predicate import Part, Predicate, at_least, at_most
from scegen.claims.series import greatest, least
from scegen.claims.view import View
from scegen.measures.distance import distance_series
from scegen.motion.batch.arrays import SPEED, Bools, Floats
from scegen.motion.model import Path

_SAMPLE_M = 0.25
_BACKWARDS_MPS = 0.05
_MUCH_M = 1e3


def reversing(view: View, by: str, to: str) -> list[Part]:
    """It goes back, towards the other or into its way, before that one has passed; and is near.

    Near counts from when it begins to go back until a little after.
    """
    back = view.row(by, SPEED) < -_BACKWARDS_MPS
    place = view.place_m(by)
    into, passes_m = _into_the_way(view, by, to, place)
    gone = np.diff(place, axis=1, prepend=place[:, :1])
    counts = back & into
    if view.path(to).length_m > 0.0:  # one that stands is never past
        counts &= view.place_m(to) < passes_m
    went = np.where(counts, gone, 0.0)
    _, step = greatest(np.cumsum(went, axis=1))
    far = at_least("driven backwards", went.sum(axis=1), limits.REVERSED, view.time_of(step))
    return [far, _near(view, by, to, counts)]


def _near(view: View, by: str, to: str, counts: Bools) -> Part:
    """How close the two come while it goes back."""
    pair = np.array([[view.index[by], view.index[to]]], dtype=np.int64)
    apart = distance_series(view.traces.tracks, view.scene.bodies, pair)[:, :, 0]
    steps = np.arange(counts.shape[1])
    since = np.maximum.accumulate(np.where(counts, steps, -_MUCH_M), axis=1)
    meanwhile = steps - since <= limits.REVERSED_FOR_S / view.dt_s
    nearest, step = least(np.where(meanwhile, apart, np.inf))
    return at_most("distance meanwhile", nearest, limits.NEAR, view.time_of(step))


def _into_the_way(view: View, by: str, to: str, place_m: Floats) -> tuple[Bools, Floats]:
    """Whether its tail is in the other's way or gets nearer to it, and where that one passes it."""
    path, other = view.path(by), view.path(to)
    s = np.linspace(0.0, path.length_m, max(2, int(path.length_m / _SAMPLE_M) + 1))
    rear_m = view.body(by).rear_m
    half_m = view.body(to).width_m / 2
    aside, passes = _from_way(path, s, rear_m, other)
    nearer = np.diff(aside, append=aside[-1]) < 0.0
    into = np.interp(place_m, s, (nearer | (aside < half_m)).astype(np.float64)) > 0.5
    return into, np.interp(place_m, s, passes)


def _from_way(path: Path, s: Floats, rear_m: float, other: Path) -> tuple[Floats, Floats]:
    """Distance of its tail from another's way at places of its own, and where on that way (m)."""
    x, y, heading = path.places(s)
    x, y = x - rear_m * np.cos(heading), y - rear_m * np.sin(heading)
    t = np.linspace(0.0, other.length_m, max(2, int(other.length_m / _SAMPLE_M) + 1))
    ox, oy, _ = other.places(t)
    gaps = np.hypot(x[:, None] - ox, y[:, None] - oy)
    nearest = gaps.argmin(axis=1)
    return gaps[np.arange(len(s)), nearest], t[nearest]


REVERSING = Predicate(reversing)

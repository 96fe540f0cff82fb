"""Dangers made by what stands beside or on the road: occlusion and obstacles."""

from __future__ import annotations

import numpy as np

from scegen.claims.hazards import thresholds as limits
from scegen.claims.hazards.predicate import Part, Predicate, at_least, at_most
from scegen.claims.view import View
from scegen.measures.occlusion import occlusion_series


def occlusion(view: View, by: str, to: str) -> list[Part]:
    """Somebody who moves is hidden from the sufferer before they come nearest.

    All occluders count together: two parked cars in a row hide longer than one.
    """
    longest, ends = np.zeros(view.count), np.zeros(view.count)
    people = [entity.id for entity in view.concrete.entities]
    rows = view.scene.occlusions
    for target in sorted({int(row[1]) for row in rows if row[0] == view.index[to]}):
        chosen = rows[(rows[:, 0] == view.index[to]) & (rows[:, 1] == target)]
        if not (chosen[:, 2] == view.index[by]).any():
            continue
        hidden = occlusion_series(view.traces.tracks, view.scene.bodies, chosen).any(axis=2)
        time = np.arange(hidden.shape[1]) * view.dt_s
        nearest = view.of_pair("closest_s", to, people[target])
        hidden &= time < np.where(np.isnan(nearest), np.inf, nearest)[:, None]
        total = hidden.sum(axis=1) * view.dt_s
        last = np.where(hidden, time, 0.0).max(axis=1)
        ends = np.where(total > longest, last, ends)
        longest = np.maximum(longest, total)
    return [at_least("hidden", longest, limits.OCCLUDED, ends)]


def obstacle(view: View, by: str, to: str) -> list[Part]:
    """The sufferer has to pass close by what stands there."""
    apart = view.of_pair("distance_m", by, to)
    return [at_most("distance", apart, limits.OBSTACLE, view.of_pair("closest_s", by, to))]


OCCLUSION = Predicate(occlusion, conflict=False)
OBSTACLE = Predicate(obstacle)

"""Which part of the world each picture of a film shows: one for all, or what follows the ego."""

from collections.abc import Sequence

import numpy as np

from scegen.criticality.encounter import Encounter
from scegen.motion.model import Array
from scegen.report.stage import Stage
from scegen.report.world import View
from scegen.scenario.vocabulary import JunctionKind

_MARGIN_M = 9.0
_LEAST_PX_PER_M, _MOST_PX_PER_M = 5.0, 16.0
_FOLLOWED_M = 100.0
_HEIGHTS = (0.3, 0.62)
"""Of a picture, as shares of its width."""
_STEADY_S = 1.0


def camera_views(stage: Stage, met: Encounter | None, width: float) -> tuple[View, ...]:
    """One view for all pictures where everybody fits in large enough; else it follows the ego."""
    moving = [
        np.column_stack((trace.x_m, trace.y_m))
        for trace in (stage.traces[p.id] for p in stage.concrete.participants)
    ]
    everything = np.concatenate(moving)
    low, high = everything.min(axis=0) - _MARGIN_M, everything.max(axis=0) + _MARGIN_M
    plain = stage.concrete.road.kind is JunctionKind.STRAIGHT
    if plain:
        low[1], high[1] = stage.surroundings.across(float(low[0]), float(high[0]))
        low[1], high[1] = low[1] - 2.0, high[1] + 2.0
    size, middle = high - low, (low + high) / 2
    least, most = (share * width for share in _HEIGHTS)
    height = float(np.clip(width * size[1] / size[0], least, most))
    scale = min(width / size[0], height / size[1], _MOST_PX_PER_M)
    count = len(everything) // len(moving)
    if scale >= _LEAST_PX_PER_M:
        centres: Sequence[Array] = [middle] * count
    else:
        scale = width / _FOLLOWED_M
        height = float(np.clip(size[1] * scale, least, most)) if plain else most
        centres = _followed(stage, met, middle, plain=plain)
    height = 2.0 * round(height / 2)
    return tuple(
        View(float(x), float(y), width / scale, 0.0, 0.0, width, height) for x, y in centres
    )


def _followed(stage: Stage, met: Encounter | None, middle: Array, *, plain: bool) -> list[Array]:
    """Where the view looks: between the ego and whom it meets, without haste."""
    ego = stage.traces[stage.concrete.ego.id]
    at = np.column_stack((ego.x_m, ego.y_m))
    other = None if met is None else stage.traces.get(met.other)
    if other is not None:
        reach = 0.3 * _FOLLOWED_M
        towards = (np.column_stack((other.x_m, other.y_m)) - at) / 2
        at = at + towards.clip(-reach, reach)
    if plain:
        at[:, 1] = middle[1]
    around = max(int(_STEADY_S / ego.step_s), 1)
    padded = np.pad(at, ((around, around), (0, 0)), mode="edge")
    window = np.ones(2 * around + 1) / (2 * around + 1)
    steady = [np.convolve(padded[:, axis], window, mode="valid") for axis in (0, 1)]
    return list(np.column_stack(steady))

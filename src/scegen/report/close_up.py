"""The enlarged picture of the closest approach, in a corner of the preview."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from scegen.report.drawing_parts import (
    HALO,
    TEXT,
    WIDTH_IN,
    Scene,
    View,
    corners_at,
    draw_box,
    draw_roads,
    draw_things,
    set_view,
)
from scegen.report.encounter import Encounter, thing_corners

_MAX_SPAN_M = 40.0
_SMALLEST_M = 16.0
_SHARE = 0.36
_CLEARANCE = np.array([0.05, 0.09])
"""Room for labels, as a share of the figure."""


def draw_close_up(figure: Figure, axes: Axes, scene: Scene, encounter: Encounter) -> None:
    """The closest approach, enlarged, in the corner where least is going on.

    Nothing is drawn where the two never come close: the whole picture shows that.
    """
    boxes = {thing.id: thing_corners(thing) for thing in scene.concrete.objects}
    both = np.concatenate(
        [
            boxes[name] if name in boxes else corners_at(scene.traces[name], encounter.step)
            for name in (scene.concrete.ego.id, encounter.other)
        ]
    )
    middle, span = (both.min(axis=0) + both.max(axis=0)) / 2, np.ptp(both, axis=0).max()
    if span > _MAX_SPAN_M:
        return
    side = max(span + 4.0, _SMALLEST_M)
    place = axes.get_position()
    size_in = _SHARE * min(place.height * figure.get_figheight(), WIDTH_IN)
    w, h = size_in / WIDTH_IN, size_in / figure.get_figheight()
    gap_x, gap_y = 0.1 / WIDTH_IN, 0.1 / figure.get_figheight()
    spots = [
        (x, y)
        for y in (place.y1 - h - gap_y, place.y0 + gap_y)
        for x in (place.x1 - w - gap_x, place.x0 + gap_x)
    ]
    points = np.concatenate([np.column_stack((t.x_m, t.y_m)) for t in scene.traces.values()])
    seen = figure.transFigure.inverted().transform(axes.transData.transform(points))

    def busy(spot: tuple[float, float]) -> int:
        low = np.array(spot)
        inside = (seen > low - _CLEARANCE) & (seen < low + np.array([w, h]) + _CLEARANCE)
        return int(inside.all(axis=1).sum())

    spot = min(spots[:3], key=busy)  # the scale lies in the fourth corner
    inset = figure.add_axes((*spot, w, h))
    set_view(inset, View(float(middle[0]), float(middle[1]), side, side))
    draw_roads(inset, scene.shapes)
    draw_things(inset, scene.concrete.objects)
    for participant in scene.concrete.participants:
        is_ego = participant.id == scene.concrete.ego.id
        trace = scene.traces[participant.id]
        inset.plot(
            trace.x_m, trace.y_m, color=scene.colour[participant.id], linewidth=1.5, zorder=3
        )
        draw_box(inset, trace, encounter.step, scene.colour[participant.id], ego=is_ego)
    inset.add_patch(
        Rectangle((0, 0), 1, 1, transform=inset.transAxes, fill=False, linewidth=1.6, zorder=9)
    )
    inset.text(
        0.04,
        0.96,
        f"{encounter.time_s:.1f} s",
        transform=inset.transAxes,
        va="top",
        fontsize=9,
        color=TEXT,
        path_effects=HALO,
        zorder=10,
    )

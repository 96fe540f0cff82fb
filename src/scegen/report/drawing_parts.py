"""Pieces that the preview and its close-up share: view, roads, boxes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.patches import Polygon, Rectangle
from matplotlib.patheffects import withStroke

from scegen.motion.model import Trace
from scegen.report.encounter import Array, box_corners, thing_corners
from scegen.report.lane_shapes import RoadShapes
from scegen.road.model import LaneType
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.objects import ObjectCategory, StaticObject

WIDTH_IN = 9.0
TEXT, FAINT, MARK = "#1b2330", "#5b6675", "#ffffff"
HALO = [withStroke(linewidth=2.6, foreground="white")]
_GROUND = "#eef2ea"
_PAINT = {
    LaneType.SIDEWALK: "#e2ddd2",
    LaneType.BORDER: "#dfe3e0",
    LaneType.SHOULDER: "#dfe3e0",
    LaneType.PARKING: "#d3ccbb",
    LaneType.DRIVING: "#c3c8d0",
}
"""In this order, so that carriageways lie on top where roads overlap."""
_THING, _PLANT = "#8f8675", "#7fa36b"
_PLANTS = frozenset({ObjectCategory.TREE, ObjectCategory.VEGETATION})


@dataclass(frozen=True)
class Scene:
    """All that is drawn."""

    concrete: ConcreteScenario
    traces: Mapping[str, Trace]
    colour: Mapping[str, str]
    shapes: RoadShapes


@dataclass(frozen=True, slots=True)
class View:
    """The part of the world that is shown (m)."""

    x_m: float
    y_m: float
    width: float
    height: float


def set_view(axes: Axes, view: View) -> None:
    """Show this part of the world, without axes, on a ground."""
    axes.set_xlim(view.x_m - view.width / 2, view.x_m + view.width / 2)
    axes.set_ylim(view.y_m - view.height / 2, view.y_m + view.height / 2)
    axes.set_axis_off()
    axes.add_patch(Rectangle((0, 0), 1, 1, transform=axes.transAxes, facecolor=_GROUND, zorder=0))


def draw_roads(axes: Axes, shapes: RoadShapes) -> None:
    """Lanes, marks and crosswalks."""
    for layer, (kind, paint) in enumerate(_PAINT.items()):
        polygons = shapes.lanes.get(kind, [])
        axes.add_collection(
            PolyCollection(
                polygons,
                facecolors=paint,
                edgecolors=paint,
                linewidths=0.6,  # closes hairline seams between roads
                zorder=1 + layer / 10,
            )
        )
    axes.add_collection(LineCollection(shapes.centre_lines, colors=MARK, linewidths=1.5, zorder=2))
    axes.add_collection(
        LineCollection(
            shapes.lane_lines, colors=MARK, linewidths=1.1, linestyles=(0, (6, 6)), zorder=2
        )
    )
    axes.add_collection(PolyCollection(shapes.stripes, facecolors=MARK, zorder=2))


def corners_at(trace: Trace, step: int) -> Array:
    """The corners of a participant's box at one step, its front first."""
    here = slice(step, step + 1)
    corners: Array = box_corners(
        trace.kind, trace.x_m[here], trace.y_m[here], trace.heading_rad[here]
    )[0]
    return corners


def draw_things(axes: Axes, things: Iterable[StaticObject]) -> None:
    """Objects: hatched boxes, plants in green."""
    for thing in things:
        face = _PLANT if thing.category in _PLANTS else _THING
        axes.add_patch(
            Polygon(
                thing_corners(thing),
                facecolor=face,
                edgecolor=TEXT,
                linewidth=0.9,
                hatch="////",
                zorder=4.5,
            )
        )


def draw_box(axes: Axes, trace: Trace, step: int, colour: str, *, ego: bool) -> None:
    """A participant with its front marked."""
    corners = corners_at(trace, step)
    middle, front = corners.mean(axis=0), corners[:2].mean(axis=0)
    edge, width = ("black", 2.0) if ego else (TEXT, 0.8)
    axes.add_patch(Polygon(corners, facecolor=colour, edgecolor=edge, linewidth=width, zorder=5))
    nose = np.array([corners[0], 0.3 * middle + 0.7 * front, corners[1]])
    axes.add_patch(Polygon(nose, facecolor=MARK, linewidth=0, alpha=0.85, zorder=5.1))

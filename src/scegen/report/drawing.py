"""The preview's drawing, with matplotlib's objects: no global state, no display."""

from __future__ import annotations

from collections.abc import Mapping
from io import BytesIO
from textwrap import wrap

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import FancyArrowPatch, Polygon, Rectangle

from scegen.motion.model import Path, Trace
from scegen.report.close_up import draw_close_up
from scegen.report.drawing_parts import (
    FAINT,
    HALO,
    MARK,
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
from scegen.report.encounter import Array, Encounter, thing_corners
from scegen.report.lane_shapes import road_shapes
from scegen.report.theme import LIGHT
from scegen.report.words import hazard_words, participant_words, thing_words
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.vocabulary import HazardKind

_LINE_IN, _DPI = 0.215, 100
_LOWEST_IN, _HIGHEST_IN = 3.2, 5.8
_MARGIN_M = 9.0
_SMALLEST_M = 40.0
_WIDE_M = 60.0


def draw_scenario(
    concrete: ConcreteScenario,
    network: RoadNetwork,
    paths: Mapping[str, Path],
    traces: Mapping[str, Trace],
    encounter: Encounter | None,
) -> bytes:
    """The picture as PNG bytes."""
    notes = _notes(concrete, encounter)
    below = _LINE_IN * (len(notes) + len(concrete.entities)) + 0.3
    view = _view(concrete, traces)
    picture = WIDTH_IN * view.height / view.width
    height = picture + below
    figure = Figure(figsize=(WIDTH_IN, height), dpi=_DPI, facecolor="white")
    canvas = FigureCanvasAgg(figure)
    axes = figure.add_axes((0.0, below / height, 1.0, picture / height))
    colour = LIGHT.colours((p.id for p in concrete.participants), concrete.ego.id)
    shapes = road_shapes(network)
    set_view(axes, view)
    draw_roads(axes, shapes)
    draw_things(axes, concrete.objects)
    for participant in concrete.participants:
        _draw_way(axes, paths[participant.id], traces[participant.id], colour[participant.id])
    if encounter is not None:
        for name in (n for n in (concrete.ego.id, encounter.other) if n in traces):
            _draw_ghost(axes, traces[name], encounter.step, colour[name])
    for number, participant in enumerate(concrete.participants):
        is_ego = participant.id == concrete.ego.id
        draw_box(axes, traces[participant.id], 0, colour[participant.id], ego=is_ego)
        text = participant.id
        if participant.speed_mps > 0:
            text += f"  {participant.speed_mps:.1f} m/s"
        middle = corners_at(traces[participant.id], 0).mean(axis=0)
        _label(axes, text, middle, above=number % 2 == 0, bold=is_ego)
    starts = [corners_at(traces[p.id], 0).mean(axis=0) for p in concrete.participants]
    for thing in concrete.objects:
        middle = np.array([thing.x_m, thing.y_m])
        nearest = int(np.argmin([np.hypot(*(start - middle)) for start in starts]))
        _label(axes, thing.id, middle, above=nearest % 2 == 1, bold=False)
    _draw_scale(axes)
    if encounter is not None and view.width > _WIDE_M:
        scene = Scene(concrete, traces, colour, shapes)
        draw_close_up(figure, axes, scene, encounter)
    _write_notes(figure, concrete, notes, colour, height)
    buffer = BytesIO()
    canvas.print_png(buffer, metadata={"Software": None})  # type: ignore[no-untyped-call]
    return buffer.getvalue()


def _view(concrete: ConcreteScenario, traces: Mapping[str, Trace]) -> View:
    """Where something happens; long empty roads are cut off."""
    points = np.concatenate(
        [
            *(np.column_stack((traces[p.id].x_m, traces[p.id].y_m)) for p in concrete.participants),
            *(thing_corners(thing) for thing in concrete.objects),
        ]
    )
    low, high = points.min(axis=0) - _MARGIN_M, points.max(axis=0) + _MARGIN_M
    middle, size = (low + high) / 2, np.maximum(high - low, _SMALLEST_M)
    width = max(size[0], size[1] * WIDTH_IN / _HIGHEST_IN)
    height = max(size[1], width * _LOWEST_IN / WIDTH_IN)
    return View(float(middle[0]), float(middle[1]), float(width), float(height))


def _draw_way(axes: Axes, path: Path, trace: Trace, colour: str) -> None:
    """The whole path faintly, the part travelled in full, an arrow where the movement ends."""
    if len(path.s_m) < 2:
        return
    axes.plot(path.x_m, path.y_m, color=colour, linewidth=1.4, alpha=0.45, dashes=(3, 3), zorder=3)
    axes.plot(trace.x_m, trace.y_m, color=colour, linewidth=2.4, zorder=3.2)
    travelled = float(trace.s_m[-1])
    for begins, ends in path.backwards:
        if travelled > begins:
            _draw_reversing(axes, path, begins, min(ends, travelled), colour)
    if travelled > 3.0:
        tail, tip = path.pose(travelled - 3.0), path.pose(travelled)
        axes.add_patch(
            FancyArrowPatch(
                (tail.x_m, tail.y_m),
                (tip.x_m, tip.y_m),
                arrowstyle="-|>,head_length=7,head_width=4",
                color=colour,
                linewidth=2.4,
                shrinkA=0,
                shrinkB=0,
                zorder=3.3,
            )
        )


def _draw_reversing(axes: Axes, path: Path, begins: float, ends: float, colour: str) -> None:
    """The part that is driven backwards: dotted, with an R."""
    s = np.linspace(begins, ends, max(2, int((ends - begins) / 0.25)))
    x, y = np.interp(s, path.s_m, path.x_m), np.interp(s, path.s_m, path.y_m)
    axes.plot(x, y, color=MARK, linewidth=1.3, linestyle=(0, (1, 1.6)), zorder=3.25)
    axes.annotate(
        "R",
        (x[len(x) // 2], y[len(x) // 2]),
        xytext=(0, 9),
        textcoords="offset points",
        ha="center",
        va="bottom",
        fontsize=9,
        fontweight="bold",
        color=colour,
        path_effects=HALO,
        zorder=6,
    )


def _draw_ghost(axes: Axes, trace: Trace, step: int, colour: str) -> None:
    corners = corners_at(trace, step)
    axes.add_patch(Polygon(corners, facecolor=colour, alpha=0.6, linewidth=0, zorder=4))
    axes.add_patch(
        Polygon(corners, fill=False, edgecolor=colour, linestyle="--", linewidth=1.3, zorder=4)
    )


def _label(axes: Axes, text: str, middle: Array, *, above: bool, bold: bool) -> None:
    left = middle[0] > float(np.mean(axes.get_xlim()))
    axes.annotate(
        text,
        (float(middle[0]), float(middle[1])),
        xytext=(-8 if left else 8, 12 if above else -12),
        textcoords="offset points",
        ha="right" if left else "left",
        va="bottom" if above else "top",
        fontsize=9,
        fontweight="bold" if bold else "normal",
        color=TEXT,
        path_effects=HALO,
        zorder=6,
    )


def _draw_scale(axes: Axes) -> None:
    """A bar of a round length in the lower left corner."""
    (x0, x1), (y0, y1) = axes.get_xlim(), axes.get_ylim()
    length = next((n for n in (5, 10, 20, 50, 100, 200, 500) if n > (x1 - x0) / 14), 1000)
    x, y = x0 + (x1 - x0) * 0.02, y0 + (y1 - y0) * 0.04
    axes.plot([x, x + length], [y, y], color=TEXT, linewidth=2.2, solid_capstyle="butt", zorder=6)
    axes.annotate(
        f"{length} m",
        (x, y),
        xytext=(0, 4),
        textcoords="offset points",
        fontsize=8.5,
        color=TEXT,
        path_effects=HALO,
        zorder=6,
    )


def _notes(concrete: ConcreteScenario, encounter: Encounter | None) -> list[str]:
    notes = []
    if concrete.hazards:
        said = "Hazards: " + "; ".join(hazard_words(h) for h in concrete.hazards)
        kinds = {h.kind for h in concrete.hazards}
        notes.append(f"{said} (R: backwards)" if HazardKind.REVERSING in kinds else said)
    if encounter is not None:
        if encounter.distance_m > 0:
            how = f"is {encounter.distance_m:.1f} m from {encounter.other}"
        else:
            how = f"touches {encounter.other}"
        notes.append(
            f"Closest approach (dashed boxes, close-up): at {encounter.time_s:.1f} s the ego {how}"
        )
    return [line for note in notes for line in wrap(note, 112, max_lines=3, placeholder=" …")]


def _write_notes(
    figure: Figure,
    concrete: ConcreteScenario,
    notes: list[str],
    colour: dict[str, str],
    height_in: float,
) -> None:
    lines = len(notes) + len(concrete.entities)
    top = _LINE_IN * lines + 0.02
    for number, participant in enumerate(concrete.participants):
        y = (top - _LINE_IN * number) / height_in
        figure.add_artist(
            Rectangle((0.018, y - 0.002), 0.014, 0.11 / height_in, facecolor=colour[participant.id])
        )
        is_ego = participant.id == concrete.ego.id
        name = f"{participant.id} (ego)" if is_ego and participant.id != "ego" else participant.id
        text = f"{name}: {participant_words(participant)}"
        weight = "bold" if is_ego else "normal"
        figure.text(0.042, y, text, fontsize=9, color=TEXT, fontweight=weight)
    for number, thing in enumerate(concrete.objects, start=len(concrete.participants)):
        y = (top - _LINE_IN * number) / height_in
        figure.text(0.042, y, f"{thing.id}: {thing_words(thing)}", fontsize=9, color=TEXT)
    for number, note in enumerate(notes, start=len(concrete.entities)):
        y = (top - _LINE_IN * number) / height_in
        figure.text(0.018, y, note, fontsize=9, color=FAINT)

"""A concrete scenario ready to be drawn, and the two panels of it: the whole, and one moment."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray

from scegen.criticality.encounter import Encounter
from scegen.motion.model import Array, Path, Trace
from scegen.report.bodies import body, braking, ghost, swept
from scegen.report.drawing import area, areas, box, letters, line, lines
from scegen.report.labels import WAY_STEP_PX, Label, Rectangle, draw_labels, place
from scegen.report.plan import arrow_head
from scegen.report.raster import text_width
from scegen.report.theme import Theme
from scegen.report.words import KMH
from scegen.report.world import Surroundings, View, corners_at, placed, thing_corners
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import ConcreteParticipant, ConcreteScenario

_NAME_PX = 12.0
_ROUND_M = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
_HAZE = 0.2
"""How strongly ground is drawn that somebody covered."""


@dataclass(frozen=True)
class Stage:
    """All that a picture of a concrete scenario is made of."""

    concrete: ConcreteScenario
    paths: Mapping[str, Path]
    traces: Mapping[str, Trace]
    surroundings: Surroundings
    colour: Mapping[str, str]
    theme: Theme

    def bodies(self, step: int, view: View, brakes: Mapping[str, NDArray[np.bool_]]) -> str:
        """Everybody who is seen at one step, the ego on top."""
        ego = self.concrete.ego.id
        people = sorted(self.concrete.participants, key=lambda p: p.id == ego)
        shown = []
        for p in people:
            trace = self.traces[p.id]
            x, y, heading = trace.x_m[step], trace.y_m[step], trace.heading_rad[step]
            if view.shows(x, y):
                brake = p.id in brakes and bool(brakes[p.id][step])
                paint = (self.colour[p.id], self.theme, view.scale)
                drawn = body(p.kind, p.body, *paint, ego=p.id == ego, braking=brake)
                shown.append(placed(drawn, x, y, heading))
        return "".join(shown)

    def box_of(self, name: str, step: int) -> Array:
        """The corners (4, 2) of a participant or an object at one step."""
        for thing in self.concrete.objects:
            if thing.id == name:
                return thing_corners(thing)
        return corners_at(self.traces[name], step)


def make_stage(
    concrete: ConcreteScenario,
    network: RoadNetwork,
    paths: Mapping[str, Path],
    traces: Mapping[str, Trace],
    theme: Theme,
) -> Stage:
    """A scenario ready to be drawn."""
    return Stage(
        concrete,
        paths,
        traces,
        Surroundings(concrete, network, theme, paths),
        theme.colours((p.id for p in concrete.participants), concrete.ego.id),
        theme,
    )


def overview(stage: Stage, view: View, encounter: Encounter | None, framed: View | None) -> str:
    """Everybody's start and way, and where they are at the closest approach.

    ``framed`` is the view of a close-up, shown as a thin frame.
    """
    theme, colour = stage.theme, stage.colour
    world = [stage.surroundings.drawn(view), stage.surroundings.lights(view, 0.0)]
    moving = [p for p in stage.concrete.participants if stage.traces[p.id].s_m[-1] > 0.0]
    world += [
        areas(view.cut(swept(stage.traces[p.id]), closed=True), colour[p.id], fill_opacity=_HAZE)
        for p in moving
    ]
    world += [_way(stage, p, view) for p in moving]
    if encounter is not None:
        width = view.at_least(0.12, 1.3)
        world += [ghost(stage.traces[p.id], encounter.step, colour[p.id], width) for p in moving]
    world.append(stage.bodies(0, view, {}))
    drawn = view.picture("".join(world), theme.ground, "whole")
    if framed is not None:
        drawn += box(*view.frame(framed), "none", stroke=theme.text, stroke_width=1, rx=3,
                     stroke_dasharray="4 3")  # fmt: skip
    labels = []
    for p in stage.concrete.ego_first:
        at, bold = around(view, stage.box_of(p.id, 0)), p is stage.concrete.ego
        labels.append(Label(name_and_speed(p, p.speed_mps), at, bold=bold))
    labels += [Label(o.id, around(view, thing_corners(o))) for o in stage.concrete.objects]
    bar, where = _scale_bar(view, theme)
    frames = [] if framed is None else _edges(view.frame(framed))
    return drawn + bar + _labelled(stage, view, labels, [where, *frames])


def moment(stage: Stage, view: View, step: int, title: str, encounter: Encounter | None) -> str:
    """Where everybody is at one step, and how far the ego is from whom it meets."""
    theme = stage.theme
    brakes = {name: braking(trace) for name, trace in stage.traces.items()}
    time_s = float(stage.traces[stage.concrete.ego.id].time_s[step])
    world = [stage.surroundings.drawn(view), stage.surroundings.lights(view, time_s)]
    for participant in stage.concrete.participants:
        trace = stage.traces[participant.id]
        if trace.s_m[-1] > 0.0:
            so_far = view.cut(swept(trace, 0, step), closed=True)
            world.append(areas(so_far, stage.colour[participant.id], fill_opacity=_HAZE))
            world.append(_way(stage, participant, view))
    world.append(stage.bodies(step, view, brakes))
    labels = []
    if encounter is not None and encounter.distance_m > 0.0:
        gap, label = gap_between(stage, view, encounter)
        world.append(gap)
        labels.append(label)
    drawn = view.picture("".join(world), theme.ground, f"at-{step}")
    for participant in stage.concrete.ego_first:
        at = around(view, stage.box_of(participant.id, step))
        speed_mps = float(stage.traces[participant.id].speed_mps[step])
        if _inside(view, at):
            bold = participant is stage.concrete.ego
            labels.append(Label(name_and_speed(participant, speed_mps), at, bold=bold))
    things = ((o.id, around(view, thing_corners(o))) for o in stage.concrete.objects)
    labels += [Label(name, at) for name, at in things if _inside(view, at)]
    x, y = view.left + 9, view.top + 19
    heading = letters(title, x, y, _NAME_PX + 0.5, theme.text, bold=True, halo=theme.halo)
    width = text_width(title, _NAME_PX + 0.5, bold=True)
    bar, where = _scale_bar(view, theme)
    taken = [where, (x, y - 14, x + width, y + 4)]
    return drawn + heading + bar + _labelled(stage, view, labels, taken)


def _labelled(stage: Stage, view: View, labels: list[Label], taken: list[Rectangle]) -> str:
    inside = (view.left, view.top, view.left + view.width, view.top + view.height)
    return draw_labels(place(labels, inside, taken, on_ways(stage, view)), stage.theme)


def on_ways(stage: Stage, view: View) -> Array:
    """Points on everybody's way, evenly apart on the picture, wherever the view shows them."""
    found = []
    for name, path in stage.paths.items():
        if stage.traces[name].s_m[-1] > 0.0:
            s = np.arange(path.s_m[0], path.s_m[-1], WAY_STEP_PX / view.scale)
            found.append(np.column_stack(path.places(s)[:2]))
    points = np.concatenate([np.empty((0, 2)), *found])
    near = np.abs(points - (view.x_m, view.y_m)) < (view.width_m / 2, view.height_m / 2)
    return view.seen(points[near.all(axis=1)])


def name_and_speed(participant: ConcreteParticipant, speed_mps: float) -> str:
    """Its name, and how fast it is if it moves."""
    moves = abs(speed_mps) * KMH >= 0.5
    return f"{participant.id} {abs(speed_mps) * KMH:.0f} km/h" if moves else participant.id


def _way(stage: Stage, participant: ConcreteParticipant, view: View) -> str:
    """The way still to come faintly dashed, the travelled one in full, with an arrow at its end."""
    path, trace = stage.paths[participant.id], stage.traces[participant.id]
    colour, width = stage.colour[participant.id], view.at_least(0.2, 1.8)
    travelled = float(trace.s_m[-1])
    whole = np.column_stack((path.x_m, path.y_m))
    seen, dashes = view.cut([whole]), f"{3 * width:.3f}"
    ahead = lines(seen, colour, width * 0.6, stroke_opacity=0.5, stroke_dasharray=dashes)
    points = shapely.get_coordinates(
        shapely.simplify(shapely.linestrings(np.column_stack((trace.x_m, trace.y_m))), 0.02)
    )
    done = lines(view.cut([points]), colour, width, stroke_linejoin="round")
    back = ""
    for begins, ends in path.backwards:
        if travelled > begins:
            s = np.linspace(begins, min(ends, travelled), 24)
            stretch = np.column_stack(path.places(s)[:2])
            dots = f"{width:.3f} {1.6 * width:.3f}"
            back += lines(view.cut([stretch]), stage.theme.mark, width * 0.6, stroke_dasharray=dots)
    head = ""
    if travelled >= 3.0 and view.shows(trace.x_m[-1], trace.y_m[-1]):
        tail, tip = points[-2:].tolist()
        head = area(arrow_head([tuple(tail), tuple(tip)], 3.6 * width), colour)
    return ahead + done + back + head


def gap_between(stage: Stage, view: View, encounter: Encounter) -> tuple[str, Label]:
    """The shortest line between the ego and the other, and how long it is."""
    names = (stage.concrete.ego.id, encounter.other)
    polygons = [shapely.Polygon(stage.box_of(name, encounter.step)) for name in names]
    ends = shapely.get_coordinates(shapely.shortest_line(*polygons))
    drawn = line(ends, stage.theme.hazard, view.at_least(0.1, 2.0))
    words = f"{encounter.distance_m:.1f} m"
    return drawn, Label(words, around(view, ends), bold=True, colour=stage.theme.hazard)


def _scale_bar(view: View, theme: Theme) -> tuple[str, Rectangle]:
    """A bar of a round length in the lower left corner, and the place it takes."""
    length = next((n for n in _ROUND_M if n * view.scale > 55), _ROUND_M[-1])
    x, y = view.left + 12, view.top + view.height - 11
    right = x + length * view.scale
    words = f"{length} m"
    drawn = line([(x, y), (right, y)], theme.halo, 5) + line([(x, y), (right, y)], theme.text, 2.2)
    drawn += letters(words, x, y - 5, 11.5, theme.text, halo=theme.halo)
    return drawn, (x, y - 18, max(right, x + text_width(words, 11.5)), y + 3)


def around(view: View, points: Array) -> Rectangle:
    """Where points are on the picture."""
    seen = view.seen(points)
    (x0, y0), (x1, y1) = seen.min(axis=0).tolist(), seen.max(axis=0).tolist()
    return x0, y0, x1, y1


def _inside(view: View, at: Rectangle) -> bool:
    x, y = (at[0] + at[2]) / 2 - view.left, (at[1] + at[3]) / 2 - view.top
    return 0.0 <= x <= view.width and 0.0 <= y <= view.height


def _edges(frame: tuple[float, float, float, float]) -> list[Rectangle]:
    """The four sides of a frame, which no label may lie across."""
    left, top, width, height = frame
    right, bottom = left + width, top + height
    sides = [(x, top, x, bottom) for x in (left, right)]
    return [*sides, *((left, y, right, y) for y in (top, bottom))]

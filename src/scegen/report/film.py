"""A concrete scenario as moving pictures: a view that stays or follows, labels that stay put."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scegen.criticality.encounter import Encounter, closest_encounter
from scegen.motion import simulate
from scegen.motion.model import Array, Path, Trace
from scegen.report.bodies import braking
from scegen.report.camera import camera_views
from scegen.report.drawing import box, circle, document, letters, line
from scegen.report.moving_labels import MovingLabels
from scegen.report.stage import Stage, around, gap_between, make_stage, name_and_speed
from scegen.report.theme import Theme
from scegen.report.world import View, corners_at
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import ConcreteScenario

_BEFORE_S, _AFTER_S, _HOLD_S, _LAST_S = 6.0, 3.0, 1.2, 0.8
_BAR_PX, _STANDS_M = 4.0, 0.1


@dataclass(frozen=True, slots=True)
class Cut:
    """What of a scenario is shown, and how: seconds, pictures a second, width in pixels.

    Without ``begin_s`` and ``end_s`` these are the seconds around the closest approach; ``speed``
    1 is real time, less is slow motion.
    """

    begin_s: float | None = None
    end_s: float | None = None
    fps: float = 10.0
    speed: float = 1.0
    width: int = 720


@dataclass(frozen=True)
class Film:
    """Pictures by number, each with how long it stays (s)."""

    stage: Stage
    views: tuple[View, ...]
    times_s: Array
    lasts_s: Array
    size: tuple[int, int]
    _brakes: Mapping[str, NDArray[np.bool_]]
    _labels: MovingLabels
    _meeting: Encounter | None
    _ground: str

    def __len__(self) -> int:
        return len(self.times_s)

    def number_at(self, time_s: float) -> int:
        """The picture nearest to a moment."""
        return int(np.abs(self.times_s - time_s).argmin())

    @property
    def critical(self) -> int:
        """The picture of the closest approach, the first one where the ego is alone."""
        return 0 if self._meeting is None else self._meeting.step

    def picture(self, number: int) -> str:
        """A picture as an SVG document."""
        stage, view = self.stage, self.views[number]
        theme = stage.theme
        people = stage.concrete.participants
        lights = stage.surroundings.lights(view, float(self.times_s[number]))
        world = [self._ground, lights, *(self._ways(p.id, number, view) for p in people)]
        world.append(stage.bodies(number, view, self._brakes))
        meets = self._meeting is not None and number == self._meeting.step
        if meets and self._meeting is not None and self._meeting.distance_m > 0.0:
            world.append(gap_between(stage, view, self._meeting)[0])
        drawn = view.picture("".join(world), theme.ground)
        speeds = {p.id: float(stage.traces[p.id].speed_mps[number]) for p in people}
        words = {p.id: name_and_speed(p, speeds[p.id]) for p in people}
        labels = self._labels.drawn(number, words, theme)
        return document(*self.size, drawn + labels + self._clock(number, meets))

    def _ways(self, name: str, number: int, view: View) -> str:
        """Where somebody has been, and faintly where they are going."""
        trace, colour = self.stage.traces[name], self.stage.colour[name]
        way = np.column_stack((trace.x_m, trace.y_m))
        if np.ptp(way, axis=0).max() < _STANDS_M:
            return ""
        width = view.at_least(0.15, 1.5)
        drawn = ""
        if number < len(way) - 1:
            dashes = f"{3 * width:.3f}"
            ahead = way[number:]
            drawn += line(ahead, colour, width, stroke_opacity=0.45, stroke_dasharray=dashes)
        if number:
            drawn += line(way[: number + 1], colour, width * 1.4, stroke_opacity=0.6)
        return drawn

    def _clock(self, number: int, meets: bool) -> str:
        """The time, what happens at it, and how far the film has come."""
        theme, (width, height) = self.stage.theme, self.size
        words = f"{self.times_s[number]:.1f} s"
        if meets and self._meeting is not None:
            apart_m = self._meeting.distance_m
            words += f" – closest, {apart_m:.1f} m" if apart_m > 0.0 else " – contact"
        ink = theme.hazard if meets else theme.text
        drawn = letters(words, 10, 22, 15, ink, bold=True, halo=theme.halo)
        share = number / max(len(self) - 1, 1)
        drawn += box(0, height - _BAR_PX, width, _BAR_PX, theme.line)
        drawn += box(0, height - _BAR_PX, width * share, _BAR_PX, theme.accent)
        if self._meeting is not None:
            at = width * self._meeting.step / max(len(self) - 1, 1)
            drawn += circle(at, height - _BAR_PX / 2, _BAR_PX, theme.hazard)
        return drawn


def make_film(
    concrete: ConcreteScenario,
    network: RoadNetwork,
    paths: Mapping[str, Path],
    cut: Cut,
    theme: Theme,
) -> Film:
    """The film of a scenario; the same input gives the same pictures."""
    played = simulate(concrete, paths)
    met = closest_encounter(concrete, played)
    times = _times(cut, met, float(played[concrete.ego.id].time_s[-1]))
    traces = {name: _at(trace, times) for name, trace in played.items()}
    brakes = {
        name: braking(trace)[np.searchsorted(trace.time_s, times).clip(max=len(trace.s_m) - 1)]
        for name, trace in played.items()
    }
    stage = make_stage(concrete, network, paths, traces, theme)
    shown = met if met is not None and times[0] <= met.time_s <= times[-1] else None
    if shown is not None:
        shown = replace(shown, step=int(np.abs(times - shown.time_s).argmin()))
    views = camera_views(stage, shown, cut.width)
    size = (cut.width, round(views[0].height))
    lasts = np.full(len(times), 1.0 / cut.fps)
    lasts[-1] = max(lasts[-1], _LAST_S)
    if shown is not None:
        lasts[shown.step] = max(lasts[shown.step], _HOLD_S)
    people = concrete.ego_first
    boxes = {
        p.id: np.array([around(v, corners_at(traces[p.id], n)) for n, v in enumerate(views)])
        for p in people
    }
    longest = {p.id: name_and_speed(p, float(np.abs(traces[p.id].speed_mps).max())) for p in people}
    labels = MovingLabels.arranged(longest, boxes, size, concrete.ego.id)
    ground = stage.surroundings.drawn(views[0], cut=False)
    return Film(stage, views, times, lasts, size, brakes, labels, shown, ground)


def _times(cut: Cut, met: Encounter | None, end_s: float) -> Array:
    """Moments of the pictures (s); the closest approach is one of them."""
    middle = 0.0 if met is None else met.time_s
    begin = cut.begin_s if cut.begin_s is not None else max(middle - _BEFORE_S, 0.0)
    latest = end_s if met is None else min(middle + _AFTER_S, end_s)
    end = min(cut.end_s, end_s) if cut.end_s is not None else latest
    step = cut.speed / cut.fps
    if not begin <= middle <= end:
        middle = begin
    before, after = int((middle - begin) / step + 1e-9), int((end - middle) / step + 1e-9)
    return np.asarray(middle + step * np.arange(-before, max(after, 0) + 1)).clip(0.0, end_s)


def _at(trace: Trace, times: Array) -> Trace:
    """A trace with one step for each of these times."""
    heading = np.unwrap(trace.heading_rad)
    values = (trace.s_m, trace.x_m, trace.y_m, heading, trace.speed_mps)
    s, x, y, turned, speed = (np.interp(times, trace.time_s, value) for value in values)
    return Trace(trace.participant, trace.body, times, s, x, y, turned, speed)

"""The world from above: roads, marks, signs and objects in metres, and the view of them.

What is drawn here goes into :meth:`View.picture`, which turns metres (x east, y north) into
pixels; widths are in metres too, with a least width in pixels where the world is drawn small.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import atan2, cos, degrees, pi, sin

import numpy as np
import shapely

from scegen.motion.footprints import box_corners
from scegen.motion.model import Array, Path, Trace
from scegen.report.drawing import area, areas, box, circle, element, group, line, lines, number
from scegen.report.lane_shapes import RoadShapes, bays, road_shapes
from scegen.report.lights import Light, entry_of, lights_of, state_at
from scegen.report.theme import Theme
from scegen.road.geometry import Pose
from scegen.road.model import LaneType, RoadNetwork
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.control import LIGHTS, STOPS
from scegen.scenario.objects import ObjectCategory, StaticObject
from scegen.scenario.signals import SignalState
from scegen.scenario.vocabulary import Control

_MARK_M, _DASHES = 0.15, "3 4.5"
_SIGN_M, _SIGN_PX = 0.9, 5.0
_AFOOT = 0.75
"""The size of lights of people on foot, of that of others."""
_PLANTS = frozenset({ObjectCategory.TREE, ObjectCategory.VEGETATION})
_HATCH_M, _FAR_M = 0.6, 1e5
_BEYOND_M, _SIZE_M = 2.0, 12.0


@dataclass(frozen=True, slots=True)
class View:
    """A part of the world (middle and width, m) on a part of the picture (px)."""

    x_m: float
    y_m: float
    width_m: float
    left: float
    top: float
    width: float
    height: float

    @property
    def scale(self) -> float:
        """Pixels per metre."""
        return self.width / self.width_m

    @property
    def height_m(self) -> float:
        """How much of the world is seen from bottom to top."""
        return self.height / self.scale

    def at_least(self, width_m: float, width_px: float) -> float:
        """A width in metres that is no thinner than so many pixels."""
        return max(width_m, width_px / self.scale)

    def seen(self, points: Array) -> Array:
        """Points of the world (…, 2) as places on the picture."""
        middle = np.array((self.left + self.width / 2, self.top + self.height / 2))
        return middle + (points - (self.x_m, self.y_m)) * (self.scale, -self.scale)

    def picture(self, world: str, ground: str, name: str | None = None) -> str:
        """What is drawn in metres, on this ground, where this view shows it.

        With a name, which tells several views apart, nothing is drawn beyond the view's edges.
        """
        place = (self.left, self.top, self.width, self.height)
        x, y = self.seen(np.zeros(2)).tolist()
        k = f"{self.scale:.5f}"
        inside = group(world, transform=f"matrix({k} 0 0 -{k} {x:.3f} {y:.3f})")
        drawn = box(*place, ground) + inside
        if name is None:
            return drawn
        clip = element("clipPath", box(*place, "#000000"), id=f"in-{name}")
        return clip + group(drawn, clip_path=f"url(#in-{name})")

    def shows(self, x_m: float, y_m: float) -> bool:
        """Whether something there may be seen: a margin is left for its size."""
        return (
            abs(x_m - self.x_m) < self.width_m / 2 + _SIZE_M
            and abs(y_m - self.y_m) < self.height_m / 2 + _SIZE_M
        )

    def cut(self, many: Iterable[Array], *, closed: bool = False) -> list[Array]:
        """The parts of lines or polygons that are seen; what lies outside costs time to clip."""
        make = shapely.polygons if closed else shapely.linestrings
        shapes = shapely.make_valid([make(points) for points in many])
        w, h = self.width_m / 2 + _BEYOND_M, self.height_m / 2 + _BEYOND_M
        kept = shapely.clip_by_rect(shapes, self.x_m - w, self.y_m - h, self.x_m + w, self.y_m + h)
        wanted = "Polygon" if closed else "LineString"
        parts = [g for g in shapely.get_parts(kept) if g.geom_type == wanted and not g.is_empty]
        return [np.asarray((g.exterior if closed else g).coords) for g in parts]

    def frame(self, other: View) -> tuple[float, float, float, float]:
        """What another view shows, as a rectangle on this one: left, top, width, height."""
        x, y = self.seen(np.array([other.x_m, other.y_m])).tolist()
        width, height = other.width_m * self.scale, other.height_m * self.scale
        return x - width / 2, y - height / 2, width, height


class Surroundings:
    """All that never moves, drawn once and shown in every view and frame."""

    def __init__(
        self,
        concrete: ConcreteScenario,
        network: RoadNetwork,
        theme: Theme,
        paths: Mapping[str, Path],
    ) -> None:
        self._theme = theme
        self._shapes: RoadShapes = road_shapes(network, bays(concrete, paths))
        self._concrete = concrete
        self._entries = [entry_of(network, arm) for arm in sorted(concrete.road.controlled_arms)]
        self._lights = lights_of(concrete, network)

    def across(self, west_m: float, east_m: float) -> tuple[float, float]:
        """How far south and north the roads reach between two places."""
        lanes = [
            shapely.make_valid(shapely.Polygon(p)) for k in self._shapes.lanes.values() for p in k
        ]
        _, south, _, north = shapely.total_bounds(
            shapely.clip_by_rect(lanes, west_m, -_FAR_M, east_m, _FAR_M)
        ).tolist()
        return south, north

    def drawn(self, view: View, *, cut: bool = True) -> str:
        """Roads, marks, signs and objects, in metres; not cut to the view, it may move on."""
        theme, shapes = self._theme, self._shapes
        beside = {
            LaneType.SIDEWALK: theme.sidewalk,
            LaneType.BORDER: theme.shoulder,
            LaneType.SHOULDER: theme.parking,
            LaneType.MEDIAN: theme.shoulder,
            LaneType.PARKING: theme.parking,
            LaneType.BIKING: theme.cycle_lane,
        }

        def seen(found: list[Array], *, closed: bool = False) -> list[Array]:
            return view.cut(found, closed=closed) if cut else found

        def lanes(kind: LaneType) -> list[Array]:
            return seen(shapes.lanes.get(kind, []), closed=True)

        # The same colour around each lane closes hairline seams between roads.
        layers = [
            areas(lanes(kind), paint, stroke=paint, stroke_width=0.06)
            for kind, paint in beside.items()
        ]
        driving = lanes(LaneType.DRIVING)
        kerb, width = view.at_least(0.3, 1.6), view.at_least(_MARK_M, 0.9)
        layers.append(areas(driving, theme.kerb, stroke=theme.kerb, stroke_width=kerb))
        layers.append(areas(driving, theme.road, stroke=theme.road, stroke_width=0.06))
        layers.append(lines(seen(shapes.centre_lines + shapes.edge_lines), theme.mark, width))
        layers.append(lines(seen(shapes.lane_lines), theme.mark, width, stroke_dasharray=_DASHES))
        layers.append(areas(shapes.stripes, theme.mark))
        layers += [
            self._entry_marks(pose, half_m, view)
            for pose, half_m in self._entries
            if not cut or view.shows(pose.x_m, pose.y_m)
        ]
        layers += [
            self._thing(thing, view)
            for thing in self._concrete.objects
            if not cut or view.shows(thing.x_m, thing.y_m)
        ]
        return "".join(layers)

    def lights(self, view: View, time_s: float) -> str:
        """The lights beside the stop lines as they are at a time."""
        return "".join(
            self._light(light, view, state_at(self._concrete, light, time_s))
            for light in self._lights
            if view.shows(light.pose.x_m, light.pose.y_m)
        )

    def _light(self, light: Light, view: View, state: SignalState | None) -> str:
        """Three lamps on top of each other; two of people on foot, and smaller."""
        theme = self._theme
        size = view.at_least(_SIGN_M, _SIGN_PX) * (_AFOOT if light.afoot else 1.0)
        x, y = _beside(light.pose, light.left_m + size * (1.6 if light.left_m > 0 else -1.6))
        lamps = {
            SignalState.RED: theme.signal_red,
            SignalState.AMBER: theme.signal_amber,
            SignalState.GREEN: theme.signal_green,
        }
        if light.afoot:
            del lamps[SignalState.AMBER]
        high, dark = len(lamps) / 2, theme.signal_off
        drawn = box(-size * 0.6, -size * high, size * 1.2, size * 2 * high, theme.outline, rx=0.3)
        for n, (lit, colour) in enumerate(lamps.items()):
            ink = colour if lit is state else dark
            drawn += circle(0, size * (high - 0.5 - n), size * 0.36, ink)
        return group(drawn, transform=f"translate({number(x)} {number(y)})")

    def _entry_marks(self, pose: Pose, half_m: float, view: View) -> str:
        """The line to stop at and what stands beside it, for traffic that enters."""
        theme, size = self._theme, view.at_least(_SIGN_M, _SIGN_PX)
        control = self._concrete.road.control
        ends = [_beside(pose, t) for t in (0.2 * half_m / abs(half_m), half_m)]
        dashes = None if control in STOPS | LIGHTS else "0.5 0.35"
        stop = line(ends, theme.mark, view.at_least(0.4, 1.2), stroke_dasharray=dashes)
        x, y = _beside(pose, half_m + size * (1.6 if half_m > 0 else -1.6))
        if control in LIGHTS:
            return stop
        if control is Control.YIELD:
            shape, rim, width = _regular(3, size * 1.25, -pi / 2), theme.signal_red, size * 0.4
            drawn = area(shape, theme.mark, stroke=rim, stroke_width=width, stroke_linejoin="round")
        else:
            shape, rim, width = _regular(8, size, pi / 8), theme.mark, size * 0.2
            drawn = area(shape, theme.signal_red, stroke=rim, stroke_width=width)
        return stop + group(drawn, transform=f"translate({number(x)} {number(y)})")

    def _thing(self, thing: StaticObject, view: View) -> str:
        """An object: plants green and round, everything else a hatched box."""
        theme, corners = self._theme, thing_corners(thing)
        edge = view.at_least(0.1, 0.9)
        if thing.category in _PLANTS:
            width, green = min(thing.length_m, thing.width_m) * 0.3, theme.plant
            return area(corners, green, stroke=green, stroke_width=width, stroke_linejoin="round")
        a, b, c, d = corners
        count = max(2, round(float(np.hypot(*(a - d))) / _HATCH_M))
        rungs = [np.stack((d + (a - d) * u, c + (b - c) * u)) for u in np.linspace(0, 1, count + 1)]
        return area(corners, theme.thing) + lines(
            [*rungs, np.stack((a, b, c, d, a))], theme.outline, edge, stroke_linejoin="round"
        )


def placed(content: str, x_m: float, y_m: float, heading_rad: float) -> str:
    """What is drawn in the frame of a body (x ahead, y left), where the body is."""
    turn = degrees(atan2(sin(heading_rad), cos(heading_rad)))
    return group(content, transform=f"translate({x_m:.3f} {y_m:.3f}) rotate({turn:.2f})")


def _beside(pose: Pose, left_m: float) -> tuple[float, float]:
    shifted = pose.shifted(left_m=left_m)
    return shifted.x_m, shifted.y_m


def _regular(corners: int, radius: float, first: float) -> list[tuple[float, float]]:
    """A regular polygon around the origin."""
    turns = [first + 2 * pi * n / corners for n in range(corners)]
    return [(radius * cos(turn), radius * sin(turn)) for turn in turns]


def corners_at(trace: Trace, step: int) -> Array:
    """The corners (4, 2) of a participant's box at one step, its front first."""
    return box_corners(trace.body, trace.x_m[step], trace.y_m[step], trace.heading_rad[step])


def thing_corners(thing: StaticObject) -> Array:
    """Corners of a thing's box, (4, 2)."""
    return box_corners(thing.body, thing.x_m, thing.y_m, float(np.deg2rad(thing.heading_deg)))

"""Participants from above, to scale: who they are, which way they look, whether they brake."""

import numpy as np
import shapely
from numpy.typing import NDArray

from scegen.motion.footprints import box_corners
from scegen.motion.model import Array, Trace
from scegen.report.drawing import Style, area, box, circle, element
from scegen.report.theme import Theme
from scegen.report.world import corners_at
from scegen.scenario.bodies import Body
from scegen.scenario.vocabulary import ANIMALS, ON_FOOT, ParticipantKind

_NARROW = frozenset({ParticipantKind.BICYCLE, ParticipantKind.MOTORCYCLE})
_BEND_RAD = 0.04
_STANDS_MPS = 0.05
_SMALLEST_PX = 6.5
_FAINT = 0.35


def body(
    kind: ParticipantKind, size: Body, colour: str, theme: Theme, scale: float,
    *, ego: bool, braking: bool,
) -> str:  # fmt: skip
    """A participant in its own frame (m): x ahead of its reference point, y to its left.

    ``scale`` (px/m) keeps edges visible, and a ring shows who would be smaller than a few pixels.
    """
    rim: dict[str, Style] = {
        "stroke": theme.outline,
        "stroke_width": max(0.06, (1.6 if ego else 0.8) / scale),
    }
    wide = size.width_m
    if kind is ParticipantKind.DOOR:
        drawn = box(-size.rear_m, -wide / 2, size.length_m, wide, colour, **rim)
    elif kind in ANIMALS:
        drawn = _animal(size, colour, theme, rim)
    elif kind is ParticipantKind.PEDESTRIAN:
        drawn = element("ellipse", rx=0.16, ry=0.28, fill=colour, **rim)
        drawn += circle(0.04, 0, 0.13, theme.outline)
    elif kind in _NARROW:
        drawn = box(-size.rear_m, -0.1, size.length_m, 0.2, theme.outline, rx=0.1)
        middle = size.centre_ahead_m - 0.1
        drawn += element("ellipse", cx=middle, rx=0.3, ry=wide / 2, fill=colour, **rim)
        drawn += circle(middle + 0.05, 0, 0.15, theme.outline)
    else:
        drawn = _vehicle(kind, size, colour, theme, rim)
    if braking and kind not in ON_FOOT | {ParticipantKind.BICYCLE, ParticipantKind.DOOR}:
        glow, lights = _brake_lights(size.rear_m, size.width_m, theme, scale)
        drawn = glow + drawn + lights
    if max(size.length_m, size.width_m) * scale < 2 * _SMALLEST_PX:
        drawn = circle(0, 0, _SMALLEST_PX / scale, colour, fill_opacity=_FAINT) + drawn
    return drawn


def _animal(size: Body, colour: str, theme: Theme, rim: dict[str, Style]) -> str:
    """Seen from above: trunk, head and tail."""
    half, wide = size.length_m / 2, size.width_m / 2
    trunk = element("ellipse", cx=-0.1 * half, rx=0.75 * half, ry=wide, fill=colour, **rim)
    tail = box(-half, -0.1 * wide, 0.3 * half, 0.2 * wide, theme.outline)
    return tail + trunk + circle(0.7 * half, 0, 0.65 * wide, theme.outline)


def _vehicle(
    kind: ParticipantKind, size: Body, colour: str, theme: Theme, rim: dict[str, Style]
) -> str:
    """Anything with four wheels: its hull, and the glass that shows its front."""
    length, half, front = size.length_m, size.width_m / 2, size.front_m
    boxy = kind in {ParticipantKind.TRUCK, ParticipantKind.BUS}
    rounded = 0.25 if boxy else 0.55
    hull = box(-size.rear_m, -half, length, 2 * half, colour, rx=rounded, **rim)
    ahead, behind = (0.3, 0.9) if boxy else (0.26 * length, 0.42 * length)
    corners = ((ahead, -0.84), (ahead, 0.84), (behind, 0.68), (behind, -0.68))
    glass = [(front - back, aside * half) for back, aside in corners]
    drawn = hull + area(glass, theme.glass, fill_opacity=0.88)
    if kind is ParticipantKind.TRUCK:
        drawn += box(front - 2.1, -half, 0.12, 2 * half, theme.outline)
    elif kind is ParticipantKind.BUS:
        drawn += box(
            -size.rear_m + 1.0, -0.5 * half, length - 3.5, half, theme.glass, fill_opacity=0.3
        )
    else:
        rear = -size.rear_m + 0.1 * length
        drawn += box(rear, -0.66 * half, 0.09 * length, 1.32 * half, theme.glass, fill_opacity=0.6)
    if kind is ParticipantKind.EMERGENCY_VEHICLE:
        drawn += box(front - 0.58 * length, -0.8 * half, 0.4, 0.8 * half, theme.signal_red)
        drawn += box(front - 0.58 * length, 0, 0.4, 0.8 * half, theme.accent)
    return drawn


def _brake_lights(rear_m: float, width_m: float, theme: Theme, scale: float) -> tuple[str, str]:
    """What they light up behind the vehicle, and themselves."""
    deep = max(0.25, 2.2 / scale)
    wide = min(max(0.3 * width_m, 2.4 / scale), 0.5 * width_m)
    glow = lights = ""
    for low in (-width_m / 2, width_m / 2 - wide):
        glow += circle(-rear_m, low + wide / 2, 1.3 * wide, theme.brake_light, fill_opacity=0.4)
        lights += box(-rear_m - deep * 0.3, low, deep, wide, theme.brake_light)
    return glow, lights


def ghost(trace: Trace, step: int, colour: str, width_m: float) -> str:
    """Where somebody is at one step, as a dashed box that one can see through."""
    rim: dict[str, Style] = {"stroke": colour, "stroke_width": width_m}
    dashes = f"{4 * width_m:.3f} {2.5 * width_m:.3f}"
    at = corners_at(trace, step)
    return area(at, colour, fill_opacity=0.45, **rim, stroke_dasharray=dashes)


def swept(trace: Trace, first: int = 0, last: int | None = None) -> list[Array]:
    """The ground that a body covers between two steps, as outlines (n, 2); holes are left out."""
    steps = slice(first, None if last is None else last + 1)
    x, y, heading = trace.x_m[steps], trace.y_m[steps], trace.heading_rad[steps]
    # Between two steps without a turn or a change of direction the ground is a convex hull.
    ahead = np.diff(x) * np.cos(heading[:-1]) + np.diff(y) * np.sin(heading[:-1])
    bends = np.diff(np.floor(heading / _BEND_RAD)) != 0
    turns = np.flatnonzero(bends | np.diff(ahead >= 0.0, append=ahead[-1:] >= 0.0))
    keep = np.unique(np.concatenate(([0], turns, turns + 1, [len(x) - 1])))
    corners = box_corners(trace.body, x[keep], y[keep], heading[keep])
    pairs = np.concatenate((corners[:-1], corners[1:]), axis=1) if len(corners) > 1 else corners
    hulls = shapely.convex_hull(shapely.multipoints(pairs))
    ground = shapely.simplify(shapely.union_all(hulls), 0.05)
    parts = [p for p in shapely.get_parts(ground) if p.geom_type == "Polygon"]
    return [np.asarray(part.exterior.coords) for part in parts]


def braking(trace: Trace, least_mps2: float = 0.5) -> NDArray[np.bool_]:
    """In which steps brake lights are on, (steps,): while it slows down, and stands after that."""
    if len(trace.time_s) < 2:
        return np.zeros(len(trace.time_s), dtype=bool)
    speed = np.abs(trace.speed_mps)
    slower = np.gradient(speed, trace.time_s) < -least_mps2
    stopped: NDArray[np.bool_] = (speed < _STANDS_MPS) & np.logical_or.accumulate(slower)
    return slower | stopped

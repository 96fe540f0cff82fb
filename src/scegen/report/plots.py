"""Speed, distance to the ego and time to collision over time, as one drawing in SVG."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from html import escape
from math import ceil

import numpy as np
from numpy.typing import NDArray

from scegen.criticality.course import Course
from scegen.report.theme import LIGHT
from scegen.scenario.concrete import ConcreteScenario

Array = NDArray[np.float64]

WIDTH, LEFT, RIGHT, TOP, BOTTOM = 960, 64, 16, 58, 34
PANEL, GAP = 112, 34
_FARTHEST_M = 60.0
_LONGEST_TTC_S = 6.0
_CRITICAL_TTC_S = 1.5
_EVERY = 2
"""Steps per drawn point: 0.1 s."""
_INK, _SOFT, _GRID, _MARK = "#1b2330", "#4e5968", "#dde2e8", "#b3261e"
_DASHES = ("", "7 3", "2 3", "9 3 2 3")
"""Of those who share a colour, or whose colours look alike to some."""


@dataclass(frozen=True, slots=True)
class _Panel:
    title: str
    series: Mapping[str, Array]
    highest: float
    threshold: tuple[float, str] | None = None


def plots_svg(concrete: ConcreteScenario, course: Course) -> str:
    """The course as three panels with the critical moment marked; same input, same text.

    The ego comes first. Distances above 60 m and times to collision above 6 s lie outside. Those
    who stand beside the road are left out, unless the critical moment is theirs.
    """
    ego = concrete.ego.id
    people = (concrete.ego, *(p for p in concrete.participants if p.id != ego))
    shown = [p.id for p in people if not p.parked or p.id == course.partner]
    shown += [thing.id for thing in concrete.objects if thing.id == course.partner]
    colour = LIGHT.colours([entity.id for entity in concrete.entities], ego)
    speeds = {name: course.speed_mps[name] for name in shown}
    apart = {name: course.distance_m[name] for name in shown if name != ego}
    ttc = {name: course.ttc_s[name] for name in shown if name != ego}
    fastest = max((float(series.max()) for series in speeds.values()), default=1.0)
    farthest = max((float(series.max()) for series in apart.values()), default=1.0)
    panels = [_Panel("speed, m/s", speeds, max(5.0, fastest * 1.05))]
    if apart:
        panels.append(_Panel("distance to the ego, m", apart, min(_FARTHEST_M, farthest + 1.0)))
        critical = (_CRITICAL_TTC_S, "1.5 s")
        panels.append(_Panel("time to collision, s", ttc, _LONGEST_TTC_S, critical))
    height = TOP + len(panels) * (PANEL + GAP) - GAP + BOTTOM
    end_s = float(course.time_s[-1]) or 1.0
    moment = _moment(course)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" role="img" '
        f'font-family="system-ui, sans-serif" font-size="12" fill="{_INK}">',
        f"<title>Speed, distance to the ego and time to collision; {escape(moment)}</title>",
        *_legend(shown, colour, ego),
    ]
    for number, panel in enumerate(panels):
        top = TOP + number * (PANEL + GAP)
        parts += _panel(panel, top, course.time_s, end_s, colour, shown)
    parts += _times(end_s, height)
    if course.partner:
        parts += _mark(course, end_s, height, moment)
    return "\n".join([*parts, "</svg>"])


def _moment(course: Course) -> str:
    if not course.partner:
        return "the ego is alone"
    time_s, apart = course.time_s[course.step], course.distance_m[course.partner][course.step]
    if apart <= 0.0:
        return f"contact with {course.partner} at {time_s:.2f} s"
    return f"closest to {course.partner}, {apart:.2f} m, at {time_s:.2f} s"


def _x(time_s: float, end_s: float) -> float:
    return LEFT + (WIDTH - LEFT - RIGHT) * time_s / end_s


def _dash(name: str, shown: list[str]) -> str:
    pattern = _DASHES[shown.index(name) % len(_DASHES)]
    return f' stroke-dasharray="{pattern}"' if pattern else ""


def _legend(shown: list[str], colour: Mapping[str, str], ego: str) -> list[str]:
    parts, x = [], float(LEFT)
    for name in shown:
        words = f"{name} (ego)" if name == ego != "ego" else name
        parts.append(
            f'<path d="M{x:.0f} 14h26" stroke="{colour[name]}" stroke-width="2.5"'
            f'{_dash(name, shown)}/><text x="{x + 32:.0f}" y="18">{escape(words)}</text>'
        )
        x += 48 + 7.2 * len(words)
    return parts


def _panel(
    panel: _Panel,
    top: float,
    times: Array,
    end_s: float,
    colour: Mapping[str, str],
    shown: list[str],
) -> list[str]:
    def y(value: float) -> float:
        return top + PANEL * (1.0 - value / panel.highest)

    parts = [f'<text x="{LEFT}" y="{top - 6}" font-weight="600">{panel.title}</text>']
    step = _tick(panel.highest, 5)
    for n in range(int(panel.highest / step + 1e-9) + 1):
        level = y(n * step)
        parts.append(
            f'<path d="M{LEFT} {level:.1f}H{WIDTH - RIGHT}" stroke="{_GRID}"/>'
            f'<text x="{LEFT - 8}" y="{level + 4:.1f}" text-anchor="end" fill="{_SOFT}">'
            f"{n * step:g}</text>"
        )
    if panel.threshold is not None:
        level, words = y(panel.threshold[0]), panel.threshold[1]
        parts.append(
            f'<path d="M{LEFT} {level:.1f}H{WIDTH - RIGHT}" stroke="{_MARK}" '
            f'stroke-dasharray="1 4"/><text x="{WIDTH - RIGHT - 4}" y="{level - 4:.1f}" '
            f'text-anchor="end" fill="{_MARK}">critical below {words}</text>'
        )
    for name, series in panel.series.items():
        points = _points(series, times, end_s, panel.highest, top)
        if points:
            width = "2.5" if name == shown[0] else "2"
            parts.append(
                f'<path d="{points}" fill="none" stroke="{colour[name]}" stroke-width="{width}"'
                f"{_dash(name, shown)}/>"
            )
    return parts


def _points(series: Array, times: Array, end_s: float, highest: float, top: float) -> str:
    """The path of a series; where it lies above the panel, there is a gap."""
    parts: list[str] = []
    drawing = False
    for time_s, value in zip(times[::_EVERY].tolist(), series[::_EVERY].tolist(), strict=True):
        if not value <= highest:
            drawing = False
            continue
        at = f"{_x(time_s, end_s):.1f} {top + PANEL * (1.0 - value / highest):.1f}"
        parts.append(f"{'L' if drawing else 'M'}{at}")
        drawing = True
    return "".join(parts)


def _times(end_s: float, height: int) -> list[str]:
    step = _tick(end_s, 10)
    bottom = height - BOTTOM
    parts = [
        f'<text x="{_x(n * step, end_s):.1f}" y="{bottom + 16}" text-anchor="middle" '
        f'fill="{_SOFT}">{n * step:g}</text>'
        for n in range(int(end_s / step + 1e-9) + 1)
    ]
    middle = (LEFT + WIDTH - RIGHT) / 2
    parts.append(
        f'<text x="{middle:.0f}" y="{bottom + 31}" text-anchor="middle" fill="{_SOFT}">'
        "time, s</text>"
    )
    return parts


def _mark(course: Course, end_s: float, height: int, moment: str) -> list[str]:
    """The critical moment: a line through all panels, with words on the side that has room."""
    x = _x(float(course.time_s[course.step]), end_s)
    side, anchor = (-6, "end") if x > WIDTH / 2 else (6, "start")
    return [
        f'<path d="M{x:.1f} 28V{height - BOTTOM}" stroke="{_MARK}" stroke-width="1.5" '
        f'stroke-dasharray="5 3"/>',
        f'<text x="{x + side:.1f}" y="38" text-anchor="{anchor}" fill="{_MARK}" '
        f'font-weight="600">{escape(moment)}</text>',
    ]


def _tick(highest: float, most: int) -> float:
    """A round distance between at most so many ticks up to ``highest``."""
    for step in (0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0):
        if highest / step <= most:
            return step
    return float(ceil(highest / most))

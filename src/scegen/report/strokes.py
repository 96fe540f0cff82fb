"""What a tile is drawn with: arrows, walks, boxes, badges and the marks of conflicts, as SVG."""

from __future__ import annotations

from collections.abc import Iterable

from scegen.report.plan import Point, arrow_head
from scegen.scenario.logical import ConflictKind

MIDDLE = 120.0
"""Where the middle of the picture lies in a tile."""
MARK, TEXT = "#ffffff", "#1b2330"


def xy(point: Point) -> str:
    """A point as in SVG, in the frame of a tile."""
    return f"{point[0] + MIDDLE:.1f} {MIDDLE - point[1]:.1f}"


def path_data(points: Iterable[Point], *, closed: bool = False) -> str:
    """A line as the data of an SVG path."""
    return "M" + "L".join(xy(p) for p in points) + ("Z" if closed else "")


def arrow(line: list[Point], colour: str, *, ego: bool) -> str:
    """The way of a vehicle."""
    head = arrow_head(line, 9.0 if ego else 7.5)
    d, h = path_data(line), path_data(head, closed=True)
    x, y = xy(line[0]).split()
    common = 'fill="none" stroke-linecap="round" stroke-linejoin="round"'
    edge, width, dot = ("#000000", 4.4, 6.0) if ego else (MARK, 3.0, 3.6)
    letter = (
        f'<text x="{x}" y="{float(y) + 3:.1f}" text-anchor="middle" font-size="8.5" '
        f'font-weight="700" fill="{MARK}">E</text>'
        if ego
        else ""
    )
    return (
        f'<path d="{d}" stroke="{edge}" stroke-width="{width + 2:.1f}" {common}/>'
        f'<path d="{h}" fill="{edge}" stroke="{edge}" stroke-width="2.4"/>'
        f'<circle cx="{x}" cy="{y}" r="{dot + 1.2:.1f}" fill="{edge}"/>'
        f'<path d="{d}" stroke="{colour}" stroke-width="{width}" {common}/>'
        f'<path d="{h}" fill="{colour}"/><circle cx="{x}" cy="{y}" r="{dot}" fill="{colour}"/>'
        f"{letter}"
    )


def reverse_badge(line: list[Point], colour: str) -> str:
    """An R on the way of one that drives backwards on it."""
    x, y = xy(line[len(line) // 3]).split()
    return (
        f'<circle cx="{x}" cy="{y}" r="6" fill="{MARK}" stroke="{colour}" stroke-width="1.5"/>'
        f'<text x="{x}" y="{float(y) + 3:.1f}" text-anchor="middle" font-size="8.5" '
        f'font-weight="700" fill="{colour}">R</text>'
    )


def walk(line: list[Point], colour: str) -> str:
    """The way of one who crosses an arm."""
    x, y = xy(line[0]).split()
    d, h = path_data(line), path_data(arrow_head(line, 7.0), closed=True)
    return (
        f'<path d="{d}" stroke="{MARK}" stroke-width="4.6" fill="none"/>'
        f'<path d="{d}" stroke="{colour}" stroke-width="2.6" stroke-dasharray="4.5 3" '
        f'fill="none"/><path d="{h}" fill="{colour}"/>'
        f'<circle cx="{x}" cy="{y}" r="4.2" fill="{colour}" stroke="{MARK}"/>'
    )


def conflict_mark(kind: ConflictKind, point: Point) -> str:
    """Told apart by shape, not by colour: a ring for a crossing, a diamond for a merge."""
    x, y = point[0] + MIDDLE, MIDDLE - point[1]
    paint = f'fill="{MARK}" stroke="{TEXT}" stroke-width="1.5"'
    if kind is ConflictKind.CROSSING:
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.4" {paint}/>'
    return f'<path d="M{x:.1f} {y - 4.4:.1f}l4.4 4.4l-4.4 4.4l-4.4-4.4Z" {paint}/>'


def box(corners: list[Point], colour: str) -> str:
    """A standing vehicle."""
    return (
        f'<path d="{path_data(corners, closed=True)}" fill="{colour}" stroke="{TEXT}" '
        'stroke-width="1" stroke-linejoin="round"/>'
    )

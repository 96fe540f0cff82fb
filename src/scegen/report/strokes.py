"""What a tile is drawn with: arrows, walks, boxes, badges and the marks of conflicts."""

from collections.abc import Iterable

from scegen.report.drawing import Style, area, circle, letters, line
from scegen.report.plan import Point, arrow_head
from scegen.report.theme import Theme
from scegen.scenario.logical import ConflictKind

MIDDLE = 120.0
"""Where the middle of the picture lies in a tile."""
_ROUND: dict[str, Style] = {"stroke_linecap": "round", "stroke_linejoin": "round"}


def in_tile(points: Iterable[Point]) -> list[Point]:
    """Points of a plan in the frame of a tile, y down, to a tenth of a pixel."""
    return [(round(x + MIDDLE, 1), round(MIDDLE - y, 1)) for x, y in points]


def arrow(way: list[Point], colour: str, theme: Theme, *, ego: bool) -> str:
    """The way of a vehicle; the ego's is thicker, with a dark edge and its letter."""
    points, head = in_tile(way), in_tile(arrow_head(way, 9.0 if ego else 7.5))
    edge, width, dot = (theme.outline, 4.4, 6.0) if ego else (theme.mark, 3.0, 3.6)
    drawn = line(points, edge, width + 2.0, **_ROUND)
    drawn += area(head, edge, stroke=edge, stroke_width=2.4)
    drawn += circle(*points[0], dot + 1.2, edge)
    drawn += line(points, colour, width, **_ROUND) + area(head, colour)
    drawn += circle(*points[0], dot, colour)
    return drawn + (_letter("E", points[0], theme.mark) if ego else "")


def reverse_badge(way: list[Point], colour: str, theme: Theme) -> str:
    """An R on the way of one that drives backwards on it."""
    place = in_tile(way)[len(way) // 3]
    disc = circle(*place, 6, theme.mark, stroke=colour, stroke_width=1.5)
    return disc + _letter("R", place, colour)


def walk(way: list[Point], colour: str, theme: Theme) -> str:
    """The way of one who crosses an arm."""
    points, head = in_tile(way), in_tile(arrow_head(way, 7.0))
    drawn = line(points, theme.mark, 4.6) + line(points, colour, 2.6, stroke_dasharray="4.5 3")
    return drawn + area(head, colour) + circle(*points[0], 4.2, colour, stroke=theme.mark)


def conflict_mark(kind: ConflictKind, point: Point, theme: Theme) -> str:
    """Told apart by shape, not by colour: a ring for a crossing, a diamond for a merge."""
    ((x, y),) = in_tile([point])
    paint: dict[str, Style] = {"stroke": theme.text, "stroke_width": 1.5}
    if kind is ConflictKind.CROSSING:
        return circle(x, y, 3.4, theme.mark, **paint)
    corners = [(x, y - 4.4), (x + 4.4, y), (x, y + 4.4), (x - 4.4, y)]
    return area(corners, theme.mark, **paint)


def standing(corners: list[Point], colour: str, theme: Theme) -> str:
    """A standing vehicle."""
    return area(in_tile(corners), colour, stroke=theme.text, stroke_linejoin="round")


def _letter(letter: str, place: Point, ink: str) -> str:
    return letters(letter, place[0], place[1] + 3, 8.5, ink, bold=True, text_anchor="middle")

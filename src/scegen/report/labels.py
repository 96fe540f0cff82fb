"""Places for labels: beside what they name, inside the picture, never on one another."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import cos, hypot, pi, sin

from scegen.motion.model import Array
from scegen.report.drawing import letters, line
from scegen.report.raster import text_width
from scegen.report.theme import Theme

Rectangle = tuple[float, float, float, float]
"""Left, top, right, bottom in pixels."""

_SIZE = 12.5
_TURNS = (90, 270, 45, 135, 315, 225, 0, 180)
_FARTHER_PX = (6.0, 16.0, 30.0, 48.0, 72.0, 100.0, 140.0, 190.0)
_LED_FROM_PX = 22.0
_ON_WAY, _ON_BODY, _PER_PX = 1.2, 60.0, 0.5
WAY_STEP_PX = 3.0
"""How far apart the points are that stand for a way."""
_MARGIN = 3.0


@dataclass(frozen=True, slots=True)
class Label:
    """Words that belong to the rectangle ``at`` on the picture."""

    words: str
    at: Rectangle
    bold: bool = False
    colour: str | None = None


@dataclass(frozen=True, slots=True)
class Placed:
    """A label with its rectangle; ``led`` where a line leads to what it names."""

    label: Label
    where: Rectangle
    led: bool


def place(
    labels: Sequence[Label], inside: Rectangle, taken: Iterable[Rectangle], ways: Array
) -> list[Placed]:
    """A place for each label that has one, first come first served; the others are left out.

    The most telling come first. They lie ``inside``, never on what is ``taken``, and rather not on
    ``ways``: points (n, 2) so many pixels apart.
    """
    walls = list(taken)
    bodies = [label.at for label in labels]
    found = []
    for label in labels:
        options = [
            (_cost(where, apart, bodies, ways), number, where, apart)
            for number, (where, apart) in enumerate(_candidates(label))
            if _contains(inside, where) and not any(_overlap(where, wall) for wall in walls)
        ]
        if not options:
            continue
        _, _, where, apart = min(options)
        walls.append(where)
        found.append(Placed(label, where, apart > _LED_FROM_PX))
    return found


def draw_labels(placed: Iterable[Placed], theme: Theme) -> str:
    """The labels, each with a thin line to what it names where that is not next to it."""
    leaders, words = [], []
    for item in placed:
        left, top, right, bottom = item.where
        if item.led:
            x0, y0, x1, y1 = item.label.at
            middle = ((x0 + x1) / 2, (y0 + y1) / 2)
            end = (min(max(middle[0], left), right), min(max(middle[1], top), bottom))
            leaders.append(line([end, middle], theme.text_soft, 0.9))
        label, base = item.label, bottom - 0.28 * (bottom - top)
        ink = label.colour or theme.text
        words.append(letters(label.words, left, base, _SIZE, ink, bold=label.bold, halo=theme.halo))
    return "".join(leaders + words)


def _candidates(label: Label) -> Iterable[tuple[Rectangle, float]]:
    x0, y0, x1, y1 = label.at
    width = text_width(label.words, _SIZE, bold=label.bold)
    height = 1.35 * _SIZE
    for apart in _FARTHER_PX:
        for turn in _TURNS:
            c, s = cos(turn * pi / 180), -sin(turn * pi / 180)
            x = (x0 + x1) / 2 + c * ((x1 - x0 + width) / 2 + apart)
            y = (y0 + y1) / 2 + s * ((y1 - y0 + height) / 2 + apart)
            yield (x - width / 2, y - height / 2, x + width / 2, y + height / 2), apart


def _cost(where: Rectangle, apart: float, bodies: Iterable[Rectangle], ways: Array) -> float:
    left, top, right, bottom = where
    on_bodies = sum(_overlap(where, body) for body in bodies)
    x, y = ways[:, 0], ways[:, 1]
    on_ways = int(((x > left) & (x < right) & (y > top) & (y < bottom)).sum())
    across = hypot(right - left, bottom - top)
    return _PER_PX * apart + _ON_BODY * on_bodies + _ON_WAY * 100 * on_ways / across


def _overlap(a: Rectangle, b: Rectangle) -> bool:
    gaps = (a[0] - b[2], b[0] - a[2], a[1] - b[3], b[1] - a[3])
    return max(gaps) < _MARGIN


def _contains(outer: Rectangle, inner: Rectangle) -> bool:
    gaps = (inner[0] - outer[0], inner[1] - outer[1], outer[2] - inner[2], outer[3] - inner[3])
    return min(gaps) >= _MARGIN

"""All logical scenarios of a description in one picture, after the source paper's figure."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape

from scegen.report.tile import TILE_WIDTH, arm_legend, roads, tile_body, tile_height
from scegen.scenario.logical import LogicalScenario, LogicalSet

MOST_TILES = 500
"""More than this nobody looks at; the rest is counted in a note."""
MOST_CHARACTERS = 2_800_000
"""Larger pictures open slowly; tiles beyond are counted in the note, too."""
_COLUMNS = 5
_GAP = 12
_HEAD = 108
_HEADING = 34
_GROUPED = 20
"""So many scenarios are grouped by pattern."""
_INK = "#1b2330"


@dataclass(frozen=True, slots=True)
class Tiles:
    """The scenarios of a set that are drawn, and each as elements that refer to ``junction``.

    Drawn once, and shown in the gallery and in the report.
    """

    shown: tuple[LogicalScenario, ...]
    bodies: tuple[str, ...]
    junction: str


def draw_tiles(logical_set: LogicalSet) -> Tiles:
    """As many as anybody looks at, from the first."""
    functional = logical_set.functional
    shown = logical_set.scenarios[:MOST_TILES]
    bodies = [tile_body(s, functional, '<use href="#junction"/>') for s in shown]
    while sum(map(len, bodies)) > MOST_CHARACTERS:
        bodies.pop()
    junction = f'<g id="junction">{roads(functional)}</g>'
    return Tiles(shown[: len(bodies)], tuple(bodies), junction)


def gallery_svg(logical_set: LogicalSet, drawn: Tiles | None = None) -> str:
    """A grid of the logical scenarios as an SVG document; the same input gives the same text.

    Many scenarios are grouped by pattern. The junction is drawn once and referred to.
    """
    functional = logical_set.functional
    drawn = drawn or draw_tiles(logical_set)
    shown, tiles = drawn.shown, drawn.bodies
    columns = max(min(_COLUMNS, len(shown)), 3)
    width = _GAP + columns * (TILE_WIDTH + _GAP)
    height = tile_height(functional)
    parts, y = [], _HEAD
    for heading, members in groups(shown):
        if heading:
            parts.append(
                f'<text x="{_GAP}" y="{y + 22}" font-size="15" font-weight="700" fill="{_INK}">'
                f"{escape(heading)}</text>"
            )
            y += _HEADING
        for place, member in enumerate(members):
            x = _GAP + (place % columns) * (TILE_WIDTH + _GAP)
            row = y + (place // columns) * (height + _GAP)
            parts.append(
                f'<g transform="translate({x} {row})"><rect width="{TILE_WIDTH}" '
                f'height="{height}" rx="8" fill="#fbfcfd" stroke="#dde2e8"/>{tiles[member]}</g>'
            )
        y += -(-len(members) // columns) * (height + _GAP)
    title = f"{counted(len(logical_set.scenarios), 'logical scenario')}"
    total = y + _GAP
    head = [
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{total}" '
            f'viewBox="0 0 {width} {total}" role="img" font-family="system-ui, sans-serif">'
            f"<title>{escape(title)}</title><desc>{escape(summary(logical_set))}</desc>"
            f"<defs>{drawn.junction}</defs>"
            f'<rect width="{width}" height="{total}" fill="#ffffff"/>'
            f'<text x="{_GAP}" y="28" font-size="18" font-weight="700" fill="{_INK}">'
            f"{escape(title)}</text>"
        ),
    ]
    for number, line in enumerate(_notes(logical_set, len(shown))):
        head.append(
            f'<text x="{_GAP}" y="{47 + 17 * number}" font-size="12.5" fill="#5b6675">'
            f"{escape(line)}</text>"
        )
    return "\n".join([*head, *parts, "</svg>\n"])


def groups(shown: tuple[LogicalScenario, ...]) -> list[tuple[str, list[int]]]:
    """Places in the list by pattern, with a heading; few or all different ones stay in a row."""
    by_pattern: dict[tuple[int, ...], list[int]] = {}
    for place, scenario in enumerate(shown):
        by_pattern.setdefault(scenario.pattern, []).append(place)
    if len(shown) < _GROUPED or len(by_pattern) > len(shown) / 2:
        return [("", list(range(len(shown))))]
    groups = []
    for pattern, members in sorted(by_pattern.items()):
        size = sum(shown[place].class_size for place in members)
        times = f", {counted(size, 'assignment')}" if size > len(members) else ""
        moves = " ".join(map(str, pattern)) or "–"
        groups.append((f"Moves {moves}: {counted(len(members), 'scenario')}{times}", members))
    return groups


def summary(logical_set: LogicalSet) -> str:
    """What was counted, and under which reduction, in one sentence."""
    certificate = logical_set.certificate
    return (
        f"{counted(certificate.total, 'assignment')} of entries and moves fall into "
        f"{counted(certificate.count, 'scenario')} "
        f"(reduction {logical_set.reduction}, arms {logical_set.arms}"
        f"{'' if certificate.complete else ', listing incomplete'})"
    )


def counted(number: int, noun: str) -> str:
    """``1 scenario``, ``1,024 scenarios``."""
    return f"{number:,} {noun}" if number == 1 else f"{number:,} {noun}s"


def _notes(logical_set: LogicalSet, shown: int) -> list[str]:
    missing = max(len(logical_set.scenarios), logical_set.certificate.count) - shown
    more = f" — {missing:,} more not drawn" if missing > 0 else ""
    return [
        summary(logical_set) + more,
        f"Arms: {arm_legend(logical_set.functional)}",
        "Ways cross at a ring ○ and merge at a diamond ◇; E is the ego; "
        "×n: the scenario stands for n assignments.",
        "Moves: how many arms further on, counter-clockwise, each vehicle leaves.",
    ]

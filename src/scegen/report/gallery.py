"""All logical scenarios of a description in one picture, after the source paper's figure."""

from __future__ import annotations

from html import escape

from scegen.report.tile import TILE_WIDTH, arm_legend, tile_body, tile_height
from scegen.scenario.logical import LogicalSet

MOST_TILES = 200
"""More than this nobody looks at; the rest is counted in a note."""
_COLUMNS = 5
_GAP = 12
_HEAD = 74


def gallery_svg(logical_set: LogicalSet) -> str:
    """A grid of the logical scenarios as an SVG document; the same input gives the same text."""
    functional = logical_set.functional
    shown = logical_set.scenarios[:MOST_TILES]
    columns = max(min(_COLUMNS, len(shown)), 3)
    rows = -(-len(shown) // columns)
    height = tile_height(functional)
    width = _GAP + columns * (TILE_WIDTH + _GAP)
    total = _HEAD + rows * (height + _GAP) + _GAP
    title = f"{counted(len(logical_set.scenarios), 'logical scenario')}"
    parts = [
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{total}" '
            f'viewBox="0 0 {width} {total}" role="img" font-family="system-ui, sans-serif">'
            f"<title>{escape(title)}</title><desc>{escape(summary(logical_set))}</desc>"
            f'<rect width="{width}" height="{total}" fill="#ffffff"/>'
            f'<text x="{_GAP}" y="28" font-size="18" font-weight="700" fill="#1b2330">'
            f"{escape(title)}</text>"
        ),
    ]
    for number, line in enumerate(_notes(logical_set, len(shown))):
        parts.append(
            f'<text x="{_GAP}" y="{47 + 17 * number}" font-size="12.5" fill="#5b6675">'
            f"{escape(line)}</text>"
        )
    for place, scenario in enumerate(shown):
        x = _GAP + (place % columns) * (TILE_WIDTH + _GAP)
        y = _HEAD + (place // columns) * (height + _GAP)
        parts.append(
            f'<g transform="translate({x} {y})"><rect width="{TILE_WIDTH}" height="{height}" '
            f'rx="8" fill="#fbfcfd" stroke="#dde2e8"/>{tile_body(scenario, functional)}</g>'
        )
    parts.append("</svg>\n")
    return "\n".join(parts)


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
    return [summary(logical_set) + more, f"Arms: {arm_legend(logical_set.functional)}"]

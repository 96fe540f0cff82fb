"""Plots as SVG, by the one drawing layer; colours are the page's own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from scegen.campaign.analysis.features import Floats
from scegen.report.drawing import box, document, letters, line

_WIDTH, _HEIGHT, _LEFT, _RIGHT, _BOTTOM, _TOP = 420.0, 190.0, 44.0, 26.0, 30.0, 24.0
_BARS = 24
_ROW, _NAMES = 22.0, 190.0
_TEXT, _SOFT, _BAR, _GRID = "var(--text)", "var(--text-soft)", "var(--accent)", "var(--line)"
SHADES = ("var(--held)", "var(--failed)", "var(--open)", "var(--accent)")


def histogram(title: str, unit: str, values: Floats, critical: float | None = None) -> str:
    """How often which values occur; ``critical`` is marked. Empty where there are no values."""
    known = values[np.isfinite(values)]
    if not len(known):
        return ""
    low, high = float(known.min()), float(np.quantile(known, 0.99))
    high = high if high > low else low + 1.0
    counts, edges = np.histogram(np.minimum(known, high), bins=_BARS, range=(low, high))
    most = int(counts.max())
    wide, tall = _WIDTH - _LEFT - _RIGHT, _HEIGHT - _BOTTOM - _TOP

    def x(value: float) -> float:
        return _LEFT + (value - low) / (high - low) * wide

    parts = [letters(f"{title}, {unit} ({len(known):,} scenarios)", 0, 14, 13, _TEXT, bold=True)]
    for share in (0.0, 0.5, 1.0):
        y = _TOP + tall * (1 - share)
        parts.append(line([(_LEFT, y), (_WIDTH - _RIGHT, y)], _GRID, 1))
        parts.append(
            letters(f"{share * most:,.4g}", _LEFT - 6, y + 4, 11, _SOFT, text_anchor="end")
        )
    for count, left, right in zip(counts, edges, edges[1:], strict=False):
        height = tall * float(count) / most
        parts.append(box(x(left) + 0.5, _TOP + tall - height, x(right) - x(left) - 1, height, _BAR))
    for value in np.linspace(low, high, 5):
        words = f"{value:.3g}" + ("+" if value == high and known.max() > high else "")
        parts.append(letters(words, x(value), _HEIGHT - 12, 11, _SOFT, text_anchor="middle"))
    if critical is not None and low <= critical <= high:
        rule = [(x(critical), _TOP), (x(critical), _TOP + tall)]
        parts.append(line(rule, "var(--failed)", 1.5, stroke_dasharray="4 3"))
    return document(_WIDTH, _HEIGHT, "".join(parts), title=f"{title}, {unit}")


def bars(title: str, rows: Mapping[str, Sequence[int]], names: Sequence[str]) -> str:
    """A bar for each row, of as many parts as there are names. Empty where there are no rows."""
    if not rows:
        return ""
    most = max(sum(parts) for parts in rows.values()) or 1
    height = _TOP + _ROW * len(rows) + _ROW
    width = _WIDTH * 1.4
    drawn = [letters(title, 0, 14, 13, _TEXT, bold=True)]
    for number, (name, counts) in enumerate(rows.items()):
        y = _TOP + _ROW * number
        drawn.append(letters(name[:34], _NAMES - 8, y + 14, 12, _TEXT, text_anchor="end"))
        x = _NAMES
        for count, shade in zip(counts, SHADES, strict=False):
            size = (width - _NAMES - 60) * count / most
            drawn.append(box(x, y + 3, size, _ROW - 7, shade))
            x += size
        drawn.append(letters(f"{sum(counts):,}", x + 5, y + 14, 11, _SOFT))
    x = _NAMES
    for name, shade in zip(names, SHADES, strict=False):
        drawn.append(box(x, height - 15, 10, 10, shade))
        drawn.append(letters(name, x + 14, height - 6, 11, _SOFT))
        x += 24 + 7.0 * len(name)
    return document(width, height, "".join(drawn), title=title)

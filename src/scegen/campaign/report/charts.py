"""Plots as SVG, by the one drawing layer; colours are the page's own."""

from collections.abc import Mapping, Sequence

import numpy as np

from scegen.motion.batch.arrays import Floats
from scegen.report.drawing import box, document, letters, line

_WIDTH, _HEIGHT, _LEFT, _RIGHT, _BOTTOM, _TOP = 420.0, 190.0, 44.0, 26.0, 30.0, 24.0
_BARS_IN_TICK = 5
_FAR = 5.0
_ROW, _NAMES = 22.0, 190.0
_TEXT, _SOFT, _BAR, _GRID = "var(--text)", "var(--text-soft)", "var(--accent)", "var(--line)"
SHADES = ("var(--held)", "var(--failed)", "var(--open)", "var(--accent)")


def histogram(title: str, unit: str, values: Floats, critical: float | None = None) -> str:
    """How often which values occur; ``critical`` is marked. Empty where there are no values.

    The last bar takes what lies far above all others, or above so many times what is critical.
    """
    known = values[np.isfinite(values)]
    if not len(known):
        return ""
    most = float(np.quantile(known, 0.99, method="higher"))
    if critical is not None:
        most = min(most, _FAR * critical)
    ticks = _ticks(float(known.min()), most, 4)
    low, high = ticks[0], ticks[-1]
    bars = _BARS_IN_TICK * (len(ticks) - 1)
    counts, edges = np.histogram(np.clip(known, low, high), bins=bars, range=(low, high))
    heights = _ticks(0.0, float(counts.max()), 3, whole=True)
    wide, tall = _WIDTH - _LEFT - _RIGHT, _HEIGHT - _BOTTOM - _TOP

    def x(value: float) -> float:
        return _LEFT + (value - low) / (high - low) * wide

    parts = [letters(f"{title}, {unit} ({len(known):,} scenarios)", 0, 14, 13, _TEXT, bold=True)]
    for count in heights:
        y = _TOP + tall * (1 - count / heights[-1])
        parts.append(line([(_LEFT, y), (_WIDTH - _RIGHT, y)], _GRID, 1))
        parts.append(letters(f"{count:,.0f}", _LEFT - 6, y + 4, 11, _SOFT, text_anchor="end"))
    for count, left, right in zip(counts, edges, edges[1:], strict=False):
        height = tall * float(count) / heights[-1]
        parts.append(box(x(left) + 0.5, _TOP + tall - height, x(right) - x(left) - 1, height, _BAR))
    for value in ticks:
        words = f"{value:,g}" + ("+" if value == high and known.max() > high else "")
        parts.append(letters(words, x(value), _HEIGHT - 12, 11, _SOFT, text_anchor="middle"))
    if critical is not None and low <= critical <= high:
        rule = [(x(critical), _TOP), (x(critical), _TOP + tall)]
        parts.append(line(rule, "var(--failed)", 1.5, stroke_dasharray="4 3"))
    return document(_WIDTH, _HEIGHT, "".join(parts), title=f"{title}, {unit}")


def _ticks(low: float, high: float, steps: int, *, whole: bool = False) -> list[float]:
    """Round numbers, evenly apart, about so many steps, from below ``low`` to above ``high``."""
    high = high if high > low else low + 1.0
    span = high - low
    power = 10.0 ** np.floor(np.log10(span / steps))
    step = next(power * m for m in (1.0, 2.0, 5.0, 10.0) if power * m * steps >= span * 0.999)
    step = max(step, 1.0) if whole else step
    first, last = np.floor(low / step + 1e-9), np.ceil(high / step - 1e-9)
    return [float(round(n * step, 12)) for n in np.arange(first, last + 1)]


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

"""Where along a road rules look."""

from __future__ import annotations

from math import ceil

STEP_M = 1.0


def stations(start: float, end: float) -> list[float]:
    """Both ends and points at most ``STEP_M`` apart between them."""
    count = max(1, min(10_000, ceil((end - start) / STEP_M)))
    return [start + (end - start) * i / count for i in range(count + 1)]

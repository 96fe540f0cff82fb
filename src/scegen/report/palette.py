"""Colours of participants: the same in every picture, safe for the colour-blind."""

from __future__ import annotations

from collections.abc import Iterable

EGO = "#0072B2"
OTHERS = ("#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#7A5C00", "#5A4FCF")
"""Okabe and Ito's palette without yellow and black, and two that stay apart from it."""


def colours(ids: Iterable[str], ego: str) -> dict[str, str]:
    """A colour for each participant: blue for the ego, the rest in turn."""
    others = (name for name in ids if name != ego)
    result = {name: OTHERS[i % len(OTHERS)] for i, name in enumerate(others)}
    return {ego: EGO} | result

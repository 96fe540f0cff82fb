"""How exact a road network must be."""

from math import pi, remainder

GAP_M = 0.01
"""Largest break of a line or lane, and step of a width or height, at a joint."""
KINK_DEG = 0.5
"""Largest step of heading at a joint."""


def heading_step(before: float, after: float) -> float:
    """The change of heading, in (-pi, pi]."""
    return remainder(after - before, 2 * pi)

"""How far apart two along a road are, by the ends of their boxes alone."""

from __future__ import annotations


def gap_m(first, second, time_s):
    """Free length along the road between two; negative where they are level."""
    (low, high), (other_low, other_high) = first.ends_m(time_s), second.ends_m(time_s)
    return max(other_low - high, low - other_high)

"""Hand-made functional and logical scenarios."""

from ways_by_hand import cases, made, scenario

__all__ = ["cases", "made", "scenario"]

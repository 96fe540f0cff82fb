"""Frames: data that say what numbers and verbs mean by the words they stand with."""

from scegen.understanding.frames.loader import AmountFrame, acts, always_acts, amounts
from scegen.understanding.frames.windows import Numbers

__all__ = ["AmountFrame", "Numbers", "acts", "always_acts", "amounts"]

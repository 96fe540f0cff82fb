"""Frames: data that say what numbers and verbs mean by the words they stand with."""

from scegen.understanding.frames.loader import ActFrame, AmountFrame, acts, amounts, words
from scegen.understanding.frames.numbers import Measured, Numbers
from scegen.understanding.frames.of_the_road import last_of, role_of, value_of

__all__ = [
    "ActFrame",
    "AmountFrame",
    "Measured",
    "Numbers",
    "acts",
    "amounts",
    "last_of",
    "role_of",
    "value_of",
    "words",
]

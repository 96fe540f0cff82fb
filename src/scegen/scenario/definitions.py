"""Definitions: what a word of the contract means, beside the word itself."""

from enum import StrEnum
from typing import NamedTuple, Self


class Definition(NamedTuple):
    """One sentence that says what a word means, its nearest neighbours, and an example.

    ``text`` and ``example`` begin small and end without a stop; ``is_not`` says which word of the
    same list is meant instead ("a lane change without haste: `cut_in`"), empty if none is near.
    """

    text: str
    is_not: str = ""
    example: str = ""

    @property
    def sentence(self) -> str:
        """All of it in one line."""
        parts = [self.text]
        parts += [f"not {self.is_not}"] if self.is_not else []
        parts += [f"such as: {self.example}"] if self.example else []
        return "; ".join(parts)


class Word(StrEnum):
    """A string of the contract that carries its definition: ``NAME = value, text, not, example``.

    A list of words is a subclass; only a word that is looked up comes without its definition.
    """

    _value_: str
    meaning: Definition

    def __new__(cls, value: str, text: str = "", is_not: str = "", example: str = "") -> Self:
        """A member: the string itself, and what it means."""
        member = str.__new__(cls, value)
        member._value_ = value
        member.meaning = Definition(text, is_not, example)
        return member

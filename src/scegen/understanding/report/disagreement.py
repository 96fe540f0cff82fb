"""A fact of the text that was read in two ways, and whose value stands."""

from __future__ import annotations

from enum import StrEnum

from pydantic import Field

from scegen.scenario.model import FrozenModel


class Kept(StrEnum):
    """Whose value stands."""

    READER = "reader"
    AGENTS = "agents"


class Disagreement(FrozenModel):
    """A fact of the text that the offline reader and the agents read differently.

    ``start`` and ``end`` are the place of ``words`` in the description.
    """

    field: str
    words: str
    start: int = Field(ge=0)
    end: int = Field(ge=0)
    reader: str
    agents: str
    kept: Kept
    reason: str

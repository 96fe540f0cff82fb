"""What understanding with language models gives: a scenario, who spoke, and what it took."""

from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from pydantic import Field

from scegen.llm import Fault, Usage
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.model import FrozenModel
from scegen.understanding.report.parse_report import Disagreement, Kept

__all__ = ["READER", "Disagreement", "Kept", "Objection", "Part", "Understanding"]

READER = "offline reader"
"""The speaker where no model gave a usable answer."""
LONGEST_REMARK = 500


class Part(StrEnum):
    """A part of the scenario, read by an agent of its own."""

    ROAD = "road"
    PARTICIPANTS = "participants"
    HAZARDS = "hazards"
    ACTS = "acts"


class Objection(FrozenModel):
    """Something in a draft that does not fit the text, and the words that prove it."""

    about: Part
    problem: str = Field(min_length=1, max_length=LONGEST_REMARK)
    words: str | None = Field(default=None, max_length=LONGEST_REMARK)


@dataclass(frozen=True, slots=True)
class Understanding:
    """A description, understood.

    ``speaker`` is the model whose answers the scenario rests on, or :data:`READER`. ``asked``
    are the models tried before and with it, ``faults`` why those before it did not speak (and
    why the reviewer did not, if so). ``objections`` were raised in the review and answered.
    """

    functional: FunctionalScenario
    speaker: str
    asked: tuple[str, ...]
    usage: Usage
    faults: tuple[Fault, ...] = ()
    disagreements: tuple[Disagreement, ...] = ()
    objections: tuple[Objection, ...] = ()
    notes: tuple[str, ...] = ()

    @property
    def fell_back(self) -> bool:
        """Whether no model gave a usable answer."""
        return self.speaker == READER

    def to_data(self) -> dict[str, Any]:
        """As in ``summary.json``: the same for a run and its replay."""
        return {
            "speaker": self.speaker,
            "asked": list(self.asked),
            **self.usage.to_data(),
            "faults": [f.model_dump(mode="json") for f in self.faults],
            "disagreements": [d.model_dump(mode="json") for d in self.disagreements],
            "objections": [o.model_dump(mode="json") for o in self.objections],
            "notes": list(self.notes),
        }

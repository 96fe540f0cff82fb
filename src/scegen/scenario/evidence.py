"""What the fields of a functional scenario rest on, and what none of them expresses."""

from collections.abc import Iterator

from pydantic import Field

from scegen.scenario.definitions import Word
from scegen.scenario.model import CheckedModel, FrozenModel


class EvidenceSource(Word):
    """What a field rests on: the words, a conclusion from them, or a default."""

    STATED = "stated", "rests on words of the text", "`inferred`", "quoted with their place"
    INFERRED = (
        "inferred",
        "follows from the text, for a reason that is given",
        "`default`",
        "who cuts in comes from the next lane",
    )
    DEFAULT = "default", "the text does not say it", "`inferred`", "driving side: right"


class Evidence(CheckedModel):
    """What one field rests on.

    ``field`` is a path such as ``junction.kind`` or ``participants.car_1.maneuvers``;
    hazards are named by kind (``hazards.speeding``). ``start`` and ``end`` are character
    offsets into the description, ``text`` the words between them; a field that does not
    rest on words has a ``reason`` instead.
    """

    field: str
    source: EvidenceSource
    text: str | None = None
    start: int | None = Field(default=None, ge=0)
    end: int | None = Field(default=None, ge=0)
    reason: str | None = None

    def misfits(self) -> Iterator[str]:
        """See CheckedModel."""
        if self.source is EvidenceSource.STATED and self.text is None:
            yield f"stated field {self.field} names no words of the text"
        if self.source is not EvidenceSource.STATED and not self.reason:
            yield f"field {self.field} is {self.source} without a reason"


class Unsupported(FrozenModel):
    """Words understood to matter but not expressible, and what was done instead."""

    text: str
    start: int = Field(ge=0)
    end: int = Field(ge=0)
    instead: str

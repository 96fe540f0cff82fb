"""The agents' parts put together: one scenario, every field with words that the text really has."""

from dataclasses import dataclass
from typing import Any

from pydantic import ValidationError

from scegen.scenario.evidence import Unsupported
from scegen.scenario.functional import FunctionalScenario
from scegen.understanding.agents.grounding import grounds
from scegen.understanding.agents.quoting import find_quote
from scegen.understanding.agents.replies import (
    ActsReply,
    HazardsReply,
    ParticipantsReply,
    Reply,
    RoadReply,
)
from scegen.understanding.agents.result import Objection, Part

_BLAMED = {
    "hazards.": Part.HAZARDS,
    "acts.": Part.ACTS,
    "act ": Part.ACTS,
    "acts ": Part.ACTS,
    "spacings": Part.ACTS,
    "outcome": Part.ACTS,
}
"""What a complaint of the scenario speaks of -> whose part it is; all else is the participants'."""


@dataclass(frozen=True, slots=True)
class Parts:
    """One answer of every agent."""

    road: RoadReply
    participants: ParticipantsReply
    hazards: HazardsReply
    acts: ActsReply

    def replies(self) -> tuple[Reply, ...]:
        """All four."""
        return (self.road, self.participants, self.hazards, self.acts)


@dataclass(frozen=True, slots=True)
class Draft:
    """The scenario, or the objections to the parts that do not fit together."""

    scenario: FunctionalScenario | None
    objections: tuple[Objection, ...] = ()
    notes: tuple[str, ...] = ()


def assemble(description: str, parts: Parts) -> Draft:
    """One scenario from the parts."""
    unsupported, notes = _unsupported(description, parts)
    evidence, doubts = grounds(description, parts.replies())
    fields: dict[str, Any] = {}
    for reply in parts.replies():
        fields |= reply.parts()
    try:
        scenario = FunctionalScenario(
            description=description,
            evidence=tuple(evidence),
            unsupported=unsupported,
            **fields,
        )
    except ValidationError as error:
        return Draft(None, tuple(_objection(told) for told in _told(error)))
    return Draft(scenario, notes=notes + doubts)


def misfit(stage: tuple[Reply, ...], reply: Reply) -> str | None:
    """Why an answer does not fit the stage that it is set on; None if it does.

    Args:
        stage: the road and the participants.
        reply: what happens on it.
    """
    fields: dict[str, Any] = {"description": ""}
    for part in stage:
        fields |= part.parts()
    if _wrong(fields) is not None:
        return None  # the fault of the stage, which is objected to elsewhere
    problem = _wrong({**fields, **reply.parts()})
    known = [one.id for name in ("participants", "objects") for one in fields.get(name, ())]
    return problem and f"{problem}; there are {', '.join(known)}"


def _wrong(fields: dict[str, Any]) -> str | None:
    try:
        FunctionalScenario(**fields)
    except ValidationError as error:
        return "; ".join(_told(error))
    return None


def _told(error: ValidationError) -> list[str]:
    return [str(item["msg"]).removeprefix("Value error, ") for item in error.errors()]


def _objection(message: str) -> Objection:
    about = next((part for sign, part in _BLAMED.items() if sign in message), Part.PARTICIPANTS)
    return Objection(about=about, problem=message[:400])


def _unsupported(description: str, parts: Parts) -> tuple[tuple[Unsupported, ...], tuple[str, ...]]:
    found: dict[tuple[int, int], Unsupported] = {}
    notes = []
    for passage in (p for reply in parts.replies() for p in reply.unsupported):
        quote = find_quote(description, passage.words)
        if quote is None:
            notes.append(
                f'left out as not expressible: "{passage.words}", which the text does not have'
            )
        else:
            place = quote.start, quote.end
            told = [found[place].instead, passage.instead] if place in found else [passage.instead]
            instead = "; ".join(dict.fromkeys(told))
            found[place] = Unsupported(
                text=quote.text, start=quote.start, end=quote.end, instead=instead
            )
    return tuple(found[place] for place in sorted(found)), tuple(notes)

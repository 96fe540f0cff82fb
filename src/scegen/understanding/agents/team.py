"""The team: agents for the parts side by side, the reviewer after them, and rounds between."""

import asyncio
from collections.abc import Awaitable, Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

from scegen.llm import Fault, FaultKind, LlmError
from scegen.llm.asking import ask
from scegen.llm.line import Line
from scegen.llm.prompting import as_data
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.model import FrozenModel
from scegen.understanding.agents.assembling import Draft, Parts, assemble, misfit
from scegen.understanding.agents.prompting import REVIEWER, prompts
from scegen.understanding.agents.quoting import find_quote
from scegen.understanding.agents.replies import (
    ActsReply,
    HazardsReply,
    ParticipantsReply,
    Review,
    RoadReply,
)
from scegen.understanding.agents.result import Objection, Part
from scegen.understanding.agents.reviewing import review_question

R = TypeVar("R")
M = TypeVar("M", bound=FrozenModel)
Stage = tuple[RoadReply, ParticipantsReply]
"""The road and who is on it: what the agents after them are shown."""
_CHANGED = "- the road or the participants are others now: name those listed below"
Checks = Callable[[FunctionalScenario], tuple[Objection, ...]]


@dataclass(frozen=True, slots=True)
class Consulted:
    """What the team agreed on; ``review_fault`` says why the reviewer did not speak."""

    scenario: FunctionalScenario
    objections: tuple[Objection, ...] = ()
    notes: tuple[str, ...] = ()
    review_fault: Fault | None = None


class Team:
    """Agents on one line, reading one description.

    Args:
        line: to the model.
        description: the text.
        checks: objections that need no model, such as to a number that the text states.
    """

    def __init__(self, line: Line, description: str, checks: Checks) -> None:
        self._line = line
        self._description = description
        self._checks = checks

    async def consult(self) -> Consulted:
        """Read, assemble, review, and read again what was objected to.

        Raises:
            LlmError: an agent gave no valid answer.
        """
        parts = await self._first()
        raised: list[Objection] = []
        review_fault: Fault | None = None
        for _ in range(self._line.limits.review_rounds):
            draft = assemble(self._description, parts)
            objections, review_fault = await self._objections(draft, raised)
            if not objections:
                break
            raised += objections
            parts = await self._again(parts, objections)
        draft = assemble(self._description, parts)
        if draft.scenario is None:
            problems = "; ".join(o.problem for o in draft.objections)
            raise LlmError(
                Fault(
                    kind=FaultKind.INVALID,
                    message=f"the agents' parts do not fit together: {problems}",
                    model=str(self._line.name),
                )
            )
        return Consulted(draft.scenario, tuple(raised), draft.notes, review_fault)

    async def _first(self) -> Parts:
        road, participants = await _all_of(self._road(), self._participants())
        stage = (road, participants)
        hazards, acts = await _all_of(self._hazards(stage), self._acts(stage))
        return Parts(road, participants, hazards, acts)

    async def _again(self, parts: Parts, objections: Iterable[Objection]) -> Parts:
        """Ask those again to whose part somebody objected, or who built on what has changed."""
        said: dict[Part, list[Objection]] = {}
        for objection in objections:
            said.setdefault(objection.about, []).append(objection)
        road, participants = await _all_of(
            self._road(parts.road, said[Part.ROAD]) if Part.ROAD in said else _same(parts.road),
            self._participants(parts.participants, said[Part.PARTICIPANTS])
            if Part.PARTICIPANTS in said
            else _same(parts.participants),
        )
        stage = (road, participants)
        changed = _shown(stage) != _shown((parts.road, parts.participants))
        hazards, acts = await _all_of(
            self._hazards(stage, parts.hazards, said.get(Part.HAZARDS, []))
            if changed or Part.HAZARDS in said
            else _same(parts.hazards),
            self._acts(stage, parts.acts, said.get(Part.ACTS, []))
            if changed or Part.ACTS in said
            else _same(parts.acts),
        )
        return Parts(road, participants, hazards, acts)

    async def _objections(
        self, draft: Draft, raised: Sequence[Objection]
    ) -> tuple[tuple[Objection, ...], Fault | None]:
        """Of the types, of the checks, and only then of the reviewer, who costs money.

        A check objects once: what is answered the same again stands.
        """
        if draft.scenario is None:
            return draft.objections, None
        found = tuple(o for o in self._checks(draft.scenario) if o not in raised)
        if found:
            return found, None
        question = review_question(draft.scenario)
        try:
            review = await self._ask(REVIEWER, Review, question)
        except LlmError as error:
            return (), error.fault
        # an objection that rests on words which the text does not have is none
        return tuple(
            o
            for o in review.objections
            if o.words is None or find_quote(self._description, o.words) is not None
        ), None

    async def _road(
        self, before: RoadReply | None = None, objections: Iterable[Objection] = ()
    ) -> RoadReply:
        return await self._ask(Part.ROAD, RoadReply, self._question(before, objections))

    async def _participants(
        self, before: ParticipantsReply | None = None, objections: Iterable[Objection] = ()
    ) -> ParticipantsReply:
        question = self._question(before, objections)
        reply = await self._ask(Part.PARTICIPANTS, ParticipantsReply, question)
        if reply.not_traffic is not None:
            raise LlmError(
                Fault(
                    kind=FaultKind.NOT_TRAFFIC,
                    message=f"finds no traffic in the text: {reply.not_traffic}",
                    agent=Part.PARTICIPANTS,
                    model=str(self._line.name),
                )
            )
        return reply

    async def _hazards(
        self,
        stage: Stage,
        before: HazardsReply | None = None,
        objections: Iterable[Objection] = (),
    ) -> HazardsReply:
        question = self._question(before, objections) + _shown(stage)
        return await self._ask(
            Part.HAZARDS, HazardsReply, question, lambda reply: misfit(stage, reply)
        )

    async def _acts(
        self, stage: Stage, before: ActsReply | None = None, objections: Iterable[Objection] = ()
    ) -> ActsReply:
        question = self._question(before, objections) + _shown(stage)
        return await self._ask(Part.ACTS, ActsReply, question, lambda reply: misfit(stage, reply))

    async def _ask(
        self,
        name: str,
        kind: type[M],
        question: str,
        complain: Callable[[M], str | None] = lambda _: None,
    ) -> M:
        return await ask(
            self._line, name, kind, question, instructions=prompts()[name], complain=complain
        )

    def _question(self, before: FrozenModel | None, objections: Iterable[Objection]) -> str:
        text = as_data(self._description)
        if before is None:
            return text
        said = "\n".join(
            f"- {o.problem}" + (f' (the text says: "{o.words}")' if o.words else "")
            for o in objections
        )
        answer = before.model_dump_json(exclude_defaults=True)
        return (
            f"{text}\n\nYour answer before:\n{answer}\n\nObjections to it; answer again, and "
            f"keep what nobody objected to:\n{said or _CHANGED}"
        )


def _shown(stage: Stage) -> str:
    """The stage as the agents are shown it."""
    road, participants = stage
    people = [*participants.participants, *participants.relations]
    return "\n".join(
        [
            "\n\nThe junction:",
            road.junction.model_dump_json(exclude_defaults=True),
            "\nThe participants:",
            *(one.model_dump_json(exclude_defaults=True) for one in people),
            "\nThe objects:",
            *(one.model_dump_json(exclude_defaults=True) for one in participants.objects),
            *([] if participants.objects else ["none"]),
        ]
    )


async def _same(reply: R) -> R:
    return reply


async def _all_of(*tasks: Awaitable[Any]) -> tuple[Any, ...]:
    """All results; the first fault in order, once all have ended: a replay must see the same."""
    results = await asyncio.gather(*tasks, return_exceptions=True)
    for result in results:
        if isinstance(result, BaseException):
            raise result
    return tuple(results)

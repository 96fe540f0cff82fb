"""The team: agents for the parts side by side, the reviewer after them, and rounds between."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any, TypeVar

from scegen.llm import Fault, FaultKind, LlmError
from scegen.llm.asking import ask
from scegen.llm.line import Line
from scegen.llm.prompting import as_data
from scegen.scenario.files import to_json
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.model import FrozenModel
from scegen.understanding.agents.assembling import Draft, Parts, assemble
from scegen.understanding.agents.prompting import REVIEWER, prompts
from scegen.understanding.agents.quoting import find_quote
from scegen.understanding.agents.replies import (
    EnvironmentReply,
    HazardsReply,
    ParticipantsReply,
    Review,
    RoadReply,
)
from scegen.understanding.agents.result import Objection, Part

R = TypeVar("R")
M = TypeVar("M", bound=FrozenModel)
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
            objections, review_fault = await self._objections(draft)
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
        road, participants, environment = await _all_of(
            self._road(), self._participants(), self._environment()
        )
        return Parts(road, participants, await self._hazards(participants), environment)

    async def _again(self, parts: Parts, objections: Iterable[Objection]) -> Parts:
        """Ask those again to whose part somebody objected."""
        said: dict[Part, list[Objection]] = {}
        for objection in objections:
            said.setdefault(objection.about, []).append(objection)
        road, participants, environment = await _all_of(
            self._road(parts.road, said[Part.ROAD]) if Part.ROAD in said else _same(parts.road),
            self._participants(parts.participants, said[Part.PARTICIPANTS])
            if Part.PARTICIPANTS in said
            else _same(parts.participants),
            self._environment(parts.environment, said[Part.ENVIRONMENT])
            if Part.ENVIRONMENT in said
            else _same(parts.environment),
        )
        parts = replace(parts, road=road, participants=participants, environment=environment)
        # dangers name participants: new participants, new dangers
        if Part.HAZARDS in said or Part.PARTICIPANTS in said:
            hazards = await self._hazards(participants, parts.hazards, said.get(Part.HAZARDS, []))
            parts = replace(parts, hazards=hazards)
        return parts

    async def _objections(self, draft: Draft) -> tuple[tuple[Objection, ...], Fault | None]:
        """Of the types, of the checks, and only then of the reviewer, who costs money."""
        if draft.scenario is None:
            return draft.objections, None
        found = self._checks(draft.scenario)
        if found:
            return found, None
        shown = to_json(draft.scenario.model_copy(update={"description": "", "evidence": ()}))
        question = f"{as_data(self._description)}\n\nThe scenario to review:\n{shown}"
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

    async def _environment(
        self, before: EnvironmentReply | None = None, objections: Iterable[Objection] = ()
    ) -> EnvironmentReply:
        question = self._question(before, objections)
        return await self._ask(Part.ENVIRONMENT, EnvironmentReply, question)

    async def _hazards(
        self,
        participants: ParticipantsReply,
        before: HazardsReply | None = None,
        objections: Iterable[Objection] = (),
    ) -> HazardsReply:
        ids = [p.id for p in participants.participants]
        listed = "\n".join(
            p.model_dump_json(exclude_defaults=True) for p in participants.participants
        )
        question = f"{self._question(before, objections)}\n\nThe participants:\n{listed}"

        def complain(reply: HazardsReply) -> str | None:
            named = (n for h in reply.hazards for n in (*h.by, *h.to))
            unknown = [n for n in named if n not in ids]
            if unknown:
                return f"hazards names the unknown participant {unknown[0]!r}; there are {ids}"
            return None

        return await self._ask(Part.HAZARDS, HazardsReply, question, complain)

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
            f"keep what nobody objected to:\n{said or '- the participants changed'}"
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

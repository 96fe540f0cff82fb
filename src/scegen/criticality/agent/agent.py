"""Ask the chain of models for proposals; the offline rules speak where none answers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from pydantic import Field

from scegen.criticality.agent.prompting import AGENT, instructions, instructions_version, question
from scegen.criticality.proposals.offline import OfflineProposer
from scegen.criticality.proposals.proposal import (
    MOST_PROPOSALS,
    Check,
    Proposal,
    Proposed,
    Situation,
)
from scegen.criticality.proposals.validating import shown
from scegen.llm import Fault, LlmError, Session
from scegen.scenario.model import FrozenModel

if TYPE_CHECKING:
    from scegen.llm.line import Line

_OBJECTED = "These changes cannot be made; answer again, and keep those that nobody objected to:"


class Reply(FrozenModel):
    """The agent's answer."""

    changes: tuple[Proposal, ...] = Field(max_length=MOST_PROPOSALS)


class ParameterAgent:
    """Proposes changes of numbers through the language models of a session."""

    def __init__(self, session: Session, progress: Callable[[str], None] = lambda _: None) -> None:
        self._session = session
        self._progress = progress

    def propose(self, situation: Situation, check: Check) -> Proposed:
        """The changes of the first model that gives a usable answer, else of the offline rules.

        Raises:
            InputError: a key is missing, or a folder of transcripts cannot be used.
        """
        self._session.open(
            description=situation.concrete.description, prompts=instructions_version()
        )
        asked = question(situation)
        heard = self._session.ask(lambda line: _consult(line, asked, check), self._progress)
        notes = tuple(fault.in_words() for fault in heard.faults)
        if heard.answer is None:
            return replace(OfflineProposer().propose(situation, check), notes=notes)
        reply, fault = heard.answer
        if fault is not None:
            notes += (f"{fault.in_words()}; its first answer counts",)
        return Proposed(str(heard.speaker), reply.changes, notes)


async def _consult(line: Line, asked: str, check: Check) -> tuple[Reply, Fault | None]:
    """The answer, objected to once; of two, the one with fewer objections counts.

    Where the second is missing, also the fault that is the reason.

    Raises:
        LlmError: no answer of the right type.
    """
    # the extra is there by now; without it this module must import all the same
    from scegen.llm.asking import ask  # noqa: PLC0415

    answers: list[tuple[int, Reply]] = []

    def complain(reply: Reply) -> str | None:
        judged = zip(reply.changes, check(reply.changes), strict=True)
        wrong = [f"{p.parameter} = {shown(p.value)}: {why}" for p, why in judged if why]
        answers.append((len(wrong), reply))
        if not wrong or len(answers) > 1:
            return None
        return "\n".join([_OBJECTED, *(f"- {line}" for line in wrong)])

    fault = None
    try:
        await ask(line, AGENT, Reply, asked, instructions=instructions(), complain=complain)
    except LlmError as error:
        if not answers:
            raise
        fault = error.fault
    # of equals the last, since it heeds the objections
    return min(reversed(answers), key=lambda answer: answer[0])[1], fault

"""The public function: a chain of models, and the offline reader at its end."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from scegen.errors import InfeasibleError, InputError, NotTrafficError
from scegen.llm import Fault, FaultKind, LlmSettings
from scegen.llm.budget import Ledger
from scegen.llm.session import Heard, Progress, Session
from scegen.scenario.functional import FunctionalScenario
from scegen.understanding.agents.combining import combine
from scegen.understanding.agents.contradicting import Contradiction, contradiction_in
from scegen.understanding.agents.numbers import lost
from scegen.understanding.agents.prompting import prompts_version
from scegen.understanding.agents.result import READER, Disagreement, Objection, Understanding
from scegen.understanding.agents.stated import miscounted
from scegen.understanding.reader import read

if TYPE_CHECKING:
    from scegen.llm.line import Line
    from scegen.understanding.agents.team import Consulted


def understand(
    text: str,
    settings: LlmSettings,
    *,
    environment: Mapping[str, str] = os.environ,
    progress: Progress = lambda _: None,
    ledger: Ledger | None = None,
) -> Understanding:
    """Understand a description with language models, checked against the offline reader.

    The models are tried in order; where none gives a usable answer, the offline reader speaks.

    Args:
        text: the description.
        settings: which models, where, within which bounds.
        environment: holds the keys.
        progress: told each step.
        ledger: what was used is written here, and its budget holds instead of the settings';
            for descriptions that share one budget.

    Raises:
        MissingToolError: the extra ``llm`` is not installed.
        InputError: the text, the settings or a recording cannot be used, or a key is missing.
        NotTrafficError: no model gave a usable answer, and the offline reader finds no traffic.
        InfeasibleError: the text contradicts itself, and no model said how to read it.
    """
    return understand_in(Session(settings, environment, ledger), text, progress)


def understand_in(
    session: Session, text: str, progress: Progress = lambda _: None
) -> Understanding:
    """The same in a session, which goes on afterwards."""
    offline = _offline(text)
    session.open(description=text, prompts=prompts_version())

    async def consult(line: Line) -> Consulted:
        # the extra is there by now; without it this module must import all the same
        from scegen.understanding.agents.team import Team  # noqa: PLC0415

        return await Team(line, text, offline.objections).consult()

    heard = session.ask(consult, progress)
    if heard.answer is None:
        return _fallen_back(heard, offline)
    return _combined(heard, heard.answer, offline)


@dataclass(frozen=True, slots=True)
class _Offline:
    """The reader's scenario, or why it has none; and the contradiction, if that is why."""

    reading: FunctionalScenario | InputError
    contradiction: Contradiction | None = None

    def objections(self, scenario: FunctionalScenario) -> tuple[Objection, ...]:
        """What speaks against a scenario, in the eyes of the reader."""
        if isinstance(self.reading, FunctionalScenario):
            return miscounted(self.reading, scenario) or lost(self.reading, scenario)
        return () if self.contradiction is None else self.contradiction.objections(scenario)


def _offline(text: str) -> _Offline:
    """What the reader makes of the text; an empty or endless one is refused at once."""
    try:
        return _Offline(read(text))
    except (NotTrafficError, InfeasibleError) as error:
        return _Offline(error, contradiction_in(text, error))


def _combined(heard: Heard[Consulted], consulted: Consulted, offline: _Offline) -> Understanding:
    scenario, notes = consulted.scenario, list(consulted.notes)
    disagreements: list[Disagreement] = []
    if isinstance(offline.reading, FunctionalScenario):
        scenario, disagreements = combine(scenario, offline.reading)
    elif offline.contradiction is not None:
        disagreements = offline.contradiction.resolved_by(scenario, str(heard.speaker))
    else:
        notes.append(f"the {READER} could not use the text: {offline.reading.message}")
    return Understanding(
        functional=scenario,
        speaker=str(heard.speaker),
        asked=heard.asked,
        usage=heard.usage,
        faults=(*heard.faults, *([consulted.review_fault] if consulted.review_fault else [])),
        disagreements=tuple(disagreements),
        objections=consulted.objections,
        notes=tuple(notes),
    )


def _fallen_back(heard: Heard[Consulted], offline: _Offline) -> Understanding:
    if isinstance(offline.reading, InputError):
        raise _worse(offline.reading, heard.faults)
    return Understanding(
        functional=offline.reading,
        speaker=READER,
        asked=heard.asked,
        usage=heard.usage,
        faults=heard.faults,
    )


def _worse(refusal: InputError, faults: tuple[Fault, ...]) -> InputError:
    """The reader's error, which is about the text, with the models' faults."""
    kind = type(refusal)
    if faults and all(fault.kind is FaultKind.NOT_TRAFFIC for fault in faults):
        kind = NotTrafficError
    why = "; ".join(fault.in_words() for fault in faults)
    message = f"{refusal.message}; and no model could help: {why}"
    return kind(message, where=refusal.where, hint=refusal.hint)

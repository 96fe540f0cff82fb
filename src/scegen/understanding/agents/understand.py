"""The public function: a chain of models, and the offline reader at its end."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from scegen.errors import InfeasibleError, InputError, NotTrafficError
from scegen.llm import Fault, FaultKind, LlmSettings
from scegen.llm.session import Heard, Progress, Session
from scegen.scenario.functional import FunctionalScenario
from scegen.understanding.agents.combining import Combiner
from scegen.understanding.agents.prompting import prompts_version
from scegen.understanding.agents.result import READER, Objection, Understanding
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
) -> Understanding:
    """Understand a description with language models, checked against the offline reader.

    The models are tried in order; where none gives a usable answer, the offline reader speaks.

    Args:
        text: the description.
        settings: which models, where, within which bounds.
        environment: holds the keys.
        progress: told each step.

    Raises:
        MissingToolError: the extra ``llm`` is not installed.
        InputError: the text, the settings or a recording cannot be used, or a key is missing.
        NotTrafficError, InfeasibleError: no model gave a usable answer, and the offline reader
            cannot use the text.
    """
    return understand_in(Session(settings, environment), text, progress)


def understand_in(
    session: Session, text: str, progress: Progress = lambda _: None
) -> Understanding:
    """The same in a session, which goes on afterwards."""
    reading, refusal = _offline(text)
    session.open(description=text, prompts=prompts_version())

    def checks(scenario: FunctionalScenario) -> tuple[Objection, ...]:
        return () if reading is None else miscounted(reading, scenario)

    async def consult(line: Line) -> Consulted:
        # the extra is there by now; without it this module must import all the same
        from scegen.understanding.agents.team import Team  # noqa: PLC0415

        return await Team(line, text, checks).consult()

    heard = session.ask(consult, progress)
    if heard.answer is None:
        return _fallen_back(heard, reading, refusal)
    return _combined(heard, heard.answer, reading, refusal)


def _offline(text: str) -> tuple[FunctionalScenario | None, InputError | None]:
    """The reader's scenario, or why it has none; an empty or endless text is refused at once."""
    try:
        return read(text), None
    except (NotTrafficError, InfeasibleError) as error:
        return None, error


def _combined(
    heard: Heard[Consulted],
    consulted: Consulted,
    reading: FunctionalScenario | None,
    refusal: InputError | None,
) -> Understanding:
    notes = list(consulted.notes)
    faults = [*heard.faults, *([consulted.review_fault] if consulted.review_fault else [])]
    scenario, disagreements = consulted.scenario, []
    if reading is not None:
        combiner = Combiner(scenario, reading)
        scenario, disagreements = combiner.run(), combiner.disagreements
    elif refusal is not None:
        notes.append(f"the {READER} could not use the text: {refusal.message}")
    return Understanding(
        functional=scenario,
        speaker=str(heard.speaker),
        asked=heard.asked,
        usage=heard.usage,
        faults=tuple(faults),
        disagreements=tuple(disagreements),
        objections=consulted.objections,
        notes=tuple(notes),
    )


def _fallen_back(
    heard: Heard[Consulted], reading: FunctionalScenario | None, refusal: InputError | None
) -> Understanding:
    if reading is None:
        why = "; ".join(fault.in_words() for fault in heard.faults)
        raise _worse(refusal, why, heard.faults)
    return Understanding(
        functional=reading,
        speaker=READER,
        asked=heard.asked,
        usage=heard.usage,
        faults=heard.faults,
    )


def _worse(refusal: InputError | None, why: str, faults: Iterable[Fault]) -> InputError:
    """The reader's error, which is about the text, with the models' faults."""
    kind = type(refusal) if refusal is not None else InputError
    message = refusal.message if refusal is not None else "the text could not be understood"
    faults = tuple(faults)
    if faults and all(fault.kind is FaultKind.NOT_TRAFFIC for fault in faults):
        kind = NotTrafficError
    return kind(
        f"{message}; and no model could help: {why}",
        where=refusal.where if refusal is not None else "description",
        hint=refusal.hint if refusal is not None else None,
    )

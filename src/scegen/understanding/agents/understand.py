"""The public function: a chain of models, and the offline reader at its end."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING

from scegen.errors import InfeasibleError, InputError, NotTrafficError
from scegen.llm import Fault, FaultKind, LlmError, LlmSettings, ModelName, Usage, require_llm
from scegen.llm.budget import Ledger
from scegen.llm.keys import NO_KEY, key_for
from scegen.llm.naming import parse_models
from scegen.llm.transcript import Recorder, Recording, Run
from scegen.scenario.functional import FunctionalScenario
from scegen.understanding.agents.combining import combine
from scegen.understanding.agents.contradicting import Contradiction, contradiction_in
from scegen.understanding.agents.prompting import prompts_version
from scegen.understanding.agents.result import READER, Disagreement, Objection, Understanding
from scegen.understanding.agents.stated import miscounted
from scegen.understanding.reader import read

if TYPE_CHECKING:
    from scegen.llm.line import Line
    from scegen.understanding.agents.team import Consulted

Progress = Callable[[str], None]
Checks = Callable[[FunctionalScenario], tuple[Objection, ...]]


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
    require_llm()
    offline = _offline(text)
    run = _Run(text, settings, environment, ledger, offline.objections)
    for chain, name in enumerate(run.models, start=1):
        progress(f"asking {name}")
        consulted = run.ask(chain, name)
        if consulted is not None:
            return _combined(run, name, consulted, offline)
    return _fallen_back(run, offline)


@dataclass(frozen=True, slots=True)
class _Offline:
    """The reader's scenario, or why it has none; and the contradiction, if that is why."""

    reading: FunctionalScenario | None
    refusal: InputError | None = None
    contradiction: Contradiction | None = None

    def objections(self, scenario: FunctionalScenario) -> tuple[Objection, ...]:
        """What speaks against a scenario, in the eyes of the reader."""
        if self.reading is not None:
            return miscounted(self.reading, scenario)
        return () if self.contradiction is None else self.contradiction.objections(scenario)


def _offline(text: str) -> _Offline:
    """What the reader makes of the text; an empty or endless one is refused at once."""
    try:
        return _Offline(read(text))
    except (NotTrafficError, InfeasibleError) as error:
        return _Offline(None, error, contradiction_in(text, error))


class _Run:
    """One pass through the chain: what all its models share."""

    def __init__(
        self,
        text: str,
        settings: LlmSettings,
        environment: Mapping[str, str],
        ledger: Ledger | None,
        checks: Checks,
    ) -> None:
        self.models, self.url = settings.models, settings.url
        self.usage = Usage()
        self.faults: list[Fault] = []
        self.asked: list[str] = []
        self._text, self._settings, self._checks = text, settings, checks
        self._ledger = Ledger(settings.budget) if ledger is None else ledger
        self._recorder: Recorder | None = None
        self._recording: Recording | None = None
        names = tuple(str(name) for name in settings.models)
        version = prompts_version()
        if settings.replay is not None:
            self._recording = Recording(settings.replay)
            self._recording.require_same(description=text, prompts=version, models=names)
            self.url = self._recording.run.url
            self.models = parse_models(",".join(self._recording.run.models), url=self.url)
            self._keys = dict.fromkeys(self.models, NO_KEY)
            return
        # a missing key is said before anything is spent
        self._keys = {n: key_for(n, environment, url=self.url) for n in self.models}
        if settings.record is not None:
            run = Run(prompts=version, description=text, models=names, url=self.url)
            self._recorder = Recorder(settings.record, run)

    def ask(self, chain: int, name: ModelName) -> Consulted | None:
        """What a team of this model agreed on; None, and a fault more, if it gave no answer."""
        # the extra is there by now; without it this module must import all the same
        from scegen.llm.line import Line  # noqa: PLC0415

        self.asked.append(str(name))
        line = Line(
            name=name,
            chain=chain,
            url=self.url,
            key=self._keys[name],
            limits=self._settings.limits,
            ledger=self._ledger,
            recorder=self._recorder,
            recording=self._recording,
        )
        try:
            return _in_a_loop(line, self._text, self._checks)
        except LlmError as error:
            self.faults.append(error.fault)
            return None
        finally:
            self.usage += line.usage


def _in_a_loop(line: Line, text: str, checks: Checks) -> Consulted:
    """Run the team to its end, also where a loop is running already (a notebook, a server)."""
    from scegen.understanding.agents.team import Team  # noqa: PLC0415 - needs the extra

    async def consult() -> Consulted:
        async with line:
            return await Team(line, text, checks).consult()

    try:
        asyncio.get_running_loop()
    except RuntimeError:
        return asyncio.run(consult())
    with ThreadPoolExecutor(max_workers=1) as pool:
        return pool.submit(asyncio.run, consult()).result()


def _combined(run: _Run, name: ModelName, consulted: Consulted, offline: _Offline) -> Understanding:
    scenario, notes = consulted.scenario, list(consulted.notes)
    disagreements: list[Disagreement] = []
    if offline.reading is not None:
        scenario, disagreements = combine(scenario, offline.reading)
    elif offline.contradiction is not None:
        disagreements = offline.contradiction.resolved_by(scenario, str(name))
    elif offline.refusal is not None:
        notes.append(f"the {READER} could not use the text: {offline.refusal.message}")
    return Understanding(
        functional=scenario,
        speaker=str(name),
        asked=tuple(run.asked),
        usage=run.usage,
        faults=(*run.faults, *([consulted.review_fault] if consulted.review_fault else [])),
        disagreements=tuple(disagreements),
        objections=consulted.objections,
        notes=tuple(notes),
    )


def _fallen_back(run: _Run, offline: _Offline) -> Understanding:
    if offline.reading is None:
        why = "; ".join(fault.in_words() for fault in run.faults)
        raise _worse(offline.refusal, why, run.faults)
    return Understanding(
        functional=offline.reading,
        speaker=READER,
        asked=tuple(run.asked),
        usage=run.usage,
        faults=tuple(run.faults),
    )


def _worse(refusal: InputError | None, why: str, faults: list[Fault]) -> InputError:
    """The reader's error, which is about the text, with the models' faults."""
    kind = type(refusal) if refusal is not None else InputError
    message = refusal.message if refusal is not None else "the text could not be understood"
    if faults and all(fault.kind is FaultKind.NOT_TRAFFIC for fault in faults):
        kind = NotTrafficError
    return kind(
        f"{message}; and no model could help: {why}",
        where=refusal.where if refusal is not None else "description",
        hint=refusal.hint if refusal is not None else None,
    )

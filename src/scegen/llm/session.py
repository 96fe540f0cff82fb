"""One run's use of language models: the chain, one budget, one transcript, one account.

Every stage that asks models shares the session, so that the budget bounds them together and a
transcript repeats them together.
"""

from __future__ import annotations

import asyncio
import os
from collections.abc import Awaitable, Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Generic, TypeVar

from scegen.llm.budget import Ledger
from scegen.llm.extra import require_llm
from scegen.llm.faults import Fault, FaultKind, LlmError
from scegen.llm.keys import NO_KEY, key_for
from scegen.llm.naming import ModelName, parse_models
from scegen.llm.settings import LlmSettings
from scegen.llm.transcript import Recorder, Recording, Run
from scegen.llm.usage import Usage

if TYPE_CHECKING:
    from scegen.llm.line import Line

T = TypeVar("T")
Progress = Callable[[str], None]
OF_ONE_ANSWER = frozenset(
    {
        FaultKind.NO_ANSWER,
        FaultKind.REFUSED,
        FaultKind.INVALID,
        FaultKind.TOO_LARGE,
        FaultKind.NOT_TRAFFIC,
    }
)
"""Faults of an answer, not of the model's service: the next question may fare better."""


@dataclass(frozen=True, slots=True)
class Heard(Generic[T]):
    """What became of a question to the chain.

    ``answer`` and ``speaker`` are None where no model gave a usable answer; ``asked`` are the
    models that were tried, ``faults`` why those before the speaker did not speak.
    """

    answer: T | None
    speaker: ModelName | None
    asked: tuple[str, ...]
    faults: tuple[Fault, ...]
    usage: Usage


class Session:
    """The models of a run.

    ``environment`` holds the keys. Sessions that share a ``ledger`` share the bounds of its budget.

    Raises:
        MissingToolError: the extra ``llm`` is not installed.
    """

    def __init__(
        self,
        settings: LlmSettings,
        environment: Mapping[str, str] = os.environ,
        ledger: Ledger | None = None,
    ) -> None:
        require_llm()
        self._ledger = Ledger(settings.budget) if ledger is None else ledger
        self._settings = settings
        self._environment = environment
        self._lines: list[Line] | None = None
        self._silent: dict[int, Fault] = {}

    @property
    def usage(self) -> Usage:
        """Everything used so far."""
        return sum((line.usage() for line in self._lines or ()), Usage())

    def open(self, *, description: str, prompts: str) -> None:
        """Look up keys and begin the transcript, before anything is spent; once a run.

        ``prompts`` is the version of those that the first stage asks with.

        Raises:
            InputError: a key is missing, or a folder of transcripts cannot be used.
        """
        if self._lines is not None:
            return
        # the extra is there by now; without it this module must import all the same
        from scegen.llm.line import Line  # noqa: PLC0415

        settings, url, models = self._settings, self._settings.url, self._settings.models
        names = tuple(str(name) for name in models)
        recorder = recording = None
        if settings.replay is not None:
            recording = Recording(settings.replay)
            recording.require_same(description=description, prompts=prompts, models=names)
            url = recording.run.url
            models = parse_models(",".join(recording.run.models), url=url)
            keys = dict.fromkeys(models, NO_KEY)
        else:
            keys = {n: key_for(n, self._environment, url=url) for n in models}
            if settings.record is not None:
                run = Run(prompts=prompts, description=description, models=names, url=url)
                recorder = Recorder(settings.record, run)
        self._lines = [
            Line(
                name=name,
                chain=chain,
                url=url,
                key=keys[name],
                limits=settings.limits,
                ledger=self._ledger,
                recorder=recorder,
                recording=recording,
            )
            for chain, name in enumerate(models, start=1)
        ]

    def ask(
        self, consult: Callable[[Line], Awaitable[T]], progress: Progress = lambda _: None
    ) -> Heard[T]:
        """Ask the models in order, until one gives a usable answer.

        A model whose service failed before in this run (a wrong key, no connection, a spent budget)
        is not asked again. ``consult``, the conversation with one model, raises LlmError where it
        has no answer.

        Raises:
            InputError: a replay lacks an exchange, or has another.
        """
        if self._lines is None:
            raise RuntimeError("the session is not open")
        asked: list[str] = []
        faults: list[Fault] = []
        used = Usage()
        for line in self._lines:
            if known := self._silent.get(line.chain):
                again = f"not asked again: {known.message}"
                faults.append(known.but(message=again))
                continue
            progress(f"asking {line.name}")
            asked.append(str(line.name))
            before = len(line.exchanges)
            try:
                answer = _in_a_loop(line, consult)
            except LlmError as error:
                faults.append(error.fault)
                if error.fault.kind not in OF_ONE_ANSWER:
                    self._silent[line.chain] = error.fault
            else:
                used += line.usage(before)
                return Heard(answer, line.name, tuple(asked), tuple(faults), used)
            used += line.usage(before)
        return Heard(None, None, tuple(asked), tuple(faults), used)


def _in_a_loop(line: Line, consult: Callable[[Line], Awaitable[T]]) -> T:
    """Run a conversation to its end, also in a notebook or a server, where a loop runs already."""

    async def converse() -> T:
        async with line:
            return await consult(line)

    try:
        asyncio.get_running_loop()
    except RuntimeError:
        return asyncio.run(converse())
    with ThreadPoolExecutor(max_workers=1) as pool:
        return pool.submit(asyncio.run, converse()).result()

"""The agents under test: every reading measured, recorded, paid from one budget."""

import json
import os
import re
import time
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from scegen.benchmark.understand import Described, Result, StoppedError, about_the_text
from scegen.errors import InputError
from scegen.llm import FaultKind, LlmSettings
from scegen.llm.budget import Ledger
from scegen.llm.session import OF_ONE_ANSWER
from scegen.llm.usage import Usage
from scegen.scenario.functional import FunctionalScenario
from scegen.understanding.agents import Understanding, understand

_PATIENCE = 3
"""Readings in a row without an answer after which a provider counts as gone."""
_GONE = frozenset(FaultKind) - OF_ONE_ANSWER - {FaultKind.BUDGET}
_LATENCY_FILE = "latency.json"


@dataclass(slots=True)
class Measured:
    """What a benchmark of language models measures beside the score.

    ``speakers`` are by (description, run), ``faults`` counted by kind; ``seconds`` are those of
    each reading that has been timed, ``usage`` is that of all readings.
    """

    speakers: dict[tuple[str, int], str] = field(default_factory=dict)
    faults: Counter[str] = field(default_factory=Counter)
    disagreements: int = 0
    seconds: list[float] = field(default_factory=list)
    usage: Usage = field(default_factory=Usage)

    def to_data(self, result: Result) -> dict[str, Any]:
        """As data that JSON can hold."""
        readings = max(result.readings, 1)
        cost = None if self.usage.unpriced else round(self.usage.cost_usd / readings, 6)
        return {
            "speakers": {
                name: {"readings": count, "understood": understood}
                for name, (count, understood) in self.by_speaker(result).items()
            },
            "faults": dict(sorted(self.faults.items())),
            "disagreements": self.disagreements,
            "latency_s": {
                "median": _rounded(quantile(self.seconds, 0.5)),
                "p95": _rounded(quantile(self.seconds, 0.95)),
            },
            **self.usage.to_data(),
            "tokens_per_reading": round(self.usage.tokens / readings),
            "cost_usd_per_reading": cost,
        }

    def by_speaker(self, result: Result) -> dict[str, tuple[int, int]]:
        """Speaker -> number of readings, and how many of them were understood."""
        found: dict[str, tuple[int, int]] = {}
        for key, name in sorted(self.speakers.items(), key=lambda item: item[1]):
            count, understood = found.get(name, (0, 0))
            found[name] = (count + 1, understood + result.held.get(key, False))
        return found


def quantile(values: list[float], share: float) -> float | None:
    """The smallest value that at least this share, in (0, 1], does not exceed; None of none."""
    if not values:
        return None
    rank = -int(-share * len(values) // 1)  # rounded up
    return sorted(values)[rank - 1]


class AgentReader:
    """Reads descriptions with language models, as ``scegen understand --llm`` does.

    The budget of ``settings`` is for all descriptions together, and the folders of recordings get
    one folder for each description and run. ``environment`` holds the keys.

    Raises:
        InputError: the folder to record into is not empty.
    """

    def __init__(
        self,
        settings: LlmSettings,
        environment: Mapping[str, str] = os.environ,
        progress: Callable[[str], None] = lambda _: None,
    ) -> None:
        self.measured = Measured()
        self._settings, self._environment, self._progress = settings, environment, progress
        self._ledger = Ledger(settings.budget)
        self._folders: dict[str, str] = {}
        self._silent, self._why = 0, ""
        folder = settings.record
        if folder is not None and folder.exists() and (folder.is_file() or any(folder.iterdir())):
            raise InputError(
                "is not empty", where=f"--llm-record {folder}", hint="name a new folder"
            )

    def __call__(self, case: Described, run: int) -> FunctionalScenario:
        """The scenario of a description, read for this time (from 1).

        Raises:
            StoppedError: the provider is gone, the budget spent, or the recording at its end.
            InputError: nobody can use the text; or, at the first reading, the settings.
        """
        if self._silent >= _PATIENCE:
            raise StoppedError(f"no model answered {_PATIENCE} times in a row: {self._why}")
        settings = self._settings_for(case, run)
        began = time.perf_counter()
        try:
            found = understand(
                case.text,
                settings,
                environment=self._environment,
                progress=lambda step: self._progress(f"{case.id}, run {run}: {step}"),
                ledger=self._ledger,
            )
        except InputError as error:
            if about_the_text(error):
                self._time(settings, time.perf_counter() - began)
                raise
            if not self.measured.speakers:
                raise
            raise StoppedError(error.render()) from error
        finally:
            self.measured.usage = self._ledger.used
        self._note(case, run, found)
        self._time(settings, time.perf_counter() - began)
        return found.functional

    def _note(self, case: Described, run: int, found: Understanding) -> None:
        kinds = [fault.kind for fault in found.faults]
        self.measured.faults.update(kind.value for kind in kinds)
        if found.fell_back and FaultKind.BUDGET in kinds:
            raise StoppedError(f"the budget is spent: {found.faults[-1].message}")
        gone = found.fell_back and all(kind in _GONE for kind in kinds)
        self._silent = self._silent + 1 if gone else 0
        self._why = found.faults[-1].in_words() if gone else ""
        self.measured.disagreements += len(found.disagreements)
        self.measured.speakers[case.id, run] = found.speaker

    def _settings_for(self, case: Described, run: int) -> LlmSettings:
        """With a folder of its own for the transcripts of this reading."""
        place = f"{len(self._folders) + 1:03d}-" + re.sub(r"[^A-Za-z0-9._-]+", "-", case.id)[:60]
        name = Path(self._folders.setdefault(case.id, place)) / str(run)
        record, replay = self._settings.record, self._settings.replay
        return replace(
            self._settings,
            record=None if record is None else record / name,
            replay=None if replay is None else replay / name,
        )

    def _time(self, settings: LlmSettings, seconds: float) -> None:
        """Measured when asked, and recorded; a replay tells what was measured then."""
        if settings.replay is not None:
            recorded = _recorded(settings.replay / _LATENCY_FILE)
            self.measured.seconds += [] if recorded is None else [recorded]
            return
        self.measured.seconds.append(seconds)
        if settings.record is not None:
            path = settings.record / _LATENCY_FILE
            try:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(json.dumps({"seconds": round(seconds, 3)}) + "\n", encoding="utf-8")
            except OSError as error:
                raise StoppedError(f"--llm-record: {path} cannot be written") from error


def _recorded(path: Path) -> float | None:
    try:
        return float(json.loads(path.read_text(encoding="utf-8"))["seconds"])
    except (OSError, ValueError, KeyError, TypeError):
        return None


def _rounded(seconds: float | None) -> float | None:
    return None if seconds is None else round(seconds, 3)

"""The source paper's eleven sentences, end to end: understood, made, and passed by whom."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from scegen.checking import CheckReport, CheckStatus
from scegen.errors import ScegenError
from scegen.pipeline.generate import generate
from scegen.pipeline.options import CheckDepth, Options
from scegen.scenario.functional import FunctionalScenario
from scegen.understanding import Case, paper_cases, read, score

PAPER_SUCCESSES = 9
PAPER_CASES = 11
"""The paper reports valid files for 9 of its 11 sentences; it gives no figure per case here."""

Progress = Callable[[str], None]


@dataclass(frozen=True, slots=True)
class Row:
    """One case. ``checks`` is by checker; ``problem`` is why no files were made, if so."""

    case: str
    understood: bool
    wrong_fields: tuple[str, ...]
    participants: int
    scenarios: int
    files: int
    checks: dict[str, str]
    problem: str | None = None

    @property
    def green(self) -> bool:
        """Understood, files made, and no checker failed or stayed away."""
        return (
            self.understood
            and self.files > 0
            and bool(self.checks)
            and set(self.checks.values()) == {CheckStatus.PASSED.value}
        )

    def to_data(self) -> dict[str, Any]:
        """The row as JSON-able data."""
        return {
            "case": self.case,
            "understood": self.understood,
            "wrong_fields": list(self.wrong_fields),
            "participants": self.participants,
            "scenarios": self.scenarios,
            "files": self.files,
            "checks": self.checks,
            "green": self.green,
            "problem": self.problem,
        }


def run(progress: Progress = lambda _: None, *, seed: int = 0) -> Iterator[Row]:
    """Generate and check every case in a folder of its own, which is removed again."""
    for case in paper_cases():
        progress(case.id)
        yield _row(case, seed)


def _row(case: Case, seed: int) -> Row:
    try:
        functional = read(case.text)
    except ScegenError as error:
        return Row(case.id, False, ("text",), 0, 0, 0, {}, error.render())
    judged = score(case.expect, functional)
    wrong = tuple(name for name, holds in judged.fields.items() if not holds)
    with tempfile.TemporaryDirectory(prefix="scegen-paper-") as folder:
        return _made(case.id, functional, wrong, Path(folder) / "out", seed)


def _made(
    case: str, functional: FunctionalScenario, wrong: tuple[str, ...], folder: Path, seed: int
) -> Row:
    count = len(functional.participants)
    try:
        result = generate(functional, folder, Options(seed=seed, depth=CheckDepth.FULL))
    except ScegenError as error:
        return Row(case, not wrong, wrong, count, 0, 0, {}, error.render())
    scenarios = result.logical.certificate.count if result.logical else 0
    return Row(case, not wrong, wrong, count, scenarios, len(result.checks), _worst(result.checks))


def _worst(reports: dict[str, CheckReport]) -> dict[str, str]:
    """By checker, the worst status over the scenarios made."""
    order = [CheckStatus.PASSED, CheckStatus.NOT_RUN, CheckStatus.FAILED]
    worst: dict[str, CheckStatus] = {}
    for report in reports.values():
        for result in report.results:
            known = worst.get(result.checker, CheckStatus.PASSED)
            worst[result.checker] = max(known, result.status, key=order.index)
    return {checker: status.value for checker, status in worst.items()}

"""The source paper's eleven sentences, end to end: understood, made, and passed by whom."""

import tempfile
from collections import defaultdict
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from scegen.checking import REPLAY, CheckReport, CheckStatus, check_folder
from scegen.checking.results import worst
from scegen.errors import ScegenError
from scegen.measures import warm_kernels
from scegen.pipeline.generate import generate
from scegen.pipeline.options import CheckDepth, Options
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.proof import Proof
from scegen.understanding import Case, paper_cases, read, score

PAPER_SUCCESSES = 9
PAPER_CASES = 11
PAPER_TRUE = 8
"""The paper reports valid files for 9 of its 11 sentences; 8 come out true."""


@dataclass(frozen=True, slots=True)
class Row:
    """One case. ``checks`` is by checker; ``problem`` is why no files were made, if so.

    ``proof`` is what the search for danger reached in ``search_s`` seconds, ``reactive`` whether
    that survives an ego that starts 20 % slower or faster (None where the ego is alone).
    """

    case: str
    understood: bool
    wrong_fields: tuple[str, ...]
    participants: int
    scenarios: int
    files: int
    checks: dict[str, str]
    problem: str | None = None
    proof: Proof | None = None
    search_s: float | None = None
    verdict: str | None = None
    reactive: bool | None = None
    esmini_agrees: bool | None = None

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
            **self._danger(),
        }

    def _danger(self) -> dict[str, Any]:
        """What the search reached, as JSON-able data."""
        hazards = self.proof.hazards if self.proof else ()
        measure = self.proof.of(self.proof.measure) if self.proof else None
        return {
            "hazards_asked": [str(h.kind) for h in hazards],
            "hazards_happened": [
                {"kind": str(h.kind), "margin": h.margin, "unit": h.unit, "time_s": h.time_s}
                for h in hazards
                if h.happened
            ],
            "target": self.proof.target if self.proof else None,
            "measure": measure.name if measure else None,
            "unit": measure.unit if measure else None,
            "before": measure.before if measure else None,
            "after": measure.after if measure else None,
            "in_band": self.proof.in_band if self.proof else None,
            "blocked_by": self.proof.blocked_by if self.proof else None,
            "evaluations": self.proof.evaluations if self.proof else None,
            "search_s": None if self.search_s is None else round(self.search_s, 3),
            "verdict": self.verdict,
            "reactive": self.reactive,
            "esmini_agrees": self.esmini_agrees,
        }


def run(progress: Callable[[str], None] = lambda _: None, *, seed: int = 0) -> Iterator[Row]:
    """Generate and check every case in a folder of its own, which is removed again."""
    warm_kernels()
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
    name = next(iter(result.checks))
    sensitivity = result.judged[name].sensitivity
    return Row(
        case,
        not wrong,
        wrong,
        count,
        scenarios,
        len(result.checks),
        _worst(result.checks),
        proof=result.proofs.get(name),
        search_s=result.search_s.get(name),
        verdict=result.judged[name].verdict.outcome.value,
        reactive=None if sensitivity is None else sensitivity.reactive,
        esmini_agrees=_agrees(folder / "scenarios" / name),
    )


def _agrees(scenario: Path) -> bool | None:
    """Whether esmini shows what our simulator predicts; None where there is no esmini."""
    status = check_folder(scenario, [REPLAY]).result(REPLAY).status
    return None if status is CheckStatus.NOT_RUN else status is CheckStatus.PASSED


def _worst(reports: dict[str, CheckReport]) -> dict[str, str]:
    """By checker, the worst status over the scenarios made."""
    found: dict[str, list[CheckStatus]] = defaultdict(list)
    for report in reports.values():
        for result in report.results:
            found[result.checker].append(result.status)
    return {checker: worst(statuses).value for checker, statuses in found.items()}

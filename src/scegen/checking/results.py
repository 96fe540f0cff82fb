"""What a check says: findings of rules, one result per checker, one report per folder or file."""

from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass, replace
from enum import StrEnum
from typing import Any


class Severity(StrEnum):
    """How bad a finding is; only an ``error`` fails a check.

    ``warning`` is a remark: nothing that a standard forbids. ``unchecked`` is a part that a rule
    could not look at, with the reason; where there is one, a check has not passed.
    """

    ERROR = "error"
    WARNING = "warning"
    INFO = "info"
    UNCHECKED = "unchecked"


class CheckStatus(StrEnum):
    """``not_run`` is never a pass: the checker is missing or could not look at everything."""

    PASSED = "passed"
    FAILED = "failed"
    NOT_RUN = "not_run"


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing that a rule found at one place (a road, a lane, an entity, a line)."""

    rule: str
    severity: Severity
    place: str
    message: str

    def to_data(self) -> dict[str, str]:
        """The finding as JSON-able data."""
        return {name: str(value) for name, value in asdict(self).items()}


def error(rule: str, place: str, message: str) -> Finding:
    """A finding that fails its check."""
    return Finding(rule, Severity.ERROR, place, message)


def warning(rule: str, place: str, message: str) -> Finding:
    """A finding that does not fail its check."""
    return Finding(rule, Severity.WARNING, place, message)


def unchecked(rule: str, place: str, message: str) -> Finding:
    """A part that was not looked at, and why."""
    return Finding(rule, Severity.UNCHECKED, place, message)


def as_remarks(findings: Iterable[Finding]) -> Iterator[Finding]:
    """The same findings as remarks: they break a convention of ours and no standard."""
    for found in findings:
        broken = found.severity is Severity.ERROR
        yield replace(found, severity=Severity.WARNING) if broken else found


@dataclass(frozen=True, slots=True)
class CheckResult:
    """The verdict of one checker; ``detail`` says what was looked at, or why nothing was."""

    checker: str
    status: CheckStatus
    findings: tuple[Finding, ...] = ()
    detail: str = ""

    @property
    def errors(self) -> tuple[Finding, ...]:
        """The findings that fail the check."""
        return tuple(f for f in self.findings if f.severity is Severity.ERROR)

    def to_data(self) -> dict[str, Any]:
        """The result as JSON-able data."""
        return {
            "checker": self.checker,
            "status": self.status.value,
            "detail": self.detail,
            "findings": [finding.to_data() for finding in self.findings],
        }


def worst(statuses: Iterable[CheckStatus]) -> CheckStatus:
    """Failed if one failed, not run if one did not run, else passed."""
    order = (CheckStatus.PASSED, CheckStatus.NOT_RUN, CheckStatus.FAILED)
    return max(statuses, key=order.index, default=CheckStatus.PASSED)


def verdict(checker: str, findings: Iterable[Finding], detail: str = "") -> CheckResult:
    """A result that failed if one finding is an error, and passed if everything was looked at."""
    listed = tuple(findings)
    severities = {finding.severity for finding in listed}
    status = CheckStatus.PASSED
    if Severity.ERROR in severities:
        status = CheckStatus.FAILED
    elif Severity.UNCHECKED in severities:
        status = CheckStatus.NOT_RUN
    return CheckResult(checker, status, listed, detail)


def not_run(checker: str, reason: str, findings: Iterable[Finding] = ()) -> CheckResult:
    """A result of a checker that did not run, or not all of it, with the reason."""
    return CheckResult(checker, CheckStatus.NOT_RUN, tuple(findings), reason)


@dataclass(frozen=True, slots=True)
class CheckReport:
    """All results for one scenario folder or one file, in the order of the checkers."""

    folder: str
    results: tuple[CheckResult, ...]

    @property
    def ok(self) -> bool:
        """Whether no checker failed; some may not have run."""
        return all(result.status is not CheckStatus.FAILED for result in self.results)

    def result(self, checker: str) -> CheckResult:
        """The result of one checker; KeyError if it was not asked."""
        return {result.checker: result for result in self.results}[checker]

    def to_data(self) -> dict[str, Any]:
        """The report as JSON-able data."""
        return {
            "folder": self.folder,
            "ok": self.ok,
            "results": [result.to_data() for result in self.results],
        }

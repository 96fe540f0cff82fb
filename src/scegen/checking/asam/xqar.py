"""ASAM's result files (XQAR): what became of each rule."""

from dataclasses import dataclass
from pathlib import Path

from lxml import etree

from scegen.checking.results import Finding, Severity, error, unchecked

LEVELS = {"1": Severity.ERROR, "2": Severity.WARNING, "3": Severity.INFO}
OTHER_VERSION = (
    "is lower than definition setting",
    "is not valid according to definition setting",
    "is not valid according to the applicable version",
)
"""How the checkers say that a rule is not for this version of the standard."""


@dataclass(frozen=True, slots=True)
class RuleOutcome:
    """A rule: its status (``completed``, ``skipped``, ``error``), why, and what it found."""

    rule: str
    status: str
    summary: str
    issues: tuple[Finding, ...]

    @property
    def completed(self) -> bool:
        """Whether the rule looked at the file."""
        return self.status == "completed"

    @property
    def other_version(self) -> bool:
        """Whether it did not, because it is for other versions of the standard."""
        return not self.completed and any(words in self.summary for words in OTHER_VERSION)

    def findings(self) -> tuple[Finding, ...]:
        """Its issues; a rule that did not run is itself a finding, an error unless by version."""
        if self.completed:
            return self.issues
        message = f"{self.status}: {self.summary}"
        found = unchecked if self.other_version else error
        return (found("asam.rule", self.rule, message),)


def read_xqar(path: Path) -> dict[str, RuleOutcome]:
    """All rules of a result file by name; empty if the file was not written."""
    if not path.is_file():
        return {}
    rules = etree.fromstring(path.read_bytes()).iterfind(".//Checker")
    return {outcome.rule: outcome for outcome in map(_outcome, rules)}


def merged(first: dict[str, RuleOutcome], second: dict[str, RuleOutcome]) -> list[RuleOutcome]:
    """The rules of the first file; those not for its version from the second, if they ran there."""
    return [
        second[name] if outcome.other_version and name in second else outcome
        for name, outcome in first.items()
    ]


def _outcome(rule: etree._Element) -> RuleOutcome:
    return RuleOutcome(
        rule=rule.get("checkerId", "?"),
        status=rule.get("status", "none"),
        summary=rule.get("summary", "").strip(),
        issues=tuple(_issue(issue) for issue in rule.iterfind("Issue")),
    )


def _issue(issue: etree._Element) -> Finding:
    node, line = issue.find(".//XMLLocation"), issue.find(".//FileLocation")
    if node is not None:
        place = node.get("xpath", "?")
    else:
        place = f"line {line.get('row', '?')}" if line is not None else "file"
    severity = LEVELS.get(issue.get("level", "1"), Severity.ERROR)
    return Finding(issue.get("ruleUID", "?"), severity, place, issue.get("description", ""))

"""What became of a description: every statement with its standing and its words."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import asdict, dataclass, replace
from enum import StrEnum
from itertools import pairwise
from typing import Any

from pydantic import Field

from scegen.errors import InfeasibleError
from scegen.scenario.evidence import EvidenceSource
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.model import FrozenModel
from scegen.understanding.building.coverage import CONTRADICTS
from scegen.understanding.reader import read

_QUOTED = re.compile(r"'([^']+)'")


class Standing(StrEnum):
    """How far a statement rests on the text."""

    UNDERSTOOD = "understood"
    INFERRED = "inferred"
    ASSUMED = "assumed"
    CONTRADICTED = "contradicted"
    UNSUPPORTED = "unsupported"


STANDINGS = {
    EvidenceSource.STATED: Standing.UNDERSTOOD,
    EvidenceSource.INFERRED: Standing.INFERRED,
    EvidenceSource.DEFAULT: Standing.ASSUMED,
}
"""How far evidence makes a field rest on the text."""


@dataclass(frozen=True, slots=True)
class Finding:
    """One statement about the scenario, or words of the text that became none.

    Attributes:
        standing: how far it rests on the text.
        field: the field that it fills, None for words that fill none.
        value: the value of the field, in the words of the vocabulary.
        words: the words of the text, None where it rests on none.
        start: their first character.
        end: the offset after their last character.
        reason: why it was inferred, assumed or left out.
    """

    standing: Standing
    field: str | None = None
    value: str = ""
    words: str | None = None
    start: int | None = None
    end: int | None = None
    reason: str | None = None


@dataclass(frozen=True, slots=True)
class ParseReport:
    """The description and all findings, by standing and then by place in the text.

    Attributes:
        text: the description.
        findings: what became of it.
        traffic: whether it is about traffic at all; if not, there are no findings.
    """

    text: str
    findings: tuple[Finding, ...]
    traffic: bool = True

    def of(self, standing: Standing) -> tuple[Finding, ...]:
        """The findings of one standing."""
        return tuple(f for f in self.findings if f.standing is standing)

    def to_data(self) -> dict[str, Any]:
        """The report as data that JSON can hold."""
        findings = [asdict(f) | {"standing": f.standing.value} for f in self.findings]
        counts = {s.value: len(self.of(s)) for s in Standing}
        return {"text": self.text, "traffic": self.traffic, "counts": counts, "findings": findings}


def report_on(
    scenario: FunctionalScenario, disagreements: Iterable[Disagreement] = ()
) -> ParseReport:
    """The report on a scenario, whoever understood it.

    Args:
        scenario: a scenario with evidence.
        disagreements: what was read in two ways; contradictions, each with its words.
    """
    found = []
    for e in scenario.evidence:
        standing, value = STANDINGS[e.source], _value(scenario, e.field)
        found.append(Finding(standing, e.field, value, e.text, e.start, e.end, e.reason))
    for left in scenario.unsupported:
        contradicts = left.instead.startswith(CONTRADICTS)
        standing = Standing.CONTRADICTED if contradicts else Standing.UNSUPPORTED
        found.append(Finding(standing, None, "", left.text, left.start, left.end, left.instead))
    found += [_from_disagreement(item, scenario) for item in disagreements]
    return ParseReport(scenario.description, _sorted(found))


def report_on_contradiction(text: str, error: InfeasibleError) -> ParseReport:
    """The report on a text that contradicts itself or geometry.

    Args:
        text: the description.
        error: what the reader said; the words that it quotes are marked.
    """
    found = []
    where = None if error.where == "description" else error.where
    for words in dict.fromkeys(_QUOTED.findall(error.message)):
        # hyphens and white space are not quoted as they stand
        loose = r"\W+".join(re.escape(word) for word in re.findall(r"\w+", words))
        place = re.search(rf"\b{loose}\b", text, re.IGNORECASE) if loose else None
        if place is not None:
            finding = Finding(Standing.CONTRADICTED, where, "", place.group(), *place.span())
            found.append(replace(finding, reason=error.message))
    if not found:
        found.append(Finding(Standing.CONTRADICTED, where, reason=error.message))
    return ParseReport(text, _sorted(found))


def parse_report(text: str, understand: Callable[[str], FunctionalScenario] = read) -> ParseReport:
    """Understands a description and reports on it; contradictions are part of the report.

    Args:
        text: the description.
        understand: who reads it, the offline reader unless said otherwise.

    Raises:
        InputError: if the text is empty, too long or not about traffic.
    """
    try:
        return report_on(understand(text))
    except InfeasibleError as error:
        return report_on_contradiction(text, error)


def _sorted(found: list[Finding]) -> tuple[Finding, ...]:
    order = list(Standing)
    return tuple(
        sorted(found, key=lambda f: (order.index(f.standing), f.start is None, f.start or 0))
    )


def _from_disagreement(item: Disagreement, scenario: FunctionalScenario) -> Finding:
    said = f"the offline reader says {item.reader}, the agents say {item.agents}; "
    said += f"the {item.kept} stand{'s' if item.kept is Kept.READER else ''}: {item.reason}"
    value = _value(scenario, item.field)
    return Finding(Standing.CONTRADICTED, item.field, value, item.words, item.start, item.end, said)


def _value(scenario: FunctionalScenario, path: str) -> str:
    """The value of a field, by its path; empty where the path names none."""
    head, _, rest = path.partition(".")
    if head == "hazards":
        kind, _, part = rest.partition(".")
        alike = [h for h in scenario.hazards if h.kind == kind]
        return "; ".join(", ".join(h.to if part == "to" else h.by) for h in alike)
    if head == "relations" and rest.isdigit() and int(rest) < len(scenario.relations):
        relation = scenario.relations[int(rest)]
        return f"{relation.participant} {_words(relation.approaches)}, seen by {relation.reference}"
    here: object = scenario
    if head == "participants":
        name, _, rest = rest.partition(".")
        here = next((p for p in scenario.participants if p.id == name), None)
    else:
        here = getattr(scenario, head, None)
    for part in rest.split("."):
        here = getattr(here, part, None)
    return _words(here) + (" m/s" if isinstance(here, float) and path.endswith("_mps") else "")


def _words(value: object) -> str:
    if value is None:
        return ""
    if isinstance(value, frozenset | tuple):
        return ", ".join(sorted(str(v) for v in value))
    if hasattr(value, "low") and hasattr(value, "high"):
        low, high = f"{value.low:.1f}", f"{value.high:.1f}"
        return f"{low} m/s" if low == high else f"{low} to {high} m/s"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.4g}" if isinstance(value, float) else str(value)


class Kept(StrEnum):
    """Whose value stands."""

    READER = "reader"
    AGENTS = "agents"


class Disagreement(FrozenModel):
    """A fact of the text that the offline reader and the agents read differently.

    ``start`` and ``end`` are the place of ``words`` in the description.
    """

    field: str
    words: str
    start: int = Field(ge=0)
    end: int = Field(ge=0)
    reader: str
    agents: str
    kept: Kept
    reason: str


_RANK = (
    Standing.CONTRADICTED,
    Standing.UNSUPPORTED,
    Standing.UNDERSTOOD,
    Standing.INFERRED,
    Standing.ASSUMED,
)
"""Trouble first; then the firmest ground: words inside a longer phrase keep their own standing."""


@dataclass(frozen=True, slots=True)
class Passage:
    """Consecutive characters on which the same findings rest.

    Attributes:
        start: first character.
        end: offset after the last character.
        standing: the one to show, None where nothing rests on the words.
        findings: all that rests on them.
    """

    start: int
    end: int
    standing: Standing | None
    findings: tuple[Finding, ...]


def passages(report: ParseReport) -> tuple[Passage, ...]:
    """The whole text in passages without gap or overlap, cut where any finding begins or ends."""
    size = len(report.text)
    placed = [
        (max(f.start, 0), min(f.end, size), f)
        for f in report.findings
        if f.start is not None and f.end is not None
    ]
    cuts = sorted({0, size, *(cut for a, b, _ in placed if a < b for cut in (a, b))})
    found = []
    for start, end in pairwise(cuts):
        here = tuple(f for a, b, f in placed if a <= start and end <= b)
        standing = min((f.standing for f in here), key=_RANK.index, default=None)
        found.append(Passage(start, end, standing, here))
    return tuple(found)

"""The description cut into passages, each with what rests on it, for terminals and pages."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

from scegen.understanding.report.parse_report import Finding, ParseReport, Standing

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
    cuts = sorted(
        {0, size, *(a for a, b, _ in placed if a < b), *(b for a, b, _ in placed if a < b)}
    )
    found = []
    for start, end in pairwise(cuts):
        here = tuple(f for a, b, f in placed if a <= start and end <= b)
        standing = min((f.standing for f in here), key=_RANK.index, default=None)
        found.append(Passage(start, end, standing, here))
    return tuple(found)

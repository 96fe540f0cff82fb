"""What a campaign did not come to, with the reason that is told most often, and an example."""

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from scegen.campaign.rows import FAILED, Row

STATEMENTS = "Statements that do not hold"
TARGETS = "Targets that are not reached"
CHECKS = "Checks that fail"
FAILURES = "What cannot be made"
MOST = 20
_HOW_MANY = re.compile(r" in [\d,]+ candidates.*")
"""How long a search has tried is no part of the reason."""


@dataclass(frozen=True, slots=True)
class Unmet:
    """One thing that is not met: why, in how many scenarios of how many descriptions; a row."""

    what: str
    why: str
    scenarios: int
    descriptions: int
    example: int


def unmet(rows: Sequence[Row]) -> dict[str, list[Unmet]]:
    """Under each heading the most frequent ones; no heading without any."""
    found: dict[tuple[str, str], list[tuple[int, str]]] = {}
    for number, row in enumerate(rows):
        for heading, what, why in _of(row):
            found.setdefault((heading, what), []).append((number, why))
    headings: dict[str, list[Unmet]] = {}
    for (heading, what), told in found.items():
        why, _ = Counter(why for _, why in told).most_common(1)[0]
        example = next(number for number, reason in told if reason == why)
        where = {rows[number]["description"] for number, _ in told}
        one = Unmet(what, why, len(told), len(where), example)
        headings.setdefault(heading, []).append(one)
    order = (STATEMENTS, TARGETS, CHECKS, FAILURES)
    return {
        heading: sorted(headings[heading], key=lambda one: (-one.scenarios, one.what))[:MOST]
        for heading in order
        if heading in headings
    }


def _of(row: Row) -> Iterator[tuple[str, str, str]]:
    """Heading, what, and why, of one row."""
    if row["status"] == FAILED:
        yield FAILURES, str(row["reason"]), f"to {row['stage']} it"
        return
    blocked = _HOW_MANY.sub("", row["blocked_by"] or "")
    for told in row["claims_missed"] or ():
        statement, _, found = told.partition(": ")
        yield STATEMENTS, statement, blocked or f"found: {found}"
    if row["reached"] is False and not row["claims_missed"]:
        yield TARGETS, str(row["target"]), blocked or "nothing is known that stands against it"
    for told in row["check_findings"] or ():
        checker, _, finding = told.partition(": ")
        _, _, rule = finding.rpartition("[")
        yield CHECKS, f"{checker}: {rule.removesuffix(']')}", finding

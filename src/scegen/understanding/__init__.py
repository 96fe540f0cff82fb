"""From an English description to a functional scenario, by rules, offline.

What one stage hands to the next has one name everywhere: ``tokens``, ``terms`` (what the lexicon
makes of them), ``chunks`` (mentions, places, things, events), ``events`` with their parts,
``clause`` (an event with who is in it), ``draft`` in its ``context``: the scenario in the making.
"""

from scegen.understanding.reader import MAX_CHARACTERS, read
from scegen.understanding.report.parse_report import (
    STANDINGS,
    Finding,
    ParseReport,
    Passage,
    Standing,
    parse_report,
    passages,
    report_on,
    report_on_contradiction,
)
from scegen.understanding.report.scoring import Case, Score, load_cases, paper_cases, score

__all__ = [
    "MAX_CHARACTERS",
    "STANDINGS",
    "Case",
    "Finding",
    "ParseReport",
    "Passage",
    "Score",
    "Standing",
    "load_cases",
    "paper_cases",
    "parse_report",
    "passages",
    "read",
    "report_on",
    "report_on_contradiction",
    "score",
]

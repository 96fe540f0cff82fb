"""From an English description to a functional scenario, by rules, offline."""

from scegen.understanding.cases import Case, load_cases, paper_cases
from scegen.understanding.explain import Mark, marks
from scegen.understanding.reader import MAX_CHARACTERS, read
from scegen.understanding.scoring import Score, score

__all__ = [
    "MAX_CHARACTERS",
    "Case",
    "Mark",
    "Score",
    "load_cases",
    "marks",
    "paper_cases",
    "read",
    "score",
]

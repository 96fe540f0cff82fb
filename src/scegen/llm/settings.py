"""How a run may use language models."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path

from scegen.llm.budget import Budget
from scegen.llm.naming import ModelName


@dataclass(frozen=True, slots=True)
class Limits:
    """Bounds on every request, so that no server can hold up a run for ever.

    ``request_s`` bounds one attempt from connecting to the last byte, ``run_s`` all requests of
    one conversation with a model. ``attempts`` counts the first one too; a wait between them
    doubles from ``first_wait_s``, follows Retry-After, and never exceeds ``longest_wait_s``.
    """

    request_s: float = 90.0
    run_s: float = 300.0
    attempts: int = 4
    first_wait_s: float = 1.0
    longest_wait_s: float = 30.0
    answer_bytes: int = 1_000_000
    answer_tokens: int = 4096
    corrections: int = 2
    review_rounds: int = 2

    def patient(self, request_s: float) -> Limits:
        """The same with another bound on one attempt, and on all of them in proportion."""
        return replace(self, request_s=request_s, run_s=self.run_s * request_s / self.request_s)


@dataclass(frozen=True, slots=True)
class LlmSettings:
    """Which models to ask, where, and how much of everything.

    ``models`` are tried in this order. ``record`` is a folder for transcripts; ``replay`` one
    to answer from, without network.
    """

    models: tuple[ModelName, ...]
    url: str | None = None
    budget: Budget = field(default_factory=Budget)
    record: Path | None = None
    replay: Path | None = None
    limits: Limits = field(default_factory=Limits)

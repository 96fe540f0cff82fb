"""What was used: requests, tokens, money."""

from __future__ import annotations

from dataclasses import astuple, dataclass
from operator import add, sub
from typing import Any


@dataclass(frozen=True, slots=True)
class Usage:
    """Totals. ``cost_usd`` leaves out ``unpriced`` answers, those of models without a known price.

    ``requests`` counts answers asked for; ``retries`` the attempts beyond the first of each.
    """

    requests: int = 0
    retries: int = 0
    input_tokens: int = 0
    output_tokens: int = 0
    cost_usd: float = 0.0
    unpriced: int = 0

    def __add__(self, other: Usage) -> Usage:
        return Usage(*map(add, astuple(self), astuple(other)))

    def __sub__(self, other: Usage) -> Usage:
        return Usage(*map(sub, astuple(self), astuple(other)))

    @property
    def tokens(self) -> int:
        """Tokens in both directions."""
        return self.input_tokens + self.output_tokens

    def to_data(self) -> dict[str, Any]:
        """As in ``summary.json``; a cost that is not known in full is null."""
        return {
            "requests": self.requests,
            "retries": self.retries,
            "input_tokens": self.input_tokens,
            "output_tokens": self.output_tokens,
            "cost_usd": None if self.unpriced else round(self.cost_usd, 6),
        }

    def in_words(self) -> str:
        """One line for a person."""
        cost = "cost not known" if self.unpriced else f"{self.cost_usd:.4f} USD"
        retried = f", {self.retries} retried" if self.retries else ""
        return (
            f"{self.requests} requests{retried}, {self.input_tokens} tokens in, "
            f"{self.output_tokens} out, {cost}"
        )

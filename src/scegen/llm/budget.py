"""The most that a run may use, in tokens, in money, or both."""

from __future__ import annotations

import re
from dataclasses import dataclass

from scegen.errors import InputError
from scegen.llm.faults import Fault, FaultKind, LlmError
from scegen.llm.usage import Usage

_TOKENS = re.compile(r"(\d{1,12}(?:\.\d{1,3})?)\s*(k?)\s*(?:tokens?)?", re.IGNORECASE)
_MONEY = re.compile(r"\$\s*(\d{1,9}(?:\.\d{1,9})?)|(\d{1,9}(?:\.\d{1,9})?)\s*usd", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Budget:
    """Limits of a run; None = no limit."""

    tokens: int | None = None
    cost_usd: float | None = None


def parse_budget(text: str) -> Budget:
    """A budget from ``20000``, ``20k tokens``, ``0.10usd``, ``$0.10``, or both with a comma.

    Raises:
        InputError: it is none of these.
    """
    tokens: int | None = None
    cost: float | None = None
    for part in (p.strip() for p in text.split(",")):
        if money := _MONEY.fullmatch(part):
            cost = float(money[1] or money[2])
        elif (count := _TOKENS.fullmatch(part)) and ("." not in count[1] or count[2]):
            tokens = round(float(count[1]) * (1000 if count[2] else 1))
        else:
            raise InputError(
                f"{part!r} is neither a number of tokens nor of dollars",
                where="--llm-budget",
                hint="such as 20000, 20k, 0.10usd, or both: 20k,0.10usd",
            )
    if not all(limit is None or limit > 0 for limit in (tokens, cost)):
        raise InputError("must be more than 0", where="--llm-budget")
    return Budget(tokens, cost)


class Ledger:
    """Keeps what was used, and refuses a request that could exceed the budget.

    What is under way counts with its most expensive outcome, so that requests which run side by
    side cannot exceed the budget together.
    """

    def __init__(self, budget: Budget) -> None:
        self._budget = budget
        self._used = Usage()
        self._held = Usage()

    @property
    def used(self) -> Usage:
        """What was used so far."""
        return self._used

    def hold(self, most: Usage) -> None:
        """Set aside what a request may use at most.

        Raises:
            LlmError: it does not fit into what is left of the budget.
        """
        planned = self._used + self._held + most
        left = self._used + self._held
        if self._budget.tokens is not None and planned.tokens > self._budget.tokens:
            raise LlmError(
                Fault(
                    kind=FaultKind.BUDGET,
                    message=f"the next request may take {most.tokens} tokens, and "
                    f"{max(self._budget.tokens - left.tokens, 0)} of the budget's "
                    f"{self._budget.tokens} are left",
                )
            )
        if self._budget.cost_usd is not None:
            if most.unpriced:
                raise LlmError(
                    Fault(
                        kind=FaultKind.BUDGET,
                        message="the model's price is not known, so no budget in dollars can "
                        "be kept; give it in tokens",
                    )
                )
            if planned.cost_usd > self._budget.cost_usd:
                raise LlmError(
                    Fault(
                        kind=FaultKind.BUDGET,
                        message=f"the next request may cost {most.cost_usd:.4f} USD, and "
                        f"{max(self._budget.cost_usd - left.cost_usd, 0.0):.4f} of the budget's "
                        f"{self._budget.cost_usd:g} USD are left",
                    )
                )
        self._held += most

    def settle(self, most: Usage, used: Usage) -> None:
        """Replace what was set aside by what was used."""
        held, back = self._held, most
        self._held = Usage(
            held.requests - back.requests,
            held.retries - back.retries,
            held.input_tokens - back.input_tokens,
            held.output_tokens - back.output_tokens,
            held.cost_usd - back.cost_usd,
            held.unpriced - back.unpriced,
        )
        self._used += used

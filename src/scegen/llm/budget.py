"""The most that a run may use, in tokens, in money, or both."""

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
        if refusal := self._refusal(most):
            raise LlmError(Fault(kind=FaultKind.BUDGET, message=refusal))
        self._held += most

    def _refusal(self, most: Usage) -> str:
        """Why a request does not fit into what is left; nothing if it does."""
        taken, tokens, usd = self._used + self._held, self._budget.tokens, self._budget.cost_usd
        if tokens is not None and (taken + most).tokens > tokens:
            left = max(tokens - taken.tokens, 0)
            return (
                f"the next request may take {most.tokens} tokens, and {left} of the budget's "
                f"{tokens} are left"
            )
        if usd is None:
            return ""
        if most.unpriced:
            return (
                "the model's price is not known, so no budget in dollars can be kept; give it in "
                "tokens"
            )
        if (taken + most).cost_usd > usd:
            left_usd = max(usd - taken.cost_usd, 0.0)
            return (
                f"the next request may cost {most.cost_usd:.4f} USD, and {left_usd:.4f} of the "
                f"budget's {usd:g} USD are left"
            )
        return ""

    def settle(self, most: Usage, used: Usage) -> None:
        """Replace what was set aside by what was used."""
        self._held -= most
        self._used += used

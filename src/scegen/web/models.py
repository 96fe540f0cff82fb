"""The language models of a server: one budget for all who use it, and what is left of it."""

import os
from dataclasses import replace

from scegen.errors import InputError
from scegen.llm import Budget, LlmSettings, Usage
from scegen.llm.keys import key_for


class Models:
    """Models that descriptions can be given to, with the budget of the whole server."""

    def __init__(self, settings: LlmSettings) -> None:
        self.settings = settings
        self.used = Usage()

    def spend(self, usage: Usage) -> None:
        """Note what a run took."""
        self.used += usage

    def settings_of_a_run(self) -> LlmSettings:
        """The settings with what is left of the budget.

        Raises:
            InputError: nothing is left.
        """
        budget = self.settings.budget
        tokens = None if budget.tokens is None else budget.tokens - self.used.tokens
        cost = None if budget.cost_usd is None else budget.cost_usd - self.used.cost_usd
        if (tokens is not None and tokens <= 0) or (cost is not None and cost <= 0):
            raise InputError(
                "the budget of this server is spent",
                where="--llm-budget",
                hint="start scegen serve with a larger one, or without --llm",
            )
        return replace(self.settings, budget=Budget(tokens, cost))

    def keys(self) -> dict[str, bool]:
        """The models by name, and whether there is a key for each; never the keys."""
        return {str(name): self._has_key(index) for index, name in enumerate(self.settings.models)}

    def _has_key(self, index: int) -> bool:
        try:
            key_for(self.settings.models[index], os.environ, url=self.settings.url)
        except InputError:
            return False
        return True

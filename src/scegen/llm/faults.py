"""What can go wrong between us and a model, as data: it is recorded, replayed and reported."""

from enum import StrEnum
from typing import Self

from scegen.scenario.model import FrozenModel


class FaultKind(StrEnum):
    """Why a model gave no usable answer."""

    AUTHENTICATION = "authentication"
    NOT_FOUND = "not_found"
    REJECTED = "rejected"
    RATE_LIMIT = "rate_limit"
    SERVER = "server"
    TIMEOUT = "timeout"
    CONNECTION = "connection"
    TOO_LARGE = "too_large"
    NO_ANSWER = "no_answer"
    REFUSED = "refused"
    INVALID = "invalid"
    NOT_TRAFFIC = "not_traffic"
    BUDGET = "budget"


_HINTS = {
    FaultKind.AUTHENTICATION: "check the key in the environment",
    FaultKind.NOT_FOUND: "check the model's name and --llm-url",
    FaultKind.RATE_LIMIT: "try again later",
    FaultKind.SERVER: "try again later",
    FaultKind.TIMEOUT: "try again later, or name a faster model",
    FaultKind.CONNECTION: "check the network and --llm-url",
    FaultKind.BUDGET: "raise --llm-budget",
    FaultKind.INVALID: "name a more capable model",
}


class Fault(FrozenModel):
    """A fault in words; ``agent`` and ``model`` say whose answer is missing."""

    kind: FaultKind
    message: str
    agent: str = ""
    model: str = ""

    @property
    def hint(self) -> str | None:
        """What the user can do about it."""
        return _HINTS.get(self.kind)

    def named(self, *, agent: str, model: str) -> Self:
        """The same fault, of this agent and model."""
        return self.but(agent=agent, model=model)

    def in_words(self) -> str:
        """One line for a person."""
        who = f"{self.model or 'the model'}" + (f", agent {self.agent}" if self.agent else "")
        return f"{who}: {self.message}"


class LlmError(Exception):
    """A model gave no usable answer. It ends in a fallback, never at the user."""

    def __init__(self, fault: Fault) -> None:
        self.fault = fault
        super().__init__(fault.in_words())

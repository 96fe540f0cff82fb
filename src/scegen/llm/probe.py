"""The connection test: one small question to a model, through all that a real run goes through."""

import asyncio
import time
from collections.abc import Mapping
from dataclasses import dataclass

from scegen.llm.asking import ask
from scegen.llm.budget import Budget, Ledger
from scegen.llm.faults import Fault, LlmError
from scegen.llm.keys import key_for
from scegen.llm.line import Line
from scegen.llm.naming import ModelName
from scegen.llm.providers import endpoint
from scegen.llm.settings import Limits
from scegen.llm.usage import Usage
from scegen.scenario.model import FrozenModel

PATIENCE = Limits(request_s=30.0, run_s=60.0, attempts=2, corrections=1)


class Answer(FrozenModel):
    """What a model that can serve has to give back."""

    arms: int


@dataclass(frozen=True, slots=True)
class Probe:
    """How the test went; ``fault`` is None if the model can serve."""

    model: str
    address: str
    fault: Fault | None
    usage: Usage
    seconds: float


def probe(
    name: ModelName,
    environment: Mapping[str, str],
    *,
    url: str | None = None,
    limits: Limits = PATIENCE,
) -> Probe:
    """Ask a model something small, in the way in which agents ask.

    Raises:
        InputError: there is no key for it.
    """
    key = key_for(name, environment, url=url)
    line = Line(name=name, chain=1, url=url, key=key, limits=limits, ledger=Ledger(Budget()))
    began = time.perf_counter()
    fault = asyncio.run(_ask(line))
    seconds = time.perf_counter() - began
    address = endpoint(name, url) or f"{name.provider}'s own address"
    return Probe(str(name), address, fault, line.usage(), seconds)


async def _ask(line: Line) -> Fault | None:
    async with line:
        try:
            await ask(
                line,
                "probe",
                Answer,
                "How many arms has a four-way intersection?",
                instructions="Answer the question by calling the tool.",
            )
        except LlmError as error:
            return error.fault
    return None

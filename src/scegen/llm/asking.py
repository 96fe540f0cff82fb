"""One agent's conversation: a question, a typed answer, corrections where it is not valid."""

from collections.abc import Callable
from typing import TypeVar

from pydantic_ai import Agent, ModelRetry, ToolOutput
from pydantic_ai.settings import ModelSettings

from scegen.errors import ScegenError
from scegen.llm.faults import LlmError
from scegen.llm.line import Line
from scegen.llm.troubles import fault_of_run
from scegen.scenario.model import FrozenModel

R = TypeVar("R", bound=FrozenModel)


async def ask(
    line: Line,
    name: str,
    kind: type[R],
    question: str,
    *,
    instructions: str,
    complain: Callable[[R], str | None] = lambda _: None,
) -> R:
    """The answer of the agent ``name``.

    What does not validate as ``kind`` goes back with the errors, and so does a valid answer of
    which ``complain`` says what is wrong.

    Raises:
        LlmError: no valid answer after every correction, or none at all.
        InputError: a replay lacks the exchange.
    """
    agent: Agent[object, R] = Agent(
        line.model(name),
        output_type=ToolOutput(kind, name="answer", description="Give the answer."),
        instructions=instructions,
        retries={"output": line.limits.corrections},
        # the same question should get the same answer
        model_settings=ModelSettings(temperature=0.0),
        name=name,
    )

    @agent.output_validator
    def _check(answer: R) -> R:
        complaint = complain(answer)
        if complaint is not None:
            raise ModelRetry(complaint)
        return answer

    try:
        result = await agent.run(question)
    except ScegenError:
        raise
    except Exception as error:
        fault = fault_of_run(error, line.key)
        raise LlmError(fault.named(agent=name, model=str(line.name))) from error
    return result.output

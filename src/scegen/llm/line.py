"""A line to one model: every request passes here, to be bounded, counted, recorded or replayed."""

from __future__ import annotations

import asyncio
import json
from collections import Counter
from collections.abc import Awaitable, Callable
from dataclasses import dataclass, field
from typing import Any, TypeVar

import httpx2
from genai_prices import Usage as PricedUsage
from genai_prices import calc_price
from pydantic import ValidationError
from pydantic_ai.messages import ModelMessage, ModelMessagesTypeAdapter, ModelResponse
from pydantic_ai.models import Model, ModelRequestParameters
from pydantic_ai.models.wrapper import WrapperModel
from pydantic_ai.settings import ModelSettings

from scegen.errors import InputError
from scegen.llm.budget import Ledger
from scegen.llm.client import ClosedTransport, GuardedTransport
from scegen.llm.faults import Fault, LlmError
from scegen.llm.keys import blot
from scegen.llm.naming import COMPATIBLE, PROVIDERS, ModelName
from scegen.llm.providers import build_model
from scegen.llm.settings import Limits
from scegen.llm.transcript import Exchange, Recorder, Recording, words_of
from scegen.llm.troubles import Trouble, trouble_of
from scegen.llm.usage import Usage

_BYTES_PER_TOKEN = 3
"""A cautious rule of thumb, for what a request takes before the server has counted."""
_REPLAY_URL = "http://replay.invalid/v1"
T = TypeVar("T")


@dataclass
class Line:
    """A connection to one model of the chain, shared by all agents.

    ``chain`` is the model's place among the models asked, from 1; it names transcript files.
    """

    name: ModelName
    chain: int
    url: str | None
    key: str
    limits: Limits
    ledger: Ledger
    recorder: Recorder | None = None
    recording: Recording | None = None
    exchanges: list[Exchange] = field(default_factory=list)
    _numbers: Counter[str] = field(default_factory=Counter)
    _deadline: float = 0.0
    _client: httpx2.AsyncClient | None = None

    async def __aenter__(self) -> Line:
        transport: httpx2.AsyncBaseTransport
        if self.recording is not None:
            transport = ClosedTransport()
        else:
            transport = GuardedTransport(
                key=self.key, request_s=self.limits.request_s, answer_bytes=self.limits.answer_bytes
            )
        self._client = httpx2.AsyncClient(transport=transport)
        self._deadline = asyncio.get_running_loop().time() + self.limits.run_s
        return self

    async def __aexit__(self, *_: object) -> None:
        if self._client is not None:
            await self._client.aclose()

    def model(self, agent: str) -> Model:
        """The model as one agent sees it."""
        if self._client is None:
            raise RuntimeError("the line is not open")
        url = _REPLAY_URL if self.recording is not None else self.url
        inner = build_model(self.name, url=url, key=self.key, http_client=self._client)
        return _AgentModel(inner, self, agent)

    def usage(self, first: int = 0) -> Usage:
        """What was used from the exchange ``first`` on, summed in an order that no race changes."""
        ordered = sorted(self.exchanges[first:], key=lambda e: (e.agent, e.number))
        return sum((e.usage for e in ordered), Usage())

    async def ask(
        self,
        agent: str,
        messages: list[ModelMessage],
        schema_bytes: int,
        send: Callable[[], Awaitable[ModelResponse]],
    ) -> ModelResponse:
        """The answer to one request.

        Raises:
            LlmError: there is none.
            InputError: the recording lacks it, or has another.
        """
        self._numbers[agent] += 1
        number = self._numbers[agent]
        request = ModelMessagesTypeAdapter.dump_python(messages, mode="json")
        if self.recording is not None:
            exchange = self.recording.exchange(self.chain, agent, number, words_of(request))
            self.ledger.settle(Usage(), exchange.usage)
        else:
            exchange = await self._exchange(agent, number, request, schema_bytes, send)
            if self.recorder is not None:
                self.recorder.keep(self.chain, exchange)
        self.exchanges.append(exchange)
        if exchange.fault is not None:
            raise LlmError(exchange.fault)
        # through the recorded form even when live, so that a replay sees the same
        try:
            response = ModelMessagesTypeAdapter.validate_python([exchange.response])[0]
        except ValidationError:
            response = None
        if isinstance(response, ModelResponse):
            return response
        raise InputError(
            f"the answer {number} of agent {agent} is damaged",
            where="--llm-replay",
            hint="record the run again with --llm-record",
        )

    async def _exchange(
        self,
        agent: str,
        number: int,
        request: Any,  # noqa: ANN401 - JSON
        schema_bytes: int,
        send: Callable[[], Awaitable[ModelResponse]],
    ) -> Exchange:
        said = len(json.dumps(request, ensure_ascii=False).encode("utf-8", "replace"))
        expected = (said + schema_bytes) // _BYTES_PER_TOKEN
        most = self._priced(expected, self.limits.answer_tokens, attempts=1)
        done = Exchange(model=str(self.name), agent=agent, number=number, request=tuple(request))
        try:
            self.ledger.hold(most)
        except LlmError as error:
            return done.but(fault=self._named(agent, error.fault))
        used = Usage()
        try:
            answer, attempts = await ask_until(send, self.limits, self._deadline, self.key)
            if isinstance(answer, Trouble):
                used = Usage(requests=1, retries=attempts - 1)
                return done.but(fault=self._named(agent, answer.fault), usage=used)
            # once more, now that no escape of JSON can hide the key
            dumped = ModelMessagesTypeAdapter.dump_python([answer], mode="json")[0]
            response = json.loads(blot(json.dumps(dumped), self.key))
            used = self._used(answer, expected, len(json.dumps(response["parts"])), attempts)
            return done.but(response=response, usage=used)
        finally:
            self.ledger.settle(most, used)

    def _used(
        self, answer: ModelResponse, expected: int, answer_bytes: int, attempts: int
    ) -> Usage:
        """As the server counted; by length where it did not."""
        counted = answer.usage
        if counted.input_tokens or counted.output_tokens:
            return self._priced(counted.input_tokens, counted.output_tokens, attempts)
        return self._priced(expected, answer_bytes // _BYTES_PER_TOKEN, attempts)

    def _priced(self, input_tokens: int, output_tokens: int, attempts: int) -> Usage:
        cost = cost_usd(self.name, input_tokens, output_tokens)
        return Usage(
            requests=1,
            retries=attempts - 1,
            input_tokens=input_tokens,
            output_tokens=output_tokens,
            cost_usd=cost or 0.0,
            unpriced=int(cost is None),
        )

    def _named(self, agent: str, fault: Fault) -> Fault:
        return fault.named(agent=agent, model=str(self.name))


class _AgentModel(WrapperModel):
    """Leads an agent's requests over the line."""

    def __init__(self, wrapped: Model, line: Line, agent: str) -> None:
        super().__init__(wrapped)
        self._line = line
        self._agent = agent

    async def request(
        self,
        messages: list[ModelMessage],
        model_settings: ModelSettings | None,
        model_request_parameters: ModelRequestParameters,
    ) -> ModelResponse:
        """Ask over the line."""
        schema = [tool.parameters_json_schema for tool in model_request_parameters.output_tools]
        # the line retries by itself, and bounds the answer
        settings = ModelSettings(
            **{
                **(model_settings or {}),
                "max_tokens": self._line.limits.answer_tokens,
                "max_retries": 0,
            }
        )

        async def send() -> ModelResponse:
            return await self.wrapped.request(messages, settings, model_request_parameters)

        return await self._line.ask(self._agent, messages, len(json.dumps(schema)), send)


async def ask_until(
    send: Callable[[], Awaitable[T]], limits: Limits, deadline: float, key: str
) -> tuple[T | Trouble, int]:
    """The answer or the last trouble, and after how many attempts.

    Nothing is awaited after the loop's time ``deadline``; ``key`` is blotted out of every message.
    """
    clock = asyncio.get_running_loop().time
    pause = limits.first_wait_s
    attempt = 0
    while True:
        attempt += 1
        try:
            async with asyncio.timeout(min(limits.request_s, deadline - clock())):
                return await send(), attempt
        except Exception as error:  # noqa: BLE001 - whatever a server provokes is a fault
            trouble = trouble_of(error, key)
        wait = pause if trouble.wait_s is None else trouble.wait_s
        hopeless = not trouble.passing or attempt >= limits.attempts
        if hopeless or wait > limits.longest_wait_s or clock() + wait >= deadline:
            return trouble, attempt
        await asyncio.sleep(wait)
        pause = min(pause * 2, limits.longest_wait_s)


def cost_usd(name: ModelName, input_tokens: int, output_tokens: int) -> float | None:
    """List price in US dollars, None if it is not known; local models are free.

    Prompt caches and discounts by the hour are left out: the real price is at most this.
    """
    if name.provider == COMPATIBLE:
        return None
    if PROVIDERS[name.provider].local:
        return 0.0
    usage = PricedUsage(input_tokens=input_tokens, output_tokens=output_tokens)
    try:
        price = calc_price(usage, name.model, provider_id=name.provider)
    except LookupError:
        return None
    return float(price.total_price)

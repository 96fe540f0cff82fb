"""List prices; and every provider of the table can be built without a network."""

import asyncio

import httpx2
import pytest

from scegen.errors import InputError
from scegen.llm.client import ClosedTransport
from scegen.llm.line import cost_usd
from scegen.llm.naming import COMPATIBLE, PROVIDERS, ModelName
from scegen.llm.providers import build_model


def test_prices():
    assert cost_usd(ModelName("ollama", "x"), 10**6, 10**6) == 0.0
    assert cost_usd(ModelName("openai", "gpt-4o-mini"), 10**6, 10**6) == pytest.approx(0.75)
    assert cost_usd(ModelName("deepseek", "deepseek-chat"), 10**6, 0) > 0
    assert cost_usd(ModelName("openai", "no-such-model"), 1, 1) is None
    assert cost_usd(ModelName(COMPATIBLE, "gpt-4o-mini"), 1, 1) is None


@pytest.mark.parametrize("url", [None, "http://127.0.0.1:9/v1"])
@pytest.mark.parametrize("provider", [*PROVIDERS, COMPATIBLE])
def test_every_provider_can_be_built(monkeypatch, provider, url):
    for known in PROVIDERS.values():
        monkeypatch.delenv(known.key_variable, raising=False)
    if provider == COMPATIBLE and url is None:
        pytest.skip("has no address of its own")

    async def build():
        async with httpx2.AsyncClient(transport=ClosedTransport()) as client:
            return build_model(
                ModelName(provider, "openai/gpt-4o"), url=url, key="a-key", http_client=client
            )

    model = asyncio.run(build())
    assert model.model_name == "openai/gpt-4o"
    address = str(model.client.base_url)
    assert address.startswith(url or "http")


def test_a_name_that_the_provider_does_not_take():
    async def build():
        async with httpx2.AsyncClient(transport=ClosedTransport()) as client:
            build_model(ModelName("openrouter", "x"), url=None, key="a-key", http_client=client)

    with pytest.raises(InputError, match="openrouter:x: cannot be used"):
        asyncio.run(build())

"""A provider's model object, over our own HTTP client."""

import os
from collections.abc import Callable
from typing import cast

import httpx2
from openai import AsyncOpenAI, OpenAIError
from pydantic_ai.exceptions import UserError
from pydantic_ai.models import Model
from pydantic_ai.models.openai import OpenAIChatModel
from pydantic_ai.providers import Provider, infer_provider_class
from pydantic_ai.providers.openai_compatible import OpenAICompatibleProvider

from scegen.errors import InputError
from scegen.llm.naming import COMPATIBLE, PROVIDERS, ModelName, require_url


def endpoint(name: ModelName, url: str | None) -> str | None:
    """Where a model is asked; None = the provider's own address.

    Raises:
        InputError: the environment names an address that is none, or holds a key.
    """
    provider = PROVIDERS.get(name.provider)
    if url is not None or provider is None:
        return url
    named = os.environ.get(provider.url_variable) if provider.url_variable else None
    if not named or provider.url_variable is None:
        return provider.default_url
    return require_url(named, where=provider.url_variable)


def build_model(
    name: ModelName, *, url: str | None, key: str, http_client: httpx2.AsyncClient
) -> Model:
    """The model that ``name`` stands for.

    ``url`` is asked instead of the provider's own address; ``key`` may be a placeholder.

    Raises:
        InputError: the provider has no such model.
    """
    address = endpoint(name, url)
    try:
        return _build(name, address, key, http_client)
    except (UserError, OpenAIError) as error:
        raise InputError(
            f"cannot be used: {error}", where=f"--llm {name}", hint="check the model's name"
        ) from error


def _build(
    name: ModelName, address: str | None, key: str, http_client: httpx2.AsyncClient
) -> Model:
    if name.provider == "anthropic":  # whose library takes a second to load
        from pydantic_ai.models.anthropic import AnthropicModel  # noqa: PLC0415
        from pydantic_ai.providers.anthropic import AnthropicProvider  # noqa: PLC0415

        return AnthropicModel(
            name.model,
            provider=AnthropicProvider(api_key=key, base_url=address, http_client=http_client),
        )
    if address is None:
        provider = _provider_class(name)(api_key=key, http_client=http_client)
        return OpenAIChatModel(name.model, provider=provider)
    client = AsyncOpenAI(base_url=address, api_key=key, http_client=http_client)
    if name.provider == COMPATIBLE:
        return OpenAIChatModel(
            name.model, provider=OpenAICompatibleProvider(COMPATIBLE, openai_client=client)
        )
    provider = _provider_class(name)(openai_client=client)
    return OpenAIChatModel(name.model, provider=provider)


def _provider_class(name: ModelName) -> Callable[..., Provider[AsyncOpenAI]]:
    """The library's own class: it knows the address and the model's peculiarities."""
    return cast("Callable[..., Provider[AsyncOpenAI]]", infer_provider_class(name.provider))

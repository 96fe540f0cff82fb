"""Model names: ``provider:model``, several with commas as a chain of fallbacks."""

from dataclasses import dataclass
from urllib.parse import urlsplit

from scegen.errors import InputError

COMPATIBLE = "compatible"
"""The provider of models behind ``--llm-url`` that name none of their own."""
KEY_VARIABLE = "SCEGEN_LLM_KEY"
"""Holds the key for ``--llm-url``; it goes before the provider's own variable."""


@dataclass(frozen=True, slots=True)
class Provider:
    """What a provider needs from the environment; ``local`` ones need no key and cost nothing."""

    key_variable: str
    local: bool = False
    default_url: str | None = None
    url_variable: str | None = None


PROVIDERS: dict[str, Provider] = {
    "deepseek": Provider("DEEPSEEK_API_KEY"),
    "openai": Provider("OPENAI_API_KEY", url_variable="OPENAI_BASE_URL"),
    "anthropic": Provider("ANTHROPIC_API_KEY", url_variable="ANTHROPIC_BASE_URL"),
    "ollama": Provider(
        "OLLAMA_API_KEY",
        local=True,
        default_url="http://localhost:11434/v1",
        url_variable="OLLAMA_BASE_URL",
    ),
    "openrouter": Provider("OPENROUTER_API_KEY"),
    "alibaba": Provider("ALIBABA_API_KEY"),
    "cerebras": Provider("CEREBRAS_API_KEY"),
    "fireworks": Provider("FIREWORKS_API_KEY"),
    "moonshotai": Provider("MOONSHOTAI_API_KEY"),
    "nebius": Provider("NEBIUS_API_KEY"),
    "together": Provider("TOGETHER_API_KEY"),
}
"""Providers by the word before the colon."""


@dataclass(frozen=True, slots=True)
class ModelName:
    """A model of a provider."""

    provider: str
    model: str

    def __str__(self) -> str:
        return self.model if self.provider == COMPATIBLE else f"{self.provider}:{self.model}"


def parse_models(text: str, *, url: str | None = None) -> tuple[ModelName, ...]:
    """The chain of models that ``--llm`` names, in the order in which they are tried.

    Raises:
        InputError: a name has no known provider, or no model.
    """
    names = tuple(_parse(part.strip(), url) for part in text.split(",") if part.strip())
    if not names:
        raise InputError(
            "names no model", where="--llm", hint="name one, such as deepseek:deepseek-chat"
        )
    return names


def _parse(text: str, url: str | None) -> ModelName:
    provider, colon, model = text.partition(":")
    if colon and model and provider in PROVIDERS:
        return ModelName(provider, model)
    if url is not None and not (colon and provider in PROVIDERS):
        return ModelName(COMPATIBLE, text)
    what = "names no model" if provider in PROVIDERS else "has no known provider"
    raise InputError(
        f"{text!r} {what}",
        where="--llm",
        hint=f"write provider:model with one of {', '.join(PROVIDERS)}, "
        "or name any OpenAI-compatible endpoint with --llm-url",
    )


def require_url(url: str, *, where: str = "--llm-url") -> str:
    """The address of an endpoint, if it is one and holds no secret.

    ``where`` is the option or variable that it comes from.

    Raises:
        InputError: it is no address, or carries a key; the message does not show it.
    """
    try:
        parts = urlsplit(url)
        usable = parts.scheme in {"http", "https"} and bool(parts.hostname) and parts.port != 0
    except ValueError:
        usable = False
    if not usable:
        raise InputError(
            "is not the address of an endpoint",
            where=where,
            hint="such as http://127.0.0.1:8000/v1",
        )
    if parts.username or parts.password or parts.query or parts.fragment:
        # what stands in an address ends up in logs and transcripts
        raise InputError(
            "holds more than scheme, host, port and path; a key does not belong there",
            where=where,
            hint=f"put the key into the environment variable {KEY_VARIABLE}",
        )
    return url.rstrip("/")

"""The extra that brings the libraries which speak to language models."""

from importlib.util import find_spec

from scegen.errors import MissingToolError

INSTALL_LLM = "pip install 'ml-scegen[llm]'"
_LIBRARIES = ("pydantic_ai", "openai", "anthropic", "httpx2", "genai_prices")


def require_llm() -> None:
    """Refuse to go on where the extra is not installed.

    Raises:
        MissingToolError: names the line that installs it.
    """
    for name in _LIBRARIES:
        if find_spec(name) is None:
            raise MissingToolError(
                f"language models need the library {name}, which is not installed",
                where="--llm",
                hint=f"run: {INSTALL_LLM}",
            )

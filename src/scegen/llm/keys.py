"""Keys: read from the environment, handed to the connection, and blotted out everywhere else."""

from collections.abc import Mapping

from scegen.errors import InputError
from scegen.llm.naming import COMPATIBLE, KEY_VARIABLE, PROVIDERS, ModelName

NO_KEY = "no-key-needed"
"""What is sent where a key is not needed: the libraries insist on one."""
_BLOT = "[key]"
_SHORTEST_SECRET = 8
"""Shorter values, such as a server's placeholder ``ollama``, are words and no secrets."""


def key_for(name: ModelName, environment: Mapping[str, str], *, url: str | None) -> str:
    """The key with which to ask a model.

    Raises:
        InputError: there is none, or it cannot be one; the message does not show it.
    """
    provider = PROVIDERS.get(name.provider)
    variables = [KEY_VARIABLE] if url is not None else []
    variables += [provider.key_variable] if provider else []
    for variable in variables:
        key = environment.get(variable, "").strip()
        if key:
            return _sound(key, variable)
    if name.provider == COMPATIBLE or url is not None or (provider and provider.local):
        return NO_KEY
    raise InputError(
        f"no key: the environment variable {variables[0]} is not set",
        where=f"--llm {name}",
        hint=f"set {variables[0]} in the environment; keys are read from nowhere else",
    )


def _sound(key: str, variable: str) -> str:
    """Refused here, so that no library puts it into the message of an encoding error."""
    if key.isascii() and key.isprintable() and " " not in key:
        return key
    raise InputError("holds characters that no key has", where=variable, hint="copy the key again")


def blot(text: str, key: str) -> str:
    """The text without the key, should a server have repeated it."""
    if key == NO_KEY or len(key) < _SHORTEST_SECRET:
        return text
    return text.replace(key, _BLOT)

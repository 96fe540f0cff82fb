"""What every prompt is made of: short files, lists of vocabulary, and text kept apart as data."""

import hashlib
from collections.abc import Iterable, Mapping
from enum import StrEnum
from importlib.resources import files
from string import Template


def data_rule() -> str:
    """The rule that what :func:`as_data` shows is data, whatever it says."""
    return prompt_file(__package__, "data").template


def prompt_file(package: str, name: str) -> Template:
    """The file ``prompts/NAME.md`` of a package."""
    text = files(package).joinpath(f"prompts/{name}.md").read_text(encoding="utf-8")
    return Template(text)


def version_of(prompts: Mapping[str, str]) -> str:
    """Changes whenever a prompt or the vocabulary in it does."""
    joined = "\0".join(f"{name}\0{text}" for name, text in sorted(prompts.items()))
    return hashlib.sha256(joined.encode()).hexdigest()[:12]


def listed(members: Iterable[StrEnum]) -> str:
    """Vocabulary as a prompt shows it."""
    return ", ".join(f"`{member}`" for member in members)


def as_data(description: str) -> str:
    """The description between marker lines that it cannot contain itself."""
    marker = hashlib.sha256(description.encode("utf-8", "replace")).hexdigest()[:16]
    return f"<<<description {marker}\n{description}\n{marker} end of description>>>"

"""What the page on measures says of each: its module's own words, and a drawing."""

from __future__ import annotations

from importlib import import_module
from inspect import getdoc

from figures import SKETCHES

from scegen.measures import MEASURES, Measure

HERE = "<!-- the measures -->"


def sections() -> str:
    """A section for each module that defines measures.

    Raises:
        KeyError: a measure has no drawing; add one to ``SKETCHES``.
    """
    modules: dict[str, list[Measure]] = {}
    for measure in MEASURES:
        modules.setdefault(measure.defined_by, []).append(measure)
    return "\n\n".join(_section(name, defined) for name, defined in modules.items())


def _section(module: str, defined: list[Measure]) -> str:
    title, _, rest = (getdoc(import_module(f"scegen.measures.{module}")) or "").partition("\n")
    title = title.rstrip(".").replace("Two-dimensional time", "Time")
    names = ", ".join(f"`{measure.name}` ({measure.unit})" for measure in defined)
    if module not in SKETCHES:
        raise KeyError(f"no drawing of {module}")
    parts = [
        f"## {title.partition(':')[0]}",
        f"![{title}](../pictures/measure-{module}.svg)",
        f"In files and commands: {names}. {title}.",
    ]
    parts += [_paragraph(text) for text in _paragraphs(rest)]
    return "\n\n".join(parts)


def _paragraphs(text: str) -> list[str]:
    """The labelled parts of a docstring, each with the lines that belong to it."""
    parts: list[str] = []
    for line in text.strip().splitlines():
        head = line.partition(":")[0]
        if ":" in line and head[:1].isupper() and len(head.split()) <= 2:
            parts.append(line)
        elif parts:
            parts[-1] += "\n" + line
    return parts


def _paragraph(text: str) -> str:
    label, _, rest = text.partition(":")
    text = f"**{label}**:{rest}".replace("``", "`")
    return text.replace("\n*", "\n\n*").replace("\n  ", "\n    ")

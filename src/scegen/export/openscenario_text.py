"""Elements as the text of an OpenSCENARIO file, and free text on its way into one."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET  # builds, never parses
from collections.abc import Sequence

LONGEST_TEXT = 2000
"""Characters kept of a description; players print it, and the whole lies in the other files."""

_ILLEGAL = re.compile(r"[^\t\n\r\x20-\uD7FF\uE000-\uFFFD\U00010000-\U0010FFFF]")
_SPECIAL = re.compile(r"[&<>\"\r\n\t]")
_NAMES = {"&": "amp", "<": "lt", ">": "gt", '"': "quot", "\r": "#13", "\n": "#10", "\t": "#09"}
_ESCAPES = {ord(character): f"&{name};" for character, name in _NAMES.items()}
_SPACES = re.compile(r"\s+")


def legal(text: str) -> str:
    """``text`` without the characters that XML forbids."""
    return _ILLEGAL.sub("", text)


def xml_text(text: str, longest: int = LONGEST_TEXT) -> str:
    """``text`` on one line, without the characters that XML forbids, cut to ``longest``."""
    line = _SPACES.sub(" ", legal(text[: 4 * longest])).strip()
    return line if len(line) <= longest else line[: longest - 1].rstrip() + "…"


def header_description(name: str) -> str:
    """The text of the file header.

    It starts with a fixed word because the start of this text has side effects:
    scenario_runner mirrors the scenario if it reads ``CARLA:``, and ``$`` names a parameter.
    What somebody said lies in the other files: players must not depend on it.
    """
    return f"Scenario {name}"


class Lines(ET.Element):
    """An element whose children are lines of text already."""

    def __init__(self, tag: str, lines: Sequence[str]) -> None:
        super().__init__(tag)
        self.lines = lines


def indented(root: ET.Element) -> str:
    """An element and all in it, a line each, as ``ET.indent`` and ``ET.tostring`` write them.

    Those take twice as long, most of it for what OpenSCENARIO has not: all that it says lies in
    attributes.
    """
    lines: list[str] = []

    def write(element: ET.Element, pad: str) -> None:
        told = "".join(
            f' {name}="{value.translate(_ESCAPES) if _SPECIAL.search(value) else value}"'
            for name, value in element.items()
        )
        inside = element.lines if isinstance(element, Lines) else ()
        if len(element) == 0 and not inside:
            lines.append(f"{pad}<{element.tag}{told} />")
            return
        lines.append(f"{pad}<{element.tag}{told}>")
        lines.extend([f"{pad}  {line}" for line in inside])
        for child in element:
            write(child, f"{pad}  ")
        lines.append(f"{pad}</{element.tag}>")

    write(root, "")
    return "\n".join(lines)

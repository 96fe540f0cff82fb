"""Free text on its way into an OpenSCENARIO file."""

import re

LONGEST_TEXT = 2000
"""Characters kept of a description; players print it, and the whole lies in the other files."""

_ILLEGAL = re.compile(r"[^\t\n\r\x20-\uD7FF\uE000-\uFFFD\U00010000-\U0010FFFF]")
_SPACES = re.compile(r"\s+")


def legal(text: str) -> str:
    """``text`` without the characters that XML forbids."""
    return _ILLEGAL.sub("", text)


def xml_text(text: str) -> str:
    """``text`` on one line, without the characters that XML forbids, cut to the longest."""
    line = _SPACES.sub(" ", legal(text[: 4 * LONGEST_TEXT])).strip()
    return line if len(line) <= LONGEST_TEXT else line[: LONGEST_TEXT - 1].rstrip() + "…"


def header_description(name: str) -> str:
    """The text of the file header.

    It starts with a fixed word because the start of this text has side effects:
    scenario_runner mirrors the scenario if it reads ``CARLA:``, and ``$`` names a parameter.
    What somebody said lies in the other files: players must not depend on it.
    """
    return f"Scenario {name}"

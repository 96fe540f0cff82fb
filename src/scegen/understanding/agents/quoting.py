"""Quotes: words that a model says the text has, looked up in the text."""

from __future__ import annotations

import re
from typing import NamedTuple

_AROUND = " \t\r\n\"'“”‘’«».,;:…"


class Quote(NamedTuple):
    """Words as they stand in the description."""

    text: str
    start: int
    end: int


def find_quote(description: str, words: str | None) -> Quote | None:
    """Where the description has these words; None if it has not.

    Case, white space and punctuation around the words may differ, the words may not; they
    must be whole.
    """
    parts = (words or "").strip(_AROUND).split()
    if not parts or not any(c.isalnum() for part in parts for c in part):
        return None
    pattern = r"(?<!\w)" + r"\s+".join(re.escape(part) for part in parts) + r"(?!\w)"
    found = re.search(pattern, description, re.IGNORECASE)
    return Quote(found.group(), found.start(), found.end()) if found else None

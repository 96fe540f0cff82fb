"""Quotes: words that a model says the text has, looked up in the text."""

import re

from scegen.understanding.agents.stated import Words

_AROUND = " \t\r\n\"'“”‘’«».,;:…"


def find_quote(description: str, words: str | None) -> Words | None:
    """Where the description has these words; None if it has not.

    Case, white space and punctuation around the words may differ, the words may not; they
    must be whole.
    """
    parts = (words or "").strip(_AROUND).split()
    if not parts or not any(c.isalnum() for part in parts for c in part):
        return None
    pattern = r"(?<!\w)" + r"\s+".join(re.escape(part) for part in parts) + r"(?!\w)"
    found = re.search(pattern, description, re.IGNORECASE)
    return Words(found.group(), found.start(), found.end()) if found else None

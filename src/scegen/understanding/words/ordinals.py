"""Words for a place in a row: "the first", "the latter"."""

from __future__ import annotations

POSITIONS = {"first": 0, "second": 1, "third": 2, "fourth": 3, "fifth": 4, "sixth": 5,
             "seventh": 6, "eighth": 7, "former": 0, "latter": -1, "last": -1}  # fmt: skip
"""Place within those spoken of last; "the former" and "the latter" are of two."""

"""Places named again: "the left lane … in that lane"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Place
from scegen.understanding.tokens import Token

_POINTING = frozenset({"that", "this", "said"})


def repeat(chunks: list[Chunk], tokens: list[Token]) -> None:
    """Gives "that lane" the directions of the lane named last.

    Args:
        chunks: the chunks of the text.
        tokens: its tokens.
    """
    last: Place | None = None
    for chunk in chunks:
        if not isinstance(chunk, Place) or chunk.kind != "lane":
            continue
        points = chunk.mods and tokens[chunk.mods[0].i].low in _POINTING
        if points and last is not None and not chunk.dirs:
            chunk.mods = [*chunk.mods, *(m for m in last.mods if m.cat == "dir")]
        elif chunk.dirs:
            last = chunk

"""Headings: "Car-to-car rear braking: the test vehicle follows …" names nobody new."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Word

_FIRST_WORDS = frozenset({"det", "num", "quant", "possessive"})


def silence(chunks: list[Chunk]) -> None:
    """Marks the participants of a heading as nobody, if the sentence after it names its own.

    A heading has no verb of its own, and its nouns stand without article or number.

    Args:
        chunks: the chunks of the text; mentions in a heading are marked as ``negated``.
    """
    colon = next((k for k, c in enumerate(chunks) if isinstance(c, Word) and c.value == ":"), None)
    if colon is None:
        return
    title, rest = chunks[:colon], chunks[colon + 1 :]
    mentions = [c for c in title if isinstance(c, Mention)]
    spoken = any(_finite(c) for c in title) or any(
        isinstance(c, Word) and c.cat in {"aux", "copy"} for c in title
    )
    bare = all(m.pronoun is None and not _introduced(m) for m in mentions)
    named = any(isinstance(c, Mention) and c.pronoun is None for c in rest)
    if not spoken and bare and named and any(isinstance(c, Event) for c in rest):
        for mention in mentions:
            mention.negated = True


def _finite(chunk: Chunk) -> bool:
    return isinstance(chunk, Event) and not chunk.nominal and chunk.form == "s"


def _introduced(mention: Mention) -> bool:
    return any(m.cat in _FIRST_WORDS for m in mention.mods) or bool(mention.label)

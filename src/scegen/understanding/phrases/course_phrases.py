"""Ways that a noun says: "on its way straight ahead", "during the ego's straight passage"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import cat_at, chunk_at, ends
from scegen.understanding.words.nominal import WAYS
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_HOLDING = frozenset({"match", "follow", "use", "move", "light", "unknown", "try"})
_BETWEEN = frozenset({"manner", "noted", "inert", "unknown"})


def courses_said(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> list[Event]:
    """A verb of motion for each noun that says which way somebody goes.

    Args:
        chunks: the chunks of the text.
        events: its events; directions that belong to such a noun are taken from them.
        tokens: the tokens of the text.
    """
    found = []
    for k, chunk in enumerate(chunks):
        if not isinstance(chunk, NounPhrase) or isinstance(chunk, Mention):
            continue
        if tokens[chunk.j - 1].base not in word_list("courses"):
            continue
        way = _way(chunk, k, chunks)
        who = _whose(chunk, k, chunks, events, tokens) if way is not None else []
        if way is None or not who:
            continue
        for event in events:
            event.mods = [m for m in event.mods if m is not way]
        going = Event("move", chunk.i, max(chunk.j, way.j), "ing", mods=[way], subject=who)
        going.sentence = sentence_at(chunk.i, events)
        found.append(going)
    return found


def sentence_at(i: int, events: list[Event]) -> int:
    """The number of the sentence that holds a token, by the events before it."""
    return max((e.sentence for e in events if e.i < i), default=0)


def _way(noun: NounPhrase, k: int, chunks: list[Chunk]) -> Term | None:
    m = k + 1
    while cat_at(chunks, m) in _BETWEEN:
        m += 1
    word = chunk_at(chunks, m)
    after = [word.term] if isinstance(word, Word) and word.cat == "dir" else []
    return next((w for w in [*noun.ways, *after] if w.value in WAYS), None)


def _whose(
    noun: NounPhrase, k: int, chunks: list[Chunk], events: list[Event], tokens: list[Token]
) -> list[Mention]:
    verb = next((e for e in events if e.object is noun), None)
    if verb is not None and noun.owner is not None and verb.name not in _HOLDING:
        return [noun.owner]  # "blocks the ego's way straight on"
    if verb is not None:
        return verb.subject if verb.name in _HOLDING and not verb.passive else []
    prep = chunk_at(chunks, k - 1)
    prep = chunk_at(chunks, k - 2) if isinstance(prep, Mention) else prep
    if not isinstance(prep, Word) or tokens[prep.i].low not in word_list("along"):
        return []
    for chunk in reversed(chunks[:k]):
        if ends(chunk):
            break
        if isinstance(chunk, Mention) and (chunk.heads or chunk.pronoun) and not chunk.possessor:
            return [chunk]
    return [c for c in chunks[k + 1 :] if isinstance(c, Mention)][:1]

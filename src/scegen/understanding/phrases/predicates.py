"""Directions and nouns that stand for a verb: "Ego straight, adversary left turn."."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Word
from scegen.understanding.phrases.course_phrases import courses_said, sentence_at
from scegen.understanding.phrases.lookahead import BOUNDARIES, cat_at, chunk_at, ends, value_at
from scegen.understanding.phrases.titles import entitle
from scegen.understanding.words.nominal import WAYS
from scegen.understanding.words.tokens import Token

_OPENERS = frozenset({",", "and", "but", "while", "when", "(", ":"})
_ENDS = frozenset({",", "and", "but", "while", "when", "(", ")", "before", "or"})
_AT = frozenset({"in", "from", "into"})
_ITS_OWN = frozenset({"move", "turn", "u_turn", "sharp_turn", "light", "cross", "leave", "use",
                      "lane_change", "merge", "swerve", "try", "pull_out"})  # fmt: skip
"""Verbs that a direction after a comma belongs to."""


def complete(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> list[Event]:
    """The events, with one for each direction that is all that is said of what somebody does.

    Args:
        chunks: the chunks of the text.
        events: its events, left-out verbs filled in; nouns of doings get their subject.
        tokens: the tokens of the text.
    """
    entitle(chunks, events, tokens)
    found = [*events, *courses_said(chunks, events, tokens)]
    for k, chunk in enumerate(chunks):
        if isinstance(chunk, Event) and chunk.nominal and not chunk.subject:
            chunk.subject = _whose(chunks, k, found)
        elif isinstance(chunk, Word) and _predicative(chunks, k) and not _has_verb(chunk, found):
            subject = _whose(chunks, k, found)
            if subject:
                going = Event("move", chunk.i, chunk.j, "s", finite=True, mods=[chunk.term])
                going.subject, going.sentence = subject, sentence_at(chunk.i, found)
                found.append(going)
    return sorted(found, key=lambda e: (e.sentence, e.i)) if len(found) > len(events) else found


def _predicative(chunks: list[Chunk], k: int) -> bool:
    """A bare direction at the end of its clause, or right before a phrase of place."""
    if chunks[k].cat != "dir" or chunks[k].value not in WAYS:
        return False
    return k + 1 == len(chunks) or value_at(chunks, k + 1) in _ENDS | BOUNDARIES | _AT


def _has_verb(word: Word, events: list[Event]) -> bool:
    """Whether the direction already says which way some verb leads."""
    return any(word.term in e.mods and e.name in _ITS_OWN for e in events)


def _whose(chunks: list[Chunk], k: int, events: list[Event]) -> list[Mention]:
    """Who does it: the noun right before, or after a comma the one that the clause is about."""
    m = k - 1
    while cat_at(chunks, m) == "manner":
        m -= 1
    before = chunk_at(chunks, m)
    acting = {id(who) for e in events for who in e.subject if e.i < chunks[k].i}
    if isinstance(before, Mention):
        free = id(before) not in acting and _opens(chunks, m) and before.prep is None
        return [before] if free and not before.negated else []
    if value_at(chunks, m) != ",":
        return []
    for n in range(m - 1, -1, -1):
        chunk = chunks[n]
        if ends(chunk):
            break
        if isinstance(chunk, Event) and chunk.subject and not chunk.nominal:
            return chunk.subject
        if isinstance(chunk, Mention) and chunk.prep is None and _opens(chunks, n):
            return [] if chunk.negated else [chunk]
    return []


def _opens(chunks: list[Chunk], m: int) -> bool:
    """Whether a noun begins its clause."""
    return m == 0 or chunks[m - 1].value in _OPENERS | BOUNDARIES

"""Late braking said without a verb of braking: "is late on the brakes", "slow to brake"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Thing, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import BOUNDARIES
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_LATE = frozenset({"late", "slow"})
_ANSWERS = frozenset({"brake", "react", "slow", "stop"})
_REACH = 5


def late_braking(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> list[Event]:
    """The events with one for each braking that only its noun names, if it comes late.

    Args:
        chunks: the chunks of the text.
        events: its events; those that are only "slow to" do something become late.
        tokens: its tokens.
    """
    found = list(events)
    for k, chunk in enumerate(chunks):
        if isinstance(chunk, Event) and chunk.name in _ANSWERS:
            _slow_to(chunk, k, chunks)
        if not isinstance(chunk, Thing) or tokens[chunk.j - 1].low not in word_list("brakes"):
            continue
        late = _late_near(k, chunks)
        who = _subject_before(k, chunks)
        if late is not None and who is not None:
            event = Event("brake", late.i, late.j, "s", finite=True, mods=[late.term])
            event.subject = [who]
            event.sentence = max((e.sentence for e in events if e.i < late.i), default=0)
            who.mods = [m for m in who.mods if m is not late.term]
            found.append(event)
    return sorted(found, key=lambda e: (e.sentence, e.i)) if len(found) > len(events) else found


def _slow_to(event: Event, k: int, chunks: list[Chunk]) -> None:
    """``is slow to brake``, ``was late in braking``."""
    if k < 2:
        return
    how, word = chunks[k - 2 : k]
    linked = isinstance(word, Word) and word.value in {"to", "in"}
    if not linked or not isinstance(how, Word) or how.cat != "manner" or how.value not in _LATE:
        return
    who = _subject_before(k - 2, chunks)
    if who is not None:
        event.subject = [who]
        who.mods = [m for m in who.mods if m is not how.term]
    event.mods = [m for m in event.mods if m is not how.term]
    event.mods = [*event.mods, how.term if how.value == "late" else _as_late(how)]


def _as_late(word: Word) -> Term:
    return Term("manner", "late", word.i, word.j)


def _late_near(k: int, chunks: list[Chunk]) -> Word | None:
    for step in (1, -1):
        for m in range(k + step, k + step * _REACH, step):
            chunk = chunks[m] if 0 <= m < len(chunks) else None
            if chunk is None or isinstance(chunk, Mention) or getattr(chunk, "cat", "") == "punct":
                break
            if isinstance(chunk, Word) and (chunk.cat, chunk.value) == ("manner", "late"):
                return chunk
    return None


def _subject_before(k: int, chunks: list[Chunk]) -> Mention | None:
    """The noun that the clause before chunk ``k`` is about; of a relative clause, its noun."""
    relative = False
    for m in range(k - 1, -1, -1):
        chunk = chunks[m]
        if isinstance(chunk, Word) and chunk.value in BOUNDARIES:
            return None
        head = chunk.head if isinstance(chunk, NounPhrase) else None
        relative = relative or (head is not None and head.value == "wh")
        if isinstance(chunk, Mention) and (relative or chunk.prep is None):
            return chunk
    return None

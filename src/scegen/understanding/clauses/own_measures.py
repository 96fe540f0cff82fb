"""Speeds that stand by a noun of their own: "the ego's 60 km/h", "a van, also at 50 km/h"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import chunk_at, is_word, value_at
from scegen.understanding.words.tokens import Token

_LINKS = frozenset({"of", "be", "speed", "mild", ":"})
_FARTHEST = 6
_SMALL = frozenset({"prep", "manner"})
_FROM_REST = frozenset({"pull_out", "unpark", "reverse", "door", "leave"})


def own_measures(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """Gives a speed to the noun that it is said of, from a verb or noun that it follows."""
    holders: list[Event | Mention] = [*events, *(c for c in chunks if isinstance(c, Mention))]
    for k, chunk in enumerate(chunks):
        if not isinstance(chunk, Word) or (chunk.cat, chunk.value) != ("quantity", "speed"):
            continue
        owner = _of_all(chunks, k) or _possessor(chunks, k, tokens) or _bracketed(chunks, k)
        told_by = [e for e in events if any(m is chunk.term for m in e.mods)]
        owner = owner or _awaited(chunks, k, told_by) or _from_a_side(chunks, k)
        owner = owner or _fronted(chunks, k) or _told_of(chunks, k, tokens)
        if owner is None:
            continue
        for holder in holders:
            holder.mods[:] = [m for m in holder.mods if m is not chunk.term]
        owner.mods.append(chunk.term)


def _of_all(chunks: list[Chunk], k: int) -> Mention | None:
    """``…, both at a steady 60 km/h, …``: of all of them."""
    m = k - 1
    while m > 0 and (isinstance(chunks[m], Thing) or getattr(chunks[m], "cat", "") in _SMALL):
        m -= 1
    who = chunk_at(chunks, m)
    everybody = isinstance(who, Mention) and who.pronoun in {"both", "all"}
    opened = everybody and value_at(chunks, m - 1) == ","
    return who if isinstance(who, Mention) and opened else None


def _possessor(chunks: list[Chunk], k: int, tokens: list[Token]) -> Mention | None:
    """``the ego's speed of 100 km/h``, ``speed of the ego: 100 km/h``, ``ego speed 100 km/h``."""
    for m in range(k - 1, max(-1, k - _FARTHEST), -1):
        chunk, before = chunks[m], chunk_at(chunks, m - 1)
        if isinstance(chunk, Thing) and chunk.owner is not None:
            return chunk.owner
        if _rates(chunk, tokens) and isinstance(before, Mention) and before.prep is None:
            return before
        if is_word(chunk, "genitive"):
            return before if isinstance(before, Mention) and before.possessor else None
        if isinstance(chunk, Mention):
            return chunk if m > 1 and _of_a_rate(chunks[m - 2 : m], tokens) else None
        about = tokens[chunk.i].low in word_list("measuring")
        if not isinstance(chunk, Thing) and getattr(chunk, "value", "") not in _LINKS and not about:
            return None
    return None


def _of_a_rate(chunks: list[Chunk], tokens: list[Token]) -> bool:
    rate, of = chunks
    return _rates(rate, tokens) and is_word(of, "of")


def _rates(chunk: Chunk, tokens: list[Token]) -> bool:
    return isinstance(chunk, Thing) and tokens[chunk.j - 1].low in word_list("rates")


def _bracketed(chunks: list[Chunk], k: int) -> Mention | None:
    """``a bus (length 12 m, speed 45 km/h)``: the noun that the brackets follow.

    In "the van ahead of the ego (70 km/h) brakes" they follow all that is said of the van.
    """
    after = next((c for c in chunks[k + 1 :] if getattr(c, "value", "") != ")"), None)
    for m in range(k - 1, max(0, k - _FARTHEST), -1):
        if isinstance(chunks[m], Mention | Event) or getattr(chunks[m], "value", "") == ")":
            return None
        if getattr(chunks[m], "value", "") == "(":
            where = chunks[m - 1]
            adverb = isinstance(where, Word) and where.cat == "locus" and m > 1
            before = chunks[m - 2] if adverb else where  # "a truck ahead (80 km/h)"
            if not isinstance(before, Mention) or before.possessor:
                return None
            return before if before.prep is None or not isinstance(after, Event) else None
    return None


def _from_a_side(chunks: list[Chunk], k: int) -> Mention | None:
    """``lets a car from the left at 50 km/h pass``: the car's."""
    who, off, side, at = (chunk_at(chunks, k - n) for n in (4, 3, 2, 1))
    placed = isinstance(side, Place) and side.kind in {"side", "direction"}
    if not (placed and is_word(off, "from") and isinstance(at, Word) and at.cat == "prep"):
        return None
    if not isinstance(who, Mention) or who.possessor or who.pronoun is not None:
        return None  # "rides across it from the left at 15 km/h"
    if who.stands_after("of"):
        return None  # "crosses the path of the ego from the left at 15 km/h"
    return who if any(p.target is side for p in who.pps) else None


def _fronted(chunks: list[Chunk], k: int) -> Mention | None:
    """``At about 100 km/h, the ego is overtaken by a van``: of whom the sentence is about."""
    ends = [m for m in range(k) if getattr(chunks[m], "value", "") in {".", ";"}]
    opening = chunks[ends[-1] + 1 if ends else 0 : k]
    at = opening[0] if opening and all(isinstance(c, Word) for c in opening) else None
    who = next((c for c in chunks[k + 1 : k + 3] if not is_word(c, ",")), None)
    led = isinstance(at, Word) and at.cat == "prep"
    return who if led and isinstance(who, Mention) and not who.possessor else None


def _told_of(chunks: list[Chunk], k: int, tokens: list[Token]) -> Mention | None:
    """``50 km/h is the speed of the ego``."""
    is_, who = chunk_at(chunks, k + 1), chunk_at(chunks, k + 4)
    if not isinstance(who, Mention) or not _of_a_rate(chunks[k + 2 : k + 4], tokens):
        return None
    return who if isinstance(is_, Word) and is_.cat == "aux" else None


def _awaited(chunks: list[Chunk], k: int, holders: list[Event]) -> Mention | None:
    """``waits for (lets) a van at 50 km/h``, ``backs out in front of a van at 50 km/h``: the van's.

    Who waits has no speed, and who sets off has none yet.
    """
    who, at = (chunk_at(chunks, m) for m in (k - 2, k - 1))
    said = isinstance(at, Word) and at.cat == "prep"
    if not said or not isinstance(who, Mention) or who.possessor:
        return None
    waits = who.prep is not None and any(e.name in {"wait", "yield"} for e in holders)
    starts = [p for e in holders if e.name in _FROM_REST for p in e.pps]
    front = any(p.value == "ahead" and p.target is who for p in starts)
    let = any(e.object is who and e.lemma == "let" for e in holders)
    return who if waits or front or let else None

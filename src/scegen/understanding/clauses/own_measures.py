"""Speeds that stand by a noun of their own: "the ego's 60 km/h", "a van, also at 50 km/h"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.tokens import Token

_LINKS = frozenset({"of", "be", "speed", "mild", ":"})
_FARTHEST = 6
_FROM_REST = frozenset({"pull_out", "unpark", "reverse", "door", "leave"})


def own_measures(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """Gives a speed to the noun that it is said of, from a verb or noun that it follows.

    Args:
        chunks: the chunks of the text, clauses read.
        events: its events.
        tokens: its tokens.
    """
    holders: list[Event | Mention] = [*events, *(c for c in chunks if isinstance(c, Mention))]
    for k, chunk in enumerate(chunks):
        if not isinstance(chunk, Word) or (chunk.cat, chunk.value) != ("quantity", "speed"):
            continue
        owner = _possessor(chunks, k) or _likewise(chunks, k, tokens) or _bracketed(chunks, k)
        told_by = [e for e in events if any(m is chunk.term for m in e.mods)]
        owner = owner or _awaited(chunks, k, told_by) or _from_a_side(chunks, k)
        owner = owner or _fronted(chunks, k)
        if owner is None:
            continue
        for holder in holders:
            holder.mods[:] = [m for m in holder.mods if m is not chunk.term]
        owner.mods.append(chunk.term)


def _possessor(chunks: list[Chunk], k: int) -> Mention | None:
    """``at 80 % of the ego's speed of 100 km/h``: the ego's."""
    for m in range(k - 1, max(0, k - _FARTHEST), -1):
        chunk, before = chunks[m], chunks[m - 1]
        if isinstance(chunk, Thing) and chunk.owner is not None:
            return chunk.owner
        if isinstance(chunk, Word) and chunk.value == "genitive":
            return before if isinstance(before, Mention) and before.possessor else None
        if not isinstance(chunk, Thing) and getattr(chunk, "value", "") not in _LINKS:
            return None
    return None


def _likewise(chunks: list[Chunk], k: int, tokens: list[Token]) -> Mention | None:
    """``meets a van, also at 50 km/h``: the van."""
    words = chunks[max(0, k - 3) : k]
    said = [c for c in words if isinstance(c, Word) and tokens[c.i].low in word_list("likewise")]
    comma = next((m for m in range(k - 1, max(0, k - 4), -1) if _is_comma(chunks[m])), None)
    before = chunks[comma - 1] if comma else None
    return before if said and isinstance(before, Mention) else None


def _bracketed(chunks: list[Chunk], k: int) -> Mention | None:
    """``a bus (length 12 m, speed 45 km/h)``: the noun that the brackets follow."""
    for m in range(k - 1, max(0, k - _FARTHEST), -1):
        if isinstance(chunks[m], Mention | Event) or getattr(chunks[m], "value", "") == ")":
            return None
        if getattr(chunks[m], "value", "") == "(":
            before = chunks[m - 1]
            own = isinstance(before, Mention) and before.prep is None and not before.possessor
            return before if own and isinstance(before, Mention) else None
    return None


def _awaited(chunks: list[Chunk], k: int, holders: list[Event]) -> Mention | None:
    """``waits for a van at 50 km/h``, ``backs out in front of a van at 50 km/h``: the van's.

    Who waits has no speed, and who sets off has none yet.
    """
    who, at = (chunks[m] if m >= 0 else None for m in (k - 2, k - 1))
    said = isinstance(at, Word) and at.cat == "prep"
    if not said or not isinstance(who, Mention) or who.possessor:
        return None
    waits = who.prep is not None and any(e.name in {"wait", "yield"} for e in holders)
    front = any(
        e.name in _FROM_REST and p.value == "ahead" and p.target is who
        for e in holders
        for p in e.pps
    )
    return who if waits or front else None


def _from_a_side(chunks: list[Chunk], k: int) -> Mention | None:
    """``lets a car from the left at 50 km/h pass``: the car's."""
    who, off, side, at = (chunks[k - n] if k >= n else None for n in (4, 3, 2, 1))
    placed = isinstance(side, Place) and side.kind in {"side", "direction"}
    preps = [w.value for w in (off, at) if isinstance(w, Word) and w.cat == "prep"]
    named = placed and len(preps) > 1 and preps[0] == "from" and isinstance(who, Mention)
    if not named or not isinstance(who, Mention) or who.possessor or who.pronoun is not None:
        return None  # "rides across it from the left at 15 km/h"
    return who if any(p.target is side for p in who.pps) else None


def _fronted(chunks: list[Chunk], k: int) -> Mention | None:
    """``At 100 km/h, the ego is overtaken by a van``: of whom the sentence is about."""
    opens = k == 1 or (k > 1 and getattr(chunks[k - 2], "value", "") in {".", ";"})
    at = chunks[k - 1] if k else None
    who = next((c for c in chunks[k + 1 : k + 3] if not _is_comma(c)), None)
    led = opens and isinstance(at, Word) and at.cat == "prep"
    return who if led and isinstance(who, Mention) and not who.possessor else None


def _is_comma(chunk: Chunk) -> bool:
    return isinstance(chunk, Word) and chunk.value == ","

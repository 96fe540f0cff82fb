"""``its left door swings open``, ``a car door opens``: what one who is parked does."""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.chunks import Chunk, Event, Mention, Thing, Word
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_HELPS = frozenset({"aux", "copy", "manner"})
_REACH = 2


def open_doors(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """The chunks with whoever a door belongs to as the one who opens it.

    A door that nobody is said to own is that of the one named before who is parked, or of a parked
    car.

    Args:
        chunks: the chunks of the text.
        tokens: its tokens.
    """
    found: list[Chunk] = []
    k = 0
    while k < len(chunks):
        chunk, owned = chunks[k], _owner_after(chunks, k)
        verb = k + (3 if owned is not None else 1)
        while verb < len(chunks) and getattr(chunks[verb], "cat", "") in _HELPS:
            verb += 1
        door = isinstance(chunk, Thing) and chunk.kind == "door" and verb < len(chunks)
        end = _opens(chunks[verb].i, tokens) if door else None
        if not door or end is None or not isinstance(chunk, Thing):
            found.append(chunk)
            k += 1
            continue
        genitive = any(m.value == "genitive" for m in chunk.mods)
        before = found[-1] if found else None
        if genitive and isinstance(before, Mention):
            before.possessor = False
        else:
            found.append(owned or _who(chunk, found))
        found.append(Event("door", chunks[verb].i, end, "s", lemma="open"))
        k = next((m for m in range(verb, len(chunks)) if chunks[m].i >= end), len(chunks))
    return found


def _owner_after(chunks: list[Chunk], k: int) -> Mention | None:
    """``the door of a parked van``."""
    of, who = [*chunks[k + 1 : k + 3], None, None][:2]
    told = isinstance(of, Word) and of.value == "of"
    return who if told and isinstance(who, Mention) else None


def _opens(i: int, tokens: list[Token]) -> int | None:
    """Where the words end that tell of it: "opens", "swings open", "is flung open"."""
    for j in range(i, min(i + _REACH, len(tokens))):
        if tokens[j].low.startswith("open"):
            return j + 1
    return None


def _who(door: Thing, before: list[Chunk]) -> Mention:
    mentions = [c for c in before if isinstance(c, Mention) and c.head is not None]
    mentions = [m for m in mentions if m.head is not None and m.head.form != "s"]
    parked = [m for m in mentions if any(mod.value == "parked" for mod in m.mods)]
    if parked:
        known = parked[-1]
        return replace(known, i=door.i, j=door.j, pps=[], prep=None, same_as=known, joined=None)
    head = Term("actor", "car", door.i, door.j)
    mods = [Term("det", "indef", door.i, door.i), Term("state", "parked", door.i, door.i)]
    return Mention(door.i, door.j, mods, head, heads=[head])

"""``its left door swings open``, ``a car door opens``: what one who is parked does."""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import cat_at, chunk_at, ends
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_HELPS = frozenset({"aux", "copy", "manner"})
_REACH = 2


def open_doors(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """The chunks with whoever a door belongs to as the one who opens it.

    A door that nobody is said to own is that of the one named before who is parked, or of a parked
    car.
    """
    if not any(map(_door, chunks)):
        return chunks
    found: list[Chunk] = []
    ended: list[Chunk] = []
    k = 0
    while k < len(chunks):
        chunk, owned = chunks[k], _owners_after(chunks, k)
        if ends(chunk):
            found, ended = [*found, *ended], []
        if owned and isinstance(chunk, Event) and _door(chunk) and _called(chunk, found):
            found += owned
            ended = _opened_by(owned[0], chunk)
            k += 1 + len(owned) + bool(owned)
            continue
        object_ = chunk_at(chunks, k + 1)
        verbal = isinstance(chunk, Event) and tokens[chunk.i].low.startswith("open")
        if verbal and isinstance(object_, Thing) and _door(object_):  # "opens its left door"
            mods = list(object_.mods)
            found.append(Event("door", chunk.i, object_.j, "s", lemma="open", mods=mods))
            k += 2
            continue
        verb = k + 1 + len(owned) + bool(owned)
        while cat_at(chunks, verb) in _HELPS:
            verb += 1
        door = isinstance(chunk, Thing) and _door(chunk) and verb < len(chunks)
        end = _opens(chunks[verb].i, tokens) if door else None
        if end is None or not isinstance(chunk, Thing):
            found.append(chunk)
            k += 1
            continue
        before = chunk_at(found, len(found) - 1)
        if isinstance(before, Mention) and chunk.has("possessive", "genitive"):
            before.possessor = False
            found[-1:] = owned or [before]  # "the driver's door of a van"
        else:
            found += owned or [_who(chunk, found)]
        shut = any(t.low in word_list("denying") for t in tokens[chunk.j : end])
        found.append(Event("door", chunks[verb].i, end, "s", lemma="open", negated=shut))
        k = next((m for m in range(verb, len(chunks)) if chunks[m].i >= end), len(chunks))
    return found + ended


def _door(chunk: Chunk) -> bool:
    named = chunk.name if isinstance(chunk, Event) else getattr(chunk, "kind", "")
    return named == "door"


def _owners_after(chunks: list[Chunk], k: int) -> list[Chunk]:
    """``the door of a van parked there``, ``… of the second of five vans``: who, and where."""
    found: list[Chunk] = []
    for of, who in zip(chunks[k + 1 :: 2], chunks[k + 2 :: 2], strict=False):
        if of.value != "of" or not isinstance(who, Mention):
            break
        found += [of, who]
    end = k + 1 + len(found)
    parked = chunk_at(chunks, end) if found else None
    if isinstance(parked, Event) and parked.name == "park":
        found.append(parked)
        end += 1
    if found and cat_at(chunks, end) == "prep" and isinstance(chunk_at(chunks, end + 1), Place):
        found += chunks[end : end + 2]
    return found[1:]


def _called(door: Event, before: list[Chunk]) -> bool:
    """``hits the open door``: a name of the door, nobody's doing."""
    article = any(m.cat in {"det", "possessive"} for m in door.mods)
    return article or cat_at(before, len(before) - 1) == "det"


def _opened_by(owner: Chunk, door: Event) -> list[Chunk]:
    """A clause that says that it opens."""
    if not isinstance(owner, Mention):
        return []
    again = _again(owner, owner.i, owner.j)
    return [Word(Term("punct", ",", door.i, door.i)), again, replace(door, mods=[], form="s")]


def _again(known: Mention, i: int, j: int) -> Mention:
    return replace(known, i=i, j=j, pps=[], same_as=known)


def _opens(i: int, tokens: list[Token]) -> int | None:
    """Where the words end that tell of it: "opens", "swings open", "is flung open"."""
    for j in range(i, min(i + _REACH, len(tokens))):
        if tokens[j].low.startswith("open"):
            return j + 1
    return None


def _stands(after: list[Chunk]) -> bool:
    """``a van is parked``, ``a van stands``: what the verb after somebody says."""
    verb = next((c for c in after if not isinstance(c, Word)), None)
    return isinstance(verb, Event) and verb.name in {"park", "wait", "locate", "stop", "pull_over"}


def _standing(before: list[Chunk]) -> list[Mention]:
    """Who is parked, or stands, of those named; who is parked comes last."""
    standing, parked = list[Mention](), list[Mention]()
    for k, c in enumerate(before):
        if not isinstance(c, Mention) or c.head is None or c.plural or c.is_ego:
            continue
        if any(mod.value == "parked" for mod in c.mods):
            parked.append(c)
        elif _stands(before[k + 1 :]):
            standing.append(c)
    return standing + parked


def _who(door: Thing, before: list[Chunk]) -> Mention:
    standing = _standing(before)
    if standing:
        return _again(standing[-1], door.i, door.j)
    head = Term("actor", "car", door.i, door.j)
    mods = [Term("det", "indef", door.i, door.i), Term("state", "parked", door.i, door.i)]
    return Mention(door.i, door.j, mods, head, heads=[head])

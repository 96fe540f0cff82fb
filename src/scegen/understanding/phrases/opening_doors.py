"""``its left door swings open``, ``a car door opens``: what one who is parked does."""

from dataclasses import replace

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import cat_at, chunk_at, ends, value_at
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_HELPS = frozenset({"aux", "copy", "manner"})
_STANDS = frozenset({"park", "wait", "locate", "stop", "pull_over"})
_REACH = 2


def open_doors(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """The chunks with whoever a door belongs to as the one who opens it.

    A door that nobody is said to own is that of the one named before who is parked, or of a parked
    car.
    """
    found: list[Chunk] = []
    after: list[Chunk] = []
    skip = 0
    for k, chunk in enumerate(chunks):
        if k < skip:
            continue
        what = chunk_at(chunks, k + 1)
        whose = chunk_at(chunks, k + 2) if what.value == "of" else None
        if ends(chunk):
            found, after = [*found, *after], []
        if isinstance(chunk, Event) and isinstance(whose, Mention) and _named(chunk, found):
            comma = Term("punct", ",", chunk.i, chunk.i)  # "hits the open door of a van"
            opened = replace(chunk, mods=[], form="s")
            after = [comma, replace(whose, pps=[], same_as=whose), opened]
            found.append(whose)
            skip = k + 3
            continue
        opens_it = isinstance(chunk, Event) and tokens[chunk.i].low.startswith("open")
        if opens_it and isinstance(what, Thing) and what.kind == "door":  # "opens its left door"
            mods = list(what.mods)
            found.append(Event("door", chunk.i, what.j, "s", lemma="open", mods=mods))
            skip = k + 2
            continue
        door = isinstance(chunk, Thing) and chunk.kind == "door"
        told = _opening(chunks, k, tokens) if door else None
        if told is None or not isinstance(chunk, Thing):
            found.append(chunk)
            continue
        owner, opens = told
        skip = next((m for m in range(k, len(chunks)) if chunks[m].i >= opens.j), len(chunks))
        on = chunks[skip + 1 : skip + 2] if value_at(chunks, skip) == "in" else []
        before = chunk_at(found, len(found) - 1)
        if isinstance(before, Mention) and chunk.has("possessive", "genitive"):
            before.possessor = False
            found[-1:] = owner or [before]  # "the driver's door of a van"
        else:
            found += owner or [_who(chunk, [*found, *on])]  # "a door opens on a parked van"
        found.append(opens)
    return found + after


def _named(door: Event, before: list[Chunk]) -> bool:
    """``hits the open door``: a name of the door, nobody's doing."""
    article = any(m.cat in {"det", "possessive"} for m in door.mods)
    return door.name == "door" and (article or cat_at(before, len(before) - 1) == "det")


def _opening(chunks: list[Chunk], k: int, tokens: list[Token]) -> tuple[list[Chunk], Event] | None:
    """``(door) of a van is flung open``: of whom, and the verb with its words."""
    owner: list[Chunk] = []
    verb = k + 1
    if value_at(chunks, verb) == "of" and isinstance(chunk_at(chunks, k + 2), Mention):
        parked = chunk_at(chunks, k + 3)  # "of a van parked on the right"
        verb = k + 3 + (isinstance(parked, Event) and parked.name == "park")
        where = chunk_at(chunks, verb + 1)
        verb += 2 * (cat_at(chunks, verb) == "prep" and isinstance(where, Place))
        owner = chunks[k + 2 : verb]
    while cat_at(chunks, verb) in _HELPS:
        verb += 1
    i = chunks[verb].i if verb < len(chunks) else len(tokens)
    near = enumerate(tokens[i : i + _REACH], i + 1)
    end = next((j for j, token in near if token.low.startswith("open")), None)
    if end is None:
        return None
    shut = any(t.low in word_list("denying") for t in tokens[chunks[k].j : end])
    return owner, Event("door", i, end, "s", lemma="open", negated=shut)


def _who(door: Thing, before: list[Chunk]) -> Mention:
    """Who is parked, or stands, of those named; else a parked car."""
    for k, who in reversed(list(enumerate(before))):
        if isinstance(who, Mention) and who.head is not None and not (who.plural or who.is_ego):
            verb = next((c for c in before[k + 1 :] if not isinstance(c, Term)), None)
            stands = isinstance(verb, Event) and verb.name in _STANDS
            if stands or any(mod.value == "parked" for mod in who.mods):
                return replace(who, i=door.i, j=door.j, pps=[], same_as=who)
    head = Term("actor", "car", door.i, door.j)
    mods = [Term("det", "indef", door.i, door.i), Term("state", "parked", door.i, door.i)]
    return Mention(door.i, door.j, mods, head, heads=[head])

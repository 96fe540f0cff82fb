"""``V1 (ego, a truck)``, ``the vehicle … the vehicle under test``: one and the same."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise, takewhile

from scegen.understanding.chunks import Chunk, Event, Mention, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import chunk_at, ends, value_at
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token, low_at

_HELPS = frozenset({"aux", "manner"})
_JOINTS = frozenset({"punct", "sub", "conj"})
_FROM = frozenset({"from", "in"})
_ENDS = frozenset({":", ",", "."})
_LOOKING = 5
"""Within so many words before a vehicle it is said that one looks from there."""


def in_brackets(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks with each of two further names of somebody in brackets of its own."""
    found: list[Chunk] = []
    for k, chunk in enumerate(chunks):
        marks = [value_at(chunks, m) for m in (k - 2, k, k + 2)]
        first, second = chunk_at(chunks, k - 1), chunk_at(chunks, k + 1)
        named = marks == ["(", ",", ")"] and isinstance(chunk_at(chunks, k - 3), Mention)
        if named and _says_who(first) and _says_who(second):
            found += [Word(Term("punct", mark, chunk.i, chunk.i)) for mark in ")("]
        else:
            found.append(chunk)
    return found


def under_test(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``the vehicle follows a van …; the vehicle under test stops``: the vehicle is that one.

    Whom a text begins with by a mere noun is nobody new, if the ego is called by that noun later.
    """
    named = [c for c in chunks if isinstance(c, Mention) and c.heads]
    first = named[0] if named else None
    if first is None or first.head is None or first.is_ego:
        return chunks
    after = chunks[chunks.index(first) + 1 :]
    verb = next((c for c in after if c.cat not in _HELPS), None)
    mere = [(m.cat, m.value) for m in first.mods] == [("det", "def")]
    clause = takewhile(lambda c: c.cat not in _JOINTS, after)  # "the vehicle leading the ego"
    meets = any(isinstance(c, Mention) and c.is_ego for c in clause)
    if mere and isinstance(verb, Event) and not meets:  # "the vehicle ahead" is another one
        noun = tokens[first.head.i].low
        egos = [a for a in named[1:] if a.is_ego and noun in {t.low for t in tokens[a.i : a.j]}]
        first.heads = [*(egos[0].heads if egos else []), *first.heads]
    return chunks


def filmed_from(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``View from inside a van: …``, ``dashcam in a lorry, …``: that one is the ego."""
    named = [k for k, c in enumerate(chunks) if isinstance(c, Mention) and c.heads]
    who = chunks[named[0]] if named else None
    if not isinstance(who, Mention) or not 0 < who.i <= _LOOKING:
        return chunks
    around = value_at(chunks, named[0] - 1), value_at(chunks, named[0] + 1)
    looks = {t.base for t in tokens[: who.i]} & word_list("filming")
    of = low_at(tokens, who.i - 2) in word_list("views_of")  # "camera of a van: …"
    egos = [h for c in chunks if isinstance(c, Mention) and c.is_ego for h in c.heads]
    another = any(h.data.get("ego") and not {"me", "speaks"} & {*h.data} for h in egos)
    plain = not (who.dirs or who.is_person) and not any(m.cat == "state" for m in who.mods)
    if looks and plain and not another and (of or around[0] in _FROM) and around[1] in _ENDS:
        data = {"ego": True, "speaks": True}
        who.heads = [Term("actor", "ego", who.i, who.i, data=data), *who.heads]
    return chunks


def counted_in(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``four cars including mine``, ``mine included``: three others and the ego."""
    named = [k for k, c in enumerate(chunks) if isinstance(c, Mention)]
    left_out: set[int] = set()
    for k, m in pairwise(named):
        group, who = chunks[k], chunks[m]
        if not (isinstance(group, Mention) and isinstance(who, Mention)):
            continue
        number = group.mod("num")
        if number is None or any(map(ends, chunks[k:m])):
            continue
        own = who.is_ego or who.is_me or who.opened_by("first_person")
        around = [tokens[who.i - 1].low, low_at(tokens, who.j)]
        among = [word in word_list("including") for word in around]
        if own and any(among) and number.data["number"] > 1:
            rest = replace(number, data={"number": number.data["number"] - 1})
            group.mods = [rest if t is number else t for t in group.mods]
            who.heads = [*group.heads, *who.heads]  # "four trucks including ours"
            chunks[m - 1] = Word(Term("conj", "and", who.i, who.i))
            left_out |= {n for n in range(k + 1, m - 1) if chunks[n].value == ","}
            left_out |= {m + 1, m + 2} if among[1] else set()
    return [c for k, c in enumerate(chunks) if k not in left_out]


def _says_who(chunk: Chunk | None) -> bool:
    """The ego, or a kind ("a truck", "passenger car")."""
    if not isinstance(chunk, Mention):
        return False
    kind = not chunk.label and all(m.value == "indef" for m in chunk.mods if m.cat == "det")
    return kind or chunk.is_ego

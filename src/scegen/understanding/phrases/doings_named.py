"""``Braking of the lead car``, ``Overtaking of a cyclist by the ego``: clauses without a verb.

The noun of a doing with "of" and "by" behind it says what its verb would say between the two.
"""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing, Word
from scegen.understanding.phrases.lookahead import BOUNDARIES, finite_follows
from scegen.understanding.words.terms import Term

_DONE_TO = frozenset({"overtake", "pass", "bypass", "follow", "encounter"})
"""Doings of which "of" names whom they are done to."""
_MADE = frozenset({"turn", "u_turn", "reverse"})
"""Doings that a title names before who does them."""
_JOINTS = frozenset({",", "and", "then"})


def spell_out_doings(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks with who does what a noun names before it, and whom it is done to behind it.

    Args:
        chunks: of the text.
    """
    found: list[Chunk] = []
    k = 0
    while k < len(chunks):
        event = chunks[k]
        told = _told(event, k, chunks) if isinstance(event, Event) else None
        if told is None:
            found.append(event)
            k += 1
        else:
            clause, k = told
            found += clause
    return found


def _told(event: Event, k: int, chunks: list[Chunk]) -> tuple[list[Chunk], int] | None:
    before = getattr(chunks[k - 1], "value", "") if k else "."
    opens = before in BOUNDARIES or (before in _JOINTS and (event.nominal or event.form == "ing"))
    if not opens or event.form not in {"base", "ing"}:
        return None
    m = k + 1 + isinstance(chunks[k + 1 : k + 2][:1] and chunks[k + 1], Thing)  # "manoeuvre"
    comma, next_one = (*chunks[k + 1 : k + 3], None, None)[:2]
    if event.name in _MADE and getattr(comma, "value", "") == "," and isinstance(next_one, Mention):
        if any(isinstance(c, Event) for c in _sentence(chunks, k + 3)):
            return None
        return [next_one, replace(event, form="s", nominal=False)], k + 3  # "Left turn, ego …"
    named: dict[str, list[Chunk]] = {}
    while (group := _group(m, chunks)) and group[0] not in named:
        named[group[0]] = group[1]
        m = group[2]
    if not named or finite_follows(chunks, m - 1) or _is_heading(m, chunks):
        return None
    whole = named.get("of", [])
    done_to = "by" in named or event.name in _DONE_TO or not isinstance(whole[:1][0], Mention)
    who = named.get("by", []) if done_to else whole
    if not who and event.name not in _DONE_TO:
        return None  # "reversing out of a drive, …"
    if not who:
        term = Term("actor", "ego", event.i, event.i, data={"ego": True, "speaks": True})
        who = [Mention(event.i, event.i, [], term, heads=[term])]
    verb = replace(event, form="s", nominal=False)
    return [*who, verb, *(whole if done_to else [])], m


def _is_heading(m: int, chunks: list[Chunk]) -> bool:
    end = m + len(_sentence(chunks, m))
    return end < len(chunks) and getattr(chunks[end], "value", "") == ":"


def _sentence(chunks: list[Chunk], m: int) -> list[Chunk]:
    """What follows up to the next mark that ends a sentence or a title."""
    ends = (n for n, c in enumerate(chunks[m:]) if getattr(c, "value", "") in BOUNDARIES)
    return chunks[m : m + next(ends, len(chunks))]


def _group(m: int, chunks: list[Chunk]) -> tuple[str, list[Chunk], int] | None:
    """``of a car ahead of the ego``: the word, the noun with its place, where it ends."""
    word, noun = (chunks[n] if n < len(chunks) else None for n in (m, m + 1))
    if not _doer(word) or not isinstance(word, Word) or not isinstance(noun, Mention | Place):
        return None
    end = m + 2
    place, of = (chunks[n] if n < len(chunks) else None for n in (end, end + 1))
    if isinstance(place, Word) and place.cat == "locus" and isinstance(of, Mention | Place):
        end += 2
    if isinstance(place, Word) and place.value == "(" and isinstance(of, Mention):
        end += 3  # "of a GVT (a van)"
    at, speed, more = (chunks[n] if n < len(chunks) else None for n in (end, end + 1, end + 2))
    told = isinstance(at, Word) and isinstance(speed, Word) and speed.cat == "quantity"
    if told and isinstance(noun, Mention) and isinstance(speed, Word) and _doer(more):
        noun.mods = [*noun.mods, speed.term]  # "of a cyclist at 15 km/h by …"
        return word.value, chunks[m + 1 : end], end + 2
    return word.value, chunks[m + 1 : end], end


def _doer(word: Chunk | None) -> bool:
    return isinstance(word, Word) and word.value in {"of", "by"}

"""``Braking of the lead car``, ``Overtaking of a cyclist by the ego``: clauses without a verb.

The noun of a doing with "of" and "by" behind it says what its verb would say between the two.
"""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing, Word, teller_at
from scegen.understanding.phrases.lookahead import (
    BOUNDARIES,
    GOVERNING,
    cat_at,
    chunk_at,
    ends,
    finite_follows,
    sentence_end,
    value_at,
)

_ENTERED = frozenset({"brake", "hard_brake", "slow", "stop", "overtake", "accelerate", "cut_in",
                      "lane_change", "merge", "swerve", "u_turn"})  # fmt: skip
"""Doings that an entry of notes names after the one that tells who it is about."""
_HOW = frozenset({"prep", "quantity", "manner", "dir", "punct", "sub"})
DONE_TO = frozenset({"overtake", "pass", "bypass", "follow", "encounter"})
"""Doings of which "of" names whom they are done to."""
_MADE = frozenset({"turn", "u_turn", "reverse"})
"""Doings that a title names before who does them."""
_DOERS = frozenset({"of", "by"})
_JOINTS = frozenset({",", "and", "then"})


def spell_out_doings(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks with who does what a noun names before it, and whom it is done to behind it."""
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
    before = value_at(chunks, k - 1) if k else "."
    opens = before in BOUNDARIES or (before in _JOINTS and (event.nominal or event.form == "ing"))
    if not opens or event.form not in {"base", "ing"}:
        return None
    after = chunk_at(chunks, k + 1)
    where = chunks[k + 1 : k + 3] if isinstance(chunk_at(chunks, k + 2), Place) else []
    m = k + 1 + len(where)
    who_else = chunk_at(chunks, m + 1)
    if event.name in _MADE and value_at(chunks, m) == "," and isinstance(who_else, Mention):
        rest = chunks[m + 2 : sentence_end(chunks, m + 2)]
        done = any(isinstance(c, Event) for c in rest)
        # "Left turn, ego at 12 km/h", "Left turn at a junction, ego 12 km/h"
        return None if done else ([who_else, _verb(event), *where], m + 2)
    m = k + 1 + isinstance(after, Thing)  # "manoeuvre"
    named: dict[str, list[Chunk]] = {}
    while (group := _group(m, chunks)) and group[0] not in named:
        named[group[0]] = group[1]
        m = group[2]
    is_heading = value_at(chunks, sentence_end(chunks, m)) == ":"
    if finite_follows(chunks, m - 1) or is_heading:
        return None
    if not named:
        who = _last_told(k, chunks) if before in BOUNDARIES else None
        if who is None or event.name != "overtake":
            return None if who is None else ([who, _verb(event)], k + 1)
        of_ego = who.same_as is not None and who.same_as.is_ego
        return None if of_ego else ([teller_at(event.i), _verb(event), who], k + 1)
    of, by = named.get("of", []), named.get("by", [])
    if not by and event.name not in DONE_TO:  # but not "reversing out of a drive, …"
        return ([*of, _verb(event)], m) if isinstance(of[0], Mention) else None
    return [*(by or [teller_at(event.i)]), _verb(event), *of], m


def _verb(event: Event) -> Event:
    return replace(event, form="s", nominal=False)


def _last_told(k: int, chunks: list[Chunk]) -> Mention | None:
    """``Lead: 80 km/h, 30 m ahead. Braking with 8 m/s²``: of whom the entry before tells.

    An entry has no verb; what follows the noun of the doing is a measure or a phrase of place.
    """
    event, mark, told = chunks[k], chunk_at(chunks, k - 1), None
    if not isinstance(event, Event) or event.name not in _ENTERED:
        return None
    bare = all(m.cat == "manner" for m in event.mods)
    if not bare or mark is None or cat_at(chunks, k + 1) not in _HOW:
        return None
    for m in range(k - 2, -1, -1):
        who = chunks[m]
        if isinstance(who, Event) or (told is not None and ends(who)):
            break
        free = cat_at(chunks, m - 1) not in GOVERNING
        if isinstance(who, Mention) and not who.possessor and free:
            told = told or Mention(event.i, event.i, [], None, same_as=who)
    else:
        return told
    return None if isinstance(who, Event) else told


def _group(m: int, chunks: list[Chunk]) -> tuple[str, list[Chunk], int] | None:
    """``of a car ahead of the ego``: the word, the noun with its place, where it ends."""
    word, noun = value_at(chunks, m), chunk_at(chunks, m + 1)
    if word not in _DOERS or not isinstance(noun, Mention | Place):
        return None
    end = m + 2
    speed = chunk_at(chunks, end + 1)
    told = isinstance(noun, Mention) and value_at(chunks, end + 2) in _DOERS
    if told and isinstance(speed, Word) and speed.cat == "quantity":
        noun.mods = [*noun.mods, speed.term]  # "of a cyclist at 15 km/h by …"
        return word, chunks[m + 1 : end], end + 2
    return word, chunks[m + 1 : end], end

"""``turns into a road that a pedestrian is crossing``, ``crosses the road entered by the ego``.

A road into which somebody turns is their exit, wherever the text tells of that road again.
"""

from __future__ import annotations

from dataclasses import replace

from scegen.scenario.vocabulary import CrossedArm
from scegen.understanding.chunks import Chunk, Event, Mention, Place
from scegen.understanding.lexicon import word_list, word_lists
from scegen.understanding.phrases.lookahead import cat_at, chunk_at, ends, value_at
from scegen.understanding.phrases.which_road import turns
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token, low_at

_ROADS = frozenset({"road", "access", "leg", "highway"})
_ON_FOOT = frozenset({"cross", "walk"})


def name_turned_into(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """The chunks; a road that is told by the turn into it is an arm, a clause on it a sentence."""
    turn = next((k for k, c in enumerate(chunks) if turns(c)), None)
    if turn is None:
        return chunks
    who = _turning(chunks, turn)
    found: list[Chunk] = []
    begin, k = 0, 0
    while k < len(chunks):
        chunk = chunks[k]
        before, after = chunk_at(found, len(found) - 1), k + 1
        if isinstance(chunk, Place) and chunk.kind in _ROADS and chunk.arm is None:
            verb = next((c for c in reversed(found[begin:]) if isinstance(c, Event)), None)
            onto = isinstance(before, Term) and low_at(tokens, before.i) in {"into", "onto"}
            if onto and turns(verb):
                told, after = _walked(chunks, k)
                again = replace(chunk, arm=CrossedArm.EXIT, user=who)
                found[begin:begin] = [again if c is chunk else c for c in told]
            else:
                end = _entered(chunks, after)
                if end != after or _pointed_at(chunk, found, tokens):
                    whole = chunk_at(found, len(found) - 2) if before.value == "of" else None
                    for place in (chunk, whole):  # "the zebra crossing of the road entered"
                        if isinstance(place, Place):
                            place.arm, place.user = CrossedArm.EXIT, who
                after = end
        found.append(chunk)
        if ends(chunk):
            begin = len(found)
        k = after
    return found


def _turning(chunks: list[Chunk], k: int) -> Mention | None:
    named = [c for c in chunks[:k] if isinstance(c, Mention)][-1:]
    named += [c for c in chunks[k:] if isinstance(c, Mention)]
    return named[0] if named else None


def _walked(chunks: list[Chunk], k: int) -> tuple[list[Chunk], int]:
    """Who crosses the road of a relative clause, as a sentence, and where the clause ends."""
    m = k + 1
    m += value_at(chunks, m) == ","
    over = (
        chunks[m : m + 1] if cat_at(chunks, m) == "prep" and cat_at(chunks, m + 1) == "rel" else []
    )
    m += len(over)
    if cat_at(chunks, m) != "rel" and value_at(chunks, m) != "where":
        return [], k + 1
    m += 1
    who = chunk_at(chunks, m)
    m += isinstance(who, Mention)
    while cat_at(chunks, m) in {"aux", "manner"}:
        m += 1
    verb = chunk_at(chunks, m)
    if not isinstance(verb, Event) or verb.name not in _ON_FOOT:
        return [], k + 1
    if not isinstance(who, Mention) and verb.form == "ed" and value_at(chunks, m + 1) == "by":
        m += 2
        who = chunk_at(chunks, m)
    if not isinstance(who, Mention):
        return [], k + 1
    ends = Term("punct", ".", who.i, who.i)
    m += 1
    paced = cat_at(chunks, m) == "prep" and cat_at(chunks, m + 1) == "quantity"  # "at 5 km/h"
    pace = chunks[m : m + 2 * paced]
    return [who, replace(verb, form="s"), *over, chunks[k], *pace, ends], m + len(pace)


def _entered(chunks: list[Chunk], start: int) -> int:
    """Where ``(the road) being entered by the ego`` ends."""
    m = start + (cat_at(chunks, start) == "aux")
    verb = chunk_at(chunks, m)
    if not isinstance(verb, Event) or (verb.name, verb.form) != ("enter", "ed"):
        return start
    by = value_at(chunks, m + 1) == "by" and isinstance(chunk_at(chunks, m + 2), Mention)
    return m + 3 if by else m + 1


def _pointed_at(road: Place, before: list[Chunk], tokens: list[Token]) -> bool:
    """``the destination road``; "that road", "the side street", if the turn alone tells which."""
    words = {t.low for t in tokens[road.i : road.j]}
    named = [c for c in before if isinstance(c, Place) and c.kind in _ROADS]
    turned = any(map(turns, before))
    that = not words.isdisjoint(word_list("pointing")) and turned and len(named) <= 1
    that |= road.kind == "access" and road.opened_by("def") and turned and not named
    return that or not words.isdisjoint(word_lists("ways")["reached"])

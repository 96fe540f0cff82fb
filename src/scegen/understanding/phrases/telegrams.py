"""Telegraphic style: "Ego straight, truck from the left: right turn", "Cut-in by a van".

What is left out is put back before the clauses are read: "goes" before a bare direction, the
colon after a heading that says who or where, and who does what a noun names.
"""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Word, teller_at
from scegen.understanding.phrases.doings_named import spell_out_doings
from scegen.understanding.phrases.lookahead import BOUNDARIES, chunk_at, governs, is_word
from scegen.understanding.words.terms import Term

_WAYS = frozenset({("dir", "left"), ("dir", "right"), ("dir", "straight"), ("manner", "backwards")})
_SEPARATORS = frozenset({",", "and", "but", "or", "while", "when", "as", "(", "both"})
_AFTER = frozenset({"prep", "conj", "sub", "manner", "env", "locus", "control"})
_WITHIN = frozenset({"prep", "locus", "dir", "manner", "label", "quantity"})
_NAMED = frozenset({"cut_in", "lane_change", "merge", "u_turn", "hard_brake", "swerve"})
_UNDERGONE = frozenset({"park", "hide", "block", "collide", "locate", "follow", "overtake",
                        "encounter", "cut_off", "cut_in", "cause", "prevent", "stop"})  # fmt: skip
"""Verbs whose participle says what happened to somebody."""


def spell_out(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks with what telegraphic style leaves out."""
    chunks = _in_lanes(chunks)
    if any(is_word(chunk, ":") for chunk in chunks):
        chunks = _after_headings(_from_titles(chunks))
    chunks = _told_by_nobody(spell_out_doings(chunks))
    for k, chunk in enumerate(chunks):
        if isinstance(chunk, Event) and not chunk.nominal and _named_doing(chunks, k):
            chunk.nominal = True
    found: list[Chunk] = []
    for k, chunk in enumerate(chunks):
        if isinstance(chunk, Place) and chunk.kind == "exit" and _clause_opener(chunks, k):
            found.append(Event("leave", chunk.i, chunk.i, "s"))  # "ego 3rd exit"
        found.append(_going(chunks, k) or chunk)
    return found


def _ends(chunk: Chunk | None) -> bool:
    return chunk is None or (isinstance(chunk, Word) and chunk.value in BOUNDARIES)


def _after_headings(chunks: list[Chunk]) -> list[Chunk]:
    """``From the left: a truck``, ``Ego: straight``: the colon adds nothing."""
    kept: list[Chunk] = []
    begin = 0
    comma = 0
    for k, chunk in enumerate(chunks):
        comma = k + 1 if is_word(chunk, ",") else comma
        title = chunks[max(begin, comma) : k]
        if is_word(chunk, ":") and _plays(chunks, k):
            continue
        if is_word(chunk, ":") and title and _adds_nothing(title, chunks, k):
            if isinstance(title[0], Word) and title[0].cat == "dir":
                _describe(title[0].term, chunks, k)
        else:
            kept.append(chunk)
        if _ends(chunk):
            begin = k + 1
    return kept


def _from_titles(chunks: list[Chunk]) -> list[Chunk]:
    """``Side road on the right: van``, ``Left lane: a bus``, ``Right: a taxi``: from there."""
    found: list[Chunk] = []
    begin = comma = 0
    for k, chunk in enumerate(chunks):
        comma = k + 1 if is_word(chunk, ",") else comma
        start = max(begin, comma)
        title, following = chunks[start:k], chunk_at(chunks, k + 1)
        if is_word(chunk, ":") and title and isinstance(following, Mention):
            place = _titled(title)
            if place is not None:
                word = "in" if place.kind == "lane" else "from"
                found[len(found) - len(title) :] = [
                    Word(Term("prep", word, place.i, place.i)),
                    place,
                    *(c for c in title[1:] if place.kind == "access"),
                ]
                continue
        found.append(chunk)
        if _ends(chunk):
            begin = k + 1
    return found


def _in_lanes(chunks: list[Chunk]) -> list[Chunk]:
    """``ego 100 km/h, right lane``: in that lane."""
    found: list[Chunk] = []
    for k, chunk in enumerate(chunks):
        if isinstance(chunk, Place) and chunk.kind == "lane" and _bare_lane(chunk, chunks, k):
            found.append(Word(Term("prep", "in", chunk.i, chunk.i)))
        found.append(chunk)
    return found


def _bare_lane(lane: Place, chunks: list[Chunk], k: int) -> bool:
    before, after = chunk_at(chunks, k - 1), chunk_at(chunks, k + 1)
    bare = isinstance(before, Word) and (before.cat == "quantity" or before.value in {",", ":"})
    who = isinstance(before, Mention) and any(m.cat == "quantity" for m in before.mods)
    placed = isinstance(after, Word) and after.cat in {"prep", "locus"}  # "lane right of it"
    ends = after is None or (isinstance(after, Word) and after.cat in {"punct", "conj"})
    plain = all(m.cat == "dir" for m in lane.mods)
    which = placed or bool({"left", "right"} & set(lane.dirs))
    which = which or (lane.head is not None and lane.head.j > lane.head.i + 1)  # "middle lane"
    return plain and which and (ends or placed) and (bare or who)


def _titled(title: list[Chunk]) -> Place | None:
    first = title[0]
    if isinstance(first, Place) and first.kind in {"access", "lane", "side", "leg"}:
        simple = all(isinstance(c, Word | Place) for c in title)
        return first if simple and first.prep is None else None
    return None


def _told_by_nobody(chunks: list[Chunk]) -> list[Chunk]:
    """``Turned right and hit a van``, ``Was going straight``: whoever tells it did."""
    first = chunk_at(chunks, 0)
    auxiliary = isinstance(first, Word) and (first.cat, first.value) == ("aux", "be")
    verb = chunk_at(chunks, 1) if auxiliary else first
    if not isinstance(verb, Event) or verb.nominal:
        return chunks
    past = verb.form == "ing" if auxiliary else verb.form == "ed"
    following = chunk_at(chunks, chunks.index(verb) + 1)
    undergone = verb.name in _UNDERGONE and not isinstance(following, Mention)
    undergone = undergone and verb.name != "stop"
    if not past or (undergone and not auxiliary) or is_word(following, "by"):
        return chunks
    return [teller_at(verb.i), *chunks]


def _plays(chunks: list[Chunk], k: int) -> bool:
    """``Conflict partner: a bus from the left``: the noun after the colon plays the role."""
    role, actor = chunk_at(chunks, k - 1), chunk_at(chunks, k + 1)
    if not (
        isinstance(role, Mention) and isinstance(actor, Mention) and _ends(chunk_at(chunks, k - 2))
    ):
        return False
    plays = role.head is not None and role.head.data.get("label") == "adversary"
    plays = plays or role.is_ego or bool({"ahead", "behind"} & set(role.dirs))
    ends = _ends(chunk_at(chunks, k + 2)) or is_word(
        chunk_at(chunks, k + 2), ","
    )  # "Ego: van, 50 km/h"
    if not plays or actor.is_ego or (role.is_ego and not ends):
        return False
    actor.same_as = role
    return True


def _adds_nothing(title: list[Chunk], chunks: list[Chunk], k: int) -> bool:
    first, following = title[0], chunk_at(chunks, k + 1)
    if isinstance(first, Word) and first.cat == "dir":
        return len(title) == 1 and isinstance(following, Mention)
    way = isinstance(following, Word) and (following.cat, following.value) in _WAYS
    named = isinstance(first, Mention) and not any(isinstance(c, Event) for c in title)
    return way and named


def _ego(chunk: Chunk) -> bool:
    return isinstance(chunk, Mention) and chunk.is_ego


def _describe(term: Term, chunks: list[Chunk], k: int) -> None:
    """``Oncoming: a van and a bus``: both are."""
    for chunk in chunks[k + 1 :]:
        if _ends(chunk) or isinstance(chunk, Event):
            return
        if isinstance(chunk, Mention) and chunk.heads and chunk.prep is None and not _ego(chunk):
            chunk.mods = [*chunk.mods, term]


def _named_doing(chunks: list[Chunk], k: int) -> bool:
    """``Cut-in from the left``, ``Cut-in, ego 100 km/h``: a doing, not yet with who does it."""
    following, event = chunk_at(chunks, k + 1), chunks[k]
    said = isinstance(event, Event) and event.form in {"base", "ing"}
    if not said or not _ends(chunk_at(chunks, k - 1)):
        return False
    placed = isinstance(following, Word) and following.cat in {"prep", "locus", "manner"}
    bare = isinstance(event, Event) and event.form == "base" and event.name in _NAMED
    listed = is_word(following, ",") or is_word(following, ":")  # "Cut-in, ego 100 km/h, target …"
    return bare and (placed or listed)


def _going(chunks: list[Chunk], k: int) -> Event | None:
    """``ego straight``, ``ego in reverse``: goes straight, backwards."""
    way = chunks[k]
    if not isinstance(way, Word) or (way.cat, way.value) not in _WAYS:
        return None
    following = chunk_at(chunks, k + 1)
    free = _ends(following) or (
        isinstance(following, Word) and (following.value == "," or following.cat in _AFTER)
    )
    opener = _clause_opener(chunks, k)
    if not free or is_word(following, "of") or opener is None:
        return None
    return Event("move", way.i, way.j, "s", mods=[way.term], drives=True)


def _clause_opener(chunks: list[Chunk], k: int) -> Mention | None:
    """The participant with which the clause before chunk ``k`` begins, if it has no verb."""
    for m in range(k - 1, -1, -1):
        chunk = chunks[m]
        if isinstance(chunk, Mention):
            before = chunk_at(chunks, m - 1)
            if not governs(before):
                return chunk if _introduced(chunks, m - 1) else None
        elif isinstance(chunk, Event) or (isinstance(chunk, Word) and chunk.cat not in _WITHIN):
            return None
    return None


def _introduced(chunks: list[Chunk], m: int) -> bool:
    """Whether a clause begins after chunk ``m``."""
    before = chunk_at(chunks, m)
    if _ends(before):
        return True
    if not isinstance(before, Word) or before.value not in _SEPARATORS:
        return False
    return before.value != "(" and not isinstance(chunk_at(chunks, m - 1), Event)

"""Phrases that open a clause and say where the participant after them is."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Thing, Word
from scegen.understanding.clauses.state import State
from scegen.understanding.phrases.lookahead import GOVERNING, behind_insertion, chunk_at, value_at

_SIDES = frozenset({"side", "direction", "lane", "sidewalk", "shoulder", "bike_lane", "access",
                    "parking", "bus_stop"})  # fmt: skip
_ROADS = frozenset({"leg", "road"})
"""Roads, if it is said which one: "from the right arm", "on the road that it turns into"."""
_MEETING = frozenset({"move", "approach", "appear", "locate", "wait", "stop", "park", "hide",
                      "walk", "cross", "follow", "brake", "slow"})  # fmt: skip
"""Verbs that may stand before their subject ("from the left comes a bus")."""


def opens_clause(state: State) -> bool:
    """Whether the phrase that begins here says where the participant after it is.

    "Behind the ego is a truck", "from the left comes a bus, and from the right a van".
    """
    begins = not state.events and state.candidate is None and not state.mentions
    road = isinstance(state.anchor, Place) and state.anchor.kind == "highway"
    begins = begins and (state.anchor is None or road)  # "a kiosk on the left hides a child"
    opened = bool(state.fronted) and not state.events and state.candidate is None
    lane = state.at(1)
    named = isinstance(lane, Place) and lane.kind == "lane" and bool(lane.dirs)
    begins |= opened and named and "," in state.between  # "behind the ego, in the left lane, a …"
    joins = {"conj", "sub", ","} & state.between and "or" not in state.between
    inserted = {"conj", ","} <= state.between  # "a child and, behind the child, a bus"
    listed = "conj" in state.between
    complete = state.candidate_done or bool(state.events) or state.being is not None
    if not begins and not (joins and (inserted or complete)):
        return False
    chunks = state.chunks
    m = _phrase_end(state.k, chunks)
    if m is None:
        return False
    while _word_of(chunks, m, GOVERNING) and (further := _phrase_end(m, chunks)) is not None:
        m = further  # "in the left lane beside the ego a van drives"
    if value_at(chunks, m) == "(":  # "ahead of the ego (40 km/h) a van drives"
        closed = (n + 1 for n, c in enumerate(chunks[m:], start=m) if c.value == ")")
        m = next(closed, m)
    if value_at(chunks, m) == ",":
        if not (begins or listed or "sub" in state.between):
            return False
        m = behind_insertion(chunks, m + 1)
    inverted = _stands_before_subject(chunks, m)
    m += _word_of(chunks, m, frozenset({"aux", "copy"})) or inverted
    # "50 m ahead of the ego lies a pedestrian crossing"
    return isinstance(chunk_at(chunks, m), NounPhrase if inverted else Mention)


def _stands_before_subject(chunks: list[Chunk], m: int) -> bool:
    verb = chunk_at(chunks, m)
    finite = isinstance(verb, Event) and not verb.nominal and verb.form != "ing"
    return finite and isinstance(verb, Event) and verb.name in _MEETING


def _word_of(chunks: list[Chunk], m: int, classes: frozenset[str]) -> bool:
    chunk = chunk_at(chunks, m)
    return isinstance(chunk, Word) and chunk.cat in classes


def _phrase_end(k: int, chunks: list[Chunk]) -> int | None:
    """Index after a phrase of place that begins at chunk ``k``; None if none does."""
    first = chunks[k]
    m = k + 1
    locus = isinstance(first, Word) and first.cat == "locus"
    while _word_of(chunks, m, GOVERNING):
        locus |= _word_of(chunks, m, frozenset({"locus"}))
        m += 1
    target = chunk_at(chunks, m)
    placed = isinstance(target, Place) and (
        target.kind in _SIDES
        or (target.kind in _ROADS and (target.arm or target.dirs or _side_after(chunks, m + 1)))
    )
    if locus and _stands_before_subject(chunks, m):
        return m  # "from ahead comes a van"
    owned = chunk_at(chunks, m + 1)
    sided = isinstance(target, Mention) and target.possessor and isinstance(owned, Place)
    if not placed and not (locus and isinstance(target, Mention | Thing)) and not sided:
        return None  # "from the ego's left a van comes"
    m += 1
    if isinstance(target, Mention) and target.possessor and isinstance(owned, NounPhrase):
        m += 1  # "behind the ego's bumper"
    parked = chunk_at(chunks, m)
    m += isinstance(parked, Event) and (parked.name, parked.form) == ("park", "ed")
    if _side_after(chunks, m):
        m += 2  # "behind a van (parked) on the right a man …", "from the road on the left a van …"
    while value_at(chunks, m) == "of" and isinstance(chunk_at(chunks, m + 1), Mention | Place):
        m += 2
    return m


def _side_after(chunks: list[Chunk], m: int) -> bool:
    side = chunk_at(chunks, m + 1)
    sided = isinstance(side, Place) and side.kind in {"side", "sidewalk", "shoulder"}
    return sided and value_at(chunks, m) in {"in", "to"}


def place_in_front(mention: Mention, state: State) -> None:
    """Gives the phrases that opened the clause to the participant that they place."""
    mention.pps += [p for p in state.fronted if p.outer != "from" and p.value != "due"]

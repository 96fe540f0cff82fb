"""Nouns joined by "and", "or" or commas: when the second takes the role of the first."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Word
from scegen.understanding.clauses.state import State
from scegen.understanding.phrases.lookahead import (
    chunk_at,
    finite_follows,
    is_word,
    sentence_end,
)


def joins(mention: Mention, k: int, chunks: list[Chunk], state: State) -> bool:
    """``a car and a truck``: the second takes the role of the first.

    Args:
        mention: the second noun.
        k: its index among the chunks.
        chunks: the chunks of the text.
        state: what the clause reader remembers.
    """
    anchor = state.anchor
    _doing_the_same(mention, k, chunks, state)
    listed = "and" in state.between or "or" in state.between or state.between == {","}
    if not (isinstance(anchor, Mention) and listed) or state.between & {"sub", "copy"}:
        return False
    joint = chunks[k - 1]
    if isinstance(joint, Word) and "next" in joint.term.data and finite_follows(chunks, k):
        return False  # "…, and then the van brakes": what happens next
    if mention.pronoun in {"count", "one", "another"} and "," in state.between:
        return False  # "four vans, two turning left": some of them, not further ones
    waiting = anchor is state.waiting
    waiting = waiting and not any(anchor in event.subject for event in state.events)
    said = bool({"aux:be", "aux:have"} & state.between) or _is_somewhere(anchor, k, chunks)
    complete = said and finite_follows(chunks, k)  # "I'm here and a van …"
    if complete or (state.between == {","} and not (waiting and _list_goes_on(k, chunks))):
        return False
    let = _let(anchor, k, chunks, state)
    if not waiting and ((finite_follows(chunks, k) and not let) or "," in state.between):
        return False
    if _in_parallel(anchor, k, chunks, state):
        return False
    mention.joined = anchor
    mention.pps += [p for p in anchor.pps if p.fronted]
    if waiting:
        state.candidate = mention
    for event in state.events:
        if event.object is anchor:
            event.object = mention
    state.stand_at(mention)
    return True


def _is_somewhere(who: Mention, k: int, chunks: list[Chunk]) -> bool:
    """``we're in the left lane of the motorway and a van …``: a clause of its own, without verb."""
    since = [c for c in chunks[:k] if c.i >= who.j]
    return any(isinstance(c, Word) and (c.cat, c.value) == ("aux", "be") for c in since)


def _list_goes_on(k: int, chunks: list[Chunk]) -> bool:
    """``a car, a van and a bus``: a comma alone does not make a list."""
    rest = chunks[k + 1 : sentence_end(chunks, k + 1)]
    joint = next((c for c in rest if isinstance(c, Event) or _joins(c)), None)
    return _joins(joint)


def _joins(chunk: Chunk | None) -> bool:
    return is_word(chunk, "and") or is_word(chunk, "or")


def _doing_the_same(mention: Mention, k: int, chunks: list[Chunk], state: State) -> None:
    """``waits for a van coming from the left and a bus coming from the right``: for both."""
    last, following = state.last, chunk_at(chunks, k + 1)
    if last is None or last.form != "ing" or last.finite or "and" not in state.between:
        return
    alike = isinstance(following, Event) and following.form == "ing"
    if alike and last.subject and mention.heads:
        mention.prep = last.subject[-1].prep


def _let(anchor: Mention, k: int, chunks: list[Chunk], state: State) -> bool:
    """``lets two people and a cyclist cross``: both are let."""
    last = state.last
    if last is None or last.control != "object" or last.object is not anchor:
        return False
    verb = next((c for c in chunks[k + 1 : k + 4] if isinstance(c, Event)), None)
    return verb is not None and verb.form == "base"


def _in_parallel(anchor: Mention, k: int, chunks: list[Chunk], state: State) -> bool:
    """``a bus approaches the ego from the left and a taxi from the right``: the taxi does, too."""
    known = anchor.is_ego or anchor.pronoun is not None  # others are described by where they are
    if not known or state.last is None or state.last.object is not anchor:
        return False
    before, place, after = (chunk_at(chunks, m) for m in (k - 3, k - 2, k + 1))
    prep = isinstance(before, Word) and before.cat == "prep" and is_word(after, before.value)
    return prep and isinstance(place, Place)

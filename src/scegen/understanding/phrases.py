"""Noun phrases that continue others: appositions, and sides joined by "and"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Prep, Word
from scegen.understanding.state import State


def apposes(chunks: list[Chunk], k: int, state: State) -> bool:
    """``vehicle 1, a sedan, was …``: the second only describes the first.

    Args:
        chunks: the chunks of the text.
        k: index of the second noun.
        state: what the clause reader remembers.
    """
    if _names_before(chunks, k, state):
        return True
    waiting = isinstance(state.anchor, Mention) and state.anchor is state.candidate
    if not waiting or state.between != {","} or state.candidate_done:
        return False
    following = chunks[k + 1 : k + 3]
    comma = bool(following) and isinstance(following[0], Word) and following[0].value == ","
    if not comma or len(following) < 2:
        return False
    after = following[1]
    verb = isinstance(after, Event) and after.form != "ing"
    return verb or (isinstance(after, Word) and after.cat == "aux")


def also_from(noun: NounPhrase, state: State) -> bool:
    """``from the north and the east``: the preposition counts for both.

    Args:
        noun: the noun just read.
        state: what the clause reader remembers.
    """
    last = state.last_prep
    if last is None or not (isinstance(noun, Place) and noun.kind == "side"):
        return False
    joined = state.between & {"and", "or", ","} and isinstance(last.target, Place)
    if not joined or last.target is None or last.target.j != noun.i - 1:
        return False
    further = Prep(last.word, noun, last.outer, last.on_mention)
    listed = [e.pps for e in state.events[-1:]] + [m.pps for m in state.mentions]
    for phrases in listed:
        if last in phrases:
            phrases.append(further)
    state.last_prep = further
    return True


def bracketed(chunks: list[Chunk], k: int) -> bool:
    """``vehicle 1 (a taxi)``: a noun alone in brackets describes the noun before.

    Args:
        chunks: the chunks of the text.
        k: index of the noun in brackets.
    """
    around = [*chunks[max(0, k - 1) : k], *chunks[k + 1 : k + 2]]
    return [c.value for c in around if isinstance(c, Word)] == ["(", ")"]


def _names_before(chunks: list[Chunk], k: int, state: State) -> bool:
    """``struck V2, an oncoming pickup.``: a noun without a name after one with a name."""
    here, before = chunks[k], state.anchor
    if state.between != {","} or not isinstance(before, Mention) or not isinstance(here, Mention):
        return False
    named = (before.label or "").startswith("#") and not (here.label or "").startswith("#")
    following = chunks[k + 1] if k + 1 < len(chunks) else None
    listed = isinstance(following, Word) and following.cat == "conj"
    indefinite = any(m.value == "indef" for m in here.mods)
    acts = isinstance(following, Event) and following.form != "ing"
    return named and indefinite and not listed and not acts

"""Attaches prepositional phrases: to the noun right before them, or to the verb."""

from __future__ import annotations

from scegen.understanding.chunks import Mention, Prep, Word
from scegen.understanding.state import State


def preposition(word: Word, state: State) -> None:
    """Opens a phrase; what it governs comes next.

    Args:
        word: the preposition.
        state: what the clause reader remembers.
    """
    outer = state.prep.value if state.prep is not None else None
    if state.prep is not None and word.cat != "locus":
        release(state)
        outer = None
    anchor = state.anchor
    near = anchor if isinstance(anchor, Mention) and not state.between else None
    if state.last_pp is not None and not state.between:
        near = state.last_pp
    state.prep = Prep(word, None, outer, near)


def release(state: State) -> None:
    """A preposition without a target: "the car ahead", "positioned behind on the right"."""
    if state.prep is not None:
        if state.prep.word.cat == "locus":
            attach(state.prep, state)
        state.prep = None


def attach(prep: Prep, state: State) -> None:
    """Gives a phrase to the noun right before it, to the last verb, or to who acts.

    Args:
        prep: the phrase, complete.
        state: what the clause reader remembers.
    """
    if prep.on_mention is not None:
        prep.on_mention.pps.append(prep)
    if state.events and (prep.on_mention is None or state.anchor is not state.candidate):
        state.events[-1].pps.append(prep)
    elif prep.on_mention is None and state.candidate is not None:
        state.candidate.pps.append(prep)

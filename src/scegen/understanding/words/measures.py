"""Nouns that name what is measured: "speed: 50 km/h"."""

from __future__ import annotations

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Match, Term
from scegen.understanding.words.tokens import Token


def names_a_measure(match: Match, tokens: list[Token], previous: Term | None) -> bool:
    """``speed 50 km/h``, ``speed difference``, ``limit 60 km/h``: what is measured, not a verb.

    Args:
        match: the word with its meanings.
        tokens: the tokens of the text.
        previous: the term before.
    """
    speed = match.has("inert") and match.get("verb").value == "speed"
    if match.form != "base" or not (speed or match.has("limit")):
        return False
    if previous is None or previous.cat == "punct":
        return True  # "speed ego = 80 km/h"
    if previous is not None and (previous.cat in {"aux", "pronoun"} or previous.value == "to"):
        return False
    following = tokens[match.j] if match.j < len(tokens) else None
    return (
        following is None
        or following.kind in {"number", "punct"}
        or following.low in word_list("measures")
    )

"""Nouns and sides that look like verbs: "left the road", "speed: 50 km/h"."""

from __future__ import annotations

from scegen.understanding.lexicon import Entry, word_list
from scegen.understanding.words.terms import Match, Term, begins
from scegen.understanding.words.tokens import Token, low_at


def left_or_gone(match: Match, tokens: list[Token], previous: Term | None) -> tuple[Entry, bool]:
    """``left`` is nearly always the side; "V1 left the road" has a subject and an object.

    Args:
        match: the word with its meanings.
        tokens: the tokens of the text.
        previous: the term before.

    Returns:
        The meaning, and that it is no participle before a noun.
    """
    subject = previous is not None and previous.cat in {"actor", "pronoun", "aux"}
    left = begins(tokens, match.j, "det", "possessive", "place", "manner")
    left = left or low_at(tokens, match.j) in word_list("leaving")
    return (match.get("verb") if subject and left else match.get("dir")), False


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
    if previous.cat in {"aux", "pronoun"} or previous.value == "to":
        return False
    following = tokens[match.j : match.j + 1]
    return all(t.kind in {"number", "punct"} or t.low in word_list("measures") for t in following)

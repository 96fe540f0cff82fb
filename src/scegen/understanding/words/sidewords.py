"""Words for sides that mean something else besides: "left" and "opposite"."""

from __future__ import annotations

from scegen.understanding.lexicon import Entry, word_list
from scegen.understanding.words.terms import Match, Term, longest_match
from scegen.understanding.words.tokens import Token


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
    following = longest_match(tokens, match.j)
    left = following is not None and following.has("det", "possessive", "place", "manner")
    left = left or (match.j < len(tokens) and tokens[match.j].low in word_list("leaving"))
    return (match.get("verb") if subject and left else match.get("dir")), False

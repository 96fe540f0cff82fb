"""Whether a noun comes: what stands before it is an adjective then."""

from __future__ import annotations

from scegen.understanding.words.quantities import quantity_at
from scegen.understanding.words.terms import Match, longest_match
from scegen.understanding.words.tokens import Token


def noun_follows(tokens: list[Token], j: int) -> bool:
    """Whether a participant or thing is named at token ``j``, adjectives skipped."""
    for step in range(3):
        following = longest_match(tokens, j)
        if following is None and step == 0 and j < len(tokens) and tokens[j].kind == "word":
            j += 1  # "a slow milk truck"
            continue
        if following is None:
            return False
        if following.has("actor", "thing"):
            return not _needs_no_article(following, tokens)
        if not following.has("state", "label", "dir", "manner", "verb") or following.has("prep"):
            return following.has("view")
        if following.only("verb") and following.form not in {"ing", "ed"}:
            return False
        j = following.j
    return False


def _needs_no_article(noun: Match, tokens: list[Token]) -> bool:
    """Pronouns and names ("me", "V1", "vehicle 2"): no participle describes them."""
    if any("me" in e.data or "speaks" in e.data for e in noun.entries):
        return True
    after = tokens[noun.j] if noun.j < len(tokens) else None
    numbered = after is not None and after.kind == "number" and quantity_at(tokens, noun.j) is None
    return numbered and noun.form == "base"

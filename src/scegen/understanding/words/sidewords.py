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


def across_from(match: Match, tokens: list[Token], previous: Term | None) -> Match:
    """``waits opposite me``: across from, unlike in "the opposite lane".

    Args:
        match: a phrase with its meanings.
        tokens: the tokens of the text.
        previous: the term before.

    Returns:
        The phrase with the meanings that it may have here.
    """
    if not (match.has("locus") and match.has("dir")):
        return match
    following = longest_match(tokens, match.j)
    inside = previous is not None and previous.cat in {"det", "prep", "possessive"}
    somebody = (
        following is not None
        and not inside
        and (
            any("me" in e.data or e.value == "reflexive" for e in following.entries)
            or following.has("det", "possessive")
        )
    )
    cat = "locus" if somebody else "dir"
    return Match(tuple(e for e in match.entries if e.cat == cat), match.j, match.form)


def creeps(match: Match, tokens: list[Token], side: Term | None) -> bool:
    """``the one to the ego's right creeps forward``: what it does, not what somebody is.

    Args:
        match: a word with its meanings.
        tokens: the tokens of the text.
        side: the term before.
    """
    if side is None or match.form != "s" or not match.has("verb", "actor"):
        return False
    if side.cat in {"place", "actor"} and any("vague" in e.data for e in match.entries):
        return match.has("verb")  # "the van on the minor road creeps forward"
    if does_it(match, tokens, side.j - 1):
        return True
    named = side.cat == "dir" and side.i > 0 and tokens[side.i - 1].kind == "clitic"
    return named and match.has("actor") and match.form == "s"


def does_it(match: Match, tokens: list[Token], role: int) -> bool:
    """``the lead creeps``, ``the second cycles along``: a role without a noun, and its verb.

    Args:
        match: the word after the role, which may be a verb or a plural.
        tokens: the tokens of the text.
        role: where the name of the role stands.
    """
    if match.form != "s" or not match.has("verb") or tokens[role].low not in word_list("roles"):
        return False
    opening = role
    while opening > 0 and tokens[opening - 1].low in word_list("before_roles"):
        opening -= 1
    before = longest_match(tokens, opening - 1) if opening else None
    opens = not opening or tokens[opening - 1].kind == "punct"
    opens = opens or (before is not None and before.has("conj", "sub"))
    return opens and not _verb_at(tokens, match.j)


def _verb_at(tokens: list[Token], j: int) -> bool:
    """``the lead cycles suddenly brake``: whether a verb is there, so that a noun stood before."""
    following = longest_match(tokens, j)
    while following is not None and following.has("manner") and not following.has("verb"):
        j = following.j
        following = longest_match(tokens, j)
    if following is None or following.has("dir"):
        return False
    return following.has("aux") or (following.has("verb") and following.form in {"base", "ed"})

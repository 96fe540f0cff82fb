"""Little words at the edge of a phrase: what they belong to, and what they only look like."""

from __future__ import annotations

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Match, Term, longest_match
from scegen.understanding.words.tokens import Token

_GIVES = frozenset({"dir", "verb"})
_OPENS_A_NOUN = ("det", "possessive", "actor", "compass", "place")


def just_right(tokens: list[Token], i: int, previous: Term | None) -> bool:
    """``right behind``, ``right past``, ``right in front of``: no direction, except after a turn.

    Args:
        tokens: the tokens of the text.
        i: index of a token.
        previous: the term before it.
    """
    if tokens[i].low != "right" or i + 1 >= len(tokens) or previous is None:
        return False
    following = longest_match(tokens, i + 1)
    located = following is not None and following.has("locus")
    located = located or (tokens[i + 1].low in word_list("particles") and previous.cat == "verb")
    located = located or tokens[i + 1].low == "across"
    located = located or (i + 2 < len(tokens) and tokens[i + 1].low == "at" and _me(tokens[i + 2]))
    return located and not previous.value.endswith("turn") and previous.cat != "det"


def _me(token: Token) -> bool:
    return token.low in {"me", "us", "him", "her", "them", "it"}


def then_a_noun(tokens: list[Token], match: Match) -> bool:
    """``straight on the main road``: "on" belongs to the road, unlike in "straight on at".

    Args:
        tokens: the tokens of the text.
        match: a phrase of motion or direction that may end in "on".
    """
    if match.j < len(tokens) and tokens[match.j].low == "of":
        return all(e.cat == "manner" and e.value == "row" for e in match.entries)
    if tokens[match.j - 1].low == "across" and any(e.value == "encounter" for e in match.entries):
        # "comes across the median"
        return _named_at(tokens, match.j, ("place",), ("actor", "thing"))
    if tokens[match.j - 1].low not in {"on", "through"} or match.j >= len(tokens):
        return False
    if not all(e.cat in _GIVES and e.value in {"straight", "move", "inert"} for e in match.entries):
        return False
    if tokens[match.j].low in word_list("each"):
        return True  # "drive on either side"
    noun = longest_match(tokens, match.j)
    if noun is not None and noun.has("possessive") and match.only("verb"):
        return all(e.value != "inert" for e in match.entries)  # "turns on its lights"
    return noun is not None and noun.has(*_OPENS_A_NOUN)


def _named_at(
    tokens: list[Token], j: int, wanted: tuple[str, ...], others: tuple[str, ...]
) -> bool:
    """Whether a noun of a class is named at token ``j``, articles and the like skipped."""
    for _ in range(3):
        found = longest_match(tokens, j)
        if found is None or found.has(*others):
            return False
        if found.has(*wanted):
            return True
        j = found.j
    return False


def nothing_shed(tokens: list[Token], match: Match) -> bool:
    """``loses patience``, ``a lost pallet``: no thing that it carried is let fall."""
    if match.entries[0].value != "shed" or not match.only("verb"):
        return False
    opened = longest_match(tokens, match.j)
    bare = match.form == "ed" and not (opened is not None and opened.has("det", "possessive"))
    return bare or not _named_at(tokens, match.j, ("thing",), ("actor", "place"))


def over_a_place(tokens: list[Token], match: Match) -> bool:
    """``runs over the crosswalk``: nothing is run over.

    Args:
        tokens: the tokens of the text.
        match: a verb that may end in "over".
    """
    if tokens[match.j - 1].low != "over" or not match.only("verb") or match.j >= len(tokens):
        return False
    noun = longest_match(tokens, match.j)
    opened = noun is not None and noun.has("det", "possessive")
    if noun is not None and opened and noun.j < len(tokens):
        noun = longest_match(tokens, noun.j)
    value = match.get("verb").value
    return value in {"collide", "lose_control"} and noun is not None and noun.has("place")


def after_a_phrase(token: Token, previous: Term, tokens: list[Token]) -> bool:
    """``a bus from the left asserts its priority``, ``the car ahead overshoots the line``.

    A noun would not stand there with an ending and an object of its own.

    Args:
        token: a word that no phrase of the lexicon holds.
        previous: the term before it.
        tokens: the tokens of the text.
    """
    if not token.low.endswith("s") or token.low.endswith(("ss", "ings", "us")):
        return False
    k = tokens.index(token)
    before = tokens[k - 2].low if k > 1 else ""
    sided = previous.cat == "dir" and previous.value in {"left", "right"} and before == "the"
    after = tokens[k + 1].low if k + 1 < len(tokens) else ""
    governs = after in {
        "the",
        "a",
        "an",
        "its",
        "their",
        "his",
        "her",
        "to",
        "and",
        "from",
    } | word_list("particles_across")
    return sided or (previous.cat in {"place", "locus", "compass"} and governs)


def suffix_form(token: Token) -> str | None:
    """The inflection that the ending of an unknown word shows.

    Args:
        token: the word.
    """
    endings = (("ing", "ing"), ("ed", "ed"), ("s", "s"))
    return next((form for ending, form in endings if token.low.endswith(ending)), None)

"""Little words at the edge of a phrase: what they belong to, and what they only look like."""

from __future__ import annotations

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Match, Term, longest_match
from scegen.understanding.words.tokens import Token

_TURN_REACH = 6
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
    located = located or (i + 2 < len(tokens) and tokens[i + 1].low == "at" and _me(tokens[i + 2]))
    return located and not previous.value.endswith("turn") and previous.cat != "det"


def _me(token: Token) -> bool:
    return token.low in {"me", "us", "him", "her", "them", "it"}


def then_a_side(tokens: list[Token], match: Match) -> bool:
    """Whether a phrase ends in "from" and a side comes next: "from" belongs to the side.

    Args:
        tokens: the tokens of the text.
        match: the phrase.
    """
    if tokens[match.j - 1].low != "from" or match.j + 1 >= len(tokens):
        return False
    across = match.j > 1 and tokens[match.j - 2].low == "across"
    if across and tokens[match.j].low in {"behind", "between"}:
        return True  # "tears across from behind a bus"
    if not match.only("locus"):
        return False
    side = longest_match(tokens, match.j + 1)
    return tokens[match.j].low in word_list("its") and side is not None and side.has("dir")


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
    noun = longest_match(tokens, match.j)
    lamps = noun is not None and noun.has("possessive") and match.only("verb")
    if lamps and all(e.value == "inert" for e in match.entries):
        return False  # "turns on its lights"
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
    if value == "lane_change":  # "slides over the wet road"
        return opened and not (noun is not None and noun.get("place").value == "lane")
    return value in {"collide", "lose_control"} and noun is not None and noun.has("place")


def in_front(tokens: list[Token], match: Match) -> bool:
    """Whether "in" at the end of a verb belongs to "in front of" as well.

    Args:
        tokens: the tokens of the text.
        match: the verb.
    """
    if tokens[match.j - 1].low != "in":
        return False
    return [t.low for t in tokens[match.j : match.j + 2]] == ["front", "of"]


def sends_back(tokens: list[Token], terms: list[Term], i: int) -> bool:
    """``forces it back into its lane``: an adverb, although "back into" is a verb.

    Such a verb would need a plural subject, an auxiliary or "to" before it.

    Args:
        tokens: the tokens of the text.
        terms: the terms before it.
        i: index of a token.
    """
    if tokens[i].low != "back" or not terms:
        return False
    previous = terms[-1]
    single = previous.cat == "actor" and previous.form == "base"
    single = single or (previous.cat == "pronoun" and previous.value in {"it", "him"})
    let = len(terms) > 1 and any(
        tokens[t.i].forms[-1][0] in word_list("letting") for t in terms[-4:-1] if t.cat == "verb"
    )
    return single and not let


def measured(tokens: list[Token], terms: list[Term], noun: Term) -> bool:
    """``the car two vehicles ahead``: how far, not who.

    Args:
        tokens: the tokens of the text.
        terms: the terms before the noun.
        noun: a term.
    """
    if noun.cat != "actor" or noun.form != "s" or len(terms) < 2 or noun.j >= len(tokens):
        return False
    counted, before = terms[-1].cat == "num", terms[-2]
    where = longest_match(tokens, noun.j)
    along = where is not None and where.has("locus")
    placed = before.cat == "actor" and before.form == "base"
    placed = placed or (before.cat, before.value) == ("aux", "be")
    return counted and along and placed


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


def a_drive(tokens: list[Token], i: int) -> bool:
    """``backs out of a drive``: where a house is reached from the road.

    Args:
        tokens: the tokens of the text.
        i: index of a token.
    """
    whose, before = (tokens[k].low if k >= 0 else "" for k in (i - 1, i - 2))
    owned = whose in {"a", "the", "his", "her", "my", "our", "its", "their"}
    return tokens[i].low == "drive" and owned and before in {"of", "from", "into", "onto"}


def no_way(tokens: list[Token], i: int, match: Match) -> bool:
    """``against the traffic rules``, ``turns left against oncoming traffic``: on no wrong side.

    Args:
        tokens: the tokens of the text.
        i: index of the first word.
        match: the phrase.
    """
    if tokens[i].low != "against" or not match.only("manner"):
        return False
    j = match.j
    rules = j < len(tokens) and tokens[j].low in word_list("rules")
    begin = max((k for k in range(i) if tokens[k].kind == "punct"), default=-1)
    near = tokens[max(begin + 1, i - _TURN_REACH) : i]
    words = {w for t in near for w in (t.low, t.forms[-1][0])}
    turns = "turn" in words and bool(words & {"left", "right"})
    return rules or turns


def lane_then_verb(tokens: list[Token], match: Match, previous: Term | None) -> bool:
    """``a van in the left lane changes lanes``: no lane changes in the plural.

    Args:
        tokens: the tokens of the text.
        match: a phrase.
        previous: the term before it.
    """
    if match.form != "s" or previous is None or previous.cat not in {"dir", "det", "compass"}:
        return False
    if not match.has("verb") or match.get("verb").value != "lane_change":
        return False
    after = tokens[match.j].low if match.j < len(tokens) else ""
    return tokens[match.j - 1].low == "changes" and after in {"lane", "lanes", "to", "into", "onto"}


def of_so_much(tokens: list[Token], match: Match) -> bool:
    """``at speeds of 10 to 80 km/h``: how fast is said by the number alone.

    Args:
        tokens: the tokens of the text.
        match: a phrase of manner.
    """
    if match.j < 2 or tokens[match.j - 1].low not in {"speed", "speeds"}:
        return False
    after = tokens[match.j].low if match.j < len(tokens) else ""
    return tokens[match.j - 2].low == "at" and after in word_list("measuring")


def suffix_form(token: Token) -> str | None:
    """The inflection that the ending of an unknown word shows.

    Args:
        token: the word.
    """
    endings = (("ing", "ing"), ("ed", "ed"), ("s", "s"))
    return next((form for ending, form in endings if token.low.endswith(ending)), None)

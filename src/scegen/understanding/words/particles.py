"""Little words at the edge of a phrase, and phrases around a name: what belongs to what."""

from dataclasses import replace

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Match, Term, begins, longest_match
from scegen.understanding.words.tokens import Token, low_at

_GIVES = frozenset({"dir", "verb"})
_OPENS_A_NOUN = ("det", "possessive", "actor", "compass", "place")


def just_right(tokens: list[Token], i: int, previous: Term) -> bool:
    """``right behind``, ``right past``, ``right in front of``: no way, except after a turn."""
    if tokens[i].low != "right" or previous.cat in {"", "det"}:
        return False
    particle = low_at(tokens, i + 1) in word_list("particles") and previous.cat == "verb"
    located = particle or begins(tokens, i + 1, "locus")
    return located and not previous.value.endswith("turn")


def then_a_noun(tokens: list[Token], match: Match) -> bool:
    """``straight on the main road``: "on" belongs to the road, unlike in "straight on at"."""
    after = low_at(tokens, match.j)
    if [t.low for t in tokens[match.j - 1 : match.j + 2]] == ["in", "front", "of"]:
        return True  # "swings back in front of the ego"
    if after == "of":
        return all(e.cat == "manner" and e.value == "row" for e in match.entries)
    if tokens[match.j - 1].low == "across" and any(e.value == "encounter" for e in match.entries):
        # "comes across the median"
        return _named_at(tokens, match.j, ("place",), ("actor", "thing"))
    if tokens[match.j - 1].low not in {"on", "through"}:
        return False
    if match.only("verb") and match.entries[0].value == "approach":
        return _named_at(tokens, match.j, ("dir",), ("place", "thing"))  # "comes up on its left"
    if not all(e.cat in _GIVES and e.value in {"straight", "move", "inert"} for e in match.entries):
        return False
    if after in word_list("each"):
        return True  # "drive on either side"
    noun = longest_match(tokens, match.j)
    if noun is not None and noun.has("possessive") and match.only("verb"):
        return all(e.value != "inert" for e in match.entries)  # "turns on its lights"
    return noun is not None and noun.has(*_OPENS_A_NOUN)


def _named_at(
    tokens: list[Token], j: int, wanted: tuple[str, ...], others: tuple[str, ...]
) -> bool:
    """Whether a noun of a class is named at token ``j``, articles and the like skipped."""
    for _ in range(4):
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
    bare = match.form == "ed" and not begins(tokens, match.j, "det", "possessive")
    return bare or not _named_at(tokens, match.j, ("thing",), ("actor", "place"))


def over_a_place(tokens: list[Token], match: Match) -> bool:
    """``runs over the crosswalk``: nothing is run over; ``squeezes in front of the bus``."""
    ends = tokens[match.j - 1].low
    if ends != "over" or not match.only("verb"):
        return False
    noun = longest_match(tokens, match.j)
    j = noun.j if noun is not None and noun.has("det", "possessive") else match.j
    return match.get("verb").value in {"collide", "lose_control"} and begins(tokens, j, "place")


def suffix_form(token: Token) -> str | None:
    """The inflection that the ending of an unknown word shows."""
    return next((ending for ending in ("ing", "ed", "s") if token.low.endswith(ending)), None)


def after_a_phrase(token: Token, previous: Term, tokens: list[Token]) -> bool:
    """``a bus from the left asserts its priority``, ``the car ahead overshoots the line``.

    A noun would not stand there with an ending and an object of its own.
    """
    if not token.low.endswith("s") or token.low.endswith(("ss", "ings", "us")):
        return False
    k = tokens.index(token)
    sided = previous.cat == "dir" and previous.value in {"left", "right"}
    sided = sided and low_at(tokens, k - 2) in word_list("its")
    after = low_at(tokens, k + 1)
    governs = begins(tokens, k + 1, "det", "possessive") or after in word_list("governed")
    return sided or (previous.cat in {"place", "locus", "compass"} and governs)


_FARTHEST = 8
GENITIVES = frozenset({"'s", "'"})


def around_somebody(tokens: list[Token], term: Term) -> tuple[Term, int, int] | None:
    """The verb before a name, and from where to where the phrase goes on behind the name."""
    if term.cat not in {"verb", "prep", "locus", "unknown"}:
        return None
    for end in range(term.i + 2, min(term.i + _FARTHEST, len(tokens))):
        if tokens[end].kind == "punct":
            return None
        if tokens[end].low in GENITIVES:
            break
    else:
        return None
    its = replace(tokens[end], text="its", low="its", kind="word", forms=(("its", "base"),))
    owned = longest_match(tokens, end + 1) if end + 1 < len(tokens) else None
    if owned is None or (owned.has("place") and owned.get("place").value != "flank"):
        return None  # "leaves the van's lane" reads as it stands
    for opening in range(term.i + 1, end - 1):
        if tokens[opening].low not in word_list("whose"):
            continue
        match = longest_match([*tokens[:opening], its, *tokens[end + 1 :]], term.i)
        if match is not None and match.j > opening + 1 and match.has("verb"):
            entry = match.get("verb")
            form = "ing" if "predicate" in entry.data else match.form
            verb = Term("verb", entry.value, term.i, opening, form, entry.data)
            return verb, end, match.j + end - opening
    return None

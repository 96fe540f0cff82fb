"""Terms: tokens grouped into phrases of the lexicon, with ambiguous words decided by context."""

from __future__ import annotations

import re
from dataclasses import replace

from scegen.understanding.lexicon import Entry
from scegen.understanding.numbers import number_at
from scegen.understanding.quantities import quantity_at
from scegen.understanding.terms import Match, Term, longest_match
from scegen.understanding.tokens import Token

_LABELLED = re.compile(r"^(?:v|veh|u|d|car|cv)\d{1,2}$")
_NOMINAL_BEFORE = frozenset(
    {"det", "possessive", "dir", "manner", "num", "quant", "label", "noted", "shape"}
)
_NO_PREMODIFIER = frozenset({"aux", "actor", "pronoun", "neg"})
_UNIT_WORDS = frozenset({"unit", "veh", "v"})
_VERBAL_BEFORE = frozenset({"actor", "pronoun", "aux", "rel", "neg"})
_ADJECTIVE_CATS = ("dir", "state", "manner", "label", "control")


def _noun_follows(tokens: list[Token], j: int) -> bool:
    """Whether a participant or thing is named at token ``j``, adjectives skipped."""
    for _ in range(3):
        if j >= len(tokens):
            return False
        following = longest_match(tokens, j)
        if following is None:
            return False
        if following.has("actor", "thing"):
            return True
        if not following.has("state", "label", "dir", "manner", "verb") or following.has("prep"):
            return following.has("view")
        if following.has("verb") and following.form not in {"ing", "ed"}:
            return False
        j = following.j
    return False


def _is_adverb(token: Token) -> bool:
    return token.low.endswith("ly")


def _may_describe(previous: Term | None) -> bool:
    """Whether a participle here can describe the noun that follows.

    After a subject or a comma it is a verb: "a van overtaking cars", "…, overtaking cars".
    """
    if previous is None:
        return True
    return previous.cat not in _NO_PREMODIFIER and previous.value != ","


def _verb_or_other(match: Match, tokens: list[Token], previous: Term | None) -> tuple[Entry, bool]:
    """Decides between a verb and the other meanings of its form; says if it is a premodifier."""
    before = previous.cat if previous else ""
    verb = match.get("verb")
    participle = match.form in {"ing", "ed"}
    attributive = _may_describe(previous) and _noun_follows(tokens, match.j)
    if participle and before in {"conj", "sub"} and match.has("dir"):
        attributive = False  # "turning left and following vehicle B": no article, no adjective
    if match.has("place", "dir") and match.get("place").value == "junction":
        shaped = before in {"shape", "control", "det"} and not attributive
        return (match.get("place") if shaped else _without_place(match, attributive)), attributive
    if match.has("dir") and match.get("dir").value == "left":
        return _left(match, previous)
    if match.form == "base" and before == "aux" and previous is not None and previous.value == "be":
        return match.get(*_ADJECTIVE_CATS, "verb"), False
    if participle and attributive:
        return (match.get(*_ADJECTIVE_CATS) if match.has(*_ADJECTIVE_CATS) else verb), True
    if match.has("dir", "state", "manner") and attributive and not participle:
        return match.get("dir", "state", "manner"), True
    nouns = ("place", "inert", "thing", "view", "env")
    preposed = before == "prep" and previous is not None and previous.value != "to"
    adverb = before == "manner" and previous is not None and _is_adverb(tokens[previous.j - 1])
    compound = before == "place" and match.form == "base" and match.has("inert")
    noun_slot = (before in _NOMINAL_BEFORE and not adverb) or preposed or compound
    one = before == "num" and previous is not None and previous.data.get("number") == 1
    if one and match.form == "s":
        return verb, False  # "one exits": of one thing there is no plural
    if match.has(*nouns) and noun_slot and match.form in {"base", "s"}:
        return match.get(*nouns), False
    controlled = previous is not None and before == "verb" and "control" in previous.data
    controlled = controlled and previous is not None and previous.value != "unknown"
    verbal = (
        controlled or before in _VERBAL_BEFORE or (previous is not None and previous.value == "to")
    )
    if match.has("dir") and not verbal and match.form == "base":
        return match.get("dir"), False
    return verb, False


def _without_place(match: Match, attributive: bool) -> Entry:
    """``crossing`` describes a vehicle or is what somebody does, unless it is a shaped one."""
    return match.get("dir" if attributive else "verb")


def _left(match: Match, previous: Term | None) -> tuple[Entry, bool]:
    """``left`` is nearly always the side; "V1 left the road" has a subject right before it."""
    subject = previous is not None and previous.cat in {"actor", "pronoun"}
    return (match.get("verb") if subject else match.get("dir")), False


_PRIORITY = (
    "noted", "cue", "control", "side", "env", "view", "actor", "possessive", "det", "pronoun",
    "aux", "neg", "sub", "conj", "quant", "dir", "locus", "state", "place", "prep", "manner",
    "rel", "shape", "leg", "compass", "thing", "label", "copy", "roadmod", "inert",
)  # fmt: skip


def _choose(match: Match, tokens: list[Token], previous: Term | None) -> tuple[Entry, bool]:
    if len(match.entries) == 1:
        entry = match.entries[0]
        premod = (
            entry.cat == "verb"
            and match.form in {"ing", "ed"}
            and _may_describe(previous)
            and _noun_follows(tokens, match.j)
        )
        return entry, premod
    if match.has("verb"):
        return _verb_or_other(match, tokens, previous)
    if match.has("rel") and match.has("det"):
        noun_before = previous is not None and previous.cat in {"actor", "place", "thing", "inert"}
        after = longest_match(tokens, match.j) if match.j < len(tokens) else None
        verbal = after is not None and (after.has("aux") or after.form in {"s", "ed"})
        sided = previous is not None and previous.cat in {"dir", "compass"}
        if sided and verbal and after is not None and not after.has("actor", "place"):
            return match.get("rel"), False  # "a bus from the right that turns"
        return match.get("rel" if noun_before else "det"), False
    if match.has("label") and match.has("place"):
        bare = match.j >= len(tokens) or longest_match(tokens, match.j) is None
        next_match = None if bare else longest_match(tokens, match.j)
        noun = next_match is not None and next_match.has("actor", "place", "label")
        return match.get("label" if noun else "place"), False
    if match.has("neg") and match.has("pronoun"):
        following = longest_match(tokens, match.j) if match.j < len(tokens) else None
        listed = following is not None and following.has("det", "actor", "possessive")
        return match.get("neg" if listed else "pronoun"), False
    if match.has("leg") and previous is not None and previous.cat == "num":
        return match.get("leg"), False
    if match.has("manner") and match.has("label") and previous and previous.cat == "det":
        return match.get("label"), False
    if match.has("det") and match.has("inert"):
        return match.get("det"), False
    return match.get(*_PRIORITY), False


def _labelled(token: Token, i: int) -> Term | None:
    """``V1``, ``car2``: a participant called by a short name."""
    if token.kind == "label" and _LABELLED.match(token.low):
        digits = token.low.lstrip("abcdefghijklmnopqrstuvwxyz")
        return Term("actor", "car", i, i + 1, "base", {"label": f"#{digits}"})
    return None


def _first_person(token: Token) -> bool:
    """``i`` is a person only as a capital letter on its own; "i.e." and "I-95" are not."""
    return token.low != "i" or token.text == "I"


def _own_form(entry: Entry, match: Match, token: Token) -> str:
    """``change lanes``: the plural of a noun inside does not inflect the verb."""
    if entry.cat == "verb" and match.form == "s" and all(form != "s" for _, form in token.forms):
        return "base"
    return match.form


def _verb_form(token: Token, previous: Term | None, tokens: list[Token]) -> str | None:
    """The form of a word that must be a verb by its place, although no rule knows it.

    "The ego commences a left turn" keeps its structure: who acts, and on what.
    """
    if token.kind != "word" or previous is None or len(token.low) < 4:
        return None
    infinitive = previous.cat == "prep" and previous.value == "to"
    if infinitive or previous.cat in {"aux", "neg"}:
        return _suffix_form(token) or "base"
    adverb = previous.cat == "manner" and _is_adverb(tokens[previous.j - 1])
    if previous.cat in {"actor", "pronoun"} or adverb:
        return _suffix_form(token)
    return None


def _suffix_form(token: Token) -> str | None:
    endings = (("ing", "ing"), ("ed", "ed"), ("s", "s"))
    return next((form for ending, form in endings if token.low.endswith(ending)), None)


def _is_clause(match: Match, tokens: list[Token], i: int, previous: Term | None) -> bool:
    """``the bus stops``: a singular noun with its verb, although "bus stop" is a word."""
    if match.j - i != 2 or match.form != "s" or not match.has("place"):
        return False
    alone = longest_match(tokens[: i + 1], i)
    singular = previous is not None and previous.cat == "det"
    rest = longest_match(tokens, i + 1)
    verbal = rest is not None and rest.has("verb")
    return singular and verbal and alone is not None and alone.has("actor")


def tag(tokens: list[Token]) -> list[Term]:
    """Terms that cover all tokens in order.

    Args:
        tokens: the tokens of the text.
    """
    terms: list[Term] = []
    i = 0
    while i < len(tokens):
        term = _term_at(tokens, i, _before(terms, tokens))
        if term.value == "crosswalk" and _list_of_doings(terms, tokens, term):
            term = _term_at(tokens[: i + 1], i, terms[-1])
        terms.append(term)
        i = terms[-1].j
    return _crossings(terms, tokens)


def _crossings(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """``at a crossing``: where people on foot are about, the place where they cross."""
    if not any(t.cat == "actor" and t.value == "pedestrian" for t in terms):
        return terms
    return [
        replace(t, value="crosswalk")
        if t.value == "junction" and t.j - t.i == 1 and tokens[t.i].low == "crossing"
        else t
        for t in terms
    ]


def _list_of_doings(terms: list[Term], tokens: list[Token], term: Term) -> bool:
    """``a van turning left and a pedestrian crossing``: not the place of that name."""
    if term.j - term.i != 2 or not tokens[term.j - 1].low.endswith("ing") or len(terms) < 3:
        return False
    counted = terms[-1].cat in {"det", "num"}
    road = longest_match(tokens, term.j) if term.j < len(tokens) else None
    if counted and road is not None and road.has("det"):
        return True  # "a pedestrian crossing the road"
    listed = counted and terms[-2].value in {"and", ","}
    return listed and any(t.cat == "verb" and t.form == "ing" for t in terms[-8:])


def _before(terms: list[Term], tokens: list[Token]) -> Term | None:
    """The term before; a number that names a vehicle ("vehicle 1") counts as the vehicle."""
    if len(terms) > 1 and terms[-1].cat == "num" and terms[-2].cat == "actor":
        return terms[-1] if tokens[terms[-2].i].text.endswith("s") else terms[-2]
    return terms[-1] if terms else None


def _just_right(tokens: list[Token], i: int, previous: Term | None) -> bool:
    """``right behind``, ``right in front of``: no direction, except after a turn."""
    if tokens[i].low != "right" or i + 1 >= len(tokens) or previous is None:
        return False
    following = longest_match(tokens, i + 1)
    located = following is not None and following.has("locus")
    return located and not previous.value.endswith("turn") and previous.cat != "det"


def _term_at(tokens: list[Token], i: int, previous: Term | None) -> Term:
    token = tokens[i]
    if token.kind == "punct":
        return Term("punct", token.low, i, i + 1)
    labelled = _labelled(token, i)
    if labelled:
        return labelled
    if _just_right(tokens, i, previous):
        return Term("manner", "mild", i, i + 1)
    quantity = quantity_at(tokens, i)
    if quantity:
        return Term("quantity", quantity.dimension, i, quantity.j, data={"quantity": quantity})
    if token.low in _UNIT_WORDS and i + 1 < len(tokens) and tokens[i + 1].kind == "number":
        return Term("actor", "car", i, i + 1)
    number = number_at(tokens, i)
    match = longest_match(tokens, i) if _first_person(token) else None
    if match and _is_clause(match, tokens, i, previous):
        match = longest_match(tokens[: i + 1], i)
    if match and (number is None or match.j > i + number.length):
        entry, premod = _choose(match, tokens, previous)
        form = _own_form(entry, match, token)
        return Term(entry.cat, entry.value, i, match.j, form, entry.data, premod)
    if number:
        return Term("num", token.low, i, i + number.length, data={"number": number.value})
    form = _verb_form(token, previous, tokens)
    if form is not None:
        return Term("verb", "unknown", i, i + 1, form, data={"control": "subject"})
    return Term("unknown", token.low, i, i + 1)

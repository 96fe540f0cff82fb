"""Terms whose class only the words before them tell: "leaves its stop", "doesn't brake"."""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.lane_numbers import number_of_a_lane
from scegen.understanding.words.noun_turns import names_a_turn
from scegen.understanding.words.other_classes import other_class
from scegen.understanding.words.paces import doing
from scegen.understanding.words.particles import measured
from scegen.understanding.words.quantities import quantity_at
from scegen.understanding.words.terms import Term, longest_match
from scegen.understanding.words.tokens import Token
from scegen.understanding.words.unnamed_roles import role_alone


def retag(term: Term, terms: list[Term], tokens: list[Token]) -> Term:
    """The term as the words before it would have it.

    Args:
        term: the term.
        terms: the terms before it; some are changed in its light.
        tokens: the tokens of the text.
    """
    if term.cat == "punct":
        return term
    term = _as_a_noun(other_class(term, terms, tokens), terms, tokens)
    term = _of_lights_and_times(term, tokens)
    if term.value == "genitive":
        term = _shortened(term, terms, tokens)
    term = number_of_a_lane(role_alone(term, terms, tokens), terms, tokens)
    if (term.cat, term.value, term.form) == ("verb", "approach", "s") and _counted(terms):
        term = Term("leg", "leg", term.i, term.j, "s")
    term = _in_place_of_a_noun(term, terms, tokens)
    if _does_not(tokens, term):
        term = replace(term, cat="aux", value="do")
    if terms and measured(tokens, terms, term):
        number = terms.pop()  # "the car two vehicles ahead"
        term = Term("quantity", "other", number.i, term.j, data={"quantity": None})
    if names_a_turn(term, terms, tokens):
        term = replace(term, cat="verb", value="turn", form="base", data={"way": term.value})
    term = _near_or_far(term, tokens)
    if (term.cat, term.value, term.form) == ("verb", "slow", "base"):
        opened = bool(terms) and terms[-1].cat in {"det", "possessive"}
        if (opened and _word_at(tokens, term.j)) or doing(tokens, term.i):
            term = replace(term, cat="manner", data={})  # "a slow convoy", "going really slow"
    if _speed(term) and doing(tokens, term.i):
        _as_motion(terms, tokens)
    if term.value == "straight" and terms and tokens[terms[-1].i].forms[-1][0] == "carry":
        terms[-1] = replace(terms[-1], value="move", data={})  # "carries straight on"
    return term


_SOON = 3
"""So many words may stand before an amount ("to less than 12 m")."""
_NEAR_OR_FAR = {"near": "near", "nearer": "near", "far": "far", "farther": "far", "further": "far"}


def _of_lights_and_times(term: Term, tokens: list[Token]) -> Term:
    if _changes_colour(tokens, term) or _comes_down(tokens, term):
        return replace(term, value="inert", data={})
    return Term("inert", "noun", term.i, term.j) if _moment(tokens, term) else term


def _changes_colour(tokens: list[Token], term: Term) -> bool:
    """``when it turns green``: the light does."""
    lit = (term.cat, term.value) == ("verb", "turn") and term.j < len(tokens)
    return lit and tokens[term.j].low in word_list("colours")


def _comes_down(tokens: list[Token], term: Term) -> bool:
    """``when the gap to the car ahead drops to 12 m``: what is measured does, not who is named."""
    if (term.cat, term.value) != ("verb", "slow") or tokens[term.j - 1].low != "to":
        return False
    after = (quantity_at(tokens, k) for k in range(term.j, min(term.j + _SOON, len(tokens))))
    amount = next((q for q in after if q is not None), None)
    return amount is not None and amount.dimension in {"length", "time"}


def _word_at(tokens: list[Token], j: int) -> bool:
    """Whether a word that may be a noun stands there."""
    if j >= len(tokens) or tokens[j].kind != "word":
        return False
    found = longest_match(tokens, j)
    return found is None or not found.has("prep", "conj", "aux", "sub", "locus")


def _as_a_noun(term: Term, terms: list[Term], tokens: list[Token]) -> Term:
    if (term.cat, term.value, term.form) == ("verb", "stop", "base") and _at_a(terms, tokens):
        # "pulls away from the stop"
        return Term("place", "bus_stop", term.i, term.j, data={"stands_on": "bus_stop"})
    if (term.cat, term.value) == ("verb", "yield") and _a_noun(terms, tokens, term):
        return Term("place", "yield_sign", term.i, term.j, data={"control": "yield"})
    own = bool(terms) and tokens[terms[-1].i].low in word_list("somebodys")
    if (term.cat, term.value) == ("place", "shoulder") and own:
        return Term("inert", "noun", term.i, term.j)  # "looks over his shoulder"
    let = bool(terms) and tokens[terms[-1].i].forms[-1][0] in {"let", "make"}
    her = (term.cat, tokens[term.i].low) == ("possessive", "her")
    if her and (_alone(tokens, term.j) or let):
        return Term("pronoun", "him", term.i, term.j)  # "stops for her"
    return term


def _in_place_of_a_noun(term: Term, terms: list[Term], tokens: list[Token]) -> Term:
    """``gets cut off by a van``: is; ``when that brakes``: it."""
    if _gets(terms, tokens, term):
        terms[-1] = replace(terms[-1], cat="aux", value="be", data={})
    that = term.cat in {"rel", "det"} and tokens[term.i].low == "that"
    if not (that and terms and terms[-1].cat == "sub" and term.j < len(tokens)):
        return term
    acts = longest_match(tokens, term.j)
    verbal = acts is not None and acts.form == "s" and acts.has("verb")
    return Term("pronoun", "it", term.i, term.j) if verbal else term


def _gets(terms: list[Term], tokens: list[Token], term: Term) -> bool:
    """``gets cut off by a van``: is."""
    get = bool(terms) and terms[-1].cat == "verb" and tokens[terms[-1].i].forms[-1][0] == "get"
    if not get or term.cat != "verb" or terms[-1].j - terms[-1].i != 1:
        return False
    by = "by" in [t.low for t in tokens[term.j : term.j + 2]]
    return by or (term.value == "collide" and (term.form == "ed" or tokens[term.i].low == "hit"))


def _moment(tokens: list[Token], term: Term) -> bool:
    """``only a second to stop``, ``half a second later``: a time, nobody."""
    if term.j - term.i != 2 or [t.low for t in tokens[term.i : term.j]] != ["a", "second"]:
        return False
    before = tokens[term.i - 1].low if term.i else ""
    after = tokens[term.j].low if term.j < len(tokens) else ""
    return before in word_list("short") or after in {"later", "ago", "before", "after"}


def _has_done(tokens: list[Token], term: Term) -> bool:
    """``someone's left a van there``: has left, nothing of theirs."""
    done, after = (tokens[k].low if k < len(tokens) else "" for k in (term.j, term.j + 1))
    return done in word_list("done") and after in word_list("after")


def _governed(terms: list[Term]) -> bool:
    """``from the ego's left at the bend``: what a preposition governs has no verb of its own."""
    k = len(terms) - 1
    while k >= 0 and terms[k].cat in {"actor", "det", "label", "possessive", "pronoun"}:
        k -= 1
    return k >= 0 and terms[k].cat == "prep"


def _near_or_far(term: Term, tokens: list[Token]) -> Term:
    """``the far kerb``: the side across the road."""
    value = _NEAR_OR_FAR.get(tokens[term.i].low) if term.j - term.i == 1 else None
    if value is None or term.j >= len(tokens) or tokens[term.j].low not in word_list("kerbs"):
        return term
    return Term("dir", value, term.i, term.j)


def _shortened(term: Term, terms: list[Term], tokens: list[Token]) -> Term:
    """``someone's left a van there``, ``the ego, who's forced to brake``: has, is."""
    if _has_done(tokens, term) and not _governed(terms):
        return replace(term, cat="aux", value="have")
    word = tokens[terms[-1].i].low if terms else ""
    short = word in {"it", "he", "she", "there", "here", "what", "that"}
    if short or (terms and terms[-1].cat == "rel"):
        return replace(term, cat="aux", value="be")
    return term


def _does_not(tokens: list[Token], term: Term) -> bool:
    """``doesn't even brake``: no doing of its own."""
    if term.cat != "verb" or tokens[term.i].forms[-1][0] != "do" or term.j >= len(tokens):
        return False
    return tokens[term.j].kind == "neg" or tokens[term.j].low == "not"


def _as_motion(terms: list[Term], tokens: list[Token]) -> None:
    """``doing about fifty``: driving."""
    k = next((k for k in range(len(terms) - 1, -1, -1) if terms[k].cat == "verb"), None)
    if k is not None and tokens[terms[k].i].forms[-1][0] == "do":
        terms[k] = replace(terms[k], value="move", data={"drives": True})


def _speed(term: Term) -> bool:
    """Whether a term says how fast: "50 mph", "40 in a 30", or a bare number after "doing"."""
    return term.cat in {"quantity", "num"} or (
        term.cat == "manner" and term.value in {"fast", "slow"}
    )


def _counted(terms: list[Term]) -> bool:
    """``with five approaches``, ``the three approaches``: roads, no doing."""
    if len(terms) < 2 or terms[-1].cat not in {"num", "quant"}:
        return False
    number = terms[-1].data.get("number", 0) if terms[-1].cat == "num" else 2
    opened = terms[-2].cat in {"prep", "det"} or terms[-2].value in {"have", ",", "be"}
    return number > 1 and opened


def _at_a(terms: list[Term], tokens: list[Token]) -> bool:
    """Whether "at the" or "from a" stands before."""
    if len(terms) < 2 or terms[-1].cat not in {"det", "possessive"}:
        return False
    if terms[-1].cat == "possessive" and terms[-2].value in {"leave", "approach", "pull_out"}:
        return True  # "leaves its stop"
    return tokens[terms[-2].i].low in {"at", "from"}


def _alone(tokens: list[Token], j: int) -> bool:
    """Whether no noun follows that a possessive could belong to."""
    if j >= len(tokens) or tokens[j].kind == "punct":
        return True
    following = longest_match(tokens, j)
    return following is not None and following.only("prep", "conj", "sub", "locus", "aux")


def _a_noun(terms: list[Term], tokens: list[Token], term: Term) -> bool:
    """``through the give way``: the sign."""
    after = tokens[term.j].kind if term.j < len(tokens) else "punct"
    return bool(terms) and terms[-1].cat == "det" and after == "punct"

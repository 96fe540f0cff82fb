"""Terms: tokens grouped into phrases of the lexicon, with ambiguous words decided by context."""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.lexicon import Entry, word_list
from scegen.understanding.words.choosing import choose, is_adverb
from scegen.understanding.words.collectives import gather
from scegen.understanding.words.labels import named_at
from scegen.understanding.words.lettered import name_letters
from scegen.understanding.words.nominal import ORDINALS
from scegen.understanding.words.numbers import number_at
from scegen.understanding.words.paces import bare_speed, pace_at, speed_at
from scegen.understanding.words.particles import (
    a_drive,
    after_a_phrase,
    in_front,
    just_right,
    lane_then_verb,
    no_way,
    nothing_shed,
    of_so_much,
    over_a_place,
    sends_back,
    suffix_form,
    then_a_noun,
    then_a_side,
)
from scegen.understanding.words.passages import from_side_to_side
from scegen.understanding.words.quantities import quantity_at
from scegen.understanding.words.retagging import retag
from scegen.understanding.words.somebodys import around_somebody
from scegen.understanding.words.terms import Match, Term, longest_match
from scegen.understanding.words.tokens import Token
from scegen.understanding.words.unnamed_roles import with_articles

_NOUNS = ("actor", "place", "thing", "inert")
_CROSSED = frozenset({"access", "road", "lane", "path", "highway", "crosswalk", "exit", "leg"})
_STEERED = frozenset({"driven", "ridden"})


def _first_person(tokens: list[Token], i: int) -> bool:
    """``i`` is a person as a capital letter or before a verb; "i.e.", "I-95", "US" are not."""
    token = tokens[i]
    if token.text == "US":
        return False
    if token.low != "i" or token.text == "I":
        return True
    following = longest_match(tokens, i + 1)
    return following is not None and following.has("aux", "verb", "neg", "manner")


def _own_form(entry: Entry, match: Match, tokens: list[Token], i: int) -> str:
    """``change lanes``: a noun's plural does not inflect the verb; but "it rear-ends the ego"."""
    if entry.cat != "verb" or match.form != "s" or any(f == "s" for _, f in tokens[i].forms):
        return match.form
    alone = longest_match(tokens, i, i + 1)
    return "base" if alone is None or alone.has("verb") else match.form


def _verb_form(token: Token, previous: Term | None, tokens: list[Token]) -> str | None:
    """The form of a word that must be a verb by its place, although no rule knows it.

    "The ego commences a left turn" keeps its structure: who acts, and on what.
    """
    if token.kind != "word" or previous is None or len(token.low) < 4:
        return None
    infinitive = previous.cat == "prep" and previous.value == "to"
    if infinitive or previous.cat in {"aux", "neg"}:
        return suffix_form(token) or "base"
    adverb = previous.cat == "manner" and is_adverb(tokens[previous.j - 1])
    helped = (
        previous.cat == "manner"
        and previous.i > 0
        and tokens[previous.i - 1].low in word_list("helps")
    )
    adverb = adverb or (helped and token.low.endswith(("ed", "ing")))  # "is then startled by"
    one = previous.cat == "num" and previous.value == "one" and token.low.endswith("es")
    if previous.cat in {"actor", "pronoun", "rel"} or adverb or one:
        return suffix_form(token)
    if after_a_phrase(token, previous, tokens):
        return "s"
    return None


def _is_clause(match: Match, tokens: list[Token], i: int, previous: Term | None) -> bool:
    """``the bus stops``: a singular noun with its verb, although "bus stop" is a word."""
    if match.j - i != 2 or match.form != "s" or not match.only(*_NOUNS):
        return False
    alone = longest_match(tokens, i, i + 1)
    singular = previous is not None and previous.cat in {"det", "dir", "label"}
    known = any(t.low == tokens[i].low for t in tokens[:i])  # "ego follows a bus; bus stops"
    singular = singular or (known and (previous is None or previous.cat in {"punct", "conj"}))
    singular = singular or (i > 0 and tokens[i - 1].low in ORDINALS)
    opens = previous is None or previous.cat in {"punct", "conj", "sub"}
    singular = singular or (opens and _is_done(tokens, match.j))
    rest = longest_match(tokens, i + 1)
    verbal = rest is not None and rest.has("verb")
    return singular and verbal and alone is not None and alone.has("actor")


def _is_done(tokens: list[Token], j: int) -> bool:
    """``bus stops with 3 m/s²``, ``bus stops ahead of the ego``: how, or where somebody does it."""
    rate = quantity_at(tokens, j + 1) if j + 1 < len(tokens) else None
    if tokens[j : j + 1] and tokens[j].low in {"with", "at"} and rate is not None:
        return rate.dimension == "acceleration"
    following = longest_match(tokens, j)
    if following is None or not following.has("manner", "locus"):
        return False
    k = following.j
    while k < len(tokens) and tokens[k].kind != "punct":
        verb = longest_match(tokens, k)
        if verb is not None and verb.has("aux", "verb") and not verb.has(*_NOUNS, "dir"):
            return False  # "bus stops ahead are empty"
        k = verb.j if verb is not None else k + 1
    return True


def tag(tokens: list[Token]) -> list[Term]:
    """Terms that cover all tokens in order."""
    terms: list[Term] = []
    i = 0
    tails: dict[int, int] = {}
    while i < len(tokens):
        if i in tails:
            terms.append(Term("inert", "noun", i, tails[i]))
            i = tails[i]
            continue
        term = _term_at(tokens, i, _before(terms, tokens))
        if term.value == "crosswalk" and _list_of_doings(terms, tokens, term):
            term = _term_at(tokens[: i + 1], i, _before(terms, tokens))
        if term.cat == "verb" and sends_back(tokens, terms, i):
            term = Term("manner", "mild", i, i + 1)
        held = around_somebody(tokens, term)
        if held is not None:
            term, tail, end = held
            tails[tail] = end
        term = retag(term, terms, tokens)
        terms.append(term)
        i = terms[-1].j
    crossed = _crossings(gather(from_side_to_side(terms), tokens), tokens)
    return with_articles(name_letters(crossed, tokens), tokens)


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
    if term.j - term.i != 2 or not tokens[term.j - 1].low.endswith("ing"):
        return False
    walker = longest_match(tokens, term.i, term.i + 1)
    if walker is None or not walker.has("actor"):
        return False  # "the zebra crossing that …"
    if _crossed(tokens, term.j):
        return True
    if len(terms) < 3:
        return False
    counted = terms[-1].cat in {"det", "num"}
    road = longest_match(tokens, term.j)
    if counted and road is not None and road.has("det"):
        return True  # "a pedestrian crossing the road"
    listed = counted and terms[-2].value in {"and", ","}
    return listed and any(t.cat == "verb" and t.form == "ing" for t in terms[-8:])


def _crossed(tokens: list[Token], j: int) -> bool:
    """``pedestrian crossing from the left``, ``… the road``, ``… in front of the ego``."""
    if j >= len(tokens):
        return False
    if tokens[j].low in {"from", "against", "into"}:
        return True
    speed = quantity_at(tokens, j + 1) if tokens[j].low == "at" and j + 1 < len(tokens) else None
    if speed is not None and speed.dimension == "speed":
        return True
    following = longest_match(tokens, j)
    if following is None:
        return False
    if following.has("det", "possessive"):
        noun = longest_match(tokens, following.j)
        return noun is not None and any(e.value in _CROSSED for e in noun.entries)
    return following.has("locus") and following.get("locus").value in {"ahead", "behind"}


def _before(terms: list[Term], tokens: list[Token]) -> Term | None:
    """The term before; a number that names a vehicle ("vehicle 1") counts as the vehicle."""
    if len(terms) > 1 and terms[-1].cat == "num" and terms[-2].cat == "actor":
        return terms[-1] if tokens[terms[-2].i].text.endswith("s") else terms[-2]
    return terms[-1] if terms else None


def _turning(previous: Term | None) -> bool:
    return previous is not None and previous.cat in {"verb", "prep", "det", "possessive"}


def _needs_infinitive(tokens: list[Token], match: Match) -> bool:
    """``continues to the third exit``: "to" leads to a place, not to another verb."""
    if tokens[match.j - 1].low != "to" or match.j >= len(tokens):
        return False
    following = longest_match(tokens, match.j)
    return following is None or not following.has("verb", "neg", "manner")


def _cut(match: Match, tokens: list[Token], i: int) -> int | None:
    """Where a phrase ends that has a word too many; None if it has not."""
    if no_way(tokens, i, match) or (match.j > i + 1 and a_drive(tokens, i)):
        return i + 1
    if match.only("side") and _is_beside(tokens, i, match.j):
        return i + 1
    if then_a_side(tokens, match) or of_so_much(tokens, match):
        return match.j - 1  # "darts across from the left"
    return None


def _is_beside(tokens: list[Token], i: int, j: int) -> bool:
    """``a bus drives on the right of the ego``: where one is, no rule of the road."""
    after = [t.low for t in tokens[j : j + 3]]
    somebody = after[:1] == ["of"] and not {"road", "street", "highway"} & set(after)
    all_do = i > 0 and tokens[i - 1].low in {"traffic", "everybody", "everyone", "one"}
    return (tokens[i].low in {"drives", "drove"} and not all_do) or somebody


def _match_at(tokens: list[Token], i: int, previous: Term | None) -> Match | None:
    """The phrase at a token, cut down where its words are no phrase here."""
    token = tokens[i]
    match = longest_match(tokens, i)
    if match and match.form in {"ed", "ing"} and match.only("actor", "pronoun", "possessive"):
        return None  # nouns are not inflected so
    if match and token.low in _STEERED and tokens[match.j - 1].low == "by":
        match = longest_match(tokens, i, i + 1)  # "driven by a student"
    if match and _is_clause(match, tokens, i, previous):
        match = longest_match(tokens, i, i + 1)
    if match and token.low == "right" and match.only("sub") and _turning(previous):
        match = longest_match(tokens, i, i + 1)  # "turns right when …"
    cut_at = _cut(match, tokens, i) if match else None
    if cut_at is not None:
        match = longest_match(tokens, i, cut_at)
    if match and match.j > i + 1 and (then_a_noun(tokens, match) or over_a_place(tokens, match)):
        match = longest_match(tokens, i, match.j - 1)
    if match and match.only("verb") and in_front(tokens, match):
        match = replace(match, j=match.j + 2)  # "forces its way in front of"
    if match and match.j > i + 1 and match.only("verb", "aux") and _needs_infinitive(tokens, match):
        match = longest_match(tokens, i, match.j - 1) or match
    if match and lane_then_verb(tokens, match, previous):
        match = longest_match(tokens, i, match.j - 1)  # "in the left lane changes to"
    compound = match is not None and match.j > i + 1 and match.only(*_NOUNS)
    if compound and any(form == "s" for _, form in token.forms):
        match = longest_match(tokens, i, i + 1)  # "two pedestrians crossing", no crossing
    if match and match.j > i + 1 and match.form in {"ed", "ing"} and match.only(*_NOUNS):
        match = longest_match(tokens, i, match.j - 1)  # "a car parked", no car park
    verbal = match is not None and match.form in {"ed", "ing"} and match.only("thing", "actor")
    no_verb = match is not None and nothing_shed(tokens, match)
    return None if verbal or no_verb else match  # "boxed in"


def _term_at(tokens: list[Token], i: int, previous: Term | None) -> Term:
    token = tokens[i]
    if token.kind == "punct":
        return Term("punct", token.low, i, i + 1)
    named = named_at(tokens, i)
    if named:
        return named
    if just_right(tokens, i, previous):
        return Term("manner", "mild", i, i + 1)
    pace = pace_at(tokens, i) or speed_at(tokens, i)
    if pace is not None:
        return pace
    quantity = quantity_at(tokens, i) or bare_speed(tokens, i)
    if quantity:
        return Term("quantity", quantity.dimension, i, quantity.j, data={"quantity": quantity})
    numbered = i + 1 < len(tokens) and tokens[i + 1].kind == "number"
    if token.low in word_list("unit_words") and numbered and quantity_at(tokens, i + 1) is None:
        return Term("actor", "car", i, i + 1)
    number = number_at(tokens, i)
    match = _match_at(tokens, i, previous) if _first_person(tokens, i) else None
    counted = number is not None and match is not None and match.has("shape", "label")
    counted = counted and match is not None and match.form == "s"
    if match and not counted and (number is None or match.j > i + number.length):
        entry, premod = choose(match, tokens, previous)
        form = _own_form(entry, match, tokens, i)
        predicate = token.low == "about" or "predicate" in entry.data
        if predicate and entry.cat == "verb" and (not previous or previous.cat != "aux"):
            form = "ing"  # "children about to cross": describes them
        return Term(entry.cat, entry.value, i, match.j, form, entry.data, premod)
    if number:
        return Term("num", token.low, i, i + number.length, data={"number": number.value})
    unknown = _verb_form(token, previous, tokens)
    if unknown is not None:
        return Term("verb", "unknown", i, i + 1, unknown, data={"control": "subject"})
    return Term("unknown", token.low, i, i + 1)

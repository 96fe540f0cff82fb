"""Terms: tokens grouped into phrases of the lexicon, with ambiguous words decided by context."""

from dataclasses import replace
from functools import lru_cache

from scegen.understanding.lexicon import Entry, word_list
from scegen.understanding.words.choosing import choose, is_adverb
from scegen.understanding.words.contexts import retag
from scegen.understanding.words.names import (
    called_shortly,
    name_letters,
    named_at,
    of_no_known_kind,
    street_name,
    tested_alone,
    whose_doing,
    with_articles,
)
from scegen.understanding.words.numbers import number_at
from scegen.understanding.words.paces import bare_speed
from scegen.understanding.words.particles import (
    GENITIVES,
    after_a_phrase,
    around_somebody,
    just_right,
    nothing_shed,
    over_a_place,
    suffix_form,
    then_a_noun,
)
from scegen.understanding.words.quantities import OPENS, quantity_at
from scegen.understanding.words.terms import NOTHING, Match, Term, begins, longest_match, term_at
from scegen.understanding.words.tokens import Token, low_at

_NOUNS = ("actor", "place", "thing", "inert")
_ON_FOOT_MPS = 3.0
_CROSSED = frozenset({"access", "road", "lane", "path", "highway", "crosswalk", "exit", "leg"})
_BEFORE_ADVERBS = frozenset(
    {"actor", "pronoun", "rel", "manner", "locus", "dir", "compass", "place"}
)
"""Behind these stands no adjective."""
_TURNING = frozenset({"verb", "prep", "det", "possessive"})
"""Behind these "right when" says where one turns, and not when."""
_STEERED = frozenset({"driven", "ridden"})


def _first_person(tokens: list[Token], i: int) -> bool:
    """``i`` is a person as a capital letter or before a verb, a word in "i.e."; not in "I-95"."""
    token = tokens[i]
    if token.text == "US":
        return False
    if token.low != "i" or token.text == "I":
        return True
    return low_at(tokens, i + 1) == "e" or begins(tokens, i + 1, "aux", "verb", "neg", "manner")


def _own_form(entry: Entry, match: Match, tokens: list[Token], i: int) -> str:
    """``change lanes``: a noun's plural does not inflect the verb; but "it rear-ends the ego"."""
    if entry.cat != "verb" or match.form != "s" or any(f == "s" for _, f in tokens[i].forms):
        return match.form
    alone = longest_match(tokens, i, i + 1)
    return "base" if alone is None or alone.has("verb") else match.form


def _verb_form(token: Token, previous: Term, tokens: list[Token]) -> str | None:
    """The form of a word that must be a verb by its place, although no rule knows it.

    "The ego commences a left turn" keeps its structure: who acts, and on what.
    """
    if token.kind != "word" or previous is NOTHING or len(token.low) < 4:
        return None
    infinitive = previous.cat == "prep" and previous.value == "to"
    if infinitive or previous.cat in {"aux", "neg"}:
        return suffix_form(token) or "base"
    adverb = previous.cat == "manner" and is_adverb(tokens[previous.j - 1])
    if previous.cat in {"actor", "pronoun", "rel"} or adverb:
        return suffix_form(token)
    return "s" if after_a_phrase(token, previous, tokens) else None


def _is_clause(match: Match, tokens: list[Token], i: int, previous: Term) -> bool:
    """``the bus stops``: a singular noun with its verb, although "bus stop" is a word."""
    changes = match.has("verb") and match.get("verb").value == "lane_change"
    within = low_at(tokens, previous.i - 2) in {"in", "from"}
    several = changes and within  # "the ego and a van in the right lane change to the left one"
    inflected = match.form == "s" or several
    last = match.j - 1
    if last == i or not inflected or not (changes or match.only(*_NOUNS)):
        return False
    before = previous.cat or "punct"
    known = any(t.low == tokens[i].low for t in tokens[:i])  # "ego follows a bus; bus stops"
    singular = before in {"det", "dir", "label", "state"}
    singular = singular or (known and before in {"punct", "conj"})
    after, number = low_at(tokens, match.j), tokens[match.j + 1 : match.j + 2]
    rated = after in {"with", "at"} and any(t.kind == "number" for t in number)
    verb = longest_match(tokens, last, match.j)  # "stops", not "stops and goes"
    verbal = begins(tokens, last, "verb") or (verb is not None and verb.has("verb"))
    verbal = verbal and (not changes or after in {"to", "into", "onto", "lanes"})
    alone = longest_match(tokens, i, last)
    return (singular or rated) and verbal and alone is not None and alone.has("actor", "place")


def tag(tokens: list[Token]) -> list[Term]:
    """Terms that cover all tokens in order."""
    terms: list[Term] = []
    i = 0
    tails: dict[int, int] = {}
    owned = any(token.low in GENITIVES for token in tokens)
    while i < len(tokens):
        if i in tails:
            terms.append(Term("manner", "mild", i, tails[i]))
            i = tails[i]
            continue
        term = _term_at(tokens, i, _before(terms, tokens))
        if term.value == "crosswalk" and _list_of_doings(terms, tokens, term):
            term = _term_at(tokens[: i + 1], i, _before(terms, tokens))
        held = around_somebody(tokens, term) if owned else None
        held = held or _around_adverb(tokens, term, _before(terms, tokens))
        if held is not None:
            term, tail, end = held
            tails[tail] = end
        term = retag(term, terms, tokens)
        terms.append(term)
        i = terms[-1].j
    crossed = _crossings(terms, tokens)
    named = with_articles(name_letters(crossed, tokens), tokens)
    return whose_doing(of_no_known_kind(called_shortly(tested_alone(named), tokens), tokens))


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
    if low_at(tokens, term.i - 2) in word_list("upon"):
        return False  # "over the pedestrian crossing from the right"
    if _crossed(tokens, term.j) or (term.j < len(tokens) and street_name(tokens, term.j)):
        return True
    counted = len(terms) > 2 and terms[-1].cat in {"det", "num"}
    return counted and begins(tokens, term.j, "det", "possessive", "pronoun")  # "… crossing it"


def _crossed(tokens: list[Token], j: int) -> bool:
    """``pedestrian crossing from the left``, ``… the road``, ``… in front of the ego``."""
    if low_at(tokens, j) in {"from", "against", "into"}:
        return True
    measured = low_at(tokens, j) == "at" and j + 1 < len(tokens)
    speed = quantity_at(tokens, j + 1) if measured else None
    if speed is not None and speed.dimension == "speed" and speed.value.high <= _ON_FOOT_MPS:
        return True  # "a pedestrian crossing at 5 km/h"; the ego approaches one at 50 km/h
    following = longest_match(tokens, j)
    if following is None:
        return False
    if following.has("det", "possessive"):
        noun = longest_match(tokens, following.j)
        return noun is not None and any(e.value in _CROSSED for e in noun.entries)
    return following.has("locus") and following.get("locus").value in {"ahead", "behind"}


def _before(terms: list[Term], tokens: list[Token]) -> Term:
    """The term before; a number that names a vehicle ("vehicle 1") counts as the vehicle.

    How something is done changes nothing of what is due after who does it: "which also brakes".
    """
    while len(terms) > 1 and terms[-1].cat == "manner" and terms[-2].cat in _BEFORE_ADVERBS:
        terms = terms[:-1]
    if len(terms) > 1 and terms[-1].cat == "num" and terms[-2].cat == "actor":
        return terms[-1] if tokens[terms[-2].i].text.endswith("s") else terms[-2]
    return term_at(terms, len(terms) - 1)


def _match_at(tokens: list[Token], i: int, previous: Term) -> Match | None:
    """The phrase at a token, cut down where its words are no phrase here."""
    match = longest_match(tokens, i)
    if match is not None and match.j > i + 1:
        match = _cut_down(match, tokens, i, previous)
    verbal = match is not None and match.form in {"ed", "ing"} and match.only("thing", "actor")
    no_verb = match is not None and nothing_shed(tokens, match)
    return None if verbal or no_verb else match  # "boxed in"


def _cut_down(match: Match, tokens: list[Token], i: int, previous: Term) -> Match | None:
    """A phrase of several words without those that belong to what follows."""
    token = tokens[i]
    by = _undergone(tokens, i) and tokens[match.j - 1].low == "by"  # "driven by a student"
    if by or (token.low == "right" and match.only("sub") and previous.cat in _TURNING):
        return longest_match(tokens, i, i + 1)
    if _is_clause(match, tokens, i, previous):
        return longest_match(tokens, i, match.j - 1)
    cut: Match | None = match
    if then_a_noun(tokens, match) or over_a_place(tokens, match):
        cut = longest_match(tokens, i, match.j - 1)
    if cut and cut.j > i + 1 and cut.only("verb", "aux") and tokens[cut.j - 1].low == "to":
        # "continues to the third exit": to a place, not to another verb
        apart = cut.j < len(tokens) and not begins(tokens, cut.j, "verb", "aux", "neg", "manner")
        cut = (longest_match(tokens, i, cut.j - 1) if apart else None) or cut
    if cut is None or cut.j == i + 1 or not cut.only(*_NOUNS):
        return cut
    if any(form == "s" for _, form in token.forms):
        return longest_match(tokens, i, i + 1)  # "two pedestrians crossing", no crossing
    participle = cut.form in {"ed", "ing"}  # "a car parked", no car park
    return longest_match(tokens, i, cut.j - 1) if participle else cut


def _around_adverb(tokens: list[Token], term: Term, previous: Term) -> tuple[Term, int, int] | None:
    """``gets completely back into its lane``: the verb before, and the phrase's rest behind."""
    if term.cat != "verb" or term.j != term.i + 1 or not low_at(tokens, term.j).endswith("ly"):
        return None
    match = _match_at([*tokens[: term.j], *tokens[term.j + 1 :]], term.i, previous)
    if match is None or match.j == term.j or not match.only("verb"):
        return None
    entry = match.entries[0]
    verb = replace(term, value=entry.value, data=entry.data)
    return verb, term.j + 1, match.j + 1


def _undergone(tokens: list[Token], i: int) -> bool:
    """``driven by``, ``gets passed by``."""
    got = i > 0 and tokens[i - 1].base == "get" and any(f == "ed" for _, f in tokens[i].forms)
    return got or tokens[i].low in _STEERED


def _term_at(tokens: list[Token], i: int, previous: Term) -> Term:
    token = tokens[i]
    if token.kind == "punct":
        return Term("punct", token.low, i, i + 1)
    if token.kind != "word" or token.text.isupper() or not _only_a_word(token.low):
        told = _measured_or_named(tokens, i, previous)
        if told is not None:
            return told
    return _by_lexicon(tokens, i, previous)


@lru_cache(maxsize=8192)
def _only_a_word(word: str) -> bool:
    """Whether a word opens no number, amount, pace or name, and is no mere "right"."""
    counts = word in OPENS or word in {"right", "at", "with"}
    return not counts and not any(word in word_list(n) for n in ("ages", "sexes", "unit_words"))


def _measured_or_named(tokens: list[Token], i: int, previous: Term) -> Term | None:
    """What a number, or a word that may open one, says besides being in the lexicon."""
    token = tokens[i]
    named = named_at(tokens, i)
    if named:
        return named
    if just_right(tokens, i, previous):
        return Term("manner", "mild", i, i + 1)
    quantity = quantity_at(tokens, i) or bare_speed(tokens, i)
    if quantity:
        return Term("quantity", quantity.dimension, i, quantity.j, data={"quantity": quantity})
    numbered = i + 1 < len(tokens) and tokens[i + 1].kind == "number"
    if token.low in word_list("unit_words") and numbered and quantity_at(tokens, i + 1) is None:
        return Term("actor", "car", i, i + 1)
    return None


def _by_lexicon(tokens: list[Token], i: int, previous: Term) -> Term:
    token = tokens[i]
    if street := street_name(tokens, i):
        return street
    number = number_at(tokens, i)
    match = _match_at(tokens, i, previous) if _first_person(tokens, i) else None
    counted = number is not None and match is not None and match.has("shape", "label")
    if match and not (counted and match.form == "s"):  # "two lanes"
        entry, premod = choose(match, tokens, previous)
        form = _own_form(entry, match, tokens, i)
        predicate = token.low == "about" or "predicate" in entry.data
        if predicate and entry.cat == "verb":
            form = "ing"  # "(is) on our tail", "children about to cross": describes them
        return Term(entry.cat, entry.value, i, match.j, form, entry.data, premod)
    if number:
        return Term("num", token.low, i, i + number.length, data={"number": number.value})
    unknown = _verb_form(token, previous, tokens)
    if unknown is not None:
        return Term("verb", "unknown", i, i + 1, unknown, data={"control": "subject"})
    return Term("unknown", token.low, i, i + 1)

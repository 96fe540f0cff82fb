"""Who and what no noun of the lexicon names: by letters, numbers, ages, or by what it does."""

import re
from dataclasses import replace

from scegen.understanding.lexicon import load, word_list
from scegen.understanding.words.numbers import POSITIONS, number_at
from scegen.understanding.words.quantities import quantity_at
from scegen.understanding.words.terms import NOTHING, Term, cat_at, noun_follows, term_at
from scegen.understanding.words.tokens import Token, low_at

_LABELLED = re.compile(r"^(?:v|veh|u|d|t|cv|obj|tgt|vt|ov)\d{1,2}$")
_WALKER = re.compile(r"^(?:p|ped)\d{1,2}$")
_FEW_DIGITS = 3
_LONGEST = 4
"""So many words a name of a road has, at most."""
_ROAD = re.compile(r"^(?:a|b|m|i|us|sr|cr|sh|fm|rn|hwy|rte)\d{1,2}$")


def named_at(tokens: list[Token], i: int) -> Term | None:
    """A participant or road that has no noun."""
    at = i > 0 and tokens[i - 1].low == "at"  # "at T0 the lead brakes": a moment
    named = (None if at else _labelled(tokens[i], i)) or _road_number(tokens, i) or _aged(tokens, i)
    numbered = named is not None and i + 1 < len(tokens) and tokens[i + 1].kind == "number"
    return None if numbered and quantity_at(tokens, i + 1) else named  # "v0 = 60 km/h"


def _labelled(token: Token, i: int) -> Term | None:
    """``V1``, ``car2``: a participant called by a short name."""
    if token.kind != "label":
        return None
    digits = token.low.lstrip("abcdefghijklmnopqrstuvwxyz")
    for names, kind, label in ((_LABELLED, "car", "#"), (_WALKER, "pedestrian", "#p")):
        if names.match(token.low):
            return Term("actor", kind, i, i + 1, data={"label": f"{label}{digits}"})
    noun = load().root.following.get(token.low.removesuffix(digits))  # "POV1", "truck2"
    for entry in noun.entries if noun is not None and 0 < len(digits) < _FEW_DIGITS else ():
        if entry.cat == "actor" and not entry.data.get("ego"):
            kind = "car" if "label" in entry.data else entry.value
            return Term("actor", kind, i, i + 1, data={"label": f"#{digits}"})
    return None


def _road_number(tokens: list[Token], i: int) -> Term | None:
    """``the A40``, ``I-95``, ``US 1``: a road."""
    token = tokens[i]
    kind = "highway" if token.low[0] in "mi" else "road"
    if token.kind == "label" and token.text[0].isupper() and _ROAD.match(token.low):
        return Term("place", kind, i, i + 1)
    after = tokens[i + 1] if i + 1 < len(tokens) else None
    gap = token.low != "a"  # "US 1", but no "A 40"
    joined = after is not None and after.kind == "number" and after.start <= token.end + gap
    named = joined and token.text.isupper() and _ROAD.match(f"{token.low}1")
    return Term("place", kind, i, i + 2) if named else None


def street_name(tokens: list[Token], i: int) -> Term | None:
    """``Elm Street``, ``North Baker Avenue``: a road."""
    if not tokens[i].text[0].isupper():
        return None
    j = next((j for j in range(i, len(tokens)) if not tokens[j].text[0].isupper()), len(tokens))
    ends = [k for k in range(i + 1, min(j, i + _LONGEST)) if tokens[k].text in word_list("streets")]
    return Term("place", "road", i, ends[0] + 1) if ends else None


def _aged(tokens: list[Token], i: int) -> Term | None:
    """``a 34-year-old cyclist``, ``the 17-year-old``: an age or a sex, or somebody of it."""
    after = tokens[i + 1] if i + 1 < len(tokens) else None
    if tokens[i].low in word_list("ages") and after is not None and after.kind == "number":
        return Term("label", "quality", i, i + 2)  # "a pedestrian, aged 70, …"
    number = number_at(tokens, i)
    k = i + (number.length if number is not None else 1)
    aged = number is not None and [t.low for t in tokens[k : k + 2]] == ["year", "old"]
    if not aged and tokens[i].low not in word_list("sexes"):
        return None
    j = k + 2 if aged else i + 1
    if noun_follows(tokens, j) or low_at(tokens, j) in word_list("sexes"):
        return Term("label", "quality", i, j)
    return Term("actor", "pedestrian", i, j)


_LETTER = re.compile(r"^[A-HJ-SU-XZ]$")
"""Not I, who tells it, and not the shapes of junctions."""
_NAMED = frozenset({"actor", "place", "thing", "inert", "shape", "leg", "limit"})
_JOINTS = frozenset({"and", "or", ","})
_PHRASE_ENDS = frozenset({"aux", "copy", "neg", "prep", "conj", "punct", "locus", "rel"})
_OPENERS = frozenset({"punct", "conj", "sub"})
_VERBAL = frozenset({"s", "ed"})


def name_letters(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """``three cars: A turns, B follows A``: each letter is one of them.

    A letter counts where its neighbour in the alphabet stands for somebody, too; in talk ("A: What
    happened? B: I braked.") it only tells who speaks, and is left out.
    """
    talk = word_list("first_person") | word_list("relevance_first_person")
    if not talk.isdisjoint(t.low for t in tokens):
        told = {
            k for k, t in enumerate(terms) if _is_letter(t, tokens) and low_at(tokens, t.j) == ":"
        }
        terms = [t for k, t in enumerate(terms) if told.isdisjoint({k, k - 1})]
    letters = {
        k: tokens[t.i].text
        for k, t in enumerate(terms)
        if _is_letter(t, tokens) and (t.value != "indef" or _stands_alone(terms, k))
    }
    if not letters:
        return terms
    used = set(letters.values())
    found = list(terms)
    for k, letter in letters.items():
        named = {chr(ord(letter) - 1), chr(ord(letter) + 1)} & used
        if named and not _belongs(terms, k, tokens):
            data = {"label": f"#{letter.lower()}"}
            found[k] = replace(terms[k], cat="actor", value="car", form="base", data=data)
    return found


def _is_letter(term: Term, tokens: list[Token]) -> bool:
    if term.cat != "unknown" and (term.cat, term.value) != ("det", "indef"):
        return False
    return term.j - term.i == 1 and bool(_LETTER.match(tokens[term.i].text))


def _stands_alone(terms: list[Term], k: int) -> bool:
    """Whether "A" is no article: a verb or the end of the phrase comes after it."""
    after = term_at(terms, k + 1)
    if after is NOTHING or after.cat in _PHRASE_ENDS:
        return True
    verb = term_at(terms, k + 2) if after.cat == "manner" else after
    return (verb.cat, verb.form, verb.premod) == ("verb", "s", False)


def _belongs(terms: list[Term], k: int, tokens: list[Token]) -> bool:
    """``car A``, ``roads A and B``: a name after a noun."""
    m = k - 1
    while m > 0 and terms[m].value in _JOINTS and _is_letter(terms[m - 1], tokens):
        m -= 2
    return m >= 0 and terms[m].cat in _NAMED


def with_articles(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """``First car stops, second brakes``: the first car, the second."""
    named = {k for k in range(len(terms)) if _names(terms, k, tokens)}
    if not named:
        return terms
    found: list[Term] = []
    for k, term in enumerate(terms):
        word = tokens[term.i].low
        if k in named and (len(named) > 1 or word != "first"):
            found += [Term("det", "def", term.i, term.i), Term("label", word, term.i, term.j)]
        else:
            found.append(term)
    return found


def _names(terms: list[Term], k: int, tokens: list[Token]) -> bool:
    """Whether an ordinal that opens a clause stands for a participant."""
    term = terms[k]
    if tokens[term.i].low not in POSITIONS or term.j - term.i != 1:
        return False
    after = term_at(terms, k + 1)
    if k and terms[k - 1].cat not in _OPENERS:
        return False
    acts = (after.cat == "verb" and after.form in _VERBAL) or after.cat in {"aux", "copy"}
    told = after.value == "," and term_at(terms, k + 2).value != "def"  # "Second, the ego brakes"
    return acts or told or after.cat == "actor" or after.value == "("


_FIRST_WORDS = frozenset({"det", "num"})
_GOVERNING = frozenset({"prep", "locus", "verb"})
_SAID_OF_IT = frozenset({"label", "dir", "manner", "state", "unknown"})
_DOINGS = frozenset({"cut_in", "brake", "hard_brake", "u_turn", "lane_change", "swerve"})
_OPENING = frozenset({"det", "manner", "dir", "inert"})
_READ_AS = {"driving": ("drives", "car"), "walking": ("walks", "pedestrian")}
"""List of events -> what they are called, and as what whoever does so is read."""


def of_no_known_kind(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """The terms with unknown nouns as cars, or people, by what they do, which is said.

    A driving verb would else find its subject in the next noun, and turn who does it to whom.
    """
    unknown = [k for k, t in enumerate(terms) if t.cat == "unknown"]
    nouns = {
        k: tokens[terms[k].i] for k in unknown if cat_at(terms, _opener(terms, k)) in _FIRST_WORDS
    }
    done = {n.low: does for k, n in nouns.items() if (does := _done(terms, k, tokens))}
    found = list(terms)
    for k, noun in nouns.items():  # "follows the EVT until the EVT brakes"
        if does := done.get(noun.low):
            doing, kind = _READ_AS[does]
            said = {"instead": f"no known kind of road user; as it {doing}, it is read as a {kind}"}
            found[k] = Term("actor", kind, terms[k].i, terms[k].j, _number(noun), said)
    return found


def called_shortly(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """``a golf cart … the cart``: the last word of a longer name means whoever was called so."""
    longer: dict[str, Term] = {}
    found: list[Term] = []
    for k, term in enumerate(terms):
        noun = tokens[term.j - 1]
        whole = longer.get(noun.base)
        open_ = term.cat == "unknown" or "instead" in term.data
        if term.j - term.i > 1 and term.cat in {"actor", "thing"}:
            longer[noun.base] = term
        elif whole is not None and open_ and term_at(terms, _opener(terms, k)).value == "def":
            term = replace(whole, i=term.i, j=term.j, form=_number(noun))  # noqa: PLW2901
        found.append(term)
    return found


def tested_alone(terms: list[Term]) -> list[Term]:
    """``the EVT overtakes a cyclist``: the ego, unless another word names one."""
    if any("ego" in t.data for t in terms):
        return terms
    return [replace(t, value="ego", data={"ego": True}) if "tested" in t.data else t for t in terms]


def _number(noun: Token) -> str:
    return "s" if noun.low.endswith("s") else "base"


def _opener(terms: list[Term], k: int) -> int:
    """Where the words before a noun end that are said of it."""
    k -= 1
    while cat_at(terms, k) in _SAID_OF_IT:
        k -= 1
    return k


def _done(terms: list[Term], k: int, tokens: list[Token]) -> str | None:
    """The list of events of which one is done by it, or to it."""
    verb, noun = term_at(terms, k + 1), tokens[terms[k].i]
    governed = cat_at(terms, _opener(terms, k) - 1) in _GOVERNING  # "a kid on a BMX shoots out"
    forms = {"base", "ed"} if _number(noun) == "s" else {"s", "ed"}
    past = verb.form in forms or tokens[verb.i].low in word_list("alike_in_the_past")
    if verb.cat == "verb" and past and not governed:
        return next((name for name in _READ_AS if verb.value in word_list(name)), None)
    return "driving" if _suffers(terms, k, proper=noun.text.istitle()) else None


def _suffers(terms: list[Term], k: int, *, proper: bool) -> bool:
    """``overtakes a Transit``, ``is hit by an Iveco``, unless a compound goes on."""
    opener = _opener(terms, k)
    verb, after = term_at(terms, opener - 1), cat_at(terms, k + 1)
    if proper and verb.value == "by":
        done = [t.value for t in terms[:opener] if t.cat == "verb"][-1:]
        return not word_list("done_to_somebody").isdisjoint(done)
    ends = after in {"", "punct", "conj", "prep", "locus", "sub", "verb", "rel"}
    met = verb.cat == "verb" and verb.value in word_list("met_driving")
    return ends and met and terms[opener].value == "indef"


def whose_doing(terms: list[Term]) -> list[Term]:
    """``A cut-in from the right``, ``hard braking ahead of the ego``: a car's, if none is named."""
    if any(t.cat == "actor" and not t.data.get("ego") for t in terms):
        return terms
    found: list[Term] = []
    opens = True
    for k, term in enumerate(terms):
        found.append(term)
        after = term_at(terms, k + 1)
        placed = after.cat == "locus" or after.value == "from"
        placed = placed and term.form not in {"s", "ed"}
        if opens and placed and term.cat == "verb" and term.value in _DOINGS:
            at = term.j
            found += [Term("prep", "of", at, at), Term("det", "indef", at, at)]
            found.append(Term("actor", "car", at, at))
        opens = term.cat == "punct" or (opens and term.cat in _OPENING)
    return found

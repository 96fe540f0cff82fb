"""Refuses what is no description in English, or none of traffic."""

import unicodedata
from collections import Counter
from functools import lru_cache

from scegen.errors import InputError, NotTrafficError
from scegen.scenario.vocabulary import ANIMALS
from scegen.understanding.lexicon import load, word_list, word_lists
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_ENGLISH = "English"
_FEWEST = 3
_HALF = 0.5
_HINT = "Describe the situation in English, for example 'Two cars meet at a T-junction.'"


@lru_cache(maxsize=1)
def _languages() -> dict[str, list[str]]:
    """A word -> the languages in which it stands in nearly every sentence."""
    found: dict[str, list[str]] = {}
    for name, common in word_lists("languages").items():
        for word in common:
            found.setdefault(word, []).append(name)
    return found


def require_english(tokens: list[Token], text: str) -> None:
    """Refuses a text in another language.

    Raises:
        InputError: if it is plainly not English.
    """
    letters = [] if text.isascii() else [c for c in text if c.isalpha()]
    foreign = [c for c in letters if not unicodedata.name(c, "").startswith("LATIN")]
    if len(letters) > _FEWEST and len(foreign) > _HALF * len(letters):
        msg = "the description is not written in Latin letters; only English is read"
        raise InputError(msg, where="description", hint=_HINT)
    words = [t.text.lower() for t in tokens if t.kind == "word"]
    counts = Counter(name for word in words for name in _languages().get(word, ()))
    english = counts.pop(_ENGLISH, 0)
    likeliest = max(counts, key=counts.__getitem__, default="")
    if counts[likeliest] >= _FEWEST and counts[likeliest] > english + len(words) * 0.1:
        msg = f"the description seems to be written in {likeliest}; only English is read"
        raise InputError(msg, where="description", hint=_HINT)
    forms = ([t.low, *(form for form, _ in t.forms)] for t in tokens if t.kind == "word")
    strange = 0 if english else sum(map(load().words.isdisjoint, forms))
    if strange >= _FEWEST and strange > _HALF * len(words):
        msg = "the description does not seem to be written in English; only English is read"
        raise InputError(msg, where="description", hint=_HINT)


_NAMED = frozenset({"signal", "right_of_way"})
"""What only its full name tells: "traffic light"."""
_DRIVING = frozenset(
    {"overtake", "lane_change", "brake", "hard_brake", "tailgate", "swerve", "cut_off", "park",
     "cut_in", "pull_out", "u_turn", "unpark", "pull_over"}
)  # fmt: skip
_WAYS = frozenset({"turn", "move"})
_ENOUGH = 2
"""So many hints, none of which would do alone, make a story of the road."""
_EXAMPLE = "For example: 'A car turns left at a T-intersection while a pedestrian crosses.'"


def require_traffic(terms: list[Term], tokens: list[Token]) -> None:
    """Refuses text in which nothing belongs to traffic.

    Raises:
        NotTrafficError: if there is neither a participant nor a road.
    """
    hints = sum(_hints_at_traffic(terms, k, tokens) for k in range(len(terms)))
    if hints < _ENOUGH and not any(_about_traffic(term, tokens) for term in terms):
        msg = "the text does not describe a traffic situation: it names no road and no vehicle"
        raise NotTrafficError(msg, where="description", hint=_EXAMPLE)


def _about_traffic(term: Term, tokens: list[Token]) -> bool:
    if term.cat == "place":
        return term.value in word_list("sites") or (term.value in _NAMED and term.j - term.i > 1)
    if term.cat == "actor":
        people = word_list("relevance_first_person") | word_list("people")
        only_people = not people.isdisjoint(t.low for t in tokens[term.i : term.j])
        return term.value not in ANIMALS and not only_people
    if term.cat in {"verb", "env", "thing"}:
        named = {t.low for t in tokens[term.i : term.j]} & word_list("of_traffic")  # "a car door"
        return term.value in _DRIVING or bool(named) or tokens[term.i].forms[-1][0] == "drive"
    return term.cat == "quantity" and term.value == "speed"


def _hints_at_traffic(terms: list[Term], k: int, tokens: list[Token]) -> bool:
    """``the guy behind me``, ``turns left``, ``ran the light``: said of the road, but not only."""
    term = terms[k]
    after = terms[k + 1] if k + 1 < len(terms) else None
    if term.cat == "verb":
        loud = tokens[term.j - 1].forms[-1][0] in word_list("loud")
        sided = term.value in _WAYS and after is not None and after.cat == "dir"
        towards = term.value == "approach" and after is not None and "me" in after.data
        return term.value in word_list("hints") or sided or loud or towards or "way" in term.data
    if term.cat == "locus":
        return after is not None and "me" in after.data
    if term.value == "from":  # "from the left"
        return [t.cat for t in terms[k + 1 : k + 3]] == ["det", "dir"]
    if term.cat == "manner":
        return term.value in {"fast", "slow", "wrong_way", "close"}
    lamps = (term.cat, term.value) in {("noted", "lights"), ("actor", "bus")}
    return lamps or (term.cat == "place" and term.value in {"signal", "path", "middle", "flank"})

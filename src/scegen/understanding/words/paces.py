"""Speeds as people say them: "doing 25 in a 40", "20 over the limit", "going 90"."""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.numbers import number_at
from scegen.understanding.words.quantities import Quantity, as_written, in_unit, quantity_at
from scegen.understanding.words.terms import Term, begins, longest_match
from scegen.understanding.words.tokens import Token, low_at

_ARTICLES = frozenset({"a", "an", "the"})
_DEGREES = {"slow": "slow_degrees", "fast": "fast_degrees"}
_OVER = {"over": "fast", "above": "fast", "under": "slow", "below": "slow"}
_CLOSED = ("conj", "sub", "rel", "prep", "locus", "verb", "dir")
"""Classes of words that go on after a number without a unit; nouns would be counted by it."""
_PHRASE = 8
_FEWEST, _MOST = 3, 200
_LOWEST_LIMIT = 10
_CRAWL = 40
"""What nobody drives on a motorway, be it in mph or in km/h."""
_MOTORWAY = 50
_LOWEST_BARE = 15
"""Lower numbers without a unit, after "at", are hours as well."""
_GUESS_REACH = 7
_SAID_REACH = 4
_BESIDE = 3


def pace_at(tokens: list[Token], i: int) -> Term | None:
    """A number that says how fast one drives compared with what is allowed."""
    number = number_at(tokens, i)
    told = doing(tokens, i) or _merely_at(tokens, i)
    if number is None or not _FEWEST <= number.value <= _MOST or not told:
        return None
    quantity = quantity_at(tokens, i)
    speed = quantity if quantity is not None and quantity.dimension == "speed" else None
    j = speed.j if speed is not None else i + number.length
    limit = number_at(tokens, j + 2) if j + 2 < len(tokens) else None
    lowest = limit is not None and limit.value >= _LOWEST_LIMIT  # "30 km/h on a two-lane road"
    if limit and lowest and tokens[j].low in {"in", "on"} and tokens[j + 1].low in _ARTICLES:
        value = "fast" if number.value > limit.value else "slow"
        return _pace(value, i, j, speed or _as_others(tokens, i, j))
    if number.value <= _CRAWL and _on_a_highway(tokens, j):
        return _pace("slow", i, j)
    if speed is not None and any(low_at(tokens, i - k) in word_list("merely") for k in (1, 2)):
        return _pace("slow", i, j, speed)
    if number.value >= _MOTORWAY and speed is None and _must_have_been(tokens, i):
        return _pace("fast", i, j)
    end = j + 1
    while low_at(tokens, end) in {*_ARTICLES, "speed", "limit"}:
        end += 1
    ends = end >= len(tokens) or tokens[end].kind == "punct" or end > j + 1
    return _pace(_OVER[tokens[j].low], i, end) if low_at(tokens, j) in _OVER and ends else None


def _merely_at(tokens: list[Token], i: int) -> bool:
    """``a van at only 30 km/h``, ``at a mere 30 km/h``."""
    before = [t.low for t in tokens[max(0, i - 3) : i] if t.low not in _ARTICLES]
    return before[-2:-1] == ["at"] and before[-1] in word_list("merely")


def _pace(value: str, i: int, j: int, quantity: Quantity | None = None) -> Term:
    """A term that says how fast, and perhaps the speed itself."""
    told = {} if quantity is None else {"quantity": quantity}
    return Term("manner", value, i, j, data={"pace": True, **told})


def _on_a_highway(tokens: list[Token], j: int) -> bool:
    """``doing 30 on the motorway``: far below what is usual there."""
    if low_at(tokens, j) not in {"on", "down"}:
        return False
    found = longest_match(tokens, j + 1 + (low_at(tokens, j + 1) in _ARTICLES))
    return found is not None and any(e.value == "highway" for e in found.entries)


def _must_have_been(tokens: list[Token], i: int) -> bool:
    """``must've been doing eighty``: a speed that is told because it was too high."""
    before = [t.low for t in tokens[max(0, i - _GUESS_REACH) : i]]
    return bool({"must", "easily"} & set(before)) and bool({"doing", "going"} & set(before))


def bare_speed(tokens: list[Token], i: int) -> Quantity | None:
    """``a car comes at 50, the ego was doing 40 km/h``: in the unit of the other speeds, if any."""
    number = number_at(tokens, i)
    if number is None or not _FEWEST < number.value <= _MOST:
        return None
    j = i + number.length
    told = (
        doing(tokens, i)
        or low_at(tokens, i - 1) in word_list("at_a_speed")
        or (low_at(tokens, i - 1) == "to" and low_at(tokens, i - 2) in word_list("comes_to"))
        or _its_speed(tokens, i)
        or _likewise(tokens, i, j)
    )
    ends = j >= len(tokens) or tokens[j].kind == "punct" or begins(tokens, j, *_CLOSED)
    if not (told and ends):
        return None
    return _as_others(tokens, i, j, lowest=_LOWEST_BARE)


def _as_others(tokens: list[Token], i: int, j: int, lowest: int = _FEWEST) -> Quantity | None:
    """A number as a speed in the unit of the other ones, else in the one that is usual there."""
    for k in range(len(tokens)):
        given = quantity_at(tokens, k)
        if given is not None and given.dimension == "speed":
            return as_written(tokens, i, j, given)
    number = number_at(tokens, i)
    if number is None or number.value < lowest:
        return None
    unit = "mph" if any(t.low in word_list("imperial") for t in tokens) else "km/h"
    note = f"no unit is said; read as {unit}"
    found = in_unit(tokens, i, j, "speed", unit)
    return replace(found, note=note) if found is not None else None


def _its_speed(tokens: list[Token], i: int) -> bool:
    """``its own speed is 120``, ``100 km/h against the ego's 80``: a speed without its unit."""
    before = tokens[max(0, i - _SAID_REACH) : i]
    rated = any(t.low in word_list("pace_nouns") for t in before)
    rated = rated and before[-1].low in {"is", "was", "of", "="}
    versus = any(t.low in {"against", "versus", "vs"} for t in before)
    return rated or (versus and before[-1].kind == "clitic")


def _likewise(tokens: list[Token], i: int, j: int) -> bool:
    """``the truck does 60 km/h, the ego 80``, ``the ego's 80``, ``and 80 for the ego``.

    Right beside who it is, after another's speed.
    """
    ends = [k for k in range(max(0, i - _BESIDE), i) if _ends_place(tokens, k, i)] or [i]
    who = longest_match(tokens, ends[0] - 1) if ends[0] else None
    if (who is None or "actor" not in who.cats) and low_at(tokens, j) != "for":
        return False
    begin = max((k for k in range(i) if tokens[k].low in {".", ":"}), default=-1) + 1
    said = (quantity_at(tokens, k) for k in range(begin, i))
    return any(q is not None and q.dimension == "speed" for q in said)


def _ends_place(tokens: list[Token], k: int, i: int) -> bool:
    """``'s``, ``in front``: whether it stands at token ``k``, right before a number."""
    place = longest_match(tokens, k)
    own = tokens[k].kind == "clitic" and k + 1 == i
    return own or (place is not None and place.j == i and place.has("locus"))


def speed_at(tokens: list[Token], i: int) -> Term | None:
    """``at a much lower constant speed``, ``with considerably higher velocity``."""
    if tokens[i].low not in {"at", "with"}:
        return None
    value = None
    for k in range(i + 1, min(i + _PHRASE, len(tokens))):
        low = tokens[k].low
        value = value or _degree(low)
        if low in word_list("pace_nouns"):
            return Term("manner", value, i, k + 1) if value is not None else None
        if not (_degree(low) or low in word_list("within_paces") or low.endswith("ly")):
            return None
    return None


def _degree(word: str) -> str | None:
    """``excessive``: fast; ``leisurely``: slow."""
    return next((d for d in _DEGREES if word in word_list(_DEGREES[d])), None)


def doing(tokens: list[Token], i: int) -> bool:
    """Whether a verb of motion stands right before, as in "doing about 50"."""
    k = i - 1 - (low_at(tokens, i) == "hundred" and low_at(tokens, i - 1) == "a")
    while k >= 0 and tokens[k].low in word_list("vaguely"):
        k -= 1
    return k >= 0 and tokens[k].base in word_list("pacing")

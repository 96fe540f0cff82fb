"""Speeds as people say them: "doing 25", "going 90"."""

from dataclasses import replace

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.numbers import number_at
from scegen.understanding.words.quantities import Quantity, as_written, in_unit, quantity_at
from scegen.understanding.words.terms import begins, longest_match
from scegen.understanding.words.tokens import Token, low_at

_CLOSED = ("conj", "sub", "rel", "prep", "locus", "verb", "dir", "quant")
"""Classes of words that go on after a number without a unit; nouns would be counted by it."""
_FEWEST, _MOST = 3, 200
_ON_FOOT_MPS = 2.5
"""Slower ones tell how people walk, or how somebody moves aside: others have other units."""
_LOWEST_BARE = 15
"""Lower numbers without a unit, after "at", are hours as well."""
_SAID_REACH = 4
_BESIDE = 3


def bare_speed(tokens: list[Token], i: int) -> Quantity | None:
    """``a car comes at 50, the ego was doing 40 km/h``: in the unit of the other speeds, if any.

    Else in the one that is usual there.
    """
    number = number_at(tokens, i)
    rated = number is not None and _its_speed(tokens, i, i + number.length)
    if number is None or not (_FEWEST < number.value <= _MOST or (rated and not number.value)):
        return None
    j = i + number.length
    led = {t.low for t in tokens[_led_by(tokens, i) : i]}
    told = (
        doing(tokens, i)
        or not led.isdisjoint(word_list("at_a_speed"))
        or (low_at(tokens, i - 1) == "to" and low_at(tokens, i - 2) in word_list("comes_to"))
        or (low_at(tokens, i - 1) == "from" and low_at(tokens, j) in {"to", *word_list("comes_to")})
        or rated
        or _beside_who(tokens, i, j, number.value)
    )
    ends = j >= len(tokens) or tokens[j].kind == "punct" or begins(tokens, j, *_CLOSED)
    if not (told and ends):
        return None
    for k in range(len(tokens)):
        given = quantity_at(tokens, k)
        if given is not None and given.dimension == "speed" and given.value.high > _ON_FOOT_MPS:
            return as_written(tokens, i, j, given)
    if 0 < number.value < _LOWEST_BARE:
        return None
    unit = "mph" if any(t.low in word_list("imperial") for t in tokens) else "km/h"
    note = f"no unit is said; read as {unit}"
    found = in_unit(tokens, i, j, "speed", unit)
    return replace(found, note=note) if found is not None else None


def _its_speed(tokens: list[Token], i: int, j: int) -> bool:
    """``its own speed is 120``, ``100 km/h against the ego's 80``, ``120 against our 80 km/h``."""
    before = tokens[max(0, i - _SAID_REACH) : i]
    rated = any(t.low in word_list("pace_nouns") for t in before)
    rated = rated and before[-1].low in {"is", "was", "of", "="}
    versus = any(t.low in word_list("versus") for t in before) and before[-1].kind == "clitic"
    return (
        rated
        or versus
        or (low_at(tokens, j) in word_list("versus") and _says_speed(tokens, j, j + _SAID_REACH))
    )


def _says_speed(tokens: list[Token], i: int, j: int) -> bool:
    said = (quantity_at(tokens, k) for k in range(i, min(j, len(tokens))))
    return any(q is not None and q.dimension == "speed" for q in said)


def _beside_who(tokens: list[Token], i: int, j: int, value: float) -> bool:
    """``ego 80``, ``him 105``, ``the truck ahead of it 60``, ``the ego's 80``, ``and 80 for it``.

    Right beside who it is. A low number may be a name, but after another's speed.
    """
    ends = [k for k in range(max(0, i - _BESIDE), i) if _ends_place(tokens, k, i)]
    at = ends[0] if ends else i - (low_at(tokens, i - 1) in {":", "="})
    who = longest_match(tokens, at - 1) if at else None
    named = who is not None and who.has("actor", "pronoun")
    if named or low_at(tokens, at - 1) in word_list("by_themselves"):
        if value >= _LOWEST_BARE and not begins(tokens, j, "verb"):
            return True
    elif low_at(tokens, j) != "for":
        return False
    begin = max((k for k in range(i) if tokens[k].low in {".", ":"}), default=-1) + 1
    return _says_speed(tokens, begin, i)


def _ends_place(tokens: list[Token], k: int, i: int) -> bool:
    """``'s``, ``in front``, ``ahead of it``: if it stands at token ``k``, right before a number."""
    place = longest_match(tokens, k)
    own = tokens[k].kind == "clitic" and k + 1 == i
    if own or place is None or not place.has("locus"):
        return own
    return place.j == i or (place.j + 1 == i and begins(tokens, place.j, "pronoun"))


def doing(tokens: list[Token], i: int) -> bool:
    """Whether a verb of motion stands right before: "doing about 50", "stays on 90"."""
    k = _led_by(tokens, i)
    before = tokens[max(0, k - _BESIDE) : k]
    if tokens[k].low == "on":
        return any(t.base in word_list("at_the_wheel") for t in before[-1:])
    verbs = before if tokens[k].low == "with" else tokens[k : k + 1]
    return any(t.base in word_list("pacing") for t in verbs)


def _led_by(tokens: list[Token], i: int) -> int:
    """The token before a number and the vague words that lead up to it."""
    return max((k for k in range(i) if tokens[k].low not in word_list("vaguely")), default=0)

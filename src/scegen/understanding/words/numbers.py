"""Number words and digits, and words for a place in a row."""

from dataclasses import dataclass
from functools import lru_cache

from text_to_num import text2num

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.tokens import Token, low_at

POSITIONS = {"first": 0, "second": 1, "third": 2, "fourth": 3, "fifth": 4, "sixth": 5,
             "seventh": 6, "eighth": 7, "former": 0, "latter": -1, "last": -1,
             "in_the_middle": 1}  # fmt: skip
"""Place within those spoken of last; "the former" and "the latter" are of two."""


ATOMS = word_list("number_words")
_LARGE = frozenset({"hundred", "thousand"})
_FRACTION_DIGITS = 3
_HALF = 0.5
COUNTED = {"a": 1, "one": 1, "two": 2, "three": 3}
PARTS = {"half": 2, "third": 3, "thirds": 3, "quarter": 4, "quarters": 4, "fifth": 5, "fifths": 5}
"""Names of parts, and how many make a whole."""
_WIDTH_REACH = 6


@dataclass(slots=True)
class Number:
    """A number and how many tokens it takes."""

    value: float
    length: int


@lru_cache(maxsize=1024)
def _spoken(words: tuple[str, ...]) -> float | None:
    try:
        return float(text2num(" ".join(words), "en"))
    except ValueError:
        return None


def _digits(text: str) -> float:
    """``1,000`` is a thousand, ``1,5`` one and a half, ``−5`` less than nothing."""
    text = text.replace("−", "-")
    head, comma, tail = text.partition(",")
    if comma and len(tail) == _FRACTION_DIGITS:
        return float(head + tail)
    return float(text.replace(",", "."))


def number_at(tokens: list[Token], i: int) -> Number | None:
    """The number that begins at token ``i``, if one does."""
    token = tokens[i]
    if token.kind == "number":
        return Number(_digits(token.text), 1)
    begin = i + (token.low == "a" and low_at(tokens, i + 1) in _LARGE)
    if tokens[begin].low not in ATOMS:
        return None
    j = begin
    while (low_at(tokens, j) in ATOMS or _goes_on(tokens, i, j)) and j - begin < 6:
        j += 1
    for end in range(j, begin, -1):
        value = _spoken(tuple(t.low for t in tokens[begin:end]))
        if value is not None:
            return _with_fraction(tokens, end, Number(value, end - i))
    return None


def _goes_on(tokens: list[Token], i: int, j: int) -> bool:
    """``a hundred and twenty``; not "between a hundred and two hundred"."""
    joins = low_at(tokens, j) == "and" and low_at(tokens, j - 1) in _LARGE
    return joins and low_at(tokens, i - 1) != "between"


def _with_fraction(tokens: list[Token], j: int, whole: Number) -> Number:
    """``two point five``, ``one and a half``."""
    lows = [t.low for t in tokens[j : j + 3]]
    if lows == ["and", "a", "half"]:
        return Number(whole.value + _HALF, whole.length + 3)
    end = j + 1
    while lows[:1] == ["point"] and low_at(tokens, end) in ATOMS:
        end += 1
    digits = "".join(f"{_spoken((t.low,)):.0f}" for t in tokens[j + 1 : end])
    return Number(whole.value + float(f"0.{digits}"), whole.length + end - j) if digits else whole


def share_at(tokens: list[Token], i: int) -> Number | None:
    """``one third of its width``, ``half overlap``: a share of a width, in percent.

    Returns:
        The share with the tokens of the fraction alone, or None where it is of anything else.
    """
    opens = low_at(tokens, i)
    count, part, length = COUNTED.get(opens), PARTS.get(low_at(tokens, i + 1)), 2
    if opens == "half":
        count, part, length = 1, 2, 1
    if count is None or part is None:
        return None
    after = [t.low for t in tokens[i + length : i + length + _WIDTH_REACH]]
    around = [*tokens[max(0, i - 3) : i], *tokens[i + length : i + length + 3]]
    wide = any(t.base == "overlap" for t in around)  # "an overlap of one half", "half overlapped"
    wide = wide or (after[:1] == ["of"] and not word_list("widths").isdisjoint(after))
    return Number(100 * count / part, length) if wide else None

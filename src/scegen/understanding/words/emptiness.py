"""Words that add nothing: "5 m of air", "a van is all that hides him", "could you make me a …"."""

import re
from functools import cache

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.numbers import number_at
from scegen.understanding.words.quantities import after_a_measure, quantity_at
from scegen.understanding.words.terms import begins, longest_match
from scegen.understanding.words.tokens import Token, low_at

_ENDS = frozenset({".", "!", "?"})
_SOON, _LONGEST = 3, 6


def without_emptiness(tokens: list[Token]) -> list[Token]:
    """The tokens without the room that a length is of, stress on who does it, who asks for it."""
    being = word_list("being")
    counts = {k: _room(tokens, k) for k, token in enumerate(tokens) if token.low == "of"}
    counts |= {
        k: 1 + count
        for k, token in enumerate(tokens)
        if token.low in being and (count := _phrase(tokens, k + 1, "stressing"))
    }
    opened = (k + 1 for k, token in enumerate(tokens[:-1]) if token.low in _ENDS)
    counts |= {k: _asked(tokens, k) or _test_of(tokens, k) for k in (0, *opened)}
    empty = {m for k, count in counts.items() for m in range(k, k + count)}
    return [token for k, token in enumerate(tokens) if k not in empty] if empty else tokens


def _room(tokens: list[Token], k: int) -> int:
    """How many words ``of free road`` has before a word that says between whom."""
    end = k + 1
    while low_at(tokens, end) in word_list("free"):
        end += 1
    between = low_at(tokens, end + 1) in word_list("apart")
    empty = between and tokens[end].low in word_list("emptiness") and after_a_measure(tokens, k)
    return end + 1 - k if empty else 0


def _asked(tokens: list[Token], k: int) -> int:
    """How many words ``could you make me`` has before what is asked for, which is new."""
    asked = _phrase(tokens, k, "asking")
    end = k + asked + (low_at(tokens, k + asked) in word_list("first_person"))
    one = end + (low_at(tokens, end) == "the")
    if not asked:
        return 0
    if low_at(tokens, one) == "one" and begins(tokens, one + 1, "prep", "sub", "punct"):
        return one + 1 - k  # "can you do one in fog?": a scenario
    match = longest_match(tokens, end)
    counted = number_at(tokens, end) is not None and quantity_at(tokens, end) is None
    indefinite = match is not None and match.has("det") and match.get("det").value == "indef"
    listed = low_at(tokens, end) == ":"
    return end + listed - k if counted or indefinite or listed else 0


def _test_of(tokens: list[Token], k: int) -> int:
    """How many words ``Car-to-pedestrian, nearside adult`` has before who is met in that test."""
    met = longest_match(tokens, k + 2) if low_at(tokens, k) == "car" else None
    if low_at(tokens, k + 1) != "to" or met is None:
        return 0
    again = [longest_match(tokens, m) for m in range(met.j, met.j + _SOON)]
    kind = met.get("actor").value if met.has("actor") else "car"
    named = any(a is not None and a.has("actor") and a.get("actor").value == kind for a in again)
    return 0 if kind == "car" else met.j - k if named else 2


def _phrase(tokens: list[Token], k: int, name: str) -> int:
    """How many words the longest phrase of a list has that stands there."""
    found = _phrases(name).match("".join(f"{token.low} " for token in tokens[k : k + _LONGEST]))
    return found.group().count(" ") if found is not None else 0


@cache
def _phrases(name: str) -> re.Pattern[str]:
    """The phrases of a list, the longest first; ``*`` is "make"."""
    making = "|".join(sorted(word_list("making")))
    longest = sorted(sorted(word_list(name)), key=lambda phrase: -phrase.count(" "))
    return re.compile("|".join(f"{phrase} ".replace("*", f"(?:{making})") for phrase in longest))

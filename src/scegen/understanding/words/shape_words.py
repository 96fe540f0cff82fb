"""Words of shape that only count arms, and letters that name a junction by themselves."""

from __future__ import annotations

from scegen.scenario.junction import ARM_COUNTS
from scegen.scenario.vocabulary import JunctionKind
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_ARMS_SAID = {JunctionKind.T: 3, JunctionKind.FOUR_WAY: 4}


def named_by_letter(terms: list[Term], k: int) -> bool:
    """``at the T``, ``reaches a T``: the junction itself."""
    before = [t.cat for t in terms[max(0, k - 2) : k]]
    after = [t.cat for t in terms[k + 1 : k + 2]]
    placed = before in (["prep", "det"], ["verb", "det"])
    return placed and after not in (["actor"], ["place"], ["num"])


def only_counted(terms: list[Term], k: int, tokens: list[Token]) -> int | None:
    """``a four-arm roundabout``: the arms are counted, the noun says what kind it is.

    Returns:
        How many arms; None if the word says more than that.
    """
    term = terms[k]
    kind = JunctionKind(term.value)
    if kind not in _ARMS_SAID or tokens[term.j - 1].low not in word_list("counting"):
        return None
    named: str | None = None
    for after in terms[k + 1 : k + 4]:
        if after.cat == "shape" or (after.cat == "place" and after.value == "junction"):
            named = after.value if after.cat == "shape" else after.data.get("kind")
            break
    if named is None or named in {kind, JunctionKind.FOUR_WAY}:
        return None
    fewest, most = ARM_COUNTS[JunctionKind(named)]
    return _ARMS_SAID[kind] if fewest <= _ARMS_SAID[kind] <= most else None

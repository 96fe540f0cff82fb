"""``left to right``, ``north to south``: where from and where to, "from" left out."""

from __future__ import annotations

from scegen.understanding.words.terms import Term

_SIDES = frozenset({"left", "right"})


def from_side_to_side(terms: list[Term]) -> list[Term]:
    """The terms with an empty "from" before such a pair."""
    if not any(t.value == "to" for t in terms):
        return terms
    found: list[Term] = []
    for k, term in enumerate(terms):
        previous = terms[k - 1] if k else None
        said = previous is not None and (
            previous.cat in {"prep", "det"} or previous.value in {"turn", "sharp_turn"}
        )
        if _pair(terms, k) and not said:
            found.append(Term("prep", "from", term.i, term.i))
        found.append(term)
    return found


def _pair(terms: list[Term], k: int) -> bool:
    if k + 2 >= len(terms) or terms[k + 1].value != "to":
        return False
    first, second = terms[k], terms[k + 2]
    sides = first.cat == second.cat == "dir" and {first.value, second.value} == _SIDES
    compass = first.cat == second.cat == "compass" and first.value != second.value
    return sides or (compass and not first.data.get("bound"))

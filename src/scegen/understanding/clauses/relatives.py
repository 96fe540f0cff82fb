"""Relative clauses: whom "which" is."""

from __future__ import annotations

from scegen.understanding.chunks import Mention
from scegen.understanding.clauses.state import State
from scegen.understanding.phrases.lookahead import is_word

_ITS = frozenset({"it", "him", "they"})


def antecedent(state: State) -> Mention:
    """The noun before "which": the last one that does not merely own something.

    In "the car ahead of us, which" and "there is a car ahead of the ego, which" it is the car.
    """
    nouns = [m for m in reversed(state.mentions) if not m.possessor] or state.mentions[-1:]
    other = _about_another(state)
    beside = [m for m in nouns if m.is_landmark and (told(m) or (other and m.is_ego))]
    return next((m for m in nouns if not (m in beside or m.aside)), nouns[0])


def _about_another(state: State) -> bool:
    """``a car ahead of the ego that …``, ``ahead of the ego, in its lane, which …``: of the car.

    "A car ahead of the ego, which …" is so where "there is" introduces the car.
    """
    begin = max(0, state.chunks.index(state.mentions[0]) - 1)
    k = next((k for k in range(state.k, 0, -1) if state.chunks[k].cat == "rel"), begin)
    if k <= begin:
        return False  # nothing stands before "which"
    comma, opened = is_word(state.chunks[k - 1], ","), [c.value for c in state.chunks[begin:k]]
    apart = not isinstance(state.chunks[k - 1 - comma], Mention)
    alone = not comma and state.waiting is not None and "be" not in opened
    return alone or apart or opened[0] == "thereis"


def told(mention: Mention) -> bool:
    """Whether one knows already who that is: "it", "them", "me"."""
    return mention.pronoun in _ITS or mention.is_me

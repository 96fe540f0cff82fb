"""People who drive, by what is said of them: "the woman coming the other way"."""

from __future__ import annotations

from scegen.understanding.chunks import Event, Place
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.tokens import Token

_OFF_THE_ROAD = frozenset({"access", "parking", "road", "junction"})


def _by_car(event: Event, tokens: list[Token]) -> bool:
    return tokens[event.i].forms[-1][0] in word_list("steering")


def in_traffic(event: Event, tokens: list[Token]) -> bool:
    """``the man coming the other way``, ``she turns into her drive``: only drivers do so.

    Args:
        event: what somebody does.
        tokens: the tokens of the text.
    """
    if event.name == "move":
        return any(d.value == "opposite" for d in event.dirs)
    goals: list[object] = [p.target for p in event.pps if p.value in {"into", "in"}]
    if event.name == "enter" and _by_car(event, tokens):
        goals.append(event.object)
    goes_in = any(isinstance(g, Place) and g.kind in _OFF_THE_ROAD for g in goals)
    return (
        event.name in {"turn", "sharp_turn", "pull_over", "enter"} and not event.nominal and goes_in
    )

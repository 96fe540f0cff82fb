"""Nothing is dropped silently: words of manner, place and measure that changed no field."""

from __future__ import annotations

from scegen.scenario.functional import Evidence, Unsupported
from scegen.understanding.tagging import Term
from scegen.understanding.tokens import Token

_INSTEAD = {
    "manner": "says how it is done; no field holds that here",
    "dir": "a direction that no rule could attach; left out",
    "locus": "a position that no rule could attach; left out",
    "compass": "a direction that no rule could attach; left out",
    "quantity": "a measure that no rule could attach; left out",
    "state": "a state that no rule could attach; left out",
    "env": "conditions are given once; the first counts",
    "control": "one rule of priority is kept for the whole junction; the strictest counts",
}
_EMPTY = frozenset({"mild", "same", "respectively"})
"""Words that stress or order what other words say."""
_MOST = 200


def unattached(
    terms: list[Term],
    tokens: list[Token],
    evidence: tuple[Evidence, ...],
    reported: tuple[Unsupported, ...],
) -> tuple[Unsupported, ...]:
    """Reports known words of manner, direction, state and measure on which nothing rests.

    Args:
        terms: the terms of the text.
        tokens: its tokens.
        evidence: what the fields rest on.
        reported: what is reported already.
    """
    spans = [(e.start, e.end) for e in evidence if e.start is not None and e.end is not None]
    spans += [(u.start, u.end) for u in reported]
    found = list(reported)
    for term in terms:
        start, end = tokens[term.i].start, tokens[term.j - 1].end
        if term.cat not in _INSTEAD or term.value in _EMPTY or len(found) >= _MOST:
            continue
        if any(a <= start and end <= b for a, b in spans):
            continue
        words = _words(tokens[term.i : term.j])
        found.append(Unsupported(text=words, start=start, end=end, instead=_INSTEAD[term.cat]))
    return tuple(sorted(found, key=lambda u: (u.start, u.end)))

"""Words for junctions, signs and lights that are not there, or that somebody carries."""

from __future__ import annotations

from itertools import dropwhile, islice

from scegen.understanding.words.terms import Term


def held(terms: list[Term], k: int) -> bool:
    """``a worker with a stop sign``: carried, not put up."""
    who, link = (None, None, *(t for t in terms[max(0, k - 3) : k] if t.cat != "det"))[-2:]
    carried = link is not None and (link.value == "with" or link.form == "ing")
    return carried and who is not None and (who.cat, who.value) == ("actor", "pedestrian")


def away_from(terms: list[Term], k: int) -> bool:
    """``outside a junction``, ``between two junctions``, ``without a junction``: on the road."""
    before = [t for t in terms[max(0, k - 3) : k] if t.cat not in {"shape", "num"}]
    last = next((t for t in reversed(before) if t.cat != "det" or t.value == "negative"), None)
    near = last.value if last is not None else ""
    between = near == "between" and terms[k].form == "s"
    return between or near in {"outside", "without", "negative"}


def negated(terms: list[Term], k: int) -> bool:
    """``no traffic lights``, ``without a stop sign``, ``neither lights nor signs``."""
    before = terms[max(0, k - 3) : k]
    listed = dropwhile(lambda t: t.cat in {"thing", "place", "conj", "det"}, reversed(terms[:k]))
    return any(t.cat == "neg" for t in islice(listed, 1)) or any(
        (t.cat == "det" and t.value == "negative") or t.value in {"without", "neither"}
        for t in before
    )

"""Where the words after a noun put it."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Prep, Thing
from scegen.understanding.clauses.dependents import chain
from scegen.understanding.clauses.state import State


def landmark(target: NounPhrase | Event | None) -> NounPhrase | Event | None:
    """``behind the ego's rear bumper``: behind the ego, as far as others are concerned.

    Args:
        target: what "behind" or "next to" governs.
    """
    part = isinstance(target, Thing) or (isinstance(target, Place) and target.kind == "shoulder")
    if part and isinstance(target, NounPhrase) and target.owner is not None:
        return target.owner
    return target


def as_the_ego_sees(mention: Mention) -> bool:
    """``the car ahead``, ``the car ahead of the ego``: placed by nobody but the ego.

    Args:
        mention: a noun with phrases of place.
    """
    return all(
        p.word.cat == "locus"
        and (
            p.target is None
            or (isinstance(p.target, Mention) and any(h.data.get("ego") for h in p.target.heads))
        )
        for p in mention.pps
    )


def loci_of(mention: Mention) -> set[str]:
    """Where a noun is said to be: "the car behind" is not "the car in front".

    Args:
        mention: a noun with phrases of place.
    """
    loci = {p.value for p in mention.pps if p.word.cat == "locus"}
    return loci | ({"elsewhere"} if mention.elsewhere else set())


def placed_last(state: State) -> Mention | None:
    """``I find the car behind me much too close``: the car, if its place was named last."""
    for mention in reversed(state.mentions):
        for prep in mention.pps:
            here = prep.target is None or prep.target in (state.anchor, state.last_pp)
            if prep.word.cat == "locus" and here and (prep.target or mention is state.anchor):
                return mention
    return None


def share_places(chunks: list[Chunk]) -> None:
    """``two cars and a truck ahead of the ego``: all of them are ahead.

    Args:
        chunks: the chunks of the text, clauses read.
    """
    for last in chunks:
        if not isinstance(last, Mention) or last.joined is None or not _newcomer(last):
            continue
        for prep in [p for p in last.pps if _from_the_ego(p)]:
            for other in chain(last)[:-1]:
                alike = _on_foot(other) == _on_foot(last)
                if not other.pps and _newcomer(other) and alike:
                    other.pps.append(prep)


def _newcomer(mention: Mention) -> bool:
    first = mention.mods[0] if mention.mods else None
    return bool(mention.heads) and (
        first is None or first.cat == "num" or (first.cat, first.value) == ("det", "indef")
    )


def _on_foot(mention: Mention) -> bool:
    return any(h.value == "pedestrian" for h in mention.heads)


def _from_the_ego(prep: Prep) -> bool:
    target = prep.target
    if prep.word.cat != "locus" or prep.value not in {"ahead", "behind"}:
        return False
    ego = isinstance(target, Mention) and any(h.data.get("ego") for h in target.heads)
    return ego or (target is None and prep.value == "ahead")

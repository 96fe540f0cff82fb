"""Who is meant by one that comes from somewhere, and by a doing that is told already."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Prep
from scegen.understanding.frames import acts

_SEVERAL = frozenset({"both", "all", "they"})
_SIDES = frozenset({"left", "right"})


def who_comes(chunks: list[Chunk], events: list[Event]) -> None:
    """``hits a cyclist at 15 km/h, coming from the left``: the ego comes from no own side."""
    for event in events:
        coming = (event.lemma, event.form) == ("come", "ing") and not event.finite
        ego = bool(event.subject) and all(m.is_ego for m in event.subject)
        if not (coming and ego and any(map(_from_a_side, event.pps))):
            continue
        named = [c for c in chunks if isinstance(c, Mention) and c.i < event.i and c.heads]
        others = [m for m in named if m.i > event.subject[0].i and not (m.is_ego or m.possessor)]
        event.subject = others[-1:] or event.subject


def named_again(events: list[Event]) -> None:
    """``… as the lane change begins``: of those who change lanes, not of who acts there."""
    for event in events:
        known = any((m.cat, m.value) == ("det", "def") for m in event.mods)
        if event.nominal and known and any(m.pronoun in _SEVERAL for m in event.subject):
            kind = acts().get(event.name)
            told = [e for e in events if e.i < event.i and e.finite and acts().get(e.name) is kind]
            event.subject = list(told[-1].subject) if told and kind else []


def _from_a_side(prep: Prep) -> bool:
    sided = prep.place is not None and bool(_SIDES & {*prep.place.dirs})
    return sided and prep.value == "from"

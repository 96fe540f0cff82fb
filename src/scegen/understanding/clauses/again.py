"""Who is meant by one that follows another again, or comes from somewhere."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Prep

_SIDES = frozenset({"left", "right"})


def followed_again(events: list[Event]) -> None:
    """``follows a car … the car that it follows brakes``: the same one.

    Args:
        events: of the text, in its order.
    """
    driven = [e for e in events if e.name == "follow" and not (e.passive or e.negated)]
    for n, event in enumerate(driven):
        whom = event.object
        if not isinstance(whom, Mention) or not event.subject or whom.i > event.subject[0].i:
            continue
        led = [e.object for e in driven[:n] if any(m.is_ego for m in e.subject)]
        before = [m for m in led if isinstance(m, Mention) and m.i < whom.i]
        if before and all(m.is_ego or m.pronoun for m in event.subject):
            whom.same_as = whom.same_as or before[-1]


def who_comes(chunks: list[Chunk], events: list[Event]) -> None:
    """``hits a cyclist at 15 km/h, coming from the left``: the ego comes from no side of its own.

    Args:
        chunks: of the text.
        events: of the text, in its order.
    """
    for event in events:
        coming = (event.lemma, event.form) == ("come", "ing") and not event.finite
        if not (coming and any(map(_from_a_side, event.pps))):
            continue
        if not event.subject or not all(m.is_ego for m in event.subject):
            continue
        named = [c for c in chunks if isinstance(c, Mention) and c.i < event.i and c.heads]
        others = [m for m in named if m.i > event.subject[0].i and not (m.is_ego or m.possessor)]
        event.subject = others[-1:] or event.subject


def _from_a_side(prep: Prep) -> bool:
    place = prep.target
    return prep.value == "from" and isinstance(place, Place) and bool(_SIDES & {*place.dirs})

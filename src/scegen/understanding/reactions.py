"""What somebody does because of something else in the same sentence."""

from __future__ import annotations

from scegen.understanding.chunks import Event, Place
from scegen.understanding.context import Context

_BRAKING = frozenset({"brake", "slow", "stop"})
_REAR = frozenset({"rear", "back"})


def mark_answers(events: list[Event]) -> None:
    """``braked but could not avoid the van``: who tries to avoid something brakes as an answer.

    Args:
        events: the events of a text.
    """
    avoiding = [e for e in events if e.name == "avoid"]
    for event in events:
        if event.name in _BRAKING and not event.nominal:
            event.modal = event.modal or any(_together(event, e) for e in avoiding)


def mark_late(events: list[Event], context: Context) -> None:
    """``failed to stop and hit it from behind``: for the one in front, not for a sign.

    Args:
        events: the events of a text.
        context: the scenario in the making.
    """
    rear_ends = [e for e in events if e.name == "collide" and into_rear(e, context)]
    for event in events:
        if event.name in _BRAKING and not event.nominal:
            event.late = any(_together(event, e) for e in rear_ends)


def into_rear(event: Event, context: Context) -> bool:
    """``rear-ends``, ``runs into the back of``, ``hits from behind``.

    Args:
        event: a collision.
        context: the scenario in the making.
    """
    ends = [event.object, *(p.target for p in event.pps)]
    rear = any(isinstance(c, Place) and "rear" in c.dirs for c in ends)
    words = {t.low for t in context.tokens[event.i : event.j]}
    behind = any(p.value == "behind" and p.outer == "from" for p in event.pps)
    return rear or behind or bool(words & _REAR)


def _together(one: Event, other: Event) -> bool:
    return one.sentence == other.sentence and one.subject == other.subject

"""What somebody does because of something else in the same sentence."""

from __future__ import annotations

from scegen.understanding.chunks import Event, Mention
from scegen.understanding.semantics.context import Context
from scegen.understanding.semantics.met import into_rear

_BRAKING = frozenset({"brake", "slow", "stop"})
_NOTICING = frozenset({"encounter", "overlook", "react"})


def mark_answers(events: list[Event]) -> None:
    """``braked but could not avoid the van``: who tries to avoid something brakes as an answer."""
    avoiding = [e for e in events if e.name == "avoid"]
    for event in events:
        if event.name in _BRAKING and not event.nominal:
            event.modal = event.modal or any(_together(event, e) for e in avoiding)


def mark_late(events: list[Event], context: Context) -> None:
    """``failed to stop and hit it from behind``: for the one in front, not for a sign."""
    stopped = [e for e in events if e.name in {"stop", "wait", "park"} and e.finite]
    standing = {who.index for event in stopped if not event.negated for who in event.doers}
    hits = [e for e in events if e.name == "collide"]
    entered = [e for e in events if any(p.value == "into" for p in e.pps)]  # "runs into its rear"
    rear_ends = [e for e in (*hits, *entered) if into_rear(e, context)]
    stood = [e for e in hits if _into_one_of(e, standing)]
    for event in events:
        if event.name in _BRAKING | _NOTICING and not event.nominal:
            failed = event.link != "ing"  # unlike "rode on without stopping and hit it"
            event.late = any(_together(event, e) for e in (*rear_ends, *(stood if failed else ())))


def _into_one_of(event: Event, standing: set[int]) -> bool:
    """Whether somebody is hit who stands."""
    hit = event.object.entities if isinstance(event.object, Mention) else []
    return not event.passive and any(e.index in standing for e in hit)


def _together(one: Event, other: Event) -> bool:
    return one.sentence == other.sentence and one.subject == other.subject

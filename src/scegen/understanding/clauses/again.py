"""``before the braking, both drive at …``: a doing that is named once more is no further one."""

from __future__ import annotations

from scegen.understanding.chunks import Event, Mention

_ALIKE = (
    frozenset({"brake", "hard_brake", "slow", "stop"}),
    frozenset({"lane_change", "cut_in", "cut_off", "merge", "pull_out"}),
    frozenset({"overtake", "pass", "bypass"}),
    frozenset({"turn", "sharp_turn"}),
)
"""What may be told of by each other's nouns."""


def named_again(events: list[Event]) -> None:
    """Who does what was told of before is not who is spoken of around its noun.

    Args:
        events: of the text, in its order.
    """
    for n, event in enumerate(events):
        definite = any((m.cat, m.value) == ("det", "def") for m in event.mods)
        if not event.nominal or not definite or event.negated:
            continue
        alike = next((kinds for kinds in _ALIKE if event.name in kinds), frozenset())
        if any(e.name in alike and e.finite and not (e.negated or e.modal) for e in events[:n]):
            event.subject = [m for m in event.subject if m.i < event.i or not _several(m)]


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


def _several(mention: Mention) -> bool:
    return len(mention.heads) > 0 and mention.heads[-1].form == "s"

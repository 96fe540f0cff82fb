"""Nobody: subjects that deny their verb of everybody."""

from __future__ import annotations

from scegen.scenario.vocabulary import ParticipantKind
from scegen.understanding.chunks import Event, Mention
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Entity
from scegen.understanding.reference.mention_words import KINDS

_OWED = frozenset({"yield", "stop", "brake", "slow", "wait", "turn", "move", "u_turn", "obey",
                   "inert", "leave", "swerve", "lane_change", "accelerate",
                   "reverse"})  # fmt: skip
"""What is told of everybody when nobody does it."""


_HIDING = frozenset({"hide", "block"})
"""What is not done if nothing does it; it is told of nobody in particular."""
_NONE = frozenset({"nobody", "everybody"})


def deny_of_everybody(events: list[Event]) -> None:
    """``no driver gives way``, ``nobody may turn left``: everybody does not."""
    for event in events:
        named = [m for m in event.subject if m.negated or m.pronoun in _NONE]
        verbal = not event.nominal and event.name in _OWED | _HIDING
        if not named or not verbal or event.form == "ing":
            continue
        if event.name in _HIDING:
            none = (m.has("det", "negative") or m.pronoun in _NONE for m in named)
            event.negated = event.negated or any(none)
            continue
        event.negated = True
        for mention in named:
            mention.negated, mention.pronoun = False, "everybody"


def everybody(mention: Mention, draft: Draft) -> list[Entity]:
    """Of whom "no driver", "no car" or "nobody" is said."""
    kinds = [KINDS[h.value] for h in mention.heads if h.value in KINDS]
    movers = [e for e in draft.entities if e.moving_vehicle]
    if not kinds or kinds == [ParticipantKind.CAR]:
        return movers
    return [e for e in draft.entities if e.kind in kinds and not e.parked]

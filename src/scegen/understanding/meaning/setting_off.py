"""Vehicles that stand at first: "a parked van suddenly pulls out"."""

from __future__ import annotations

from scegen.understanding.chunks import Event, Thing
from scegen.understanding.semantics.context import Context

_MOVING = frozenset({"pull_out", "unpark", "leave", "enter", "turn", "u_turn", "lane_change",
                     "reverse", "overtake", "cut_in", "cut_off", "merge", "move", "cross",
                     "accelerate", "swerve", "sharp_turn"})  # fmt: skip


def set_off(events: list[Event], context: Context) -> None:
    """Whoever is parked and then drives is not parked for the whole scenario.

    On a plain road it stands beside it and pulls out; elsewhere it drives from the start.
    """
    for event in events:
        moves = event.name in _MOVING and not event.nominal and event.premod_of is None
        gives = event.name == "leave" and isinstance(event.object, Thing)
        if not moves or event.negated or event.passive or gives:
            continue  # "parked vans leave 1 m of free space"
        for entity in (e for m in event.subject for e in m.entities):
            entity.sets_off = max(entity.sets_off, event.i)
            if entity.parked and not entity.ego:
                entity.was_parked = entity.parked_basis or entity.basis
                entity.parked, entity.parked_basis, entity.pulls_out = False, None, True
                context.draft.from_kerb = not context.junction.crossing

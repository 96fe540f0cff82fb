"""Verbs that only their phrases tell: "runs into the van", "moves within its lane"."""

from __future__ import annotations

from scegen.understanding.chunks import Mention, Place
from scegen.understanding.semantics.context import Clause, Context

_SHIFTING = frozenset({"move", "shift", "steer", "drift", "wander", "sway", "edge", "ease"})
_BEING = frozenset({"is", "are", "was", "were", "be", "been", "gets", "being"})


def contact_or_shift(clause: Clause, context: Context) -> str | None:
    """What a verb of motion is that ends at somebody, or within one's lane.

    Args:
        clause: what happens.
        context: the scenario in the making.
    """
    if _runs_into(clause, context):
        return "collide"
    return "swerve" if _within_its_lane(clause, context) else None


def _within_its_lane(clause: Clause, context: Context) -> bool:
    """``moves within its lane, 0.5 m to the right``: to the side, without leaving it."""
    event = clause.event
    shifts = event.name == "move" and event.lemma in _SHIFTING
    inside = [p for p in event.pps if context.tokens[p.word.i].low in {"within", "inside"}]
    lane = any(isinstance(p.target, Place) and p.target.kind == "lane" for p in inside)
    return shifts and lane and bool(clause.drivers)


def _flank(place: Place) -> bool:
    """``its right side``, ``the left flank of the van``."""
    owned = place.owner is not None or any(m.cat == "possessive" for m in place.mods)
    return place.kind in {"side", "flank"} and owned and bool({"left", "right"} & set(place.dirs))


def _runs_into(clause: Clause, context: Context) -> bool:
    """``runs into the van``, ``is run into from behind``: contact."""
    event = clause.event
    after = context.tokens[event.j].low if event.j < len(context.tokens) else ""
    lemma = event.lemma
    into = [p.target for p in event.pps if context.tokens[p.word.i].low == "into"]
    run = event.name in {"walk", "move"} and lemma in {"run", "drive"} and clause.drivers
    if not run or (after != "into" and not into):
        return False
    before = context.tokens[event.i - 1].low if event.i else ""
    if before in _BEING and lemma == "run":
        clause.actors, clause.targets = [], clause.actors
        return True
    rear = [t for t in into if isinstance(t, Place) and ("rear" in t.dirs or _flank(t))]
    met = [t for t in into if isinstance(t, Mention) and any(e.is_vehicle for e in t.entities)]
    met += [t for t in into if isinstance(t, Mention) and lemma == "run"]
    clause.targets = clause.targets or [e for t in met for e in t.entities]
    return bool(rear or met)

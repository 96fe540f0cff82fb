"""Role nouns that say what their bearer does: "a tailgater", "the red-light runner"."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding.chunks import Mention
from scegen.understanding.draft import Basis
from scegen.understanding.semantics.context import Context

_WHERE = {HazardKind.TAILGATING: Approach.BEHIND, HazardKind.ONCOMING_LANE: Approach.OPPOSITE}
_HOW = {HazardKind.OVERTAKING: Maneuver.OVERTAKE, HazardKind.CUT_IN: Maneuver.LANE_CHANGE}


def act_by_name(mention: Mention, context: Context) -> None:
    """Adds the danger that a role noun names, with where its bearer must be.

    Args:
        mention: a noun, resolved.
        context: the scenario in the making.
    """
    for head in mention.heads:
        drivers = [e for e in mention.entities if e.moving_vehicle]
        if "does" not in head.data or not drivers:
            continue
        kind, basis = HazardKind(head.data["does"]), Basis(head.i, head.j)
        context.draft.hazard(kind, basis, drivers)
        for entity in drivers:
            seen = any(p.entity is entity for p in context.draft.placements)
            if kind in _WHERE and not seen and not entity.ego:
                context.draft.place(entity, None, {_WHERE[kind]}, basis)
            if kind in _HOW:
                context.draft.maneuver(entity, {_HOW[kind]}, basis)

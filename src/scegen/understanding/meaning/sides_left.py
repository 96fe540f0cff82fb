"""Sides that are named apart from the verb: "so from the right, as the ego sees it"."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.chunks import Chunk, Place
from scegen.understanding.draft import Basis
from scegen.understanding.semantics.context import Context

_SIDES = {"left": Approach.LEFT, "right": Approach.RIGHT}


def sides_left(chunks: list[Chunk], context: Context) -> None:
    """Gives such a side to the one who crosses, if only one does of whom no side is said."""
    lateral = set(_SIDES.values())
    placed = {p.entity.index for p in context.draft.placements if p.approaches & lateral}
    used = [(p.basis.i, p.basis.j) for p in context.draft.placements if not p.entity.ego]
    crossers = [
        e
        for e in context.draft.entities
        if Maneuver.CROSS in e.maneuvers and e.index not in placed and not e.ego
    ]
    for place in chunks:
        if not isinstance(place, Place) or place.prep is None or len(crossers) != 1:
            continue
        sides = {_SIDES[d] for d in place.dirs if d in _SIDES}
        apart = place.kind in {"side", "sidewalk"} and place.prep.value == "from"
        taken = any(i is not None and j and i <= place.i < j for i, j in used)
        if len(sides) == 1 and apart and not taken:
            basis = Basis(place.prep.i, place.j)
            context.draft.place(crossers[0], None, sides, basis)
            return

"""Turns that are said by the road they lead onto: "joins the main road to the left"."""

from __future__ import annotations

from scegen.scenario.vocabulary import Maneuver
from scegen.understanding.chunks import Place
from scegen.understanding.meaning import ways
from scegen.understanding.meaning.lane_moves import apply, merge
from scegen.understanding.semantics.context import Clause, Context

_ROADS = frozenset({"road", "highway", "leg", "access"})
_ENTERING = frozenset({"enter", "merge", "pull_out"})


def onto_a_road(clause: Clause, context: Context) -> bool:
    """``enters the main road to the right``: the side to which it leads is the turn.

    Args:
        clause: what happens.
        context: the scenario in the making.
    """
    event = clause.event
    goals = [event.object, *(p.target for p in event.pps if p.value == "into")]
    road = any(isinstance(g, Place) and g.kind in _ROADS for g in goals)
    found = ways.directions(event, context.tokens) if road and event.name in _ENTERING else {}
    sideways = {m: basis for m, basis in found.items() if m is not Maneuver.STRAIGHT}
    if sideways:
        basis = next(iter(sideways.values()))
        context.crossing_implied(basis, "vehicles turn")
        apply(clause, context, set(sideways), basis)
    return bool(sideways)


def join(clause: Clause, context: Context) -> None:
    """``joins the traffic``: merging, unless a turn onto another road is told.

    Args:
        clause: what happens.
        context: the scenario in the making.
    """
    if not onto_a_road(clause, context):
        merge(clause, context)

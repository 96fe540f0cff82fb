"""Dangers from where a movement leads."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind, Maneuver
from scegen.understanding.draft import Basis
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.ways import against, head_on


def oncoming_lane(clause: Clause, context: Context) -> None:
    """A movement into or along the lane of oncoming traffic."""
    sources = {id(p.target) for p in clause.event.pps if p.value in {"from", "against"}}
    had = {id(p.target) for p in clause.event.pps if p.value in {"with", "without"}}
    for place in clause.places():
        if id(place) in sources:
            continue  # "coming from opposite lanes": where one belongs
        if place.kind == "centerline" and (place.owner is not None or id(place) in had):
            continue  # "right of the ego's centre line", "a crossroads with a median"
        lane = place.kind == "lane" and "opposite" in place.dirs and place.owner is None
        lane = lane or head_on(clause, place, context)
        wrong = [e for e in clause.drivers if against(e, place)]
        if lane or wrong or place.kind == "centerline":
            over = place.kind == "centerline" or bool(wrong) or "opposite" not in place.dirs
            by = [e for e in wrong or clause.drivers if over or not context.oncoming(e)]
            meets = clause.event.name == "approach"
            by = [e for e in by if not meets or Maneuver.OVERTAKE in e.maneuvers]
            if by:
                basis = Basis(place.i, place.j)
                context.draft.hazard(HazardKind.ONCOMING_LANE, basis, by)

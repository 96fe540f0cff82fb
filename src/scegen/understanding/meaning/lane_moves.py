"""Movements from lane to lane: changes of lane, merging, the oncoming lane."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind, Maneuver
from scegen.understanding.chunks import Mention, Place
from scegen.understanding.draft import Basis
from scegen.understanding.meaning import ways
from scegen.understanding.semantics.context import Clause, Context

_HALF = frozenset({"half", "halfway", "partly", "partially", "midway", "way"})


def apply(clause: Clause, context: Context, values: set[Maneuver], basis: Basis) -> None:
    """Says what the drivers of a clause do.

    Args:
        clause: what happens.
        context: the scenario in the making.
        values: the movements that the words allow.
        basis: the words.
    """
    alternative = clause.alternative
    for entity in clause.drivers:
        later = context.in_order(entity.maneuver_basis, clause.event)
        context.draft.maneuver(entity, values, basis, alternative, later=later)


def lane_change(clause: Clause, context: Context) -> None:
    """A change of lane on the way; where the vehicle leaves stays free."""
    basis = Basis(clause.event.i, clause.event.j)
    context.lanes_implied(basis, "a lane change needs a second lane")
    apply(clause, context, {Maneuver.LANE_CHANGE}, basis)


def merge(clause: Clause, context: Context) -> None:
    """Merging on a road without a junction, or into a lane, is a lane change."""
    meets = context.junction.crossing or context.draft.access is not None
    if ways.into_lane(clause.event) is not None or not meets:
        lane_change(clause, context)


def between_lanes(mention: Mention, context: Context) -> None:
    """``the ego is half in its lane and half in the next``: it is changing lanes.

    Args:
        mention: who is there.
        context: the scenario in the making.
    """
    words = {context.tokens[m.j - 1].low for m in mention.mods} | {
        context.tokens[p.word.i - 1].low for p in mention.pps if p.word.i
    }
    lanes = [p.target for p in mention.pps if isinstance(p.target, Place)]
    lanes = [p for p in lanes if p.kind == "lane" and ways.BESIDE & set(p.dirs)]
    movers = [e for e in mention.entities if e.moving_vehicle and not e.maneuvers]
    for entity in movers if lanes and words & _HALF else []:
        basis = Basis(mention.i, lanes[-1].j)
        context.lanes_implied(basis, "a lane change needs a second lane")
        context.draft.maneuver(entity, {Maneuver.LANE_CHANGE}, basis)


def swerve(clause: Clause, context: Context) -> None:
    """``swerves into the oncoming lane``, ``veers into the left lane``."""
    lane = ways.into_lane(clause.event)
    if lane is None or lane.kind != "lane" or lane.owner is not None:
        return
    if "opposite" in lane.dirs and not any(context.oncoming(e) for e in clause.drivers):
        use_oncoming_lane(clause, lane, context)
    elif ways.next_lane(clause.event, context):
        lane_change(clause, context)


def forced(clause: Clause, context: Context) -> None:
    """``is forced into the opposite lane``, ``pushes the ego into the left lane``."""
    lane = ways.into_lane(clause.event)
    moved = [e for e in clause.targets if e.moving_vehicle]
    if lane is None or lane.kind != "lane" or not moved:
        return
    if "opposite" in lane.dirs:
        use_oncoming_lane(Clause(clause.event, moved, []), lane, context)
    elif ways.BESIDE & set(lane.dirs):
        lane_change(Clause(clause.event, moved, []), context)


def use_oncoming_lane(clause: Clause, lane: Place, context: Context) -> None:
    """Whoever is in the oncoming lane passes something there.

    Args:
        clause: what happens.
        lane: the oncoming lane.
        context: the scenario in the making.
    """
    reason = "the oncoming lane is used to get past something"
    basis = Basis(clause.event.i, max(clause.event.j, lane.j), reason)
    apply(clause, context, {Maneuver.OVERTAKE}, basis)


def on_the_wrong_side(mention: Mention, context: Context) -> None:
    """``an oncoming bus in the ego's lane``: it has no business there.

    Args:
        mention: who is there.
        context: the scenario in the making.
    """
    if "opposite" not in mention.dirs:
        return
    for prep in mention.pps:
        lane = prep.target
        owner = lane.owner if isinstance(lane, Place) and lane.kind == "lane" else None
        if prep.value == "in" and owner is not None and any(e.ego for e in owner.entities):
            by = [e for e in mention.entities if e.moving_vehicle]
            basis = Basis(prep.word.i, owner.j)
            context.draft.hazard(HazardKind.ONCOMING_LANE, basis, by, owner.entities)

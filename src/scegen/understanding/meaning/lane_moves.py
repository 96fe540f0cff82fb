"""Movements from lane to lane: changes of lane, merging, the oncoming lane."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind, Maneuver
from scegen.understanding.chunks import Mention, Place
from scegen.understanding.draft import Basis
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics import ways
from scegen.understanding.semantics.context import Clause, Context


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
    for entity in movers if lanes and words & word_list("half") else []:
        basis = Basis(mention.i, lanes[-1].j)
        context.lanes_implied(basis, "a lane change needs a second lane")
        context.draft.maneuver(entity, {Maneuver.LANE_CHANGE}, basis)


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

"""Pulling out: of a side road or a parking space, or from lane to lane."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding.meaning import lane_moves
from scegen.understanding.meaning.conflicts import lane_change, mentioned
from scegen.understanding.meaning.ways import into_lane
from scegen.understanding.semantics.context import Clause, Context

_ASIDE = frozenset({"access", "parking", "shoulder", "sidewalk", "junction", "bus_stop"})


def pull_out(clause: Clause, context: Context) -> None:
    """Leaving a side road or a parking space without giving way."""
    out_of_sight = any(p.word.cat == "locus" and p.outer == "from" for p in clause.event.pps)
    drivers = [e for e in clause.drivers if not (out_of_sight and context.is_cyclist(e))]
    drivers = [e for e in drivers if Maneuver.OVERTAKE not in e.maneuvers]  # out of its lane
    front = [] if out_of_sight else mentioned(clause.event)
    if front and any(context.placed(e, Approach.AHEAD) for e in drivers):
        context.draft.hazard(HazardKind.CUT_IN, clause.words, drivers, front)
        return  # out of the queue that is being overtaken
    _out_of_the_row(clause, context)
    along = any(context.placed(e, a) for e in drivers for a in (Approach.BEHIND, Approach.AHEAD))
    if drivers and _into_the_next_lane(clause, context):
        lane_moves.lane_change(clause, context)
        lane_change(clause, context)
        return
    if drivers and not along and not _to_overtake(clause, context):
        parking = any(p.kind == "parking" for p in clause.places())
        for entity in drivers:
            entity.pulls_out = True
            if parking:
                entity.was_parked = entity.was_parked or clause.words
        to = [] if out_of_sight else mentioned(clause.event)
        context.draft.hazard(HazardKind.FAILURE_TO_YIELD, clause.words, drivers, to)


def _out_of_the_row(clause: Clause, context: Context) -> None:
    """``the slow van ahead pulls out as well``: it leaves its lane, and no side road."""
    aside = any(p.kind in _ASIDE for p in clause.places()) or context.junction.crossing
    for entity in [] if aside else clause.drivers:
        if context.placed(entity, Approach.AHEAD) and not (entity.ego or entity.maneuvers):
            context.lanes_implied(clause.words, "pulling out needs a second lane")
            context.draft.maneuver(entity, {Maneuver.LANE_CHANGE}, clause.words)


def _into_the_next_lane(clause: Clause, context: Context) -> bool:
    """``pulls out into the left lane``: from lane to lane, unless it comes out of somewhere."""
    lane = into_lane(clause.event)
    sides = {"left", "right", "adjacent", "opposite"}
    named = lane is not None and lane.head is not None and lane.head.j - lane.head.i > 1
    named = named and not context.junction.crossing  # "the overtaking lane"
    beside = lane is not None and lane.kind == "lane" and (named or bool(sides & set(lane.dirs)))
    out = any(p.kind in _ASIDE for p in clause.places())
    kerb = any(context.comes_across(e) for e in clause.drivers) or context.draft.from_kerb
    return beside and not out and not kerb


def _to_overtake(clause: Clause, context: Context) -> bool:
    """``pulls out to pass``, ``from behind a bus``: out of a lane, not out of a side road."""
    around = {"around", "round", "past"}
    if any(context.tokens[p.word.i].low in around for p in clause.event.pps):
        return True
    following = [c.name for c in clause.event.children]
    purpose = clause.event.parent.name if clause.event.parent is not None else ""
    return bool({*following, purpose} & {"overtake", "bypass", "pass"})

"""Dangers from how one vehicle drives, and the table of all rules about dangers."""

from __future__ import annotations

from collections.abc import Callable

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding.chunks import Mention, Place
from scegen.understanding.draft import Basis
from scegen.understanding.meaning import (
    braking,
    breaches,
    conflicts,
    encounters,
    forcing,
    lane_moves,
    pulling_out,
    returning,
    screens,
)
from scegen.understanding.meaning.reactions import endangered
from scegen.understanding.meaning.walking import keep_along
from scegen.understanding.meaning.ways import against, into_lane
from scegen.understanding.semantics.context import Clause, Context


def accelerate(clause: Clause, context: Context) -> None:
    """Speeding up is a danger unless it is an answer to one."""
    if all(e.ego for e in clause.drivers) and clause.sudden is None and endangered(context):
        return  # "speeds up to get clear of it"
    starts = any(p.kind == "signal" for p in clause.places()) and clause.sudden is None
    starts = starts and any(
        p.value in {"from", "outside"} for p in clause.event.pps
    )  # "away from a light"
    if not (clause.reaction or starts) and clause.drivers and clause.how("slow") is None:
        basis = clause.sudden or clause.words
        context.draft.hazard(HazardKind.SUDDEN_ACCELERATION, basis, clause.drivers)


def speed(clause: Clause, context: Context) -> None:
    """``speeds``, ``a speeding car``."""
    if clause.drivers:
        context.draft.hazard(HazardKind.SPEEDING, clause.words, clause.drivers)


def move(clause: Clause, context: Context) -> None:
    """``moves left into the lane of the van``: a change of lane."""
    lane = into_lane(clause.event)
    sideways = any(t.value in {"left", "right"} for t in clause.event.dirs)
    if lane is not None and lane.kind == "lane":
        if sideways or clause.how("sudden", "emergency", "aggressive") is not None:
            conflicts.lane_change(clause, context)
            if conflicts.cuts_in(clause, context):
                lane_moves.lane_change(clause, context)
        elif lane is not clause.event.object:
            conflicts.enter(clause, context)
    encounters.ride(clause, context)
    keep_along(clause, context)
    close = clause.how("close")
    behind = [e for e in clause.drivers if context.placed(e, Approach.BEHIND)]
    if close is not None and behind:
        context.draft.hazard(HazardKind.TAILGATING, close, behind)


def crawl(clause: Clause, context: Context) -> None:
    """Verbs that say that somebody drives slowly."""
    if clause.drivers and not clause.reaction:
        context.draft.hazard(HazardKind.SLOW_DRIVING, clause.words, clause.drivers)


def swerve(clause: Clause, context: Context) -> None:
    """Swerving, weaving, drifting; what the ego does to avoid another danger is its answer."""
    answers = clause.reaction or endangered(context)
    drivers = [e for e in clause.drivers if not (answers and e.ego)]
    if not drivers or (clause.event.modal and any(e.ego for e in drivers)):
        return
    context.draft.hazard(HazardKind.SWERVING, clause.words, drivers, clause.targets)
    ahead = [p for p in clause.event.pps if p.word.cat == "locus" and p.value == "ahead"]
    whom = [e for p in ahead if isinstance(p.target, Mention) for e in p.target.entities]
    if whom and not clause.reaction and not any(context.oncoming(e) for e in drivers):
        conflicts.cut_in(clause, context)  # "swings out in front of the bus"


def oncoming_lane(clause: Clause, context: Context) -> None:
    """A movement into or along the lane of oncoming traffic."""
    sources = {id(p.target) for p in clause.event.pps if p.value in {"from", "against"}}
    for place in clause.places():
        if id(place) in sources:
            continue  # "coming from opposite lanes": where one belongs
        if place.kind == "centerline" and place.owner is not None:
            continue  # "right of the ego's centre line": no line on the road
        lane = place.kind == "lane" and "opposite" in place.dirs and place.owner is None
        lane = lane or conflicts.head_on(clause, place, context)
        wrong = [e for e in clause.drivers if against(e, place)]
        if lane or wrong or place.kind == "centerline":
            over = place.kind == "centerline" or bool(wrong) or "opposite" not in place.dirs
            by = [e for e in wrong or clause.drivers if over or not context.oncoming(e)]
            meets = clause.event.name == "approach"
            by = [e for e in by if not meets or Maneuver.OVERTAKE in e.maneuvers]
            if by:
                basis = Basis(place.i, place.j)
                context.draft.hazard(HazardKind.ONCOMING_LANE, basis, by)


def enter(clause: Clause, context: Context) -> None:
    """People enter the road on foot, vehicles a lane."""
    encounters.walk(clause, context)
    encounters.ride(clause, context)
    conflicts.enter(clause, context)


def tailgate(clause: Clause, context: Context) -> None:
    """Following too closely."""
    context.draft.hazard(HazardKind.TAILGATING, clause.words, clause.drivers, clause.targets)


def follow(clause: Clause, context: Context) -> None:
    """Following is tailgating when close."""
    close = clause.how("close")
    if close is not None:
        context.draft.hazard(HazardKind.TAILGATING, close, clause.drivers, clause.targets)


def undertake(clause: Clause, context: Context) -> None:
    """``undertakes me``: overtaking on the near side; "undertakes a turn" is none."""
    if clause.targets:
        conflicts.overtake(clause, context)


def swerve_around(clause: Clause, context: Context) -> None:
    """``swerves around the ego``: getting past somebody, but swerving it is."""
    others = [e for e in clause.drivers if not e.ego]
    if others and clause.event.lemma == "swerve":
        context.draft.hazard(HazardKind.SWERVING, clause.words, others, clause.targets)


def cut_bend(clause: Clause, context: Context) -> None:
    """``an oncoming truck cuts the bend``: through the lane of the others."""
    by = [e for e in clause.drivers if context.oncoming(e)]
    meet = context.junction.crossing or context.draft.crossing_implied is not None
    if by and not meet:
        context.draft.hazard(HazardKind.ONCOMING_LANE, clause.words, by)


def reverse(clause: Clause, context: Context) -> None:
    """Driving backwards; out of a driveway one comes from the side."""
    context.draft.hazard(HazardKind.REVERSING, clause.words, clause.drivers)
    event, draft = clause.event, context.draft
    out_of = [p.target for p in event.pps if p.value in {"of", "from"}]
    met = any(e.moving_vehicle and e not in clause.actors for e in draft.entities)
    if not met or not any(isinstance(p, Place) and p.kind == "access" for p in out_of):
        return
    for entity in [e for e in clause.drivers if not e.ego]:
        # "in front of the ego" says where it gets to, not where it comes from
        draft.placements[:] = [
            p
            for p in draft.placements
            if p.entity is not entity or p.approaches != {Approach.AHEAD}
        ]
        if not any(p.entity is entity for p in draft.placements):
            draft.place(entity, None, {Approach.LEFT, Approach.RIGHT}, clause.words)


def lose_control(clause: Clause, context: Context) -> None:
    """Skidding and the like."""
    if clause.drivers:
        context.draft.hazard(HazardKind.LOSS_OF_CONTROL, clause.words, clause.drivers)


def park(clause: Clause, context: Context) -> None:
    """``parked in its lane``: whoever drives there has to get past it."""
    lanes = [p for p in clause.places() if p.kind == "lane"]
    driven = any(not {"adjacent", "opposite", "lateral"} & set(p.dirs) for p in lanes)
    parked = [e for e in clause.actors if e.still]
    if driven and parked:
        context.draft.hazard(HazardKind.OBSTACLE, clause.words, parked)


DANGERS: dict[str, Callable[[Clause, Context], None]] = {
    "accelerate": accelerate,
    "speed": speed,
    "brake": braking.brake,
    "hard_brake": braking.hard_brake,
    "slow": braking.slow,
    "stop": braking.stop,
    "wait": braking.wait,
    "swerve": swerve,
    "turn": conflicts.turn,
    "sharp_turn": conflicts.turn,
    "lane_change": conflicts.lane_change,
    "cut_in": conflicts.cut_in,
    "cut_off": conflicts.cut_in,
    "merge": conflicts.merge,
    "overtake": conflicts.overtake,
    "pass": conflicts.overtake,
    "pull_out": pulling_out.pull_out,
    "tailgate": tailgate,
    "follow": follow,
    "cross": encounters.cross,
    "walk": encounters.walk,
    "collide": encounters.struck,
    "enter": enter,
    "move": move,
    "unpark": conflicts.unpark,
    "leave": conflicts.leave,
    "appear": encounters.appear,
    "block": screens.block,
    "hide": screens.occlude,
    "cause": forcing.cause,
    "send": forcing.cause,
    "door": encounters.door,
    "encounter": braking.too_late,
    "react": braking.too_late,
    "crawl": crawl,
    "bypass": swerve_around,
    "undertake": undertake,
    "return": returning.pull_back,
    "use": breaches.take_priority,
    "cut_bend": cut_bend,
    "reverse": reverse,
    "lose_control": lose_control,
    "delay": braking.delay,
    "park": park,
}
"""Event -> what it means for danger."""

"""What an event says about where a participant goes."""

from __future__ import annotations

from collections.abc import Callable

from scegen.scenario.vocabulary import Approach, HazardKind, JunctionKind, Maneuver
from scegen.understanding.chunks import Event, Mention, Place, Thing
from scegen.understanding.draft import Basis
from scegen.understanding.meaning import courses, ways
from scegen.understanding.meaning.crossed_arms import crossed_road
from scegen.understanding.meaning.lane_moves import (
    apply,
    forced,
    lane_change,
    swerve,
    use_oncoming_lane,
)
from scegen.understanding.meaning.onto_roads import join, onto_a_road
from scegen.understanding.semantics.context import Clause, Context, span

_ASIDE = frozenset({"move", "shift", "steer", "edge", "ease"})
"""Verbs that on an open road mean a shift to the side, not a turn."""
_OFF = frozenset({"access", "road", "leg", "junction"})
"""Places that one turns into."""
_REACH = 3
_ORDINALS = {
    "first": Maneuver.EXIT_1,
    "second": Maneuver.EXIT_2,
    "third": Maneuver.EXIT_3,
    "fourth": Maneuver.EXIT_4,
    "fifth": Maneuver.EXIT_5,
    "sixth": Maneuver.EXIT_6,
}


def turn(clause: Clause, context: Context) -> None:
    """``turns left``, ``a right turn``, ``turns to the left``; without a side, either one."""
    event = clause.event
    directions = ways.directions(event, context.tokens)
    basis = next(iter(directions.values()), Basis(event.i, event.j))
    if not directions and ways.into_lane(event):
        return
    if ways.only_signalled(event, context):
        return
    cyclists = [e for e in clause.drivers if context.is_cyclist(e) and not e.ego]
    if cyclists and cyclists == clause.drivers and ways.across_the_road(event, context):
        return  # they cross the road, see the dangers
    denied = {ways.DIRECTIONS[d] for d in event.denied_ways if d in ways.DIRECTIONS}
    values = set(directions) or ({Maneuver.LEFT, Maneuver.RIGHT} - denied) or {Maneuver.STRAIGHT}
    alike = _as_others_do(clause, context) if not directions else set()
    if alike:
        values = alike
    elif not directions:
        made = event.parent is not None and event.parent.name in {"light", "try"}
        if any(entity.maneuvers for entity in clause.actors) or (event.nominal and not made):
            return
        if not denied:
            basis = Basis(basis.i, basis.j, "the text does not say which way it turns")
    context.crossing_implied(basis, "vehicles turn")
    apply(clause, context, values, basis)


def _as_others_do(clause: Clause, context: Context) -> set[Maneuver]:
    """``the car ahead, which is turning as well``: the same way as the one before."""
    event = clause.event
    near = [t.low for t in context.tokens[max(0, event.i - _REACH) : event.j + _REACH]]
    if not {"too", "also", "likewise"} & set(near) and "as well" not in " ".join(near):
        return set()
    turns = {Maneuver.LEFT, Maneuver.RIGHT}
    ways = [e.maneuvers & turns for e in context.draft.entities if e not in clause.actors]
    told = [way for way in ways if len(way) == 1]
    return set(told[-1]) if told else set()


def move(clause: Clause, context: Context) -> None:
    """``goes straight``, ``drives``, ``continues to the left``."""
    event = clause.event
    directions = ways.directions(event, context.tokens)
    straight = any(p.kind in {"road", "highway"} and "straight" in p.dirs for p in clause.places())
    aside = event.lemma in _ASIDE and not context.junction.crossing
    aside = aside and not any(
        p.value in {"into", "to"} and isinstance(p.target, Place) and p.target.kind in _OFF
        for p in event.pps
    )
    sideways = set(directions) & {Maneuver.LEFT, Maneuver.RIGHT}
    lane = ways.into_lane(event)
    if ways.next_lane(event, context) or (
        sideways and (aside or (lane is not None and lane.kind == "lane"))
    ):
        lane_change(clause, context)  # "moves left into the next lane"
        return
    if any(p.kind == "exit" for p in clause.places()):
        leave(clause, context)
    through = ways.through(event, context)
    for entity in clause.drivers:
        entity.through = entity.through or through
        entity.moves = entity.moves or Basis(event.i, event.j)
        entity.on_straight = entity.on_straight or straight
    if not directions:
        return
    values = set(directions)
    basis = next(iter(directions.values()))
    if any(context.tokens[m.i].low == "instead" for m in event.mods):
        for entity in clause.drivers:
            entity.maneuvers = set()  # "was waiting to turn left, goes straight instead"
    if ways.side_to_side(event) and any(not context.is_cyclist(e) for e in clause.drivers):
        context.crossing_implied(basis, "a vehicle comes across")
    if values & {Maneuver.LEFT, Maneuver.RIGHT}:
        context.crossing_implied(basis, "vehicles turn")
    apply(clause, context, values, basis)


def u_turn(clause: Clause, context: Context) -> None:
    """A U-turn."""
    basis = Basis(clause.event.i, clause.event.j)
    apply(clause, context, {Maneuver.U_TURN}, basis)


def overtake(clause: Clause, context: Context) -> None:
    """Overtaking, or passing something that stands in the lane."""
    event = clause.event
    _whom(clause, context)
    if event.name == "bypass" and event.object is None and not event.passive:
        by = context.tokens[event.j - 1].low == "past"
        behind = any(context.placed(e, Approach.BEHIND) for e in clause.drivers)
        if (by or event.pps) and not behind:
            move(clause, context)  # "waits for the bus to go past"
            return
    dodges = isinstance(event.object, Thing) and any(context.oncoming(e) for e in clause.drivers)
    if event.name == "bypass" and (isinstance(event.object, Place) or dodges):
        return  # "an oncoming moped swerves round a pothole"
    if not ways.overtaking(clause, context) or ways.past_the_roadside(clause, context):
        move(clause, context)
        return
    basis = Basis(event.i, event.j)
    means = event.parent if event.link == "inf" else None
    if not (means is not None and _changes_lane(means)):
        apply(clause, context, {Maneuver.OVERTAKE}, basis)
    if any(entity.moving_vehicle for entity in clause.targets):
        draft = context.draft
        draft.passing_implied = draft.passing_implied or basis
    egos = [e for e in clause.targets if e.ego]
    stated = {
        p.entity.index
        for p in context.draft.placements
        if p.reference in clause.targets
        or (p.reference is None and (egos or p.approaches != {Approach.ADJACENT}))
    }
    if not any(e.index in stated for e in clause.actors):
        context.ahead(clause.targets, clause.actors, basis)


def _whom(clause: Clause, context: Context) -> None:
    """``drives behind a tractor and overtakes``: the one ahead."""
    event = clause.event
    if event.name != "overtake" or clause.targets or event.object is not None or event.passive:
        return
    leaders = [
        p.entity
        for p in context.draft.placements
        if p.approaches == {Approach.AHEAD}
        and (p.reference in clause.actors or p.reference is None)
    ]
    one = [e for e in dict.fromkeys(leaders) if e.moving_vehicle and e not in clause.actors]
    if len(one) == 1 and any(e.ego for e in clause.actors):
        clause.targets = one


def pull_around(clause: Clause, context: Context) -> None:
    """``pulls out around a parked van``: past it; onto a road to one side, a turn."""
    onto_a_road(clause, context)
    for prep in clause.event.pps:
        around = context.tokens[prep.word.i].low in {"around", "round", "past"}
        passed = prep.target.entities if isinstance(prep.target, Mention) else []
        if around and passed:
            overtake(Clause(clause.event, clause.actors, list(passed)), context)
            return


def undertake(clause: Clause, context: Context) -> None:
    """Overtaking on the near side, if it is done to somebody."""
    if clause.targets:
        overtake(clause, context)


def _changes_lane(event: Event) -> bool:
    """``changes lanes to get past``: the change of lane is the movement, the rest its purpose."""
    return event.name == "lane_change" or any(c.name == "lane_change" for c in event.children)


def cross(clause: Clause, context: Context) -> None:
    """Who walks, crosses; a vehicle that crosses a junction goes straight through."""
    basis = Basis(clause.event.i, clause.event.j)
    for entity in clause.actors:
        open_road = not context.junction.crossing and context.draft.crossing_implied is None
        onto = _onto_road(clause.event) or (open_road and clause.event.object is None)
        if not entity.is_vehicle or (context.is_cyclist(entity) and onto):
            context.draft.maneuver(entity, {Maneuver.CROSS}, basis)
    drivers = [e for e in clause.drivers if Maneuver.CROSS not in e.maneuvers]
    lanes = isinstance(clause.event.object, Place) and clause.event.object.kind == "lane"
    if lanes and drivers and not context.junction.crossing:
        lane_change(clause, context)  # "crosses two lanes to get to the exit"
        return
    if ways.directions(clause.event, context.tokens) and drivers:
        move(clause, context)
        return
    for entity in drivers:
        if not entity.maneuvers and not _onto_road(clause.event):
            reason = "a vehicle that crosses goes straight through"
            context.draft.maneuver(
                entity, {Maneuver.STRAIGHT}, Basis(basis.i, basis.j, reason), clause.alternative
            )


def _onto_road(event: Event) -> bool:
    """The road itself, a crosswalk or somebody's way is crossed, not a junction."""
    places = [event.object, *(p.target for p in event.pps)]
    kinds = {p.kind for p in places if isinstance(p, Place)}
    return (
        crossed_road(event)
        or bool(kinds & {"road", "crosswalk", "lane", "path", "highway", "centerline"})
        or (not kinds and event.object is None)
    )


def leave(clause: Clause, context: Context) -> None:
    """``takes the second exit`` of a roundabout."""
    target = clause.event.object
    exits = [p for p in clause.places() if p.kind == "exit"]
    target = exits[0] if exits else target
    if not isinstance(target, Place):
        _set_off(clause, context)
        return
    if target.kind == "side":
        sides = {ways.DIRECTIONS[d] for d in target.dirs if d in {"left", "right"}}
        if sides and clause.event.name == "leave" and target.head is not None:
            drivers = [e for e in clause.drivers if not clause.reaction]
            context.draft.hazard(HazardKind.LOSS_OF_CONTROL, clause.words, drivers)
            return  # "departs the right edge of the road"
        if sides:
            basis = span(clause.event, target.i, target.j)
            context.crossing_implied(basis, "vehicles turn")
            apply(clause, context, sides, basis)
        return
    if target.kind != "exit":
        return
    ordinal = next((m.value for m in target.mods if m.value in _ORDINALS), None)
    if ordinal is not None:
        basis = Basis(target.i, target.j)
        apply(clause, context, {_ORDINALS[ordinal]}, basis)


def _set_off(clause: Clause, context: Context) -> None:
    """``sets off straight ahead``, ``moves off to the left``: which way it leaves."""
    found = ways.directions(clause.event, context.tokens) if clause.event.name == "leave" else {}
    if found and context.junction.kind is not JunctionKind.ROUNDABOUT and not clause.event.nominal:
        apply(clause, context, set(found), next(iter(found.values())))


def use(clause: Clause, context: Context) -> None:
    """``uses the opposite lane``, ``takes a left``."""
    target = clause.event.object
    if isinstance(target, Place) and target.kind == "lane" and "opposite" in target.dirs:
        use_oncoming_lane(clause, target, context)
        return
    leave(clause, context)


def through_junction(clause: Clause, context: Context) -> None:
    """Approaching or entering says no more than that the vehicle moves."""
    event = clause.event
    for entity in clause.drivers:
        entity.moves = entity.moves or Basis(event.i, event.j)
    if event.name == "enter" and ways.next_lane(event, context):
        lane_change(clause, context)
    onto_a_road(clause, context)
    onward = next((d for d in event.dirs if d.value == "straight"), None)
    if onward is not None:
        apply(clause, context, {Maneuver.STRAIGHT}, Basis(onward.i, onward.j))
    if isinstance(event.object, Mention) and event.name == "approach":
        targets = [e for e in clause.targets if e.still]
        context.ahead(targets, clause.actors, Basis(event.i, event.j))


MOVEMENTS: dict[str, Callable[[Clause, Context], None]] = {
    "turn": turn,
    "sharp_turn": move,
    "move": move,
    "u_turn": u_turn,
    "lane_change": lane_change,
    "overtake": overtake,
    "undertake": undertake,
    "crawl": move,
    "bypass": overtake,
    "pass": overtake,
    "pull_out": pull_around,
    "cross": cross,
    "leave": leave,
    "try": leave,
    "light": leave,
    "use": use,
    "match": courses.hold,
    "cause": forced,
    "send": forced,
    "swerve": swerve,
    "follow": courses.follow,
    "tailgate": courses.follow,
    "precede": courses.precede,
    "breach": move,
    "wait": courses.stay,
    "stop": courses.stay,
    "slow": courses.stay,
    "brake": courses.stay,
    "hard_brake": courses.stay,
    "park": courses.park,
    "merge": join,
    "approach": through_junction,
    "enter": through_junction,
    "speed": move,
    "accelerate": move,
}

"""Expressions for participants: ``drivers-ego``, ``targets+moving``, ``drivers+does.overtake``.

A base is who acts (``actors``, ``drivers``, ``walkers``), on whom it is done (``targets``), who
stands in phrases (``@for``), ``everybody``, ``others`` (than those who act) or one of `NAMED`.
``+x`` and ``-x`` keep, and leave out, those of whom a word of `ENTITY` holds.
"""

import re
from collections.abc import Callable
from typing import TypeAlias

from scegen.scenario.control import STOPS
from scegen.scenario.signals import AtLight
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver, ParticipantKind
from scegen.understanding.entity import Entity
from scegen.understanding.semantics import lanes, met
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.lanes import FACING, SIDES
from scegen.understanding.semantics.marks import NOTED
from scegen.understanding.semantics.patterns import people, phrases

Who: TypeAlias = Callable[[Clause, Context], list[Entity]]
EntityTest: TypeAlias = Callable[[Entity, Context], bool]
_PART = re.compile(r"[+-][\w.|]+")
_SLOWER = frozenset({HazardKind.STOPPING, HazardKind.SLOW_DRIVING})


def _leads(e: Entity, context: Context) -> bool:
    """Somebody is behind it."""
    return context.placed(e, Approach.AHEAD) or any(
        (e.ego if p.reference is None else p.reference is e) and p.approaches == {Approach.BEHIND}
        for p in context.draft.placements
    )


def _is(name: str) -> EntityTest:
    return lambda e, _: getattr(e, name)


def _placed(place: Approach) -> EntityTest:
    return lambda e, c: c.placed(e, place)


_IS = ("parked", "still", "pulls_out", "nears", "ego")
_PLACES = {"beside": Approach.ADJACENT} | {
    str(a): a for a in (Approach.AHEAD, Approach.BEHIND, Approach.LEFT, Approach.RIGHT)
}

ENTITY: dict[str, EntityTest] = {
    # whoever is said to, or is on foot and not said to keep along the road
    "may_cross": lambda e, _: (
        Maneuver.CROSS in e.maneuvers
        or not (e.is_vehicle or e.maneuvers in ({Maneuver.STRAIGHT}, {Maneuver.STAY}))
    ),
    "stood": lambda e, _: e.pulls_out or e.was_parked is not None or e.stands is not None,
    "stood_free": lambda e, c: e.is_vehicle and e.stands is not None and c.junction.control is None,
    "braked": lambda e, c: (
        e.is_vehicle and e.brakes_from is not None and c.junction.control not in STOPS
    ),
    "lets_by": lambda e, c: e in c.letting,
    "awaits_green": lambda e, _: e.light is not None and e.light[0] is AtLight.WAITS,
    "leads": _leads,
    "vehicle": lambda e, _: e.is_vehicle,
    "moving": lambda e, _: e.moving_vehicle,
    **{name: _is(name) for name in _IS},
    "stands": lambda e, _: e.stands is not None,
    "goes_off": lambda e, _: e.sets_off >= 0,
    "bus": lambda e, _: e.kind is ParticipantKind.BUS,
    "cyclist": lambda e, _: e.kind is ParticipantKind.BICYCLE,
    "free": lambda e, _: not e.maneuvers,
    "headed": lambda e, _: e.heading is not None,
    "faced": lambda e, c: any(
        o.heading and FACING[o.heading] == e.heading for o in c.draft.entities
    ),
    "opposite": lambda e, _: "opposite" in e.dirs,
    "oncoming": lambda e, c: c.oncoming(e),
    **{word: _placed(place) for word, place in _PLACES.items()},
    "sided": lambda e, c: c.from_the_side(e),
    "from_there": lambda e, c: any(
        p.approaches <= set(SIDES.values())
        and c.lows(p.basis.i or 0, p.basis.j or 0)[:1] == ["from"]
        for p in c.draft.placements_of(e)
    ),
    "across": lambda e, c: c.comes_across(e),
    "does_across": lambda e, c: Maneuver(c.across) in e.maneuvers,
    "only_across": lambda e, c: e.maneuvers == {Maneuver(c.across)},
    "in_front": lambda e, c: c.draft.only(e, Approach.AHEAD),
    "aloof": lambda e, c: not any(e in {p.entity, p.reference} for p in c.draft.placements),
    "unplaced": lambda e, c: not c.draft.placements_of(e),
    "unseen": lambda e, c: all(
        p.reference and not p.reference.ego for p in c.draft.placements_of(e)
    ),
    "unfaced": lambda e, c: c.draft.ego is None or met.apart(e, c.draft.ego, c),
    "slower": lambda e, c: e.still or e in c.draft.causing(*_SLOWER),
    "wrong_side": met.on_the_wrong_side,
    "person": lambda e, _: e.kind is ParticipantKind.PEDESTRIAN,
    "numbered": lambda e, _: e.lane is not None,
    "laned": lambda e, _: e.start_lane is not None,
    "in_egos_lane": lambda e, _: e.in_egos_lane is not None,
    "on_minor": lambda e, _: e.on_minor is not None and e.on_minor[0],
}


def entity(word: str) -> EntityTest:
    """What a word asks of a participant.

    Args:
        word: one of `ENTITY` or `NOTED`, ``does.MANEUVER|…`` (among others), ``only.MANEUVER``,
            ``causes.HAZARD``, ``suffers.HAZARD``.
    """
    name, _, detail = word.partition(".")
    if name == "does":
        done = {Maneuver(way) for way in detail.split("|")}
        return lambda e, _: not done.isdisjoint(e.maneuvers)
    if name == "only":
        return lambda e, _: e.maneuvers == {Maneuver(detail)}
    if name in {"causes", "suffers"}:
        kinds = [HazardKind(kind) for kind in detail.split("|")]
        if name == "causes":
            return lambda e, c: e in c.draft.causing(*kinds)
        return lambda e, c: e in c.draft.suffering(*kinds)
    return (lambda e, _: name in e.told) if name in NOTED else ENTITY[name]


def _owners_of(kind: str) -> Who:
    """Whose it is that is named; the oncoming lane is that of those who come towards the ego."""

    def owners(clause: Clause, context: Context) -> list[Entity]:
        named = [p for p in clause.places() if p.kind == kind]
        other = any("opposite" in p.dirs for p in named)
        theirs = [e for e in context.draft.entities if other and context.oncoming(e)]
        return [e for p in named for e in p.owned_by] or theirs

    return owners


def _in_the_way(clause: Clause, context: Context) -> list[Entity]:
    """Who is said to keep somebody from seeing; else the one that is parked, or stands, there."""
    named = [e for e in clause.event.whom("due", "with", "for", "by") if e.is_vehicle and not e.ego]
    there = [e for e in context.draft.entities if e.parked or (e.stands and not e.ego)]
    still = [e for e in there if e not in clause.targets]
    return named or (still if len(still) == 1 else [])


def _others(clause: Clause, context: Context) -> list[Entity]:
    return [e for e in context.draft.entities if e not in clause.actors]


def _in_phrases(pattern: str) -> Who:
    find = phrases(pattern)
    return lambda clause, context: people(find(clause, context))


def _hiders(clause: Clause, context: Context) -> list[Entity]:
    parts = [p.place for p in clause.event.pps if p.value in {"behind", "by"} and p.place]
    owners = [e for part in parts for e in part.owned_by]  # "by the front of a van"
    behind = [*_BEHIND(clause, context), *owners]
    own = [] if clause.event.passive or clause.event.object is None else clause.actors
    return [e for e in own if e.is_vehicle and not e.ego] + [e for e in behind if not e.ego]


_WITH = _in_phrases("with|by")
_IN_THE_WAY = _in_phrases("behind|between|from<ahead named +opaque")
_BEHIND = _in_phrases("behind|between|by|due|ahead")
NAMED: dict[str, Who] = {
    "actors": lambda clause, _: clause.actors,
    "drivers": lambda clause, _: clause.drivers,
    "walkers": lambda clause, _: [e for e in clause.actors if not e.is_vehicle],
    "targets": lambda clause, _: clause.targets,
    "everybody": lambda _, context: context.draft.entities,
    "others": _others,
    "named": lambda clause, _: people([p for p in clause.event.pps if p.word.cat == "locus"]),
    "owners": lambda clause, c: lanes.owners(lanes.into_lane(clause.event), clause, c),
    "path_owners": _owners_of("path"),
    "lane_owners": _owners_of("lane"),
    "flank_owners": _owners_of("flank"),
    "hit": lambda clause, _: [*clause.targets, *getattr(clause.event.object, "owned_by", [])],
    # out of a side road: who overtakes comes out of its lane
    "pullers": lambda clause, _: [
        e for e in clause.drivers if Maneuver.OVERTAKE not in e.maneuvers
    ],
    "foremost": lambda clause, c: _in_phrases("between")(clause, c)[:1],
    "hiders": _hiders,
    "screens": lambda clause, c: [e for e in _IN_THE_WAY(clause, c) if e not in clause.actors],
    "driven_up_to": met.driven_up_to,
    "involved": lambda clause, _: [*clause.actors, *clause.targets],
    "met_with": lambda clause, c: [*clause.actors, *clause.targets, *_WITH(clause, c)],
    "overlooked": lambda clause, c: clause.targets or _others(clause, c),
    "in_the_way": _in_the_way,
    "nobody": lambda _clause, _context: [],
}


def who(expression: str) -> Who:
    """The participants that an expression means."""
    first, *more = expression.split(" or ")
    if more:
        either = [who(part) for part in (first, *more)]
        return lambda clause, c: next((f for w in either if (f := w(clause, c))), [])
    parts = _PART.findall(expression)
    name = expression[: len(expression) - sum(map(len, parts))]
    base = _in_phrases(name[1:]) if name.startswith("@") else NAMED[name]
    if not parts:
        return base
    tests = [(entity(part[1:]), part[0] == "+") for part in parts]

    def kept(clause: Clause, context: Context) -> list[Entity]:
        found = base(clause, context)
        for test, wanted in tests:
            if not found:
                break
            found = [e for e in found if test(e, context) == wanted]
        return found

    return kept

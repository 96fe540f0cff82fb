"""What rows note of a participant, and what they change in a clause."""

from collections.abc import Callable
from typing import TypeAlias

from scegen.scenario.model import Interval
from scegen.scenario.vocabulary import Approach, Maneuver, ParticipantKind
from scegen.understanding.chunks import Mention, Prep, Thing
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.words.terms import Term

Mark: TypeAlias = Callable[[Entity, Basis], object]

_RUNNING = Interval(low=2.2, high=3.8)
"""From Euro NCAP's running adult (8 km/h, AEB VRU protocol) up; the upper end is our own."""
NOTED = (
    "moves", "through", "circulates", "waits", "on_ramp", "roadside", "exits", "gives_way",
    "same_way",  # it goes as another does
    "followed",  # by one who keeps behind it
    "held",  # it stands at a light when it begins
    "bides",  # it waits to turn
    "is_hit",  # somebody drives into it
    "stays_put",  # it does not go on, whatever others do
    "begins_over",  # it only begins to change lanes, as far as has been told
    "goes_back",  # it goes back before it has changed lanes
    "backs",  # it drives backwards at some time
    "walks_up",  # it goes towards the road, on foot, and has not crossed it
    "halts",  # it stops at the kerb, and does not go on
    "unmoved",  # it does not react
    "gone_by",  # it has passed before what is told with it
)  # fmt: skip
"""What only rows, or few besides, ask of a participant again."""
_TOLD = ("was_parked", "stands", "by_ramp")
"""Fields that hold the first words that say so."""
_EITHER = {"along": ("course", True), "against": ("course", False),
           "on_minor": ("on_minor", True), "on_major": ("on_minor", False)}  # fmt: skip
"""Fields that hold whether it is so, and the first words that say it."""


def _told(field: str) -> Mark:
    def mark(entity: Entity, basis: Basis) -> None:
        setattr(entity, field, getattr(entity, field) or basis)

    return mark


def first(field: str, value: object) -> Mark:
    """Sets a field to a value with the first words that say so."""

    def mark(entity: Entity, basis: Basis) -> None:
        setattr(entity, field, getattr(entity, field) or (value, basis))

    return mark


def _noted(word: str) -> Mark:
    return lambda entity, basis: entity.told.setdefault(word, basis)


def _parked(entity: Entity, basis: Basis) -> None:
    entity.parked, entity.parked_basis = True, basis


def _sets_off(entity: Entity, basis: Basis) -> None:
    """Whoever is parked and then drives is not parked for the whole scenario."""
    entity.sets_off = max(entity.sets_off, basis.i or 0)
    if entity.parked and not entity.ego:
        entity.was_parked = entity.parked_basis or entity.basis
        entity.parked, entity.parked_basis, entity.pulls_out = False, None, True


def in_the_lane(entity: Entity, basis: Basis) -> None:
    """It stands there from the start, unless it has braked or is parked."""
    if entity.parked or basis in entity.rests:
        return
    entity.stands = entity.stands or basis
    if entity.ego and entity.speed is None:
        entity.speed, entity.speed_basis = Interval(low=0.0, high=0.0), basis


def comes_to_rest(entity: Entity, basis: Basis) -> None:
    """Notes who stands since it has braked."""
    if entity.brakes_from is not None and entity.brakes_from < (basis.i or 0):
        entity.rests.append(basis)


def _stands_aside(entity: Entity, basis: Basis) -> None:
    """``stands on the shoulder``, ``… and pulls out``: parked, all the time or at first."""
    if entity.sets_off < (basis.i or 0):
        (in_the_lane if entity.ego else _parked)(entity, basis)
    else:
        entity.was_parked, entity.pulls_out = entity.was_parked or basis, True


def _runs(entity: Entity, basis: Basis) -> None:
    if entity.speed is None:
        entity.speed, entity.speed_basis = _RUNNING, basis


def _parks(entity: Entity, basis: Basis) -> None:
    """Unless the text says before or after that it drives."""
    at = basis.i or 0
    if entity.ego:
        entity.was_parked = entity.was_parked or basis
    if entity.is_vehicle and not entity.ego and entity.sets_off < at:
        _parked(entity, basis)
    entity.pulls_out = entity.pulls_out or entity.sets_off > at


MARKS: dict[str, Mark] = {
    **{field: _told(field) for field in _TOLD},
    **{word: _noted(word) for word in NOTED},
    **{name: first(field, so) for name, (field, so) in _EITHER.items()},
    "pulls_out": lambda entity, _: setattr(entity, "pulls_out", True),
    "parked": _parked,
    "off_strip": lambda entity, _: setattr(entity, "strip", None),  # "at its stop in our lane"
    "parks": _parks,
    "in_the_lane": in_the_lane,
    "comes_to_rest": comes_to_rest,
    "stands_aside": _stands_aside,
    "sets_off": _sets_off,
    "runs": _runs,
    "forgets": lambda entity, _: setattr(entity, "maneuvers", set()),
}
"""Mark -> what it sets; ``forgets``: what was said of its way before no longer holds."""


def _side_to_verb(clause: Clause, _: Context) -> None:
    """``hangs a right``: turns right."""
    event, side = clause.event, clause.event.object
    ways = [m for m in side.mods if m.cat == "dir" and m.value in {"left", "right"}] if side else []
    turned = [m for m in event.mods if m.value != "straight"]  # "hangs a right, straight across"
    event.mods, event.object = [*turned, *ways], None


def rounded(clause: Clause, context: Context) -> tuple[Prep, Thing | Mention, list[Entity]] | None:
    """The phrase that names what somebody gets past, with that, and the vehicles in it."""
    for prep in clause.event.pps if clause.event.object is None else []:
        passed = prep.target
        if context.tokens[prep.word.i].low not in word_list("past"):
            continue
        if isinstance(passed, Thing) and passed.lies_there:
            return prep, passed, []
        who = passed.entities if isinstance(passed, Mention) else []
        vehicles = [e for e in who if e.is_vehicle and e not in clause.actors]
        if vehicles and isinstance(passed, Mention):
            return prep, passed, vehicles
    return None


def _take_round(clause: Clause, context: Context) -> None:
    """What is passed becomes the object of the verb."""
    found, event = rounded(clause, context), clause.event
    if found is not None:
        phrase, event.object, clause.targets = found
        event.pps = [p for p in event.pps if p is not phrase]


def _lane_left(clause: Clause, _: Context) -> None:
    """``leaves the ego's lane``: that lane is where it comes from, not where it goes."""
    event, lane = clause.event, clause.event.object
    source = Term("prep", "from", event.i, event.i + 1)
    event.pps, event.object = [*event.pps, Prep(source, lane)], None


def _who_is_passed(clause: Clause, context: Context) -> None:
    """``drives behind a tractor and overtakes``, ``passes``: who is ahead, or goes the same way."""
    event = clause.event
    if clause.targets or event.object is not None or event.passive:
        return
    there = any(p.value != "with" and not isinstance(p.target, Thing) for p in event.pps)
    there = there or context.junction.crossing or event.nominal or event.negated
    if event.name != "overtake" and (event.name != "pass" or there):
        return
    seen = [p for p in context.draft.placements if p.reference in (None, *clause.actors)]
    leaders = dict.fromkeys(p.entity for p in seen if p.approaches == {Approach.AHEAD})
    one = [e for e in leaders if e.moving_vehicle and e not in clause.actors]
    if not one and event.name == "overtake" and not context.junction.crossing:
        kerb = {Approach(context.draft.kerb)}  # a cyclist may ride there, and is ahead
        elsewhere = [
            p.entity
            for p in seen
            if Approach.AHEAD not in p.approaches
            and not (p.approaches == kerb and p.entity.kind is ParticipantKind.BICYCLE)
        ]
        others = [e for e in context.draft.entities if e not in (*elsewhere, *clause.actors)]
        one = [e for e in others if _goes_the_same_way(e, event.i)]
    together = len({(e.basis.i, e.basis.j) for e in one}) == 1  # "two cyclists ride …"
    if together and any(e.ego for e in clause.actors):
        clause.targets = one


def _goes_the_same_way(entity: Entity, i: int) -> bool:
    """``a cyclist rides along the road, the ego overtakes``: who is named before and drives on."""
    named = entity.basis.i is not None and entity.basis.i < i
    comes = "opposite" in entity.dirs or entity.heading is not None or bool(entity.entries)
    crosses = Maneuver.CROSS in entity.maneuvers
    return named and entity.moving_vehicle and not comes and not crosses


REWRITES: dict[str, Callable[[Clause, Context], None]] = {
    "side_to_verb": _side_to_verb,
    "take_round": _take_round,
    "lane_left": _lane_left,
    "who_is_passed": _who_is_passed,
}
"""Rewrite -> what it does to the clause."""

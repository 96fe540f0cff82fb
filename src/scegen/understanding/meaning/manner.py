"""How somebody drives or stands, in answer to what, and which rules that breaks."""

from scegen.scenario.vocabulary import Approach, Control, DrivingSide, HazardKind
from scegen.understanding.chunks import Chunk, Event, Mention, Place
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.meaning import placing
from scegen.understanding.semantics.conditions import holds
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.marks import comes_to_rest, in_the_lane
from scegen.understanding.semantics.met import into_rear
from scegen.understanding.words.terms import Term


def note_braking(clauses: list[Clause], context: Context) -> None:
    """``brakes hard; once it stands …``: it does not stand from the start."""
    for clause in clauses:
        for entity in clause.drivers if holds("slows_now", clause, context) else []:
            at = clause.event.i if entity.brakes_from is None else entity.brakes_from
            entity.brakes_from = at


def jam(mention: Mention, context: Context) -> None:
    """``the end of a jam``: it stands, unless the text lets it move."""
    if mention.head is not None and mention.head.data.get("stands"):
        others = [e for e in mention.entities if not e.ego]
        state(Term("state", "stationary", mention.i, mention.j), others, context)


def state(term: Term, entities: list[Entity], context: Context) -> None:
    """``a stationary car``, ``a parked van``: in the lane, or beside it."""
    basis = Basis(term.i, term.j)
    if term.value == "stationary":
        for entity in entities:
            comes_to_rest(entity, basis)
        entities = [e for e in entities if basis not in e.rests]
        drivers = [e for e in entities if e.moving_vehicle and not e.ego]
        if drivers:
            kind = HazardKind.OBSTACLE if term.data.get("broken") else HazardKind.STOPPING
            context.draft.hazard(kind, basis, drivers)
        for entity in entities:
            if entity.ego:
                in_the_lane(entity, basis)
            entity.stands = entity.stands or basis
    elif term.value == "parked":
        others = [e for e in entities if not e.ego]
        for entity in others:
            if entity.is_vehicle and entity.sets_off < 0:
                entity.parked, entity.parked_basis = True, basis
        if term.data.get("in_lane"):
            context.draft.hazard(HazardKind.OBSTACLE, basis, [e for e in others if e.parked])


_BY_MANNER = {
    "backwards": HazardKind.REVERSING,
    "fast": HazardKind.SPEEDING,
    "slow": HazardKind.SLOW_DRIVING,
    "wrong_way": HazardKind.ONCOMING_LANE,
    "out_of_control": HazardKind.LOSS_OF_CONTROL,
    "out_of_turn": HazardKind.FAILURE_TO_YIELD,
}


def told_by(term: Term, entities: list[Entity], context: Context) -> None:
    """``a slow van``, ``a parked car``."""
    drivers = [e for e in entities if e.moving_vehicle]
    kind = _BY_MANNER.get(term.value) if term.cat == "manner" else None
    slow = kind is HazardKind.SLOW_DRIVING
    if slow:  # the ego under test may drive as slowly as it likes
        drivers = [e for e in drivers if "ego" not in e.named_by or "speaks" in e.named_by]
    measured = not {"quantity", "figure"}.isdisjoint(term.data)
    own = slow and measured and all(e.ego for e in drivers)  # "I was only doing 25 km/h"
    if kind is not None and drivers and not own:
        context.draft.hazard(kind, Basis(term.i, term.j), drivers)
    elif term.cat == "manner" and term.value == "close":
        follows = [e for e in drivers if context.placed(e, Approach.BEHIND)]
        if follows:
            context.draft.hazard(HazardKind.TAILGATING, Basis(term.i, term.j), follows)
    elif term.cat == "state":
        state(term, entities, context)


def told_with(clause: Clause, context: Context) -> None:
    """``drives northbound``, ``approaches head-on``, ``backs out slowly``."""
    event = clause.event
    travels = event.name in word_list("travelling")
    for term in event.mods:
        if term.cat == "compass":
            placing.heading(term, clause.actors)
        elif (term.cat, term.value) == ("dir", "opposite") and travels:
            for entity in clause.drivers:
                context.draft.place(entity, None, {Approach.OPPOSITE}, Basis(term.i, term.j))
        elif term.cat == "state":
            told_by(term, clause.actors, context)
        elif (term.cat, term.value) == ("manner", "head_on"):
            _meet_head_on(term, clause, context)
    for term in event.mods if travels or not event.nominal else []:
        answers = not travels or holds("reaction", clause, context)
        slows = term.value == "slow" and answers  # "brakes slowly"
        aside = term.value == "wrong_way" and any(p.names("sidewalk") for p in event.pps)
        if term.cat == "manner" and term.value in _BY_MANNER and not (slows or aside):
            told_by(term, clause.drivers, context)


def _meet_head_on(term: Term, clause: Clause, context: Context) -> None:
    """``a motorcycle approaches head-on``: who collides so has come from the front, too."""
    several = len(clause.drivers) > 1 and not clause.targets  # "two trucks meet head-on"
    whom = clause.drivers[:1] if several else clause.targets
    for entity in clause.drivers if several or clause.event.name in word_list("meeting") else []:
        to = next((e for e in whom if e.moving_vehicle), None)
        context.draft.place(entity, to, {Approach.OPPOSITE}, Basis(term.i, term.j))


_BRAKING = frozenset({"brake", "slow", "stop"})
_NOTICING = frozenset({"encounter", "overlook", "react"})


def mark_answers(events: list[Event]) -> None:
    """``braked but could not avoid the van``: who tries to avoid something brakes as an answer."""
    avoiding = [e for e in events if e.name == "avoid"]
    for event in events:
        if event.name in _BRAKING and not event.nominal:
            event.modal = event.modal or any(_together(event, e) for e in avoiding)


def mark_late(events: list[Event], context: Context) -> None:
    """``failed to stop and hit it from behind``: for the one in front, not for a sign."""
    stopped = [e for e in events if e.name in {"stop", "wait", "park"} and e.finite]
    standing = {who.index for event in stopped if not event.negated for who in event.doers}
    hits = [e for e in events if e.name == "collide"]
    entered = [e for e in events if any(p.value == "into" for p in e.pps)]  # "runs into its rear"
    rear_ends = [e for e in (*hits, *entered) if into_rear(e, context)]
    stood = [e for e in hits if _into_one_of(e, standing)]
    for event in events:
        if event.name in _BRAKING | _NOTICING and not event.nominal:
            failed = event.link != "ing"  # unlike "rode on without stopping and hit it"
            event.late = any(_together(event, e) for e in (*rear_ends, *(stood if failed else ())))


def _into_one_of(event: Event, standing: set[int]) -> bool:
    """Whether somebody is hit who stands."""
    hit = event.object.entities if isinstance(event.object, Mention) else []
    return not event.passive and any(e.index in standing for e in hit)


def _together(one: Event, other: Event) -> bool:
    return one.sentence == other.sentence and one.subject == other.subject


_FROM_THE_SIDE = frozenset({Approach.LEFT, Approach.RIGHT})
_MARGIN = 1.1
_ANYWHERE_MPS = 44.0
"""About 100 mph: too fast wherever there is a limit."""


def onto_the_road(draft: Draft, side: DrivingSide) -> None:
    """Who comes from the side and turns left in front of somebody fails to give way.

    An unprotected left turn is one across oncoming traffic; off the same road it is a sudden one.
    """
    for danger in draft.dangers:
        across = danger.kind is HazardKind.UNPROTECTED_LEFT_TURN and side is DrivingSide.RIGHT
        whence = [e.approaches for e in danger.by] if across else []
        if whence and all(told and told <= _FROM_THE_SIDE for told in whence):
            danger.kind = HazardKind.FAILURE_TO_YIELD
        elif whence and all(told == {Approach.AHEAD} for told in whence):
            danger.kind = HazardKind.SUDDEN_TURN


def too_fast(draft: Draft, limit_mps: float | None) -> None:
    """``at 60 mph in a 35 mph zone``: speeding, though nobody says the word."""
    allowed = limit_mps * _MARGIN if limit_mps is not None else _ANYWHERE_MPS
    for entity in draft.entities:
        speed, basis = entity.speed, entity.speed_basis
        if not entity.moving_vehicle or speed is None or basis is None:
            continue
        if speed.low >= allowed:
            draft.hazard(HazardKind.SPEEDING, basis, [entity])


def out_of_turn(chunks: list[Chunk], events: list[Event], context: Context) -> None:
    """``the ego was at the four-way stop first, but the van goes``: the van had to wait."""
    tokens = context.tokens
    at = _turn(chunks, context)
    if at is None or not word_list("still") & {t.low for t in tokens}:
        return
    who = _who(at, chunks)
    for event in events:
        drivers = [e for e in event.doers if e.moving_vehicle]
        goes = (
            event.finite and event.name in word_list("goes") and not (event.negated or event.modal)
        )
        if who and goes and drivers and not any(e in who for e in drivers):
            basis = Basis(event.i, event.j)
            context.draft.hazard(HazardKind.FAILURE_TO_YIELD, basis, drivers, who)
            return


def _turn(chunks: list[Chunk], context: Context) -> int | None:
    """Where it says that it is somebody's turn: "first" at an all-way stop, "has priority"."""
    lows = context.lows(0, len(context.tokens))
    if context.junction.control is Control.ALL_WAY_STOP and "first" in lows:
        return lows.index("first")
    across = context.junction.crossing or any(map(context.comes_across, context.draft.entities))
    for before, has, what in zip(chunks, chunks[1:], chunks[2:], strict=False):
        way = isinstance(what, Place) and what.kind == "right_of_way" and not what.has("quant")
        if way and has.value == "have" and before.cat != "neg" and across:
            return what.i
    return None


def _who(at: int, chunks: list[Chunk]) -> list[Entity]:
    """Whom it is said of: the participant named last before it, outside phrases."""
    named = [c for c in chunks if isinstance(c, Mention) and c.i < at and c.prep is None]
    return list(named[-1].entities) if named else []

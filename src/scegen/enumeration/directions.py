"""Who may enter or cross where, as the road itself has it: a bend, one way, a ramp, a crosswalk."""

from collections.abc import Callable

from scegen.errors import InfeasibleError
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.roadway import AuxiliaryLane, Carriageway
from scegen.scenario.vocabulary import Approach, JunctionKind, Maneuver, Side

_IN_AT = frozenset({0})


def on_its_road(functional: FunctionalScenario) -> FunctionalScenario:
    """The description with the entries that its road leaves to who drives, or goes across it.

    Raises:
        InfeasibleError: somebody is said to come the other way of a one-way road, the ego to enter
            a bend where it leads to the other side, or somebody to use a ramp that is not there.
    """
    if functional.junction.auxiliary is not None:
        functional = _beside_the_others(functional)
    else:
        for person in functional.participants:
            for maneuver in (one for one in _LEADS if one in person.maneuvers):
                _refuse_ramp(person, maneuver)
    if functional.junction.kind is JunctionKind.STRAIGHT and functional.junction.crosswalks:
        functional = _over_the_crosswalk(functional)
    bend = functional.junction.bend
    if functional.junction.carriageway is not Carriageway.ONE_WAY:
        if bend is None or bend.side is None:
            return functional
        return _entering(functional, functional.ego, bend.side)
    drivers = {vehicle.id for vehicle in functional.vehicles}
    return _each(functional, lambda who: _one_way(who) if who.id in drivers else who)


def _each(
    functional: FunctionalScenario, changed: Callable[[Participant], Participant]
) -> FunctionalScenario:
    people = tuple(map(changed, functional.participants))
    return functional.but(participants=people)


_LEADS = {
    Maneuver.MERGE: frozenset({AuxiliaryLane.ON_RAMP, AuxiliaryLane.LANE_DROP}),
    Maneuver.EXIT: frozenset({AuxiliaryLane.OFF_RAMP}),
}
"""Which auxiliary lanes a maneuver needs."""


def _beside_the_others(functional: FunctionalScenario) -> FunctionalScenario:
    """The ego's direction has the auxiliary lane, and enters at arm 0."""
    junction = functional.junction
    lane = junction.through_lanes + 1
    people = []
    for person in functional.participants:
        update: dict[str, object] = {}
        for maneuver, needs in _LEADS.items():
            if maneuver in person.maneuvers and junction.auxiliary not in needs:
                _refuse_ramp(person, maneuver)
        uses = person.maneuvers & _LEADS.keys()
        if uses or person.id == functional.ego.id:
            if person.entries and not person.entries & _IN_AT:
                raise InfeasibleError(
                    f"{person.id} goes the ego's way, which enters at arm 0",
                    where=f"participants.{person.id}.entries",
                    hint="Let it enter at arm 0, or leave its entries open.",
                )
            update["entries"] = _IN_AT
        elsewhere = len(person.maneuvers) > 1 or (person.lanes and lane not in person.lanes)
        if Maneuver.MERGE in person.maneuvers and elsewhere:
            raise InfeasibleError(
                f"{person.id} merges: it is in the lane that ends, and must leave it",
                where=f"participants.{person.id}",
                hint=f"Give it no other maneuver, and no lane or {lane}.",
            )
        people.append(person.but(**update))
    lanes = junction.lanes or (junction.through_lanes,) * junction.arms
    road = junction.but(lanes=lanes)
    return functional.but(participants=tuple(people), junction=road)


def lanes_told(functional: FunctionalScenario, person: Participant) -> frozenset[int]:
    """The lanes in which somebody starts: those that are said, that which ends if it merges."""
    if functional.junction.auxiliary is not None and Maneuver.MERGE in person.maneuvers:
        return frozenset({functional.junction.through_lanes + 1})
    return person.lanes


def _refuse_ramp(person: Participant, maneuver: Maneuver) -> None:
    wanted = " or ".join(sorted(_LEADS[maneuver]))
    raise InfeasibleError(
        f"{person.id} is said to {maneuver}, and the road has no lane for that",
        where=f"participants.{person.id}.maneuvers",
        hint=f"Let junction.auxiliary be {wanted}, or leave the maneuver out.",
    )


def _over_the_crosswalk(functional: FunctionalScenario) -> FunctionalScenario:
    """Who goes across a road without a junction does so on its crosswalk."""
    arms = functional.junction.crosswalks
    crossing = {p.id for p in functional.crossers if p.maneuvers <= {Maneuver.CROSS}}
    return _each(
        functional,
        lambda p: p.but(entries=p.entries or arms) if p.id in crossing else p,
    )


def _entering(functional: FunctionalScenario, ego: Participant, side: Side) -> FunctionalScenario:
    """The ego enters a bend that leads to a side at arm 0, seen from where it does."""
    if ego.entries and not ego.entries & _IN_AT:
        raise InfeasibleError(
            f"{ego.id} drives a bend to the {side} from arm 0 only",
            where=f"participants.{ego.id}.entries",
            hint="Let it enter at arm 0, or name no side of the bend.",
        )
    entering = ego.but(entries=_IN_AT)
    return _each(functional, lambda who: entering if who.id == ego.id else who)


def _one_way(person: Participant) -> Participant:
    against = person.entries and not person.entries & _IN_AT
    if against or person.approaches == {Approach.OPPOSITE}:
        raise InfeasibleError(
            f"{person.id} comes the other way of a one-way road",
            where=f"participants.{person.id}",
            hint="Let the road have two directions (carriageway undivided or divided).",
        )
    return person.but(entries=_IN_AT)

"""Who may enter where, as the road itself has it: into a bend, and on a one-way road."""

from __future__ import annotations

from scegen.errors import InfeasibleError
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.roadway import Carriageway
from scegen.scenario.vocabulary import Approach, Side

_IN_AT = frozenset({0})


def on_its_road(functional: FunctionalScenario) -> FunctionalScenario:
    """The description with the entries that its road leaves to who drives.

    Raises:
        InfeasibleError: somebody is said to come the other way of a one-way road, or the ego to
            enter a bend where it leads to the other side.
    """
    bend = functional.junction.bend
    if functional.junction.carriageway is not Carriageway.ONE_WAY:
        if bend is None or bend.side is None:
            return functional
        return _entering(functional, functional.ego, bend.side)
    drivers = {vehicle.id for vehicle in functional.vehicles}
    people = tuple(
        _one_way(person) if person.id in drivers else person for person in functional.participants
    )
    return functional.model_copy(update={"participants": people})


def _entering(functional: FunctionalScenario, ego: Participant, side: Side) -> FunctionalScenario:
    """The ego enters a bend that leads to a side at arm 0, seen from where it does."""
    if ego.entries and not ego.entries & _IN_AT:
        raise InfeasibleError(
            f"{ego.id} drives a bend to the {side} from arm 0 only",
            where=f"participants.{ego.id}.entries",
            hint="Let it enter at arm 0, or name no side of the bend.",
        )
    people = tuple(
        p.model_copy(update={"entries": _IN_AT}) if p.id == ego.id else p
        for p in functional.participants
    )
    return functional.model_copy(update={"participants": people})


def _one_way(person: Participant) -> Participant:
    against = person.entries and not person.entries & _IN_AT
    if against or person.approaches == {Approach.OPPOSITE}:
        raise InfeasibleError(
            f"{person.id} comes the other way of a one-way road",
            where=f"participants.{person.id}",
            hint="Let the road have two directions (carriageway undivided or divided).",
        )
    return person.model_copy(update={"entries": _IN_AT})

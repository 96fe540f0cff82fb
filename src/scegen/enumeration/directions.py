"""Who may enter where, as the road itself has it: on a one-way road everybody at arm 0."""

from __future__ import annotations

from scegen.errors import InfeasibleError
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.roadway import Carriageway
from scegen.scenario.vocabulary import Approach

_IN_AT = frozenset({0})


def on_its_road(functional: FunctionalScenario) -> FunctionalScenario:
    """The description with the entries that its road leaves to who drives.

    Raises:
        InfeasibleError: somebody is said to come the other way of a one-way road.
    """
    if functional.junction.carriageway is not Carriageway.ONE_WAY:
        return functional
    drivers = {vehicle.id for vehicle in functional.vehicles}
    people = tuple(
        _one_way(person) if person.id in drivers else person for person in functional.participants
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

"""Cars at a neutral junction, for counts without a description."""

from collections.abc import Sequence

from scegen.errors import InputError
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.junction import ARM_COUNTS, Junction
from scegen.scenario.vocabulary import JunctionKind, Role

_KINDS = {2: JunctionKind.STRAIGHT, 3: JunctionKind.Y, 4: JunctionKind.FOUR_WAY}


def plain_crossing(entries: Sequence[int] = (0, 1, 2), arms: int = 4) -> FunctionalScenario:
    """One car for each entry, free in its move, at a regular junction with so many arms.

    Raises:
        InputError: no car, no such junction, or an entry that is not one of its arms.
    """
    most = ARM_COUNTS[JunctionKind.MULTI_WAY][1]
    if not 2 <= arms <= most:
        raise InputError(f"a junction has 2 to {most} arms, not {arms}", where="arms")
    if not entries:
        raise InputError("no car enters", where="entries", hint="Give the arms, such as 0,1,2.")
    wrong = [entry for entry in entries if not 0 <= entry < arms]
    if wrong:
        raise InputError(f"no arm {wrong[0]}: the arms are 0 to {arms - 1}", where="entries")
    cars = tuple(
        Participant(
            id=f"car_{index}",
            role=Role.EGO if index == 1 else Role.OTHER,
            entries=frozenset({entry}),
        )
        for index, entry in enumerate(entries, start=1)
    )
    return FunctionalScenario(
        description=f"{len(cars)} cars at a junction with {arms} arms",
        junction=Junction(kind=_KINDS.get(arms, JunctionKind.MULTI_WAY), arms=arms),
        participants=cars,
    )

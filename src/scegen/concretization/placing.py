"""A drive finds the offset next to the wanted one at which it is in nobody's way."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from scegen.concretization.clearance import Differences, same_lane
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.priorities import Manners, Waits

_ROOM_S = 0.3
_STEP_S = 0.5
LONGEST_S = 40.0


@dataclass(frozen=True, slots=True)
class Placing:
    """A drive that is to be so late, and whom it must keep ``clear`` of among those placed.

    ``near`` are those whom it may touch. ``direction`` 1 looks later, -1 earlier, 0 both ways, as
    far as ``within_s``. ``headway_s`` is kept to those of its lane; who ``waits`` does so for its
    light and for whoever has right of way.
    """

    draft: DriveDraft
    offset_s: float
    clear: Sequence[DriveDraft]
    near: Sequence[DriveDraft] = ()
    direction: int = 1
    within_s: float = LONGEST_S
    headway_s: float = _ROOM_S
    waits: bool = True


def clear_offset(
    place: Placing,
    offsets_s: Mapping[str, float],
    differences: Differences,
    manners: Manners | None = None,
) -> float:
    """The offset next to that of a placing at which it touches none of the others.

    Where none is free, the first that is free of those of its lane. With ``manners`` nobody takes
    another's way, of those placed, either.
    """
    draft, manners = place.draft, manners if place.waits else None
    placed = [(other, offsets_s[other.id]) for other in place.clear]
    everybody = [*placed, *((other, offsets_s[other.id]) for other in place.near)]
    before = Waits.of([draft, *(other for other, _ in everybody)])
    line = [each for each in placed if same_lane(draft, each[0])]
    others = [each for each in placed if each not in line]
    usual: float | None = None
    for k in range(int(place.within_s / _STEP_S) + 1):
        for sign in (place.direction,) if place.direction else (1, -1):
            own = draft, place.offset_s + sign * k * _STEP_S
            if differences.touches(own, line, place.headway_s):
                continue
            usual = own[1] if usual is None else usual
            if manners is not None:
                manners.wait(*own)
                if not manners.settle(*own, everybody):
                    before.restore()
                    continue
            waiting = {each.id for each in before.changed()}
            people = [own, *everybody]
            if not (
                differences.touches(own, others, _ROOM_S)
                or (draft.id in waiting and differences.touches(own, line, place.headway_s))
                or any(
                    differences.touches(one, people, _ROOM_S)
                    for one in people
                    if one[0].id in waiting
                )
            ):
                return own[1]
            before.restore()
    found = place.offset_s if usual is None else usual
    if manners is not None:
        manners.wait(draft, found)
    return found

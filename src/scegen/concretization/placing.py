"""A drive finds the offset next to the wanted one at which it is in nobody's way."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from scegen.concretization.clearance import Differences, same_lane
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.lights import Lights

_ROOM_S = 0.3
_STEP_S = 0.5
LONGEST_S = 40.0


@dataclass(frozen=True, slots=True)
class Placing:
    """A drive that is to be so late, and whom it must keep ``clear`` of among those placed.

    ``direction`` 1 looks later, -1 earlier, 0 both ways, as far as ``within_s``. ``headway_s`` is
    kept to those of its lane; who ``waits`` does so for its light.
    """

    draft: DriveDraft
    offset_s: float
    clear: Sequence[DriveDraft]
    direction: int = 1
    within_s: float = LONGEST_S
    headway_s: float = _ROOM_S
    waits: bool = True


def clear_offset(
    place: Placing,
    offsets_s: Mapping[str, float],
    differences: Differences,
    lights: Lights | None = None,
) -> float:
    """The offset next to that of a placing at which it touches none of the others.

    Where none is free, the first that is free of those of its lane. Right of way is left to the
    search, which keeps it as it keeps everything else that is claimed.
    """
    draft, lights = place.draft, lights if place.waits else None
    placed = [(other, offsets_s[other.id]) for other in place.clear]
    line = [each for each in placed if same_lane(draft, each[0])]
    others = [each for each in placed if each not in line]
    usual: float | None = None
    for k in range(int(place.within_s / _STEP_S) + 1):
        for sign in (place.direction,) if place.direction else (1, -1):
            own = draft, place.offset_s + sign * k * _STEP_S
            if lights is not None:
                lights.wait(*own)
            if differences.touches(own, line, place.headway_s):
                continue
            usual = own[1] if usual is None else usual
            if not differences.touches(own, others, _ROOM_S):
                return own[1]
    found = place.offset_s if usual is None else usual
    if lights is not None:
        lights.wait(draft, found)
    return found

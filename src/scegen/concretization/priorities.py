"""Right of way while starts are chosen: nobody is placed where it takes another's way."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from math import inf

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.lights import Lights
from scegen.measures.grounds import grounds
from scegen.motion.rules.giving_way import CLEAR_S, TOGETHER_S, Duty

_ROOM_S = 0.3
"""More than a claim asks for: starts are rounded, and simulators step."""


@dataclass(frozen=True)
class Manners:
    """What whoever is placed keeps to: its light, and the right of way of those placed before."""

    lights: Lights | None
    duties: tuple[Duty, ...] = ()
    _by_pair: dict[frozenset[str], Duty] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._by_pair.update({frozenset((d.yields, d.other)): d for d in self.duties})

    def wait(self, draft: DriveDraft, offset_s: float) -> None:
        """Let a drive with this offset wait for its green, where it has to."""
        if self.lights is not None:
            self.lights.wait(draft, offset_s)

    def broken(
        self, draft: DriveDraft, offset_s: float, others: Iterable[tuple[DriveDraft, float]]
    ) -> bool:
        """Whether somebody takes another's way where a drive is so late."""
        return any(self._taken(draft, offset_s, other, at) for other, at in others)

    def _taken(self, one: DriveDraft, one_s: float, two: DriveDraft, two_s: float) -> bool:
        duty = self._by_pair.get(frozenset((one.id, two.id)))
        if duty is None:
            return False
        if duty.by_arrival:
            late = _rests_s(one, one_s) - _rests_s(two, two_s)
            at_once = abs(late) <= TOGETHER_S + _ROOM_S
            one_yields = (late > 0.0 and not at_once) or (at_once and duty.yields == one.id)
        else:
            one_yields = duty.yields == one.id
        if one_yields:
            return _takes_way(one, one_s, two, two_s)
        return _takes_way(two, two_s, one, one_s)


def _rests_s(draft: DriveDraft, offset_s: float) -> float:
    """When a drive comes to rest at its line; never if it does not."""
    phase = next((p for p in draft.course.phases if p.target_mps == 0.0), None)
    if phase is None:
        return inf
    return offset_s + draft.course.profile.settles_s(phase.begins_s)


def _takes_way(name: DriveDraft, name_s: float, other: DriveDraft, other_s: float) -> bool:
    """Whether one that gives way comes before the other is gone, and is not gone long before."""
    shared = grounds(name.laid.path, name.kind, other.laid.path, other.kind)
    for ground in shared:
        comes = name_s + name.course.time_at(ground.enter_m)
        goes = name_s + name.course.time_at(ground.leave_m) if ground.leave_m < inf else inf
        they_come = other_s + other.course.time_at(ground.other_enters_m)
        they_go = inf
        if ground.other_leaves_m < inf:
            they_go = other_s + other.course.time_at(ground.other_leaves_m)
        if comes < they_go + _ROOM_S and goes + CLEAR_S + _ROOM_S > they_come:
            return True
    return False

"""Who has to give way waits at its line until the other has passed, and is seen to do so."""

from __future__ import annotations

from math import inf

import numpy as np

from scegen.concretization.clearance import Differences
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.limits import STOPS_FOR_S
from scegen.concretization.setup import Setup
from scegen.motion.rules.giving_way import CLEAR_S, TOGETHER_S, Duty, must_give_way
from scegen.scenario.vocabulary import Control

_ROOM_S = 0.6
"""More than a claim asks for: starts are rounded, simulators step, and one who waits looks at the
other's tail."""
_AT_ONCE_S = 1.0
"""Those who come to an all-way stop within so long are made to come at once."""
_WAITS_S = np.arange(STOPS_FOR_S, 25.0, 0.25)
"""How long one may be let wait: of a stream of others somebody comes later instead."""


def duties_of(scene: Setup) -> list[Duty]:
    """Who waits for whom: who is said to, and who has to where the text wants no danger of that.

    Where it asks for no danger and tells of no end, a near miss with the ego is looked for.
    """
    told = scene.functional.hazards or scene.functional.outcome
    rules = scene.road.control is not Control.SIGNALS and not scene.functional.spacings
    return [
        duty
        for duty in must_give_way(scene.functional, scene.logical)
        if {duty.yields, duty.other} <= scene.drives.keys()
        and (not duty.rule or (rules and (told or scene.ego.id not in {duty.yields, duty.other})))
        and _is_free(scene.drives[duty.yields])
    ]


def _is_free(draft: DriveDraft) -> bool:
    """Whether nothing else fixes how it comes to its line."""
    does = draft.marks or draft.steps or draft.reversal or draft.lane_changes
    return not (does or draft.stands or draft.drive.circulating)


def let_by(scene: Setup) -> None:
    """Let those wait who would take another's way: the shortest time that is enough is taken."""
    for duty in duties_of(scene):
        late, other = scene.drives[duty.yields], scene.drives[duty.other]
        sooner_s = _rests_s(other) - _rests_s(late) if duty.by_arrival else 0.0
        if sooner_s > _AT_ONCE_S:  # first come, first served
            late, other = other, late
        elif sooner_s > TOGETHER_S:
            late.offset_s += sooner_s
        if not _takes_way(late, other):
            continue
        before = late.waits_s
        for waits_s in _WAITS_S:
            late.waits_s, late.lets_by = float(waits_s), other.id
            if not _takes_way(late, other):
                break
        else:
            late.waits_s, late.lets_by = before, None


def _takes_way(late: DriveDraft, other: DriveDraft) -> bool:
    """Whether one that gives way comes before the other is gone, and is not long gone."""
    between, late_s, other_s = Differences(0.0), late.offset_s, other.offset_s
    return between.touch((late, late_s), (other, other_s), _ROOM_S) or any(
        -_ROOM_S < other_s + own.other_enters_m - (late_s + own.leave_m) < CLEAR_S + _ROOM_S
        for own in between.grounds_s(late, other)
    )


def _rests_s(draft: DriveDraft) -> float:
    """When a drive comes to rest at its line; never if it does not."""
    phase = draft.course.stop
    if phase is None:
        return inf
    return draft.offset_s + draft.course.profile.settles_s(phase.begins_s)

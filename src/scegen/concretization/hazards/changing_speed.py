"""Dangers that are a change of speed: braking, stopping, gaining speed where it matters.

Laid backwards from where the danger happens, by the act that the danger consists of. Who does such
an act by the text does it so; who reverses stops for that.
"""

from __future__ import annotations

from scegen.concretization.amounts import GAINING, SLOWING, change_of_speed
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.hazards.rule import Rule, culprits, happens_s_m, stops_for_walkers
from scegen.concretization.profile import SpeedChange
from scegen.concretization.setup import Setup
from scegen.scenario.acts import Act
from scegen.scenario.functional import Hazard
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.vocabulary import HazardKind

_HOLDS_S = {HazardKind.STOPPING: 3.0}
_HOLD_S = 1.5
_AFTER_WALKER_S = 0.5
_LATE = 0.5
"""One who brakes late begins with half of the braking distance left."""
_BEFORE_M = 5.0
_FIRST_M = 5.0


def _act_of(scene: Setup, hazard: Hazard, draft: DriveDraft) -> Act | None:
    """The act that a danger consists of, where the text has none of the sort."""
    kind = HAZARDS[hazard.kind].acts[0]
    alike = SLOWING if kind in SLOWING else GAINING
    if draft.reversal is not None or any(a.kind in alike for a in scene.speed_acts(draft.id)):
        return None
    return Act(id=f"{hazard.kind}_of_{draft.id}"[:40], participant=draft.id, kind=kind)


def _runs_in(scene: Setup, hazard: Hazard, draft: DriveDraft) -> bool:
    """Whether who brakes late runs into another, as is said, and the text tells of no braking."""
    late = hazard.kind is HazardKind.DELAYED_BRAKING
    return late and any(scene.contact_wanted(draft.id, to) for to in hazard.to)


def _change_speed(scene: Setup, hazard: Hazard) -> None:
    for draft in culprits(scene, hazard):
        act = _act_of(scene, hazard, draft)
        if act is None or _runs_in(scene, hazard, draft):
            continue
        event = happens_s_m(scene, draft, hazard.kind, act.kind)
        before = draft.course.speed_at(max(1.0, event - _BEFORE_M))
        target, rate = change_of_speed(
            act, before, draft.body, draft.grip_mps2, hazard.kind, draft.cruise_mps
        )
        if act.kind in GAINING:
            draft.resume_mps = target
            begins = max(_FIRST_M, event)
            draft.add_speed_change(SpeedChange(target, rate, s_m=begins, hazard=hazard.kind))
            continue
        late = hazard.kind is HazardKind.DELAYED_BRAKING
        way = before**2 / (2 * rate) * (_LATE if late else 1.0)
        hold = _HOLDS_S.get(hazard.kind, _HOLD_S)
        walkers = stops_for_walkers(scene, draft)
        if walkers is not None:
            hold = max(hold, walkers[1] - before / rate + _AFTER_WALKER_S)
        begins = max(3.0, event - way - 0.1)
        stop = SpeedChange(0.0, rate, s_m=begins, hazard=hazard.kind)
        draft.add_speed_change(stop, holds_s=hold)


CHANGES_SPEED = Rule(act=_change_speed)

"""Traffic lights: a plan under which those in danger meet as they are to, and others wait.

The plan is laid around whoever is placed first, the ego and those whom it meets in danger; whoever
comes later stands at the line while it has red, and goes with its green.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.setup import Setup
from scegen.motion.rules.intergreen import LEAST_GREEN_S, all_red_s, amber_s
from scegen.motion.rules.lights import at_lights, green_phases, light_runners, must_obey
from scegen.scenario.concrete import AtTime
from scegen.scenario.control import LIGHTS
from scegen.scenario.signals import SignalGroup, SignalPlan
from scegen.scenario.vocabulary import Control, JunctionKind

_AFTER_GREEN_S, _BEFORE_AMBER_S = 3.0, 2.5
"""Who is to be met has had green for so long, and has it so long yet, where that can be."""
_AFTER_AMBER_S, _BEFORE_GREEN_S = 1.5, 1.5
"""Who runs a light has had red for so long, and has it so long yet."""
_STEP_S = 0.25
_STARTS_S = 1.0
"""Lost time of the first in a queue, 1 to 2 s: FHWA, Signal Timing Manual (2008), 3.3."""
_LATE_S = 0.3
_LEAST_WAIT_S = 0.5
_FEW = 1e-3


@dataclass(frozen=True)
class Lights:
    """The lights of a scene on the clock of its ego's course, and who must obey them."""

    plan: SignalPlan
    obeying: frozenset[str]

    def wait(self, draft: DriveDraft, offset_s: float) -> None:
        """Let a drive with this offset stand at its line until green, if it comes at red."""
        if draft.waits_s is not None:
            draft.waits_s, draft.course_ = None, None
        group = self.plan.group_of(draft.drive.entry)
        if draft.id not in self.obeying or group is None:
            return
        since = (crosses_s(draft, offset_s) - group.green_from_s) % self.plan.cycle_s
        if since < group.green_s - _LATE_S:
            return
        goes = crosses_s(draft, offset_s) + self.plan.cycle_s - since + _STARTS_S
        draft.waits_s, draft.course_ = _LEAST_WAIT_S, None
        again = next(phase for phase in draft.course.phases if phase.resumes)
        longer = goes - (offset_s + again.begins_s)
        draft.waits_s, draft.course_ = _LEAST_WAIT_S + max(0.0, longer), None


def crosses_s(draft: DriveDraft, offset_s: float) -> float:
    """When its front goes over the line."""
    return offset_s + draft.course.time_at(draft.stop_line_s_m - draft.body.front_m)


def lights_of(scene: Setup, offsets_s: Mapping[str, float]) -> Lights | None:
    """The lights under which those who are placed pass as they are to; None where there are none.

    Of plans of equal green the one that suits them best, and gives the others green soonest.
    """
    functional, logical = scene.functional, scene.logical
    if scene.road.control not in LIGHTS or scene.road.kind is JunctionKind.STRAIGHT:
        return None
    drives = at_lights(functional, logical)
    runners, obeying = light_runners(functional, logical), must_obey(functional, logical)
    plan = _plan(scene, green_phases(functional, logical))
    if not plan.working:
        return Lights(plan, obeying)
    placed = [scene.drives[n] for n in offsets_s if n in scene.drives and n in drives]
    best, best_worth = plan, -np.inf
    for late in np.arange(0.0, plan.cycle_s, _STEP_S):
        tried = shifted(plan, float(late))
        worth = sum(
            _worth(tried, draft, crosses_s(draft, offsets_s[draft.id]), runs=draft.id in runners)
            for draft in placed
            if draft.id in runners | obeying
        )
        if worth > best_worth + _FEW:
            best, best_worth = tried, worth
    return Lights(best, obeying)


def shifted(plan: SignalPlan, later_s: float) -> SignalPlan:
    """The plan with everything so much later."""
    groups = tuple(
        group.model_copy(
            update={"green_from_s": round((group.green_from_s + later_s) % plan.cycle_s, 3)}
        )
        for group in plan.groups
    )
    return plan.model_copy(update={"groups": groups})


def _plan(scene: Setup, phases: tuple[int, ...]) -> SignalPlan:
    """Every phase in turn, with the shortest times between them that keep them apart."""
    amber = amber_s(max(arm.speed_limit_mps for arm in scene.road.arms))
    between = amber + all_red_s(scene.network, phases, amber)
    numbers = sorted(set(phases))
    groups = tuple(
        SignalGroup(
            id=number + 1,
            arms=frozenset(arm for arm, phase in enumerate(phases) if phase == number),
            green_from_s=place * (LEAST_GREEN_S + between),
            green_s=LEAST_GREEN_S,
        )
        for place, number in enumerate(numbers)
    )
    return SignalPlan(
        cycle_s=len(numbers) * (LEAST_GREEN_S + between),
        amber_s=amber,
        groups=groups,
        working=scene.road.control is Control.SIGNALS,
    )


def _worth(plan: SignalPlan, draft: DriveDraft, crosses: float, *, runs: bool) -> float:
    """How well a plan suits one who goes over its line at a time; below 0: not at all (s)."""
    group = plan.group_of(draft.drive.entry)
    if group is None:
        return 0.0
    since = (crosses - group.green_from_s) % plan.cycle_s
    begins, ends = (0.0, group.green_s)
    after, before = _AFTER_GREEN_S, _BEFORE_AMBER_S
    if runs:
        begins, ends = group.green_s + plan.amber_s, plan.cycle_s
        after, before = _AFTER_AMBER_S, _BEFORE_GREEN_S
    if begins <= since < ends:
        # What is more than enough counts a little against it: others wait for the rest.
        kept = min(since - begins - after, ends - since - before, 0.0)
        return 2 * plan.cycle_s + 10 * kept - (ends - since) * _FEW * 10
    missed = min((begins - since) % plan.cycle_s, (since - ends) % plan.cycle_s)
    return -missed


def set_lights(scene: Setup) -> None:
    """The plan on the scenario's clock; who waits goes on by it."""
    if scene.signals is None:
        return
    scene.signals = shifted(scene.signals, scene.ego.offset_s)
    for draft in scene.drives.values():
        if draft.waits_s is None or draft.lets_by is not None:
            continue
        again = next(phase for phase in draft.course.phases if phase.resumes)
        draft.goes_at = AtTime(time_s=round(draft.offset_s + again.begins_s, 3))
        draft.course_ = None
        scene.note(f"{draft.id}.goes_at_s", draft.goes_at.time_s, "its light is green")

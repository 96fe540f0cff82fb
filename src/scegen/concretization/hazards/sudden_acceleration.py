"""Sudden acceleration: from reduced speed at 3 to 4 m/s2 just before it matters."""

from __future__ import annotations

from scegen.concretization.amounts import GAINING
from scegen.concretization.drafts import DriveDraft, Scene
from scegen.concretization.hazards.rule import Rule, culprits, event_s_m, same_arm, victims
from scegen.concretization.limits import SUDDEN_ACCELERATION_MPS2
from scegen.concretization.marks import Mark
from scegen.concretization.passing import slowing_s_m
from scegen.concretization.room import NeedsLongerArms
from scegen.concretization.turning import bend_of
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind

_FROM = 0.65
_TO = 1.2
"""Parts of its usual speed, before and after."""
_TO_CLOSE_UP = 1.4
_TOO_LATE_M = 15.0
_LEAST_RUN_UP_M = 10.0
_BEFORE_S = 1.5
"""It accelerates this long before the place where it matters."""


def _slows_first(scene: Scene, hazard: Hazard, draft: DriveDraft) -> bool:
    """One who follows its sufferer must not fall back from it before it accelerates.

    Nor does one whose speed, or whose acceleration, is said.
    """
    if scene.has_said_speed(draft.id) or _as_said(scene, draft):
        return False
    return not any(same_arm(draft, victim) for victim in victims(scene, hazard, draft))


def _as_said(scene: Scene, draft: DriveDraft) -> bool:
    return any(act.kind in GAINING for act in scene.speed_acts(draft.id))


def _prepare(scene: Scene, hazard: Hazard) -> None:
    for draft in culprits(scene, hazard):
        if not _slows_first(scene, hazard, draft):
            continue
        scene.note(
            f"{draft.id}.speed_mps",
            draft.cruise_mps * _FROM,
            "sudden acceleration: reduced speed first",
            draft.cruise_mps,
        )
        draft.cruise_mps *= _FROM


def _act(scene: Scene, hazard: Hazard) -> None:
    for draft in culprits(scene, hazard):
        if _as_said(scene, draft):
            continue
        rate = draft.acceleration_mps2(float(scene.rng.uniform(*SUDDEN_ACCELERATION_MPS2)))
        first = _slows_first(scene, hazard, draft)
        target = draft.cruise_mps * (_TO / _FROM if first else _TO_CLOSE_UP)
        bend = bend_of(draft.laid, target, draft.lateral_mps2)
        start = max(5.0, event_s_m(scene, draft, hazard) - draft.cruise_mps * _BEFORE_S)
        draft.resume_mps = target
        if bend is not None and bend.start_s_m - _TOO_LATE_M < start < bend.end_s_m:
            # Nobody speeds up into a bend that it cannot hold: it does so out of the bend.
            start = bend.end_s_m - 2.0
        elif bend is not None and start <= bend.start_s_m:
            draft.approach_mps = target
            reaching = (target**2 - draft.cruise_mps**2) / (2 * rate)
            start = min(start, slowing_s_m(draft) - reaching - 2.0)
            if start < _LEAST_RUN_UP_M:
                raise NeedsLongerArms(_LEAST_RUN_UP_M - start + 5.0, draft.id)
        draft.add_mark(Mark(start, target, rate, HazardKind.SUDDEN_ACCELERATION))


SUDDEN_ACCELERATION = Rule(prepare=_prepare, act=_act)

"""Sudden acceleration: from reduced speed at 3 to 4 m/s2 just before it matters."""

from __future__ import annotations

from scegen.motion.concretization.drafts import DriveDraft, Scene
from scegen.motion.concretization.hazards.rule import Rule, culprits, event_s_m, same_arm, victims
from scegen.motion.concretization.limits import SUDDEN_ACCELERATION_MPS2
from scegen.motion.concretization.marks import Mark
from scegen.motion.concretization.turning import bend_of
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind

_FROM = 0.65
_TO = 1.2
_BEFORE_S = 1.5
"""It accelerates this long before the place where it matters."""


def _slows_first(scene: Scene, hazard: Hazard, draft: DriveDraft) -> bool:
    """One who follows its sufferer must not fall back from it before it accelerates."""
    return not any(same_arm(draft, victim) for victim in victims(scene, hazard, draft))


def _prepare(scene: Scene, hazard: Hazard) -> None:
    for draft in culprits(scene, hazard):
        draft.stops_at_line = False
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
        rate = min(
            float(scene.rng.uniform(*SUDDEN_ACCELERATION_MPS2)), draft.body.max_acceleration_mps2
        )
        usual = draft.cruise_mps
        if _slows_first(scene, hazard, draft):
            usual /= _FROM
        target = usual * _TO
        bend = bend_of(draft.laid, target, draft.lateral_mps2)
        event = event_s_m(scene, draft, hazard)
        start = max(5.0, event - draft.cruise_mps * _BEFORE_S)
        if bend is not None and start > bend.start_s_m - 15.0 and start < bend.end_s_m:
            # Nobody speeds up into a bend that it cannot hold: it does so out of the bend.
            start = bend.end_s_m - 2.0
        elif bend is not None and start <= bend.start_s_m:
            target = min(target, bend.speed_mps * 1.2)
        draft.add_mark(Mark(start, target, rate, HazardKind.SUDDEN_ACCELERATION))
        draft.resume_mps = target


SUDDEN_ACCELERATION = Rule(prepare=_prepare, act=_act)

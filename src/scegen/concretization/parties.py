"""Whom a danger at a junction concerns, and where on their ways it happens."""

from __future__ import annotations

import numpy as np

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.meetings import drives_meet
from scegen.concretization.setup import Setup
from scegen.measures.grounds import grounds
from scegen.scenario.acts import GAINING, ActKind
from scegen.scenario.functional import Hazard
from scegen.scenario.hazards import HAZARDS, Arrangement, Case, Motion
from scegen.scenario.vocabulary import HazardKind

_CLEAR_OF_WALKER_M, _CLEAR_BEHIND_M, _CLEAR_OF_OTHER_M = 1.3, 0.7, 3.0
_TURNED_RAD = 0.75
"""Who stops in a bend is seen to turn: it has got so far, and may stop a little sooner."""
_BEFORE_S = 1.5
"""Who gains speed begins to so long before the place where it matters."""


def culprits(scene: Setup, hazard: Hazard) -> list[DriveDraft]:
    """The drives that cause a hazard."""
    return [scene.drives[name] for name in hazard.by if name in scene.drives]


def victims(scene: Setup, hazard: Hazard, culprit: DriveDraft) -> list[DriveDraft]:
    """The drives that suffer it; none where those who do are on foot."""
    return [scene.drives[n] for n in hazard.to if n in scene.drives and n != culprit.id]


def pairs(scene: Setup, hazard: Hazard) -> list[tuple[DriveDraft, DriveDraft]]:
    """(cause, sufferer) of a hazard for which they must arrive together, drives only.

    None where a danger is made by where somebody walks or stands, not by how anybody drives.
    """
    row = HAZARDS[hazard.kind]
    if row.moves is Motion.STILL or Arrangement.OVER in row.needs.get(Case.ANYWHERE, ()):
        return []
    return [(c, v) for c in culprits(scene, hazard) for v in victims(scene, hazard, c)]


def same_arm(first: DriveDraft, second: DriveDraft) -> bool:
    """Whether both enter on the same arm."""
    return first.drive.entry == second.drive.entry


def ahead_on_arm(scene: Setup, draft: DriveDraft) -> list[DriveDraft]:
    """Those who come before it on the same arm, the first first."""
    same = (other for other in scene.drives.values() if same_arm(other, draft))
    ahead = (other for other in same if other.drive.rank < draft.drive.rank)
    return sorted(ahead, key=lambda other: other.drive.rank)


def event_s_m(scene: Setup, draft: DriveDraft, hazard: Hazard) -> float:
    """Where on its way a driver's danger happens.

    Of one in the ring already, half way round; where it meets a sufferer; else on its entry arm,
    before it slows to turn.
    """
    if draft.drive.circulating:
        laid = draft.laid
        return laid.path_s_m((laid.turning_starts_m + laid.turning_ends_m) / 2)
    for victim in victims(scene, hazard, draft):
        point = drives_meet(draft, victim)
        if point is not None:
            return point.first_s_m
    base = [mark.s_m for mark in draft.road_changes() if mark.s_m > 1.0]
    return min([draft.junction_s_m - 10.0, *base]) - 5.0


def stops_for_walkers(scene: Setup, draft: DriveDraft, *names: str) -> tuple[float, float] | None:
    """Where the reference point must rest for those who cross, and how long until they have.

    For all of them, or those of some names.
    """
    stops = []
    for walk in (scene.walks[n] for n in names or scene.walks if n in scene.walks):
        for shared in grounds(draft.laid.path, draft.body, walk.path, walk.body)[:1]:
            over = min(shared.other_leaves_m, walk.path.length_m)
            clear = over + _CLEAR_BEHIND_M - walk.setback_m
            stops.append((shared.enter_m - _CLEAR_OF_WALKER_M, clear / walk.speed_mps))
    if not stops:
        return None
    return min(place for place, _ in stops), max(clear for _, clear in stops)


def happens_s_m(scene: Setup, draft: DriveDraft, kind: HazardKind, act: ActKind) -> float:
    """Where a change of speed is to be over (or a gain of it to begin), as far as nobody says.

    Who causes no danger by it does so for those who endanger it, or whom it endangers.
    """
    hazards = scene.functional.hazards
    about = [h.to for h in hazards if draft.id in h.by and h.kind is kind]
    about += [h.by for h in hazards if draft.id in h.to]
    about += [h.to for h in hazards if draft.id in h.by]
    hazard = Hazard(kind=kind, by=(draft.id,), to=about[0] if about else ())
    place = event_s_m(scene, draft, hazard)
    if act in GAINING:
        return place - _BEFORE_S * draft.cruise_mps
    walkers = stops_for_walkers(scene, draft)
    if walkers is not None:
        return walkers[0]
    if draft is scene.ego:
        # The ego brakes to avoid, the others brake in its way.
        place -= draft.body.length_m / 2 + _CLEAR_OF_OTHER_M
    elif act is ActKind.STOP and place > draft.junction_s_m:
        path = draft.laid.path
        turned = np.abs(path.heading_rad - path.heading_rad[0]) >= _TURNED_RAD
        place = max(place, float(path.s_m[turned.argmax()]))
    return place

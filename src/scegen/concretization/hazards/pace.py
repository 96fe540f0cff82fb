"""Dangers that are a pace: too fast, too slow, or too close to the next.

The shares of the limit lie within those of the table of hazards; a time gap of tailgating is 0.4 to
0.8 s at the leader's speed.
"""

from __future__ import annotations

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.hazards.rule import Rule, culprits, in_line_before, pairs, same_arm
from scegen.concretization.limits import (
    FAST_LATERAL_MPS2,
    TAILGATING_HEADWAY_S,
    USUAL_SHARES,
)
from scegen.concretization.meetings import STRUCTURAL, Meeting
from scegen.concretization.setup import Setup
from scegen.scenario.functional import Hazard
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.speed_limits import limit_for_kind_mps
from scegen.scenario.vocabulary import HazardKind

_LEAST_GAP_M = 2.0
_PLACE = 0.5
"""Where on the arm one is so close behind the other."""


def _set_pace(scene: Setup, hazard: Hazard) -> None:
    share = HAZARDS[hazard.kind].speed_share
    if share is None:
        return
    least, most, _ = share
    usual = USUAL_SHARES[hazard.kind]
    drives = sorted(culprits(scene, hazard), key=lambda each: each.drive.rank)
    for draft in drives:
        limit = limit_for_kind_mps(draft.kind, scene.limit_mps)
        wanted = float(scene.rng.uniform(*usual)) * limit
        low, high = scene.allowed(f"{draft.id}.speed_mps", (wanted, wanted))
        inside = min(max(wanted, low), high)
        # A range that ends at the limit would undo the danger that the text asks for.
        speed = inside if least * limit <= inside <= most * limit else wanted
        speed = min(speed, draft.body.top_speed_mps)
        kind = hazard.kind.value.replace("_", " ")
        reason = f"{kind}: {speed / limit:.2f} times the limit"
        scene.note(f"{draft.id}.speed_mps", speed, reason, draft.cruise_mps)
        draft.cruise_mps = speed
        if least > 1.0:
            draft.lateral_mps2 = FAST_LATERAL_MPS2
        ahead = [each for each in in_line_before(scene, draft) if each in drives]
        if ahead:  # a line of them drives as fast as its first
            draft.cruise_mps = ahead[-1].cruise_mps


def _follow_closely(scene: Setup, hazard: Hazard) -> list[Meeting]:
    couples = [(c, v) for c, v in pairs(scene, hazard) if same_arm(c, v)]
    for follower, leader in couples[:1]:
        headway = float(scene.rng.uniform(*TAILGATING_HEADWAY_S))
        follower.entry_lane = leader.entry_lane
        if not _comes_up_fast(scene, follower, leader):
            follower.cruise_mps = leader.cruise_mps
        follower.lateral_mps2 = leader.lateral_mps2
        follower.lay(scene.network)
        gap = max(_LEAST_GAP_M, headway * leader.cruise_mps)
        place = leader.junction_s_m * _PLACE
        met = place - gap - leader.body.rear_m - follower.body.front_m
        scene.note(f"{follower.id}.headway_s", headway, f"tailgating {leader.id}")
        reason = f"tailgating at {headway:.2f} s"
        return [Meeting(STRUCTURAL - 1, leader.id, follower.id, place, met, 0.0, reason)]
    return []


def _comes_up_fast(scene: Setup, follower: DriveDraft, leader: DriveDraft) -> bool:
    """Whether the follower is said to be speeding, and the leader is not."""
    fast = {n for h in scene.functional.hazards if h.kind is HazardKind.SPEEDING for n in h.by}
    alone = follower.id in fast and leader.id not in fast
    return alone and follower.cruise_mps > leader.cruise_mps


KEEPS_PACE = Rule(prepare=_set_pace)
TAILGATES = Rule(shape=_follow_closely, meets=False)

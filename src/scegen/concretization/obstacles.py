"""Things in the way: where they lie, and what those in whose way they lie do about them.

Who changes lanes anyway does it because of the thing, which lies in the lane that it leaves. Who
is concerned with nothing else brakes and stops short of it, and so does, in line, who follows.
Everybody else goes round it, as round a parked vehicle; who is said to brake does so first.
"""

from __future__ import annotations

from dataclasses import replace

from scegen.concretization.clock import same_lane
from scegen.concretization.courses import SpeedChange
from scegen.concretization.drafts import DriveDraft, Setup
from scegen.concretization.hazards.rule import culprits, same_arm, victims
from scegen.concretization.lane_choice import lanes_in
from scegen.concretization.limits import HARD_BRAKING_MPS2
from scegen.concretization.meetings import drives_meet
from scegen.concretization.objects import (
    caused_by_nobody,
    lying_in_the_way,
    made_of,
    shape_of,
)
from scegen.concretization.obstacle_spots import Spot, is_free, spots, touches
from scegen.concretization.passing import calm_change_length_m, pass_standing
from scegen.errors import MotionInfeasibleError
from scegen.scenario.bodies import Body
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.vocabulary import HazardKind, Maneuver

_BRAKES = frozenset({HazardKind.HARD_BRAKING, HazardKind.STOPPING, HazardKind.DELAYED_BRAKING})
_BY_THINGS = frozenset({HazardKind.OBSTACLE, HazardKind.OCCLUSION})
_IN_LINE = _BRAKES | {HazardKind.SPEEDING, HazardKind.TAILGATING}
"""Dangers in one line of vehicles that end with it standing before the thing."""
_SIDEWAYS = frozenset({Maneuver.LANE_CHANGE, Maneuver.OVERTAKE})
_KERB_M = 0.1
_SHORT_M = 1.0
"""Between a thing and who stops for it."""
_QUEUE_M = 1.5
"""Between two who stop for it in line."""
_PULLS_OUT_OVER_M = 15.0
"""One that has stopped needs no more room than this to change lanes."""
_BEFORE_PULLING_OUT_M = 0.5


def needs_obstacle(functional: FunctionalScenario, hazard: Hazard) -> bool:
    """Whether a danger is a thing in the way, and nobody is said to be that thing."""
    return hazard.kind is HazardKind.OBSTACLE and caused_by_nobody(functional, hazard)


def expect_obstacles(scene: Setup) -> None:
    """Which dangers need a thing in the way, what it is, and in whose way it lies."""
    if scene.obstacles:
        scene.expected = lying_in_the_way(scene.functional, scene.logical, scene.drives)


def goes_round_a_thing(scene: Setup, draft: DriveDraft) -> bool:
    """Whether a drive that overtakes or changes lanes does so round a thing in its way."""
    expected = any(thing.in_way_of == draft.id for _, thing in scene.expected)
    return expected and (draft.drive.maneuver is Maneuver.OVERTAKE or lanes_in(scene, draft) == 1)


def place_obstacles(scene: Setup) -> None:
    """Lay every thing that is expected in the way, and lead the others round it.

    Where there is no place for it, it is left out, and the danger with it.
    """
    for hazard, thing in scene.expected:
        draft = scene.drives[thing.in_way_of or ""]
        width = scene.road.arms[draft.drive.entry].lane_width_m - 2 * _KERB_M
        shape = shape_of(thing.kind)
        shape = replace(shape, width_m=min(shape.width_m, width))
        stays = _may_stay(scene, draft)
        free = (s for s in spots(scene, draft, shape.body, stays=stays)
                if is_free(scene, draft, s, shape.body))  # fmt: skip
        spot = next((s for s in free if _react(scene, draft, s, shape.body, stays=stays)), None)
        if spot is None:
            continue
        made = made_of(thing.id, shape, thing.called, spot.pose)
        scene.add_object(made, hazard, draft.id)
        away = draft.laid.turning_starts_m - spot.station_m
        scene.note(f"{made.id}.from_junction_m", away, f"lies in the way of {draft.id}")


def _may_stay(scene: Setup, draft: DriveDraft) -> bool:
    """Whether a drive may stop short of a thing for good: nothing but its line is concerned."""
    line = [draft, *_behind(scene, draft)]
    names = {d.id for d in line}
    if scene.walks or any(d.changes_before or d.drive.maneuver in _SIDEWAYS for d in line):
        return False
    for hazard in scene.functional.hazards:
        own = {d.id for d in culprits(scene, hazard)} | {*hazard.by, *hazard.to} <= names
        if hazard.kind not in _BY_THINGS and not (own and hazard.kind in _IN_LINE):
            return False
    return all(
        same_lane(other, draft) or drives_meet(one, other) is None
        for one in line
        for other in scene.drives.values()
        if other.id not in names
    )


def _behind(scene: Setup, draft: DriveDraft) -> list[DriveDraft]:
    """Those behind a drive in its lane, in line."""
    behind = [
        other
        for other in scene.drives.values()
        if same_lane(other, draft) and other.drive.rank > draft.drive.rank
    ]
    return sorted(behind, key=lambda other: other.drive.rank)


def _react(scene: Setup, draft: DriveDraft, spot: Spot, body: Body, *, stays: bool) -> bool:
    """Lead everybody round a thing who would touch it; who may stay stops short of it.

    False where somebody has no room for it: nothing has changed then.
    """
    before = {name: list(other.lane_changes) for name, other in scene.drives.items()}
    try:
        _go_round(scene, draft, spot, body, stays=stays)
    except MotionInfeasibleError:
        for name, changes in before.items():
            other = scene.drives[name]
            other.rests_at_m = other.halts_at_m = None
            if other.lane_changes != changes:
                other.lane_changes = changes
                other.lay(scene.network)
        return False
    return True


def _go_round(scene: Setup, draft: DriveDraft, spot: Spot, body: Body, *, stays: bool) -> None:
    line = [draft, *_behind(scene, draft)] if stays else []
    rear = spot.station_m - body.length_m / 2 - _SHORT_M
    for one in line:
        one.halts_at_m = one.rests_at_m = one.laid.path_s_m(rear - one.body.front_m)
        rear -= one.body.length_m + _QUEUE_M
    brakes = _brakes(scene, draft)
    for other in scene.drives.values():
        if other.changes_before or other in line:
            continue
        if touches(other.laid.path, other.body, spot.pose, body):
            width = scene.road.arms[other.drive.entry].lane_width_m
            calm = calm_change_length_m(other, width)
            out = _PULLS_OUT_OVER_M if brakes and other is draft else calm
            pass_standing(scene, other, spot.station_m, body, over_m=(out, calm))
            if other is draft and brakes:
                out = draft.lane_changes[0].position_m - _BEFORE_PULLING_OUT_M
                draft.rests_at_m = draft.laid.path_s_m(out)


def _brakes(scene: Setup, draft: DriveDraft) -> bool:
    """Whether a drive is said to brake or to stop, as one does before a thing.

    Who brakes in the way of one from another arm does it where the two meet.
    """
    return any(
        hazard.kind in _BRAKES
        and draft in culprits(scene, hazard)
        and all(same_arm(victim, draft) for victim in victims(scene, hazard, draft))
        for hazard in scene.functional.hazards
    )


def stop_short(scene: Setup) -> None:
    """Who stops short of a thing stays there; where nothing says how it brakes, it brakes hard."""
    for draft in scene.drives.values():
        if draft.halts_at_m is None:
            continue
        stopping = [n for n, mark in enumerate(draft.marks) if mark.target_mps == 0.0]
        if stopping:
            draft.marks[stopping[0]] = replace(draft.marks[stopping[0]], hold_s=None)
        else:
            rate = draft.braking_mps2(float(scene.rng.uniform(*HARD_BRAKING_MPS2)))
            braking = draft.course.speed_at(draft.halts_at_m) ** 2 / (2 * rate)
            start = max(3.0, draft.halts_at_m - braking - 0.1)
            draft.add_speed_change(SpeedChange(start, 0.0, rate, HazardKind.OBSTACLE))
        draft.course_ = None

"""Things in the way: where they lie, and who goes round them.

A thing lies in the lane of somebody, some way before the junction, or where that one leaves the
lane anyway. Who is concerned with nothing else brakes for it and stays, and so does, in
line, who follows (see ``answering``); everybody else goes round it, as round a parked vehicle.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from scegen.concretization.boxes import apart, box_of, box_on
from scegen.concretization.clock import same_lane
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.hazards.rule import same_arm, victims
from scegen.concretization.lane_choice import lanes_in, neighbour_lane
from scegen.concretization.meetings import drives_meet
from scegen.concretization.objects import caused_by_nobody, lying_in_the_way, made_of, shape_of
from scegen.concretization.passing import calm_change_length_m, pass_standing
from scegen.concretization.room import NeedsLongerArms
from scegen.concretization.setup import Setup
from scegen.concretization.stationary import BLOCKS_AT_M
from scegen.road.geometry import Pose
from scegen.road.model import RouteStep
from scegen.scenario.bodies import Body
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.vocabulary import DrivingSide, HazardKind, Maneuver

_BRAKES = frozenset({HazardKind.HARD_BRAKING, HazardKind.STOPPING, HazardKind.DELAYED_BRAKING})
_BY_THINGS = frozenset({HazardKind.OBSTACLE, HazardKind.OCCLUSION})
_IN_LINE = _BRAKES | _BY_THINGS | {HazardKind.SPEEDING, HazardKind.TAILGATING}
"""Dangers in one line of vehicles that end with it standing before the thing."""
_SIDEWAYS = frozenset({Maneuver.LANE_CHANGE, Maneuver.OVERTAKE})
_KERB_M, _CLEAR_M, _WOULD_HIT_M = 0.1, 0.45, 0.1
"""From the edge of the lane; from who keeps clear of it; into who would not."""
_LEAST_WAY_M, _ROOM_M = 30.0, 6.0
_SAMPLE_M = 0.5
_SHORT_M, _QUEUE_M = 1.0, 1.5
"""Between a thing and who stops for it, and the next in line."""
_PULLS_OUT_OVER_M, _BEFORE_PULLING_OUT_M = 15.0, 0.5
"""One that has stopped needs no more room than this to change lanes."""


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

    Where somebody who may not touch it would do so, it is left out, and the danger with it.
    """
    for hazard, thing in scene.expected:
        draft = scene.drives[thing.in_way_of or ""]
        shape = shape_of(thing)
        if thing.length_m is None and thing.width_m is None:
            width = scene.road.arms[draft.drive.entry].lane_width_m - 2 * _KERB_M
            shape = replace(shape, width_m=min(shape.width_m, width))
        line = _who_may_stay(scene, draft)
        station, pose = _spot(scene, draft, shape.body, stays=bool(line))
        touching = [d for d in scene.drives.values() if _touches(d, pose, shape.body)]
        if any(d.changes_before or not (d is draft or same_lane(d, draft)) for d in touching):
            continue
        made = made_of(thing.id, shape, thing.called, pose)
        scene.add_object(made, hazard, draft.id)
        away = draft.laid.turning_starts_m - station
        scene.note(f"{made.id}.from_junction_m", away, f"lies in the way of {draft.id}")
        rear = station - shape.length_m / 2 - _SHORT_M
        for one in line:
            one.rests_at_m = one.laid.path_s_m(rear - one.body.front_m)
            rear -= one.body.length_m + _QUEUE_M
        for other in touching if not line else ():
            _go_round(scene, other, station, shape.body, brakes=other is draft)


def _spot(scene: Setup, draft: DriveDraft, body: Body, *, stays: bool) -> tuple[float, Pose]:
    """Where a thing lies on a drive (m), and the pose of its middle.

    In the middle of the lane for one that stops; near those who pass for one that goes round; at
    the far edge of the lane that one leaves anyway.
    """
    arm = scene.road.arms[draft.drive.entry]
    in_lane = (arm.lane_width_m - body.width_m) / 2
    out = next((c for c in draft.lane_changes if c.lane_after != draft.entry_lane), None)
    if out is not None and draft.changes_before:
        aside = out.lane_after
        station = out.position_m + out.length_m
        share = -in_lane
    else:
        aside = neighbour_lane(scene, draft, oncoming=True)
        calm = 0.0 if stays else calm_change_length_m(draft, arm.lane_width_m)
        room = calm + draft.body.length_m + body.length_m + _ROOM_M
        station = draft.laid.turning_starts_m - max(BLOCKS_AT_M, room)
        if station <= _LEAST_WAY_M:
            raise NeedsLongerArms(_LEAST_WAY_M - station + 1.0, draft.id)
        near = min(in_lane, (draft.body.width_m + body.width_m) / 2 - _WOULD_HIT_M)
        share = 0.0 if stays else near
    right = scene.network.driving_side is DrivingSide.RIGHT
    lane = -draft.entry_lane if right else draft.entry_lane
    step = RouteStep(scene.network.arm_roads[draft.drive.entry], lane, forward=True)
    inwards = (aside < draft.entry_lane) == right
    return station, scene.network.pose_at(step, station, share if inwards else -share)


def _touches(draft: DriveDraft, pose: Pose, body: Body) -> bool:
    """Whether one who goes along its way comes too close to a thing."""
    path = draft.laid.path
    s = np.linspace(0.0, path.length_m, max(2, int(path.length_m / _SAMPLE_M) + 1))
    return bool((apart(box_on(path, draft.body, s), box_of(pose, body), _CLEAR_M) < _CLEAR_M).any())


def _who_may_stay(scene: Setup, draft: DriveDraft) -> list[DriveDraft]:
    """A drive and those behind it in line, if nothing else concerns them: they stop for good."""
    behind = (
        other
        for other in scene.drives.values()
        if same_lane(other, draft) and other.drive.rank > draft.drive.rank
    )
    line = [draft, *sorted(behind, key=lambda other: other.drive.rank)]
    names = {d.id for d in line}
    if scene.walks or any(d.changes_before or d.drive.maneuver in _SIDEWAYS for d in line):
        return []
    for hazard in scene.functional.hazards:
        own = {*hazard.by, *hazard.to} & scene.drives.keys() <= names
        if hazard.kind not in _BY_THINGS and not (own and hazard.kind in _IN_LINE):
            return []
    others = [other for other in scene.drives.values() if other.id not in names]
    met = any(not same_lane(o, draft) and drives_meet(one, o) for one in line for o in others)
    return [] if met else line


def _go_round(scene: Setup, draft: DriveDraft, station: float, body: Body, *, brakes: bool) -> None:
    """Out of the lane and back; who is said to brake or to stop does so first.

    Who brakes in the way of one from another arm does it where the two meet.
    """
    braking = [
        hazard
        for hazard in scene.functional.hazards
        if hazard.kind in _BRAKES and draft.id in hazard.by and brakes
    ]
    brakes = any(all(same_arm(v, draft) for v in victims(scene, h, draft)) for h in braking)
    calm = calm_change_length_m(draft, scene.road.arms[draft.drive.entry].lane_width_m)
    out = _PULLS_OUT_OVER_M if brakes else calm
    pass_standing(scene, draft, station, body, over_m=(out, calm))
    if brakes:
        out = draft.lane_changes[0].position_m - _BEFORE_PULLING_OUT_M
        draft.rests_at_m = draft.laid.path_s_m(out)

"""Things in the way: where they lie, and what those in whose way they lie do about them.

Who changes lanes anyway does it because of the thing, which lies in the lane that it leaves. Who
is concerned with nothing else brakes and stops short of it, and so does, in line, who follows.
Everybody else goes round it, as round a parked vehicle; who is said to brake does so first.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import ceil, degrees

import numpy as np

from scegen.motion.concretization.boxes import Poses, overlaps
from scegen.motion.concretization.clock import same_lane
from scegen.motion.concretization.drafts import DriveDraft, Expected, Scene
from scegen.motion.concretization.hazards.rule import culprits
from scegen.motion.concretization.lane_choice import lanes_in, neighbour_lane
from scegen.motion.concretization.limits import HARD_BRAKING_MPS2
from scegen.motion.concretization.marks import Mark
from scegen.motion.concretization.meetings import drives_meet
from scegen.motion.concretization.passing import pass_standing
from scegen.motion.concretization.said import object_id, words_of
from scegen.motion.concretization.standers import BLOCKS_AT_M, BLOCKS_STRAIGHT_AT_M
from scegen.motion.concretization.things import OBSTACLE, obstacle_named
from scegen.motion.model import Path
from scegen.motion.standing import object_path
from scegen.road.geometry import Pose
from scegen.road.model import RouteStep
from scegen.scenario.bodies import Body
from scegen.scenario.objects import StaticObject
from scegen.scenario.vocabulary import DrivingSide, HazardKind, Maneuver

_REACTS = (
    HazardKind.HARD_BRAKING,
    HazardKind.SWERVING,
    HazardKind.STOPPING,
    HazardKind.DELAYED_BRAKING,
    HazardKind.LOSS_OF_CONTROL,
    HazardKind.MERGING_CONFLICT,
    HazardKind.CUT_IN,
    HazardKind.ONCOMING_LANE,
    HazardKind.OVERTAKING,
    HazardKind.SUDDEN_TURN,
)
"""What somebody may do because of a thing in its way, the plainest first."""
_BRAKES = frozenset({HazardKind.HARD_BRAKING, HazardKind.STOPPING, HazardKind.DELAYED_BRAKING})
_IN_LINE = _BRAKES | {HazardKind.SPEEDING, HazardKind.TAILGATING}
"""Dangers in one line of vehicles that end with it standing before the thing."""
_SIDEWAYS = frozenset({Maneuver.LANE_CHANGE, Maneuver.OVERTAKE})
_CLEAR_M = 0.45
"""What keeps clear of a thing passes by at least so far from it."""
_KERB_M = 0.1
_SHORT_M = 1.0
"""Between a thing and who stops for it."""
_QUEUE_M = 1.5
"""Between two who stop for it in line."""
_PULLS_OUT_OVER_M = 12.0
"""One that has stopped needs no more room than this to change lanes."""
_BEFORE_PULLING_OUT_M = 0.5
_LEAST_WAY_M = 30.0
_EARLIER_M = 40.0
_STEP_M = 1.0
_SAMPLE_M = 0.5


@dataclass(frozen=True, slots=True)
class _Spot:
    """Where a thing may lie: ``station_m`` along the drive, the pose of its middle."""

    station_m: float
    pose: Pose


def expect_obstacles(scene: Scene) -> None:
    """Which dangers need a thing in the way, what it is, and in whose way it lies."""
    for hazard in scene.functional.hazards:
        if hazard.kind is not HazardKind.OBSTACLE or hazard.by:
            continue
        named = obstacle_named(words_of(scene.functional, hazard))
        if named is None and scene.stands:
            continue
        named_victims = [name for name in hazard.to if name in scene.drives]
        who = named_victims[0] if named_victims else _who_reacts(scene)
        scene.expected.append(Expected(hazard, named or OBSTACLE, who))


def _who_reacts(scene: Scene) -> str:
    """Who does something that one does because of a thing in the way; else the ego."""
    for kind in _REACTS:
        for hazard in scene.functional.hazards:
            if hazard.kind is kind:
                found = culprits(scene, hazard)
                if found:
                    return found[0].id
    sideways = [d.id for d in scene.drives.values() if d.drive.maneuver in _SIDEWAYS]
    return next(iter(sideways), scene.ego.id) if scene.ego.id not in sideways else scene.ego.id


def goes_round_a_thing(scene: Scene, draft: DriveDraft) -> bool:
    """Whether a drive that overtakes or changes lanes does so round a thing in its way."""
    expected = any(plan.who == draft.id for plan in scene.expected)
    return expected and (draft.drive.maneuver is Maneuver.OVERTAKE or lanes_in(scene, draft) == 1)


def place_obstacles(scene: Scene) -> None:
    """Lay every thing that is expected in the way, and lead the others round it.

    Where there is no place for it, it is left out, and the danger with it.
    """
    for plan in scene.expected:
        draft = scene.drives[plan.who]
        width = scene.road.arms[draft.drive.entry].lane_width_m - 2 * _KERB_M
        thing = replace(plan.thing, width_m=min(plan.thing.width_m, width))
        body = _body(thing.length_m, thing.width_m, thing.height_m)
        stays = _may_stay(scene, draft)
        if draft.lane_changes:
            spots = _beside(scene, draft, body)
        else:
            spots = _ahead(scene, draft, body, stays=stays)
        spot = next((spot for spot in spots if _free(scene, draft, spot, body)), None)
        if spot is None:
            continue
        made = StaticObject(
            id=object_id(scene, thing.what),
            category=thing.category,
            what=thing.what,
            x_m=round(spot.pose.x_m, 3),
            y_m=round(spot.pose.y_m, 3),
            heading_deg=round((degrees(spot.pose.heading_rad) + 180) % 360 - 180, 3),
            length_m=thing.length_m,
            width_m=round(thing.width_m, 3),
            height_m=thing.height_m,
            mass_kg=thing.mass_kg,
            blueprint=thing.blueprint,
        )
        _react(scene, draft, spot, body, stays=stays)
        scene.add_object(made, plan.hazard, draft.id)
        away = draft.laid.turning_starts_m - spot.station_m
        scene.note(f"{made.id}.from_junction_m", away, f"lies in the way of {draft.id}")


def _body(length_m: float, width_m: float, height_m: float) -> Body:
    return Body(length_m, width_m, height_m, 0.0, 0.0, "", 0.0, 0.0, 0.0)


def _may_stay(scene: Scene, draft: DriveDraft) -> bool:
    """Whether a drive may stop short of a thing for good: nothing but its line is concerned."""
    line = [draft, *_behind(scene, draft)]
    names = {d.id for d in line}
    if scene.walks or any(d.lane_changes or d.drive.maneuver in _SIDEWAYS for d in line):
        return False
    for hazard in scene.functional.hazards:
        own = {d.id for d in culprits(scene, hazard)} | {*hazard.by, *hazard.to} <= names
        if hazard.kind is not HazardKind.OBSTACLE and not (own and hazard.kind in _IN_LINE):
            return False
    return all(
        same_lane(other, draft) or drives_meet(one, other) is None
        for one in line
        for other in scene.drives.values()
        if other.id not in names
    )


def _behind(scene: Scene, draft: DriveDraft) -> list[DriveDraft]:
    """Those behind a drive in its lane, in line."""
    found = [d for d in scene.drives.values() if same_lane(d, draft)]
    return sorted(
        (d for d in found if d.drive.rank > draft.drive.rank), key=lambda d: d.drive.rank
    )


def _ahead(scene: Scene, draft: DriveDraft, body: Body, *, stays: bool) -> Iterator[_Spot]:
    """In the lane of one that keeps to it, before the junction, then farther away from it.

    In the middle for one that stops; towards those who pass for one that goes round.
    """
    arm = scene.road.arms[draft.drive.entry]
    aside = 0.0 if stays else _aside_m(scene, draft, (arm.lane_width_m - body.width_m) / 2)
    nearest = BLOCKS_AT_M if scene.network.junctions else BLOCKS_STRAIGHT_AT_M
    for k in range(int(_EARLIER_M / _STEP_M)):
        station = draft.laid.turning_starts_m - nearest - k * _STEP_M
        if station > _LEAST_WAY_M:
            yield _Spot(station, _pose(scene, draft, station, aside))


def _beside(scene: Scene, draft: DriveDraft, body: Body) -> Iterator[_Spot]:
    """In the lane that one leaves, where it has left it; as near to its way as can be."""
    leaving = next((c for c in draft.lane_changes if c.lane_after != draft.entry_lane), None)
    if leaving is None:
        return
    back = [
        c.position_m + c.length_m
        for c in draft.lane_changes
        if c.position_m > leaving.position_m and c.lane_after == draft.entry_lane
    ]
    end = draft.laid.turning_starts_m
    if not scene.network.junctions:
        end += scene.road.arms[draft.drive.exit].length_m
    last = min([*back, end - body.length_m])
    room = (scene.road.arms[draft.drive.entry].lane_width_m - body.width_m) / 2
    inwards = leaving.lane_after < draft.entry_lane
    for k in range(max(0, ceil((last - leaving.position_m) / _STEP_M))):
        station = leaving.position_m + k * _STEP_M
        for share in (1.0, 0.75, 0.5, 0.25, 0.0):
            aside = _left_m(scene, room * share, inwards=inwards)
            yield _Spot(station, _pose(scene, draft, station, aside))


def _aside_m(scene: Scene, draft: DriveDraft, room_m: float) -> float:
    """How far to a drive's left a thing lies, so that one who goes round comes close to it."""
    inwards = neighbour_lane(scene, draft, oncoming=True) < draft.entry_lane
    return _left_m(scene, room_m, inwards=inwards)


def _left_m(scene: Scene, aside_m: float, *, inwards: bool) -> float:
    keeps_right = scene.network.driving_side is DrivingSide.RIGHT
    return aside_m if inwards == keeps_right else -aside_m


def _pose(scene: Scene, draft: DriveDraft, station_m: float, left_m: float) -> Pose:
    """A place in the lane in which a drive enters, whether or not it has left it there."""
    network, lane = scene.network, draft.entry_lane
    inwards = -1 if network.driving_side is DrivingSide.RIGHT else 1
    entry = network.arm_roads[draft.drive.entry]
    length = network.road(entry).length_m
    if station_m <= length or network.junctions:
        return network.pose_at(RouteStep(entry, inwards * lane, forward=True), station_m, left_m)
    step = RouteStep(network.arm_roads[draft.drive.exit], -inwards * lane, forward=False)
    return network.pose_at(step, station_m - length, left_m)


def _free(scene: Scene, draft: DriveDraft, spot: _Spot, body: Body) -> bool:
    """Whether a thing may lie there: whoever would touch it and may not can still go round."""
    for other in scene.drives.values():
        free = not other.lane_changes and (other is draft or same_lane(other, draft))
        if not free and _touches(other.laid.path, other.body, spot.pose, body):
            return False
    still = [(w.path, w.body) for w in scene.walks.values()]
    still += [(s.path, s.body) for s in scene.stands.values()]
    still += [(object_path(thing), thing.body) for thing in scene.objects]
    return not any(_touches(path, own, spot.pose, body) for path, own in still)


def _touches(path: Path, own: Body, place: Pose, body: Body) -> bool:
    """Whether one who goes along a path comes too close to a box."""
    count = max(2, int(path.length_m / _SAMPLE_M) + 1)
    s = np.linspace(0.0, path.length_m, count)
    way: Poses = (
        np.interp(s, path.s_m, path.x_m),
        np.interp(s, path.s_m, path.y_m),
        np.interp(s, path.s_m, path.heading_rad),
    )
    there: Poses = (
        np.full(count, place.x_m),
        np.full(count, place.y_m),
        np.full(count, place.heading_rad),
    )
    return bool(overlaps(way, own, there, body, _CLEAR_M).any())


def _react(scene: Scene, draft: DriveDraft, spot: _Spot, body: Body, *, stays: bool) -> None:
    """Lead everybody round a thing who would touch it; who may stay stops short of it."""
    line = [draft, *_behind(scene, draft)] if stays else []
    rear = spot.station_m - body.length_m / 2 - _SHORT_M
    for one in line:
        one.halts_at_m = one.rests_at_m = one.laid.path_s_m(rear - one.body.front_m)
        rear -= one.body.length_m + _QUEUE_M
    brakes = _brakes(scene, draft)
    for other in scene.drives.values():
        if other.lane_changes or other in line:
            continue
        if _touches(other.laid.path, other.body, spot.pose, body):
            over = _PULLS_OUT_OVER_M if brakes and other is draft else None
            pass_standing(scene, other, spot.station_m, body, over_m=over)
            if other is draft and brakes:
                out = draft.lane_changes[0].position_m - _BEFORE_PULLING_OUT_M
                draft.rests_at_m = draft.laid.path_s_m(out)


def _brakes(scene: Scene, draft: DriveDraft) -> bool:
    """Whether a drive is said to brake or to stop."""
    return any(
        hazard.kind in _BRAKES and draft in culprits(scene, hazard)
        for hazard in scene.functional.hazards
    )


def stop_short(scene: Scene) -> None:
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
            draft.add_mark(Mark(start, 0.0, rate, HazardKind.OBSTACLE))
        draft.course_ = None

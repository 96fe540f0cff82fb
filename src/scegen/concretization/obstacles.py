"""Things in the way: where they lie, and what those in whose way they lie do about them.

Places are tried from the junction outwards until one is free and everybody can do something about
it. Who changes lanes anyway does it because of the thing, which lies in the lane that it leaves.
Who is concerned with nothing else brakes and stops short of it, and so does, in line, who follows.
Everybody else goes round it, as round a parked vehicle; who is said to brake does so first.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from scegen.concretization.boxes import apart, box_of, box_on
from scegen.concretization.clock import same_lane
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.hazards.rule import culprits, same_arm, victims
from scegen.concretization.lane_choice import lanes_in, neighbour_lane
from scegen.concretization.limits import HARD_BRAKING_MPS2
from scegen.concretization.meetings import drives_meet
from scegen.concretization.objects import caused_by_nobody, lying_in_the_way, made_of, shape_of
from scegen.concretization.passing import calm_change_length_m, pass_standing
from scegen.concretization.room import NeedsLongerArms
from scegen.concretization.setup import Setup
from scegen.concretization.speed_change import SpeedChange
from scegen.concretization.stationary import BLOCKS_AT_M
from scegen.errors import MotionInfeasibleError
from scegen.motion.model import Path
from scegen.motion.standing import object_path
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
_PLACES, _STEP_M, _SAMPLE_M = 40, 1.0, 0.5
_SHARES = (1.0, 0.75, 0.5, 0.25, 0.0)
_SHORT_M, _QUEUE_M = 1.0, 1.5
"""Between a thing and who stops for it, and the next in line."""
_PULLS_OUT_OVER_M, _BEFORE_PULLING_OUT_M = 15.0, 0.5
"""One that has stopped needs no more room than this to change lanes."""


@dataclass(frozen=True, slots=True)
class _Spot:
    """Where a thing may lie: ``station_m`` along the drive, the pose of its middle."""

    station_m: float
    pose: Pose
    body: Body

    def touches(self, path: Path, body: Body) -> bool:
        """Whether one who goes along a path comes too close to it."""
        s = np.linspace(0.0, path.length_m, max(2, int(path.length_m / _SAMPLE_M) + 1))
        free_m = apart(box_on(path, body, s), box_of(self.pose, self.body), _CLEAR_M)
        return bool((free_m < _CLEAR_M).any())


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
        shape = shape_of(thing)
        if thing.length_m is None and thing.width_m is None:
            shape = replace(shape, width_m=min(shape.width_m, width))
        line = _who_may_stay(scene, draft)
        spots = _spots(scene, draft, shape.body, stays=bool(line))
        free = (spot for spot in spots if _is_free(scene, draft, spot))
        spot = next((spot for spot in free if _react(scene, draft, spot, line)), None)
        if spot is None:
            continue
        made = made_of(thing.id, shape, thing.called, spot.pose)
        scene.add_object(made, hazard, draft.id)
        away = draft.laid.turning_starts_m - spot.station_m
        scene.note(f"{made.id}.from_junction_m", away, f"lies in the way of {draft.id}")


def _spots(scene: Setup, draft: DriveDraft, body: Body, *, stays: bool) -> Iterator[_Spot]:
    """In the lane of one that keeps to it, from the junction outwards; or in that which it leaves.

    In the middle for one that stops; as near to those who pass as can be for one that goes round.
    """
    arm, leaves = scene.road.arms[draft.drive.entry], draft.changes_before
    in_lane = (arm.lane_width_m - body.width_m) / 2
    room = 0.0 if stays else min(in_lane, (draft.body.width_m + body.width_m) / 2 - _WOULD_HIT_M)
    if leaves:
        out = next((c for c in draft.lane_changes if c.lane_after != draft.entry_lane), None)
        if out is None:
            return
        back = [
            c.position_m + c.length_m for c in draft.lane_changes if c.position_m > out.position_m
        ]
        last = min([*back, draft.laid.turning_starts_m - body.length_m])
        stations = np.arange(out.position_m, last, _STEP_M)
        inwards = out.lane_after < draft.entry_lane
    else:
        change = 0.0 if stays else calm_change_length_m(draft, arm.lane_width_m)
        nearest = max(BLOCKS_AT_M, change + draft.body.length_m + body.length_m + _ROOM_M)
        first = draft.laid.turning_starts_m - nearest
        if first <= _LEAST_WAY_M:
            raise NeedsLongerArms(_LEAST_WAY_M - first + 1.0, draft.id)
        stations = first - _STEP_M * np.arange(_PLACES)
        stations = stations[stations > _LEAST_WAY_M]
        inwards = neighbour_lane(scene, draft, oncoming=True) < draft.entry_lane
    right = scene.network.driving_side is DrivingSide.RIGHT
    lane = -draft.entry_lane if right else draft.entry_lane
    step = RouteStep(scene.network.arm_roads[draft.drive.entry], lane, forward=True)
    for station in stations:
        for share in _SHARES if leaves else _SHARES[:1]:
            left = room * share * (1 if inwards == right else -1)
            yield _Spot(float(station), scene.network.pose_at(step, float(station), left), body)


def _is_free(scene: Setup, draft: DriveDraft, spot: _Spot) -> bool:
    """Whether a thing may lie there: whoever would touch it and may not can still go round."""
    for other in scene.drives.values():
        goes_round = not other.changes_before and (other is draft or same_lane(other, draft))
        if not goes_round and spot.touches(other.laid.path, other.body):
            return False
    still = [(w.path, w.body) for w in scene.walks.values()]
    still += [(s.path, s.body) for s in scene.stands.values()]
    still += [(object_path(thing), thing.body) for thing in scene.objects]
    return not any(spot.touches(path, body) for path, body in still)


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
        own = {d.id for d in culprits(scene, hazard)} | {*hazard.by, *hazard.to} <= names
        if hazard.kind not in _BY_THINGS and not (own and hazard.kind in _IN_LINE):
            return []
    others = [other for other in scene.drives.values() if other.id not in names]
    met = any(not same_lane(o, draft) and drives_meet(one, o) for one in line for o in others)
    return [] if met else line


def _react(scene: Setup, draft: DriveDraft, spot: _Spot, line: list[DriveDraft]) -> bool:
    """Lead everybody round a thing who would touch it; those in ``line`` stop short of it.

    False where somebody has no room for it: nothing has changed then.
    """
    before = {name: list(other.lane_changes) for name, other in scene.drives.items()}
    try:
        _go_round(scene, draft, spot, line)
    except MotionInfeasibleError:
        for name, changes in before.items():
            other = scene.drives[name]
            other.rests_at_m = other.halts_at_m = None
            if other.lane_changes != changes:
                other.lane_changes = changes
                other.lay(scene.network)
        return False
    return True


def _go_round(scene: Setup, draft: DriveDraft, spot: _Spot, line: list[DriveDraft]) -> None:
    rear = spot.station_m - spot.body.length_m / 2 - _SHORT_M
    for one in line:
        one.halts_at_m = one.rests_at_m = one.laid.path_s_m(rear - one.body.front_m)
        rear -= one.body.length_m + _QUEUE_M
    for other in scene.drives.values():
        if other.changes_before or other in line or not spot.touches(other.laid.path, other.body):
            continue
        calm = calm_change_length_m(other, scene.road.arms[other.drive.entry].lane_width_m)
        brakes = other is draft and _brakes(scene, draft)
        out = _PULLS_OUT_OVER_M if brakes else calm
        pass_standing(scene, other, spot.station_m, spot.body, over_m=(out, calm))
        if brakes:
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
        stopping = [n for n, change in enumerate(draft.marks) if change.target_mps == 0.0]
        if stopping:
            draft.marks[stopping[0]] = replace(draft.marks[stopping[0]], then=None)
        else:
            rate = draft.braking_mps2(float(scene.rng.uniform(*HARD_BRAKING_MPS2)))
            braking = draft.course.speed_at(draft.halts_at_m) ** 2 / (2 * rate)
            start = max(3.0, draft.halts_at_m - braking - 0.1)
            stop = SpeedChange(0.0, rate, s_m=start, hazard=HazardKind.OBSTACLE)
            draft.add_speed_change(stop)
        draft.course_ = None

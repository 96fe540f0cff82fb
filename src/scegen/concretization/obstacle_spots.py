"""Where things may lie in somebody's way: ahead in its lane, or beside the way that it takes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import ceil

import numpy as np

from scegen.concretization.boxes import Poses, overlaps
from scegen.concretization.clock import same_lane
from scegen.concretization.drafts import DriveDraft, Setup
from scegen.concretization.lane_choice import neighbour_lane
from scegen.concretization.passing import calm_change_length_m
from scegen.concretization.room import NeedsLongerArms
from scegen.concretization.stationary import BLOCKS_AT_M, BLOCKS_STRAIGHT_AT_M
from scegen.motion.model import Path
from scegen.motion.standing import object_path
from scegen.road.geometry import Pose
from scegen.road.model import RouteStep
from scegen.scenario.bodies import Body
from scegen.scenario.vocabulary import DrivingSide

_CLEAR_M = 0.45
"""What keeps clear of a thing passes by at least so far from it."""
_WOULD_HIT_M = 0.1
_LEAST_WAY_M = 30.0
_ROOM_M = 6.0
"""Beside the change back and the two bodies: what who goes round keeps before and behind."""
_EARLIER, _STEP_M = 40, 1.0
_SHARES = (1.0, 0.75, 0.5, 0.25, 0.0)
_SAMPLE_M = 0.5


@dataclass(frozen=True, slots=True)
class Spot:
    """Where a thing may lie: ``station_m`` along the drive, the pose of its middle."""

    station_m: float
    pose: Pose


def spots(scene: Setup, draft: DriveDraft, body: Body, *, stays: bool) -> Iterator[Spot]:
    """In the lane of one that keeps to it, before the junction and then farther away from it.

    In the lane that one leaves, as near to its way as can be. In the middle for one that stops;
    towards those who pass for one that goes round.
    """
    room = 0.0 if stays else _room_m(scene, draft, body)
    if draft.changes_before:
        stations, inwards = _where_it_has_left(scene, draft, body)
    else:
        stations = _ahead(scene, draft, body, stays=stays)
        inwards = neighbour_lane(scene, draft, oncoming=True) < draft.entry_lane
    for station in stations:
        for share in _SHARES if draft.changes_before else _SHARES[:1]:
            aside = _left_m(scene, room * share, inwards=inwards)
            yield Spot(station, _pose(scene, draft, station, aside))


def _ahead(scene: Setup, draft: DriveDraft, body: Body, *, stays: bool) -> list[float]:
    arm = scene.road.arms[draft.drive.entry]
    nearest = BLOCKS_STRAIGHT_AT_M
    if scene.network.junctions:
        back = 0.0 if stays else calm_change_length_m(draft, arm.lane_width_m)
        nearest = max(BLOCKS_AT_M, back + draft.body.length_m + body.length_m + _ROOM_M)
    first = draft.laid.turning_starts_m - nearest
    if first <= _LEAST_WAY_M:
        raise NeedsLongerArms(_LEAST_WAY_M - first + 1.0, draft.id)
    return [s for s in (first - k * _STEP_M for k in range(_EARLIER)) if s > _LEAST_WAY_M]


def _where_it_has_left(scene: Setup, draft: DriveDraft, body: Body) -> tuple[list[float], bool]:
    """From where it leaves its lane until it comes back; and whether it leaves it inwards."""
    changes = draft.lane_changes
    leaving = next((c for c in changes if c.lane_after != draft.entry_lane), None)
    if leaving is None:
        return [], False
    back = [
        c.position_m + c.length_m
        for c in changes
        if c.position_m > leaving.position_m and c.lane_after == draft.entry_lane
    ]
    end = draft.laid.turning_starts_m
    if not scene.network.junctions:
        end += scene.road.arms[draft.drive.exit].length_m
    last = min([*back, end - body.length_m])
    steps = range(max(0, ceil((last - leaving.position_m) / _STEP_M)))
    inwards = leaving.lane_after < draft.entry_lane
    return [leaving.position_m + k * _STEP_M for k in steps], inwards


def _room_m(scene: Setup, draft: DriveDraft, body: Body) -> float:
    """How far aside a thing can lie, so that one who goes round comes close to it.

    It lies in the lane, and one who stayed in the middle of the lane would hit it.
    """
    in_lane = (scene.road.arms[draft.drive.entry].lane_width_m - body.width_m) / 2
    return min(in_lane, (draft.body.width_m + body.width_m) / 2 - _WOULD_HIT_M)


def _left_m(scene: Setup, aside_m: float, *, inwards: bool) -> float:
    keeps_right = scene.network.driving_side is DrivingSide.RIGHT
    return aside_m if inwards == keeps_right else -aside_m


def _pose(scene: Setup, draft: DriveDraft, station_m: float, left_m: float) -> Pose:
    """A place in the lane in which a drive enters, whether or not it has left it there."""
    network, lane = scene.network, draft.entry_lane
    inwards = -1 if network.driving_side is DrivingSide.RIGHT else 1
    entry = network.arm_roads[draft.drive.entry]
    length = network.road(entry).length_m
    if station_m <= length or network.junctions:
        return network.pose_at(RouteStep(entry, inwards * lane, forward=True), station_m, left_m)
    step = RouteStep(network.arm_roads[draft.drive.exit], -inwards * lane, forward=False)
    return network.pose_at(step, station_m - length, left_m)


def is_free(scene: Setup, draft: DriveDraft, spot: Spot, body: Body) -> bool:
    """Whether a thing may lie there: whoever would touch it and may not can still go round."""
    for other in scene.drives.values():
        free = not other.changes_before and (other is draft or same_lane(other, draft))
        if not free and touches(other.laid.path, other.body, spot.pose, body):
            return False
    still = [(w.path, w.body) for w in scene.walks.values()]
    still += [(s.path, s.body) for s in scene.stands.values()]
    still += [(object_path(thing), thing.body) for thing in scene.objects]
    return not any(touches(path, own, spot.pose, body) for path, own in still)


def touches(path: Path, own: Body, place: Pose, body: Body) -> bool:
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

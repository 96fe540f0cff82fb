"""What stands in the way at a junction or beside it, who goes round it, and who pulls out.

Who meets nobody and has nothing else to do brakes for a thing in its way and stays, and so does who
follows (see ``answering``); everybody else goes round it, as round a parked vehicle.

One that pulls out from the strip beside the road has stood there for long, and sets off so that it
is in the lane close before the one in whose way it pulls out; that one brakes late, down to the
pace that it has by then.
"""

from math import pi

import numpy as np

from scegen.concretization.amounts import implied
from scegen.concretization.aside import close_before, pass_standing
from scegen.concretization.boxes import apart, box_of, box_on
from scegen.concretization.clearance import same_lane
from scegen.concretization.deeds import marks_of
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.meetings import Meeting, drives_meet
from scegen.concretization.others import StandDraft
from scegen.concretization.setup import Setup
from scegen.concretization.tale import SIDEWAYS
from scegen.concretization.turning_ways import turns_back_from_kerb
from scegen.errors import MotionInfeasibleError
from scegen.motion.lanes import STANDING, strip_number
from scegen.motion.standing import heads_for_junction, standing_path
from scegen.road.geometry import Pose
from scegen.road.model import Route
from scegen.scenario.acts import ActKind
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import LaneChange, StandingMotion
from scegen.scenario.logical import Drive
from scegen.scenario.vocabulary import Maneuver, Side

CLEAR_OF_CORNER_M = 6.0
"""From the junction to the nearest parked bumper: behind a crosswalk of 4 m set back by 1 m."""
_ROOM_TO_PULL_OUT_M = 30.0
_BETWEEN_M = 1.5
_BEFORE_PULLING_OUT_M = 7.0
"""In a row, who pulls out needs this much before it."""
BLOCKS_AT_M = 45.0
"""A vehicle that blocks its lane stands this far before the junction, so that others get round."""
BLOCKS_STRAIGHT_AT_M = 15.0
_CLEAR_M = 0.45
"""From who keeps clear of it."""
_SAMPLE_M = 0.5
_ROLLS_M = 0.5
_CHANGE_M, _SWINGS_OUT_M = 10.0, 8.0
_LONG_CHANGE = 1.4
"""Lorries and buses, by their length, need more room than a car to leave a gap."""
_LONG_M = 7.0
_SHARE = 0.8


def place_stationary(scene: Setup) -> None:
    """Line them up from the junction outwards, those that hide somebody next to the corner."""
    filled: dict[tuple[int, Side, bool], float] = {}
    pulling = {p.id for p in scene.functional.participants if p.pulls_out}
    rows_to_leave = {s.arm for s in scene.logical.standings if s.participant in pulling}
    plain = scene.network.plain
    for standing in scene.logical.standings:
        participant = scene.functional.participant(standing.participant)
        name, body = participant.id, participant.body
        motion = StandingMotion(
            arm=standing.arm, side=standing.side, from_junction_m=0.0,
            in_lane=standing.in_lane, strip=participant.strip,
        )  # fmt: skip
        towards = heads_for_junction(scene.network, motion)
        inner = BLOCKS_STRAIGHT_AT_M if plain else BLOCKS_AT_M
        if not standing.in_lane:
            leaves = not plain and standing.arm in rows_to_leave
            inner = _ROOM_TO_PULL_OUT_M if leaves else CLEAR_OF_CORNER_M
        if name in pulling and _route(scene, name, standing.arm).exit == standing.arm:
            inner = max(_SWINGS_OUT_M * _long(body) + 2 * _ROLLS_M - body.front_m, 0.0)
        key = (standing.arm, standing.side, standing.in_lane)
        if key in filled:
            inner = filled[key]
            inner += _BEFORE_PULLING_OUT_M if name in pulling and towards else 0.0
        # The bumper that faces the junction: the front of one that heads for it.
        away = inner + (body.front_m if towards else body.rear_m)
        filled[key] = inner + body.length_m + _BETWEEN_M
        motion = motion.but(from_junction_m=round(away, 3))
        path = standing_path(scene.network, motion, body, name)
        scene.note(f"{name}.from_junction_m", away, "stands clear of the corner")
        scene.stands[name] = StandDraft(name, body, motion, path)


def blocking_m(scene: Setup, draft: DriveDraft) -> list[tuple[StandDraft, float]]:
    """Those who stand in a drive's way, and where on it that is."""
    standing = [stand for stand in scene.stands.values() if stand.motion.in_lane]
    found = [(stand, _met_m(draft, stand.path.start, stand.body)) for stand in standing]
    return [(stand, place) for stand, place in found if place is not None]


def go_round_stationary(scene: Setup) -> None:
    """Who comes to a vehicle that blocks its lane goes round."""
    for draft in scene.drives.values():
        for stand, place in blocking_m(scene, draft):
            if not draft.lane_changes:
                pass_standing(scene, draft, place, stand.body)


def _met_m(draft: DriveDraft, pose: Pose, body: Body) -> float | None:
    """Where on its way a drive is level with what stands or lies there, None if it stays clear."""
    path = draft.path
    s = np.linspace(0.0, path.length_m, max(2, int(path.length_m / _SAMPLE_M) + 1))
    near = apart(box_on(path, draft.body, s), box_of(pose, body), _CLEAR_M) < _CLEAR_M
    if not near.any():
        return None
    return draft.laid.station_m(float(s[near].mean()) + draft.body.centre_ahead_m)


def may_stay(scene: Setup, draft: DriveDraft) -> bool:
    """Whether a drive and those behind it may end before a thing: they meet nobody, change no lane.

    Nor does a danger between others want them to go on.
    """
    line = [draft, *(o for o in scene.drives.values() if same_lane(o, draft))]
    line = [one for one in line if one.drive.rank >= draft.drive.rank]
    names = {one.id for one in line}
    told = [{*hazard.by, *hazard.to} & scene.drives.keys() for hazard in scene.functional.hazards]
    aside = any(one.lane_changes or one.drive.maneuver in SIDEWAYS for one in line)
    if aside or scene.walks or not all(who <= names for who in told):
        return False
    others = [o for o in scene.drives.values() if o.id not in names and not same_lane(o, draft)]
    return not any(drives_meet(one, other) for one in line for other in others)


def pull_out(scene: Setup) -> list[Meeting]:
    """Let those drive who pull out; returns whom they meet in the lane, and where."""
    meetings: list[Meeting] = []
    for name, stand in list(scene.stands.items()):
        if scene.functional.participant(name).pulls_out and not stand.motion.in_lane:
            del scene.stands[name]
            draft = _draft(scene, stand)
            scene.drives[name] = draft
            meetings += _meets(scene, draft)
    return meetings


def _draft(scene: Setup, stand: StandDraft) -> DriveDraft:
    name, entry = stand.id, stand.motion.arm
    if not heads_for_junction(scene.network, stand.motion):
        raise MotionInfeasibleError(
            "is parked on the other side of the road: one that pulls out there comes into nobody's "
            "way on the ego's side",
            where=name,
            hint="Say that it is parked on the ego's side.",
        )
    road = scene.network.arm_road(entry)
    start = road.length_m - stand.motion.from_junction_m
    route = _route(scene, name, entry)
    lane, back = route.entry_lane, route.exit == entry
    turn, change_m = (Maneuver.U_TURN, _SWINGS_OUT_M) if back else (Maneuver.STRAIGHT, _CHANGE_M)
    draft = DriveDraft(
        id=name, body=stand.body,
        drive=Drive(
            participant=name, entry=entry, move=(route.exit - entry) % len(scene.road.arms),
            exit=route.exit, turn=turn, maneuver=turn,
        ),
        speed_mps=min(_SHARE * scene.limit_mps, stand.body.top_speed_mps),
        entry_lane=strip_number(road, STANDING, inbound=True),
        exit_lane=route.exit_lane, ring_lane=route.ring_lane, grip_mps2=scene.grip_mps2,
    )  # fmt: skip
    draft.lane_changes = [
        LaneChange(
            position_m=round(start + _ROLLS_M, 3),
            length_m=change_m * _long(stand.body),
            lane_after=lane,
            hazard=scene.hazard_of(implied("out", name, name, ActKind.CHANGE_LANE)),
        )
    ]
    draft.lay(scene.network)
    draft.parked_s_m = draft.laid.path_s_m(start)
    draft.steps = list(marks_of(scene, draft))
    scene.note(f"{name}.start_m", start, "is parked, and pulls out")
    return draft


def _route(scene: Setup, name: str, entry: int) -> Route:
    """The way out of the outermost lane that bends least; or back, where it is to turn back."""
    lane = scene.road.arms[entry].lanes_in
    heading_rad = scene.network.arm_road(entry).line.end.heading_rad
    back = turns_back_from_kerb(scene.functional, name)

    def bend_rad(route: Route) -> float:
        last = scene.network.arm_road(route.exit).line.end.heading_rad
        return abs((last - heading_rad) % (2 * pi) - pi)

    routes = (route for found in scene.network.routes.values() for route in found)
    ways = (route for route in routes if (route.entry, route.entry_lane) == (entry, lane))
    return min(ways, key=lambda way: (back and way.exit != entry, bend_rad(way), way.exit))


def _long(body: Body) -> float:
    return _LONG_CHANGE if body.length_m > _LONG_M else 1.0


def _meets(scene: Setup, draft: DriveDraft) -> list[Meeting]:
    """The one in whose way it pulls out is close behind as it is in the lane."""
    change = draft.lane_changes[0]
    others = (other for other in scene.concerned(draft.id) if other is not draft)
    station_m = change.position_m + change.length_m
    return next(filter(None, (close_before(scene, draft, o, station_m) for o in others)), [])

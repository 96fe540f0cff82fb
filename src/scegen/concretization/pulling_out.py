"""One who is parked and then pulls out: from the strip beside the road into the lane next to it.

It has stood there for long, and sets off so that it is in the lane close before the one in whose
way it pulls out; that one brakes late, down to the pace that it has by then.
"""

from __future__ import annotations

from math import pi

from scegen.concretization.amounts import implied
from scegen.concretization.aside import close_before
from scegen.concretization.deeds import marks_of
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.meetings import Meeting
from scegen.concretization.others import StandDraft
from scegen.concretization.setup import Setup
from scegen.errors import MotionInfeasibleError
from scegen.motion.lanes import STANDING, strip_number
from scegen.motion.standing import heads_for_junction
from scegen.road.model import Route
from scegen.scenario.acts import ActKind
from scegen.scenario.concrete import LaneChange
from scegen.scenario.logical import Drive
from scegen.scenario.vocabulary import Maneuver

_ROLLS_M = 0.5
_CHANGE_M = 10.0
_LONG_CHANGE = 1.4
"""Lorries and buses, by their length, need more room than a car to leave a gap."""
_LONG_M = 7.0
_SHARE = 0.8


def pull_out(scene: Setup) -> list[Meeting]:
    """Let those drive who pull out; returns whom they meet in the lane, and where."""
    meetings: list[Meeting] = []
    for name, stand in list(scene.stands.items()):
        if scene.functional.participant(name).pulls_out and not stand.standing.in_lane:
            del scene.stands[name]
            draft = _draft(scene, stand)
            scene.drives[name] = draft
            meetings += _meets(scene, draft)
    return meetings


def _draft(scene: Setup, stand: StandDraft) -> DriveDraft:
    name, entry = stand.id, stand.standing.arm
    if not heads_for_junction(scene.network, stand.motion):
        raise MotionInfeasibleError(
            "is parked on the other side of the road: one that pulls out there comes into nobody's "
            "way on the ego's side",
            where=name,
            hint="Say that it is parked on the ego's side, or let it turn back.",
        )
    road = scene.network.arm_road(entry)
    start = road.length_m - stand.motion.from_junction_m
    lane = scene.road.arms[entry].lanes_in

    def bend_rad(route: Route) -> float:
        last = scene.network.arm_road(route.exit).line.end.heading_rad
        return abs((last - road.line.end.heading_rad) % (2 * pi) - pi)

    routes = (route for found in scene.network.routes.values() for route in found)
    ways = (route for route in routes if (route.entry, route.entry_lane) == (entry, lane))
    route = min(ways, key=lambda way: (bend_rad(way), way.exit))
    draft = DriveDraft(
        id=name,
        kind=stand.kind,
        body=stand.body,
        drive=Drive(
            participant=name,
            entry=entry,
            move=(route.exit - entry) % len(scene.road.arms),
            exit=route.exit,
            turn=Maneuver.STRAIGHT,
            maneuver=Maneuver.STRAIGHT,
        ),
        cruise_mps=min(_SHARE * scene.limit_mps, stand.body.top_speed_mps),
        entry_lane=strip_number(road, STANDING, inbound=True),
        exit_lane=route.exit_lane,
        ring_lane=route.ring_lane,
        grip_mps2=scene.grip_mps2,
    )
    draft.lane_changes = [
        LaneChange(
            position_m=round(start + _ROLLS_M, 3),
            length_m=_CHANGE_M * (_LONG_CHANGE if stand.body.length_m > _LONG_M else 1.0),
            lane_after=lane,
            hazard=scene.hazard_of(implied("out", name, name, ActKind.CHANGE_LANE)),
        )
    ]
    draft.lay(scene.network)
    draft.parked_s_m = draft.laid.path_s_m(start)
    draft.steps = list(marks_of(scene, draft))
    scene.note(f"{name}.start_m", start, "is parked, and pulls out")
    return draft


def _meets(scene: Setup, draft: DriveDraft) -> list[Meeting]:
    """The one in whose way it pulls out is close behind as it is in the lane."""
    change = draft.lane_changes[0]
    others = (other for other in scene.concerned(draft.id) if other is not draft)
    station_m = change.position_m + change.length_m
    return next(filter(None, (close_before(scene, draft, o, station_m) for o in others)), [])

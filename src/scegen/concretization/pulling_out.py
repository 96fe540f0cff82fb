"""One who is parked and then pulls out: from the strip beside the road into the lane next to it.

It stands until the one in whose way it pulls out has come so far that it is close before it once
it is in the lane; that one brakes late, down to the pace that it has by then.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import pi, sqrt

from scegen.concretization.amounts import change_of_speed
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.limits import LATE_BRAKING_MPS2, LEAD_IN_S, SUDDEN_ACCELERATION_MPS2
from scegen.concretization.meetings import nearest_s_m
from scegen.concretization.others import PullDraft
from scegen.concretization.setup import Setup
from scegen.concretization.stationary import towards_junction
from scegen.concretization.walkers import Appointment
from scegen.errors import MotionInfeasibleError
from scegen.motion.friction import GRAVITY_MPS2, friction_of
from scegen.motion.lanes import STANDING, strip_number
from scegen.motion.paths import lay_drive
from scegen.scenario.acts import ActKind, AfterStart
from scegen.scenario.bodies import BODIES
from scegen.scenario.concrete import AtTime, DriveMotion, LaneChange, SpeedPhase, Travelled
from scegen.scenario.vocabulary import HazardKind

_ROLLS_M = 0.5
_CHANGE_M = 10.0
_LONG_CHANGE = 1.4
"""Lorries and buses, by their length, need more room than a car to leave a gap."""
_LONG_M = 7.0
_ACCELERATION_MPS2 = 2.0
_GAP_M = 1.5
_SHARE = 0.8
_LANE_M = 1.0
_TURNS = (
    HazardKind.CUT_IN,
    HazardKind.SUDDEN_TURN,
    HazardKind.SWERVING,
    HazardKind.MERGING_CONFLICT,
)


@dataclass(frozen=True, slots=True)
class _Rendezvous:
    """Where one who comes along is when another is in its lane, and how long that took."""

    draft: DriveDraft
    place_m: float
    takes_s: float


def pull_out(scene: Setup) -> None:
    """Give those who pull out their ways, and those behind them their braking."""
    for name, stand in list(scene.stands.items()):
        participant = scene.functional.participant(name)
        if participant.pulls_out and not stand.standing.in_lane:
            del scene.stands[name]
            pull = _draft(scene, name, stand.motion.from_junction_m)
            scene.pulls[name] = pull
            met = _meet(scene, pull)
            if met is not None:
                pull.waits_for = met.draft.id
                pull.place_m = met.place_m
                pull.takes_s = met.takes_s


def _draft(scene: Setup, name: str, from_junction_m: float) -> PullDraft:
    participant = scene.functional.participant(name)
    standing = next(s for s in scene.logical.standings if s.participant == name)
    body = BODIES[participant.kind]
    own = {hazard.kind for hazard in scene.functional.hazards if name in hazard.by}
    length = _CHANGE_M * (_LONG_CHANGE if body.length_m > _LONG_M else 1.0)
    entry = standing.arm
    if not towards_junction(scene, standing):
        raise MotionInfeasibleError(
            "is parked on the other side of the road: one that pulls out there comes into nobody's "
            "way on the ego's side",
            where=name,
            hint="Say that it is parked on the ego's side, or let it turn back.",
        )
    start = scene.network.arm_road(entry).length_m - from_junction_m
    lane = scene.road.arms[entry].lanes_in
    exits = [
        (abs(_bend_rad(scene, entry, pair[1], lane)), pair[1])
        for pair, routes in scene.network.routes.items()
        if pair[0] == entry and any(route.entry_lane == lane for route in routes)
    ]
    exit_ = min(exits)[1]
    route = next(r for r in scene.network.routes[entry, exit_] if r.entry_lane == lane)
    bay = strip_number(scene.network.arm_road(entry), STANDING, inbound=True)
    motion = DriveMotion(
        entry=entry,
        entry_lane=bay,
        exit=exit_,
        exit_lane=route.exit_lane,
        ring_lane=route.ring_lane,
        start_m=round(start, 3),
        turning_starts_m=0.0,
        turning_ends_m=0.0,
        lane_changes=(
            LaneChange(
                position_m=round(start + _ROLLS_M, 3),
                length_m=length,
                lane_after=lane,
                hazard=next((kind for kind in _TURNS if kind in own), None),
            ),
        ),
    )
    laid = lay_drive(scene.network, motion, name)
    motion = motion.model_copy(
        update={
            "turning_starts_m": round(laid.turning_starts_m, 3),
            "turning_ends_m": round(laid.turning_ends_m, 3),
        }
    )
    rate = _ACCELERATION_MPS2
    if HazardKind.SUDDEN_ACCELERATION in own:
        rate = SUDDEN_ACCELERATION_MPS2[1]
    rate = min(rate, body.max_acceleration_mps2)
    speed = min(_SHARE * scene.limit_mps, body.top_speed_mps)
    act = scene.first_act(name, ActKind.SET_OFF)
    if act is not None:
        grip = friction_of(scene.functional.environment) * GRAVITY_MPS2
        target, said = change_of_speed(act, 0.0, body, grip, None, speed)
        speed, rate = target, said if act.rate_mps2 is not None else rate
    scene.note(f"{name}.start_m", start, "is parked, and pulls out")
    return PullDraft(
        id=name,
        kind=participant.kind,
        motion=motion,
        laid=laid,
        speed_mps=speed,
        rate_mps2=rate,
        in_lane_m=laid.path_s_m(start + _ROLLS_M + length),
        hazard=next(iter(sorted(own)), None),
    )


def _bend_rad(scene: Setup, entry: int, exit_: int, lane: int) -> float:
    route = next(r for r in scene.network.routes[entry, exit_] if r.entry_lane == lane)
    first = scene.network.arm_road(entry).line.end.heading_rad
    last = scene.network.arm_road(route.exit).line.end.heading_rad
    return (last - first) % (2 * pi) - pi


def _meet(scene: Setup, pull: PullDraft) -> _Rendezvous | None:
    """The one in whose way it pulls out."""
    pose = pull.laid.path.pose(pull.in_lane_m)
    for draft in scene.concerned(pull.id):
        place, apart = nearest_s_m(draft.laid.path, pose.x_m, pose.y_m)
        if apart > _LANE_M:
            continue
        body = BODIES[pull.kind]
        pace = min(sqrt(2 * pull.rate_mps2 * pull.in_lane_m), pull.speed_mps)
        takes = pace / pull.rate_mps2 + (pull.in_lane_m - pace**2 / (2 * pull.rate_mps2)) / pace
        closing = max(0.0, draft.cruise_mps - pace)
        gap = _GAP_M + closing**2 / (2 * LATE_BRAKING_MPS2)
        behind = max(1.0, place - body.rear_m - gap - draft.body.front_m)
        return _Rendezvous(draft, behind, takes + 0.1)
    return None


def pull_appointments(scene: Setup) -> list[Appointment]:
    """Nobody may come by before one who pulls out can be there."""
    return [
        Appointment(pull.waits_for, pull.place_m, pull.takes_s + LEAD_IN_S)
        for pull in scene.pulls.values()
        if pull.waits_for is not None
    ]


def program_pulls(scene: Setup, leaves_s: Callable[[str], float]) -> None:
    """Set off at its moment, as the one in whose way it is has come so far."""
    for pull in scene.pulls.values():
        go = leaves_s(pull.id)
        act = scene.first_act(pull.id, ActKind.SET_OFF)
        trigger: Travelled | AtTime = AtTime(time_s=round(max(go, 0.0), 3))
        if pull.waits_for is not None and not (act and isinstance(act.when, AfterStart)):
            draft = scene.drives[pull.waits_for]
            distance = max(0.0, draft.course.s_at(go - draft.offset_s) - draft.start_m)
            trigger = Travelled(participant=draft.id, distance_m=round(distance, 3))
            scene.note(f"{pull.id}.sets_off_at_m", distance, f"pulls out in front of {draft.id}")
        pull.program = [
            SpeedPhase(
                trigger=trigger,
                target_speed_mps=round(pull.speed_mps, 3),
                rate_mps2=pull.rate_mps2,
                hazard=pull.hazard,
                act=None if act is None else act.id,
            )
        ]

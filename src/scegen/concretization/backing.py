"""Where one that reverses stops, goes back and drives on, and what speed program that takes.

Where it changes direction it has to stand. Simulators fire a trigger up to a step late, so it
creeps the last bit and comes to rest within a centimetre or two.
"""

from dataclasses import replace

import numpy as np

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.limits import (
    CREEP_MPS,
    HARD_BRAKING_MPS2,
    REVERSING_MPS,
    REVERSING_MPS2,
    STOPPING_MPS2,
)
from scegen.concretization.meetings import first_ground
from scegen.concretization.others import WalkDraft
from scegen.concretization.profile import Sort, SpeedChange
from scegen.concretization.setup import Setup, require_room
from scegen.errors import MotionInfeasibleError
from scegen.motion.lanes import arm_lane_id
from scegen.motion.standing import side_sign
from scegen.scenario.acts import ActKind
from scegen.scenario.logical import Reverses
from scegen.scenario.reversing import BacksOut, BacksUp
from scegen.scenario.vocabulary import HazardKind, Side

_CREEPS_M = 0.8
_STOPS_MPS2 = 2.0
_WAITS_S = 2.5
_GOES_AT_ONCE_S = 0.8
_PAUSE_S = 1.0
_LEAST_RUN_UP_M = 5.0
_BACK_M = (5.0, 8.0)
"""How far one goes back towards another on its own lane."""
_LONGEST_BACK_M = 9.0
_CLEAR_M = 1.0
"""One that has crossed another's way stops so far beyond it, before it reverses into it."""
_PAST_M = 4.0
"""One that reverses towards somebody on foot begins with its tail so far beyond."""
_MERGED_M = 12.0
_WIDE_M = 40.0
"""Where they share more of their ways, these do not cross but merge."""
_BEFORE_JUNCTION_M = 2.0
_BEHIND_MIDDLE_M = 10.0
_TIGHTEST = 1.7
"""Radius of a tight turn in wheelbases, at 30 degrees of steering."""
_ROOM_M = 0.5
_SAMPLE_M = 0.1
_OUT_OF_ARM_M = 2.0
_BEFORE_END_M = 15.0
_REACH_M = 60.0
_WAY_ON_M = 0.3
"""The way of one that stays where it has come to ends a little farther on: it has not left."""


def back_up(scene: Setup, draft: DriveDraft, other: DriveDraft | WalkDraft | None) -> None:
    """Let it stop on its way, stand there, go back on it and drive on.

    On another's arm ahead of it; where the ways cross, beyond the other's way: right across it, or
    until it is just before one on foot.
    """
    length_m, shared = draft.path.length_m, None
    along = isinstance(other, DriveDraft) and other.drive.entry == draft.drive.entry
    if other is not None and not along:
        shared = first_ground(draft, other)
        if shared is None:
            raise MotionInfeasibleError(
                f"its way and that of {other.id} do not touch, so it cannot reverse into it",
                where=draft.id,
            )
    back_m, waits_s = float(scene.rng.uniform(*_BACK_M)), _WAITS_S
    if shared is None:
        stops_s = length_m / 2 + _BEHIND_MIDDLE_M
        if not scene.network.plain:
            stops_s = draft.junction_s_m - draft.body.front_m - _BEFORE_JUNCTION_M
    elif isinstance(other, WalkDraft):
        stops_s, back_m, waits_s = shared.leave_m + _PAST_M, _PAST_M - _ROOM_M, _GOES_AT_ONCE_S
        draft.backs_to = other.id
    elif shared.leave_m < min(length_m - _MERGED_M - _BEFORE_END_M, shared.enter_m + _WIDE_M):
        stops_s = shared.leave_m + _CLEAR_M
        back_m = min(stops_s - (shared.enter_m + shared.leave_m) / 2, _LONGEST_BACK_M)
    else:
        stops_s = shared.enter_m + _MERGED_M + draft.body.length_m
    laid = draft.laid
    station = laid.station_m(stops_s)
    draft.reversal = BacksUp(
        from_m=round(station, 3), length_m=round(station - laid.station_m(stops_s - back_m), 3)
    )
    draft.lay(scene.network)
    scene.note(f"{draft.id}.reversal.from_m", station, "reversing: stops here and goes back")
    # Brake to creeping, creep, stand: at the place from which it goes back.
    rest_s, ends_s = draft.path.backwards[0]
    hard = HazardKind.HARD_BRAKING in scene.kinds_by(draft.id)
    rate = draft.braking_mps2(HARD_BRAKING_MPS2[0] if hard else STOPPING_MPS2)
    begins = brakes_from(draft, rest_s - _CREEPS_M, rate, CREEP_MPS)
    require_room(draft.id, begins, _LEAST_RUN_UP_M)
    draft.alone_s_m = (begins, ends_s + _ROOM_M)
    draft.marks.append(SpeedChange(CREEP_MPS, rate, s_m=begins))
    _go_back(scene, draft, waits_s)


def back_out(scene: Setup, draft: DriveDraft) -> None:
    """Let it come out backwards into its lane from where it stands, and drive on."""
    body = draft.body
    if draft.from_arm is not None:
        setback = round(body.rear_m + _OUT_OF_ARM_M, 3)
        _come_to(scene, draft, _BEFORE_JUNCTION_M, BacksOut(arm=draft.from_arm, setback_m=setback))
    else:
        side = Side.RIGHT if draft.drive.reverses is Reverses.FROM_RIGHT else Side.LEFT
        road, sign = scene.network.arm_road(draft.drive.entry), side_sign(side)
        lane = road.lane_centre_t_m(arm_lane_id(road, draft.entry_lane, inbound=True))
        radius = round(_TIGHTEST * body.wheelbase_m, 3)
        aside = radius - abs(road.edge_t_m(sign) - lane)
        setback = round(max(aside, body.rear_m) + _ROOM_M, 3)
        back = BacksOut(side=side, setback_m=setback, radius_m=radius)
        _come_to(scene, draft, _BEFORE_END_M, back)
    scene.note(f"{draft.id}.start_m", draft.joins_m, "reversing: comes out backwards to here")
    draft.alone_s_m = (0.0, draft.path.backwards[0][1] + _ROOM_M)
    _go_back(scene, draft, _WAITS_S)


def stand_square(
    scene: Setup, draft: DriveDraft, *, more_m: float = 0.0, straight_m: float = _REACH_M
) -> None:
    """Let it stand square to the road, beside its lane or on its arm, and go straight back.

    ``more_m`` farther off than just clear of it.
    """
    plain = scene.network.plain
    off_m = draft.body.rear_m + (_ROOM_M if plain else _OUT_OF_ARM_M) + more_m
    back = BacksOut(
        side=scene.functional.junction.kerb if plain else None,
        arm=None if plain else draft.drive.entry,
        setback_m=round(off_m, 3),
        straight_m=round(straight_m + _WAY_ON_M, 3),
    )
    _come_to(scene, draft, _BEFORE_END_M if plain else _BEFORE_JUNCTION_M, back)


def _come_to(scene: Setup, draft: DriveDraft, before_m: float, back: BacksOut) -> None:
    """Let it come out backwards to a place so far before the end of its arm."""
    draft.joins_m = round(draft.laid.turning_starts_m - before_m, 3)
    draft.reversal = back
    require_room(draft.id, draft.joins_m, _LEAST_RUN_UP_M)
    draft.lay(scene.network)


def back_straight(scene: Setup, draft: DriveDraft, speed: float, stop: SpeedChange) -> float:
    """Stand, go back and stop before the way ends; returns where it begins to."""
    begins_s, ends_s = draft.path.backwards[0]
    scene.note(f"{draft.id}.reversal.setback_m", ends_s - begins_s, "reversing: comes so far back")
    draft.alone_s_m = (0.0, ends_s + _ROOM_M)
    act = scene.first_act(draft.id, ActKind.REVERSE)
    back = SpeedChange(
        speed, REVERSING_MPS2, act=act.id if act is not None else None,
        hazard=HazardKind.REVERSING, sort=Sort.GOES_ON, then_s=_WAITS_S,
    )  # fmt: skip
    # It hardly rolls forwards, slower and slower.
    draft.marks.append(SpeedChange(0.0, CREEP_MPS**2 / (2 * begins_s), s_m=0.0, then=back))
    braking_m = speed**2 / (2 * stop.rate_mps2)
    draft.marks.append(replace(stop, s_m=ends_s - braking_m - _WAY_ON_M))
    return begins_s


def reversing_mps(scene: Setup, draft: DriveDraft) -> float:
    """How fast it goes back."""
    return scene.driven_mps(draft.id, sum(REVERSING_MPS) / 2)


def _go_back(scene: Setup, draft: DriveDraft, waits_s: float) -> None:
    """Stand, go back, stop where the way back ends, pause, and drive on."""
    begins_s, ends_s = draft.path.backwards[0]
    said = scene.functional.participant(draft.id).speed_mps
    speed = said.middle if said is not None else float(scene.rng.uniform(*REVERSING_MPS))
    if said is None:
        scene.note(f"{draft.id}.reversing_mps", speed, "usual speed backwards")
    back = SpeedChange(
        speed, REVERSING_MPS2, hazard=HazardKind.REVERSING, sort=Sort.GOES_ON, then_s=waits_s
    )
    draft.marks.append(SpeedChange(0.0, _STOPS_MPS2, s_m=_brakes_at(begins_s), then=back))
    braking = (speed**2 - CREEP_MPS**2) / (2 * REVERSING_MPS2)
    slows = max(begins_s + 0.5, ends_s - _CREEPS_M / 2 - braking)
    draft.marks.append(SpeedChange(CREEP_MPS, REVERSING_MPS2, s_m=slows))
    stop = SpeedChange(0.0, _STOPS_MPS2, s_m=_brakes_at(ends_s))
    draft.hold(stop, _PAUSE_S)


def brakes_from(draft: DriveDraft, until_s: float, rate_mps2: float, to_mps: float) -> float:
    """Where it has to begin to brake to be that slow at a place; below 0 if it is too late."""
    s = np.arange(0.0, until_s, _SAMPLE_M)
    _, speed = draft.course.profile.at_times(draft.course.times_at(s))
    spare = until_s - s - np.maximum(speed**2 - to_mps**2, 0.0) / (2 * rate_mps2)
    in_time = np.flatnonzero(spare >= 0.0)
    return float(s[in_time[-1]]) if in_time.size else float(spare.max())


def _brakes_at(rest_s: float) -> float:
    return rest_s - CREEP_MPS**2 / (2 * _STOPS_MPS2)

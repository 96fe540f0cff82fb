"""Where pedestrians and cyclists cross, and what makes them step off."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from math import sin, sqrt

from scegen.concretization.amounts import pace_across_mps
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.limits import starting_mps2
from scegen.concretization.meetings import MeetingPoint, crossing_at, meeting_point
from scegen.concretization.others import WalkDraft, abreast_m
from scegen.concretization.setup import Setup
from scegen.concretization.tale import pace_of
from scegen.motion.standing import crossing_path
from scegen.motion.trigger_steps import just_before_step_s
from scegen.road.cross_section import CARRIAGEWAY, KERBED, half_width_m
from scegen.scenario.acts import ActKind, AfterStart
from scegen.scenario.concrete import AtTime, CrossingMotion, Travelled, Trigger
from scegen.scenario.functional import Participant
from scegen.scenario.logical import Crossing
from scegen.scenario.vocabulary import HazardKind, Side

_SPREAD, _SLOWEST_MPS = (0.9, 1.2), 0.3
_SETBACK_M = 1.5
_BEYOND_STRIP_M = 1.0
_UNMARKED_M = 4.0
_STRAIGHT_M = 5.0
_BEYOND_PARKED_M = 1.2
_BEHIND_SCREEN_M = 0.8
"""The front of one whom a thing is to hide is so far from the carriageway: it needs room there."""
_STOP_SHORT_M = 0.15
_MOVES_MPS = 0.1
_SPARE_S = 0.1
_INTO_PATH_M = 1.0
"""The walker is in the driver's line when the bumper is this close (both at their speed)."""
_STEPS_OFF_M = 0.5
_OF_PEAK = 0.9
"""Of the pace at which one who sets off must begin to stop, the share that is used."""


def place_walkers(scene: Setup) -> None:
    """On the crosswalk if the arm has one, from behind a parked vehicle if one hides them."""
    side_by_side: Counter[tuple[int, Side]] = Counter()
    for crossing in scene.logical.crossings:
        place = (crossing.arm, crossing.start)
        aside = abreast_m(side_by_side[place])
        side_by_side[place] += 1
        participant = scene.functional.participant(crossing.participant)
        speed = _speed(scene, participant, crossing.arm)
        setback = _setback_m(scene, crossing.arm, participant, speed)
        act = scene.first_act(crossing.participant, ActKind.CROSS)
        far = None if act is None or act.distance_m is None else act.distance_m.middle
        motion = CrossingMotion(
            arm=crossing.arm,
            start_side=crossing.start,
            from_junction_m=round(max(0.0, _from_junction_m(scene, crossing) + aside), 3),
            setback_m=setback,
            stops_after_m=None if far is None else round(setback + far, 3),
        )
        path = crossing_path(scene.network, motion, participant.id)
        scene.walks[participant.id] = WalkDraft(
            participant.id, participant.kind, participant.body, crossing, speed, motion, path
        )


def _speed(scene: Setup, participant: Participant, arm: int) -> float:
    pace = pace_of(scene.functional, scene.logical, participant.id)
    slow, fast = (share * pace.default for share in _SPREAD)
    speed = float(scene.rng.uniform(max(slow, pace.low), min(fast, pace.high)))
    speed = max(speed, _SLOWEST_MPS)
    if participant.speed_mps is None:
        road = scene.network.arm_road(arm)
        width = road.edge_t_m(1) - road.edge_t_m(-1)
        speed = pace_across_mps(scene.acts, participant.id, width) or speed
    scene.note(f"{participant.id}.speed_mps", speed, "usual pace")
    return round(speed, 3)


def _setback_m(scene: Setup, arm: int, who: Participant, speed_mps: float) -> float:
    """How far outside the carriageway one starts: far enough to have its pace on it."""
    hidden = any(not hazard.by for hazard in scene.of_kind(HazardKind.OCCLUSION))
    behind = who.body.front_m + _BEHIND_SCREEN_M if hidden else 0.0
    lanes = scene.network.arm_road(arm).lanes
    beside = CARRIAGEWAY - KERBED
    strip = max(half_width_m(lanes, sign, beside) for sign in (-1, 1))
    usual = strip + _BEYOND_STRIP_M if strip else _SETBACK_M
    gains = speed_mps**2 / (2 * starting_mps2(who.kind))
    return round(max(usual, behind, gains), 3)


def _from_junction_m(scene: Setup, crossing: Crossing) -> float:
    road = scene.network.arm_road(crossing.arm)
    if road.crosswalks:
        return road.length_m - road.crosswalks[0].s_m
    hidden = [
        stand
        for stand in scene.stands.values()
        if stand.standing.arm == crossing.arm
        and not stand.standing.in_lane
        and stand.standing.side is crossing.start
    ]
    usual = _UNMARKED_M if not scene.network.plain else _STRAIGHT_M
    if not hidden:
        return usual
    # All stand with their inner bumper at the same clearance: just inside of it is in sight last.
    nearest = min(hidden, key=lambda stand: stand.motion.from_junction_m)
    body = nearest.body
    towards = nearest.path.heading_rad[0] - road.line.end.heading_rad
    front = body.front_m if abs(towards) < 1.0 else body.rear_m
    return max(0.5, nearest.motion.from_junction_m - front - _BEYOND_PARKED_M)


def partner_of(scene: Setup, walk: WalkDraft) -> tuple[DriveDraft, MeetingPoint] | None:
    """The drive into whose way a walker steps."""
    for draft in scene.concerned(walk.id):
        point = meeting_point(draft.laid.path, walk.path)
        if point is not None:
            return draft, point
    return None


def rendezvous(
    scene: Setup, draft: DriveDraft, walk: WalkDraft, point: MeetingPoint
) -> tuple[float, float]:
    """(place of the driver, way of the walker) to be reached at the same time.

    The walker is in the driver's line when its bumper comes; where the driver brakes for it,
    the walker leaves the kerb just then. Behind one that reverses it is where the tail will be.
    """
    spare = _SPARE_S * walk.speed_mps
    if draft.backs_to == walk.id:
        begins_s, ends_s = draft.laid.path.backwards[0]
        return (begins_s + ends_s) / 2, point.second_s_m + spare
    if scene.contact_wanted(walk.id, draft.id):
        return _contact(scene, draft, walk, point)
    before = [m for m in draft.marks if m.then is not None]
    before += [m for m in draft.deeds if m.target_mps == 0.0 and scene.is_loose(m.act)]
    for mark in before:
        if mark.s_m < point.first_s_m - draft.body.front_m:
            return mark.s_m, max(0.0, walk.motion.setback_m - _STEPS_OFF_M) + spare
    place = point.first_s_m - draft.body.front_m - _INTO_PATH_M
    return max(1.0, place), point.second_s_m + spare


def _contact(
    scene: Setup, draft: DriveDraft, walk: WalkDraft, point: MeetingPoint
) -> tuple[float, float]:
    """The front of the driver at the side of the walker, whose middle is where it is to be hit."""
    first_s, second_s, turn = crossing_at(draft.laid.path, walk.path, point)
    aside = (scene.impact_share - 0.5) * draft.body.width_m * (1 if sin(turn) > 0 else -1)
    place = first_s - draft.body.front_m - walk.body.width_m / 2
    return max(1.0, place), second_s - walk.body.centre_ahead_m - aside


def program_walkers(scene: Setup, leaves_s: Callable[[str], float]) -> None:
    """Step off when the driver has come so far that both arrive together; stop at the far side."""
    for walk in scene.walks.values():
        found = partner_of(scene, walk)
        act = scene.first_act(walk.id, ActKind.CROSS)
        go = leaves_s(walk.id)
        trigger: Trigger = AtTime(time_s=round(max(0.0, go), 3))
        draft = found[0] if found is not None else None
        if draft is not None and not (act is not None and isinstance(act.when, AfterStart)):
            own = just_before_step_s(go) - draft.offset_s
            distance = draft.course.s_at(own) - draft.start_m
            if draft.course.speed_then(own) > _MOVES_MPS or distance <= 0.0:
                trigger = Travelled(participant=draft.id, distance_m=round(max(0.0, distance), 3))
            scene.note(f"{walk.id}.starts_at_m", distance, f"arrives when {draft.id} does")
        name = None if act is None else act.id
        walk.program = walk.program_to(trigger, walk.path.length_m, name, stops=walk.stops)


def stop_in_the_way(scene: Setup) -> None:
    """End the ways of those who are said to stop where the driver whom they meet comes by."""
    for hazard in scene.of_kind(HazardKind.STOPPING):
        for walk in (scene.walks[n] for n in hazard.by if n in scene.walks):
            found = partner_of(scene, walk)
            if found is None or walk.stops:
                continue
            length = min(found[1].second_s_m + _STOP_SHORT_M, walk.path.length_m)
            # Nobody reaches its full pace on a way too short to stop from it.
            walk.speed_mps = round(min(walk.speed_mps, _OF_PEAK * sqrt(walk.rate_mps2 * length)), 3)
            walk.motion = walk.motion.model_copy(update={"stops_after_m": round(length, 3)})
            walk.path = crossing_path(scene.network, walk.motion, walk.id)

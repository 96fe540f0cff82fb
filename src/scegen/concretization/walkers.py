"""Those who go across: how fast, where on their way they are met, and what makes them step off."""

from collections import Counter
from math import sin, sqrt
from typing import NamedTuple

from scegen.concretization.amounts import BRAKING
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.meetings import MeetingPoint, before_front_m, crossing_at, meeting_point
from scegen.concretization.others import STOPS_SHORT_M, WalkDraft, Walker, abreast_m
from scegen.concretization.setup import Setup
from scegen.concretization.tale import Tale, pace_of
from scegen.concretization.things import caused_by_nobody
from scegen.motion.standing import heads_for_junction
from scegen.road.cross_section import CARRIAGEWAY, KERBED, half_width_m
from scegen.scenario.acts import RESTING, SLOWING, Act, ActKind, BeforeJunction
from scegen.scenario.bodies import Body
from scegen.scenario.functional import Participant
from scegen.scenario.in_line import goes_first
from scegen.scenario.logical import Crossing
from scegen.scenario.spacings import CONTACT, Measure
from scegen.scenario.vocabulary import HazardKind, Side

_SETBACK_M, _BEYOND_STRIP_M = 1.5, 0.6
_UNMARKED_M, _STRAIGHT_M = 4.0, 5.0
_BEYOND_PARKED_M = 1.2
BEHIND_KERB_M, _BEHIND_SCREEN_M = 0.2, 0.8
"""The front of one who waits is so far from the carriageway; of whom a thing is to hide: it needs
room there."""
_PASSES_BEFORE_S = 0.5
"""Who is just missed has left the way of the vehicle so long before it comes."""
_STEPS_OFF_M = 0.5
STOOD_S = 1.0
"""Who stops in somebody's way has stood there so long when that one comes."""
_OF_PEAK = 0.9
"""Of the pace at which one who sets off must begin to stop, the share that is used."""
OWES = HazardKind.FAILURE_TO_YIELD
_BRAKES = BRAKING | {HazardKind.STOPPING}


class Met(NamedTuple):
    """Whom one who goes across meets, or would: ``body`` and ``speed_mps`` are that one's.

    ``middle_m`` is its own way when the middle of its body is amid the other's way, ``to_left`` 1
    if it goes to the other's left, else -1.
    """

    who: str
    body: Body
    speed_mps: float
    middle_m: float
    to_left: int


def pace_mps(tale: Tale, participant: Participant, width_m: float) -> float:
    """How fast somebody goes across a road that is so wide: as is said, else as is usual."""
    act = tale.first_act(participant.id, ActKind.CROSS)
    if participant.speed_mps is not None or act is None or act.duration_s is None:
        return pace_of(tale.functional, tale.logical, participant.id).default
    return width_m / max(act.duration_s.middle, 0.1)


def goes_far_m(act: Act | None) -> float | None:
    """How far onto the road one is said to go, None if across it."""
    return None if act is None or act.distance_m is None else act.distance_m.middle


def stops(tale: Tale, name: str) -> bool:
    """Whether one who goes across is said to stop on its way."""
    return HazardKind.STOPPING in tale.kinds_by(name) or stop_of(tale, name) is not None


def stop_of(tale: Tale, name: str) -> Act | None:
    """The act by which it does: for a while, or for good."""
    return tale.first_act(name, *RESTING)


def rests_m(tale: Tale, walk: Walker, met: Met, *, centre_m: float) -> float:
    """The way that one who stops has gone by then: as is said, else into the other's way.

    ``centre_m`` is its way when the middle of its body is amid the road.
    """
    ends = {CONTACT, *((walk.stop.id,) if walk.stop is not None else ())}
    for said in tale.functional.spacings:
        if walk.id not in {said.participant, said.reference} or said.at not in ends:
            continue
        value = said.value.middle
        if said.participant == said.reference:
            return centre_m + value
        if said.measure is Measure.LATERAL_OFFSET_M:
            return met.middle_m + met.to_left * (value if said.participant == walk.id else -value)
        if said.measure is Measure.LATERAL_GAP_M:
            return met.middle_m - (met.body.width_m + walk.body.length_m) / 2 - value
    return _struck_m(tale, met) if tale.contact_wanted(walk.id, met.who) else met.middle_m


def _struck_m(tale: Tale, met: Met) -> float:
    """The way that one has gone when the other touches it as is said."""
    return met.middle_m + met.to_left * tale.struck_left_m(met.body)


def setback_m(tale: Tale, walk: Walker, strip_m: float) -> float:
    """How far outside the carriageway one starts, beyond a strip beside it: behind the kerb."""
    unseen = tale.of_kind(HazardKind.OCCLUSION)
    hidden = any(caused_by_nobody(tale.functional, hazard) for hazard in unseen)
    behind = walk.body.front_m + (_BEHIND_SCREEN_M if hidden else BEHIND_KERB_M)
    return max(strip_m + _BEYOND_STRIP_M if strip_m else _SETBACK_M, behind)


def brakes(tale: Tale, name: str) -> bool:
    """Whether one who meets somebody on foot is said to brake for it."""
    acts = [act for act in tale.acts_of(name, SLOWING) if tale.is_loose(act.id)]
    return bool(tale.kinds_by(name) & _BRAKES or acts)


def aim_m(tale: Tale, walk: Walker, met: Met) -> float:
    """The way that one has gone when the front of whom it meets comes to its line."""
    if tale.contact_wanted(walk.id, met.who):
        return _struck_m(tale, met)
    if brakes(tale, met.who):
        return met.middle_m
    clear = (met.body.width_m + walk.body.length_m) / 2 + _PASSES_BEFORE_S * walk.speed_mps
    owed = walk.id in tale.endangered_by(met.who, OWES)
    if owed or goes_first(tale.functional, met.who, walk.id):  # the other just passes before it
        passes_s = met.body.length_m / max(met.speed_mps, 1.0)
        return met.middle_m - clear - walk.speed_mps * passes_s
    return met.middle_m + clear


def place_walkers(scene: Setup) -> None:
    """On the crosswalk if the arm has one, from behind a parked vehicle if one hides them."""
    side_by_side: Counter[tuple[int, Side]] = Counter()
    for crossing in scene.logical.crossings:
        place = (crossing.arm, crossing.start)
        aside = abreast_m(side_by_side[place])
        side_by_side[place] += 1
        participant = scene.functional.participant(crossing.participant)
        road = scene.network.arm_road(crossing.arm)
        strip = max(half_width_m(road.lanes, sign, CARRIAGEWAY - KERBED) for sign in (-1, 1))
        speed = pace_mps(scene, participant, road.edge_t_m(1) - road.edge_t_m(-1))
        who = participant.id, participant.kind, participant.body, crossing, round(speed, 3)
        scene.note(f"{participant.id}.speed_mps", speed, "usual pace")
        act = scene.first_act(participant.id, ActKind.CROSS)
        walk = WalkDraft(*who, act, max(0.0, _from_junction_m(scene, crossing) + aside))
        walk.setback_m = max(setback_m(scene, walk, strip), walk.gains_m)
        far = goes_far_m(act)
        walk.stops_after_m = None if far is None else walk.setback_m + far
        walk.lay(scene.network)
        scene.walks[participant.id] = walk


def _from_junction_m(scene: Setup, crossing: Crossing) -> float:
    road = scene.network.arm_road(crossing.arm)
    act = scene.first_act(crossing.participant, ActKind.CROSS)
    if act is not None and isinstance(act.when, BeforeJunction) and act.when.participant is None:
        return act.when.distance_m.middle
    if road.crosswalks:
        return road.length_m - road.crosswalks[0].s_m
    hidden = [
        stand
        for stand in scene.stands.values()
        if stand.motion.arm == crossing.arm
        and not stand.motion.in_lane
        and stand.motion.side is crossing.start
    ]
    if not hidden:
        return _STRAIGHT_M if scene.network.plain else _UNMARKED_M
    # All stand with their inner bumper at the same clearance: just inside of it is in sight last.
    nearest = min(hidden, key=lambda stand: stand.motion.from_junction_m)
    towards = heads_for_junction(scene.network, nearest.motion)
    reach = nearest.body.front_m if towards else nearest.body.rear_m
    return max(0.5, nearest.motion.from_junction_m - reach - _BEYOND_PARKED_M)


def partner_of(scene: Setup, walk: WalkDraft) -> tuple[DriveDraft, MeetingPoint] | None:
    """The drive into whose way a walker steps; who stands all the time comes up to nobody."""
    for draft in (each for each in scene.concerned(walk.id) if not each.stands):
        point = meeting_point(draft, walk)
        if point is not None:
            return draft, point
    return None


def rendezvous(
    scene: Setup, draft: DriveDraft, walk: WalkDraft, point: MeetingPoint
) -> tuple[float, float]:
    """(place of the driver, way of the walker) to be reached at the same time.

    Who brakes for the walker would meet it if it did not, and begins as that one has left the kerb.
    Behind one that reverses it is where the tail will be.
    """
    if draft.backs_to == walk.id:
        begins_s, ends_s = draft.path.backwards[0]
        return (begins_s + ends_s) / 2, point.second_s_m
    line_s, met = _met_at(draft, walk, point)
    way = aim_m(scene, walk, met)
    place = max(1.0, line_s - draft.body.front_m - walk.body.width_m / 2)
    if scene.contact_wanted(walk.id, draft.id):
        return place, way
    marks = [m for m in draft.marks if m.then is not None]
    marks += [m for m in draft.steps if m.target_mps == 0.0 and scene.is_loose(m.act)]
    done = {p.act: p.s_m for p in draft.course.phases if p.act}  # one after another
    for begins_m in (done.get(mark.act or "", mark.s_m) for mark in marks):
        if begins_m < place:
            sooner_s = (place - begins_m) / max(draft.course.speed_at(begins_m), 1.0)
            left_kerb = max(0.0, walk.setback_m - _STEPS_OFF_M)
            return begins_m, max(way - walk.speed_mps * sooner_s, left_kerb)
    return place, way


def _met_at(draft: DriveDraft, walk: WalkDraft, point: MeetingPoint) -> tuple[float, Met]:
    """Where on a drive a walker's line lies, and how it meets that one there."""
    line_s, middle_m, turn = crossing_at(draft.path, walk.path, point)
    middle_m -= walk.body.centre_ahead_m
    to_left = 1 if sin(turn) > 0 else -1
    return line_s, Met(draft.id, draft.body, draft.speed_mps, middle_m, to_left)


def leaves_s(scene: Setup, name: str) -> float:
    """When one who stands at first sets off: as is said, or to meet whom it is to meet."""
    walk = scene.walks[name]
    if walk.sets_off_s is not None:
        return walk.sets_off_s
    found = partner_of(scene, walk)
    if found is None:
        return 1.0
    draft, point = found
    place, way_m = rendezvous(scene, draft, walk, point)
    there_s = draft.offset_s + draft.course.time_at(place)
    leaves = there_s - walk.runs_s(way_m)
    if walk.stops_after_m is None or not stops(scene, name):
        return leaves
    left_m = max(0.0, point.first_s_m - draft.body.front_m - place)  # it brakes from there on
    comes_s = there_s + left_m / max(draft.course.speed_at(place), 1.0)
    return min(leaves, comes_s - walk.rests_s() - STOOD_S)


def stop_in_the_way(scene: Setup) -> None:
    """End the ways of those who are said to stop, where is said or whom they meet comes by."""
    for walk in scene.walks.values():
        found = partner_of(scene, walk) if stops(scene, walk.id) else None
        if found is None or walk.stops_after_m is not None:
            continue
        draft, point = found
        walk.stop = stop_of(scene, walk.id)
        _, met = _met_at(draft, walk, point)
        ahead_m = walk.body.centre_ahead_m
        rests = rests_m(scene, walk, met, centre_m=walk.path.length_m / 2 - ahead_m)
        own = [s.at for s in scene.functional.spacings if s.participant == s.reference == walk.id]
        if walk.stop is None or walk.stop.id not in own:  # else the road alone tells where
            aside_m = met.to_left * (rests - met.middle_m)
            reach_m = draft.body.front_m + walk.body.width_m / 2
            rests = before_front_m(draft.path, walk.path, point, reach_m, aside_m) - ahead_m
        length = min(rests + STOPS_SHORT_M, walk.path.length_m)
        # Nobody reaches its full pace on a way too short to stop from it.
        walk.speed_mps = round(min(walk.speed_mps, _OF_PEAK * sqrt(walk.rate_mps2 * length)), 3)
        walk.stops_after_m = length
        walk.lay(scene.network)

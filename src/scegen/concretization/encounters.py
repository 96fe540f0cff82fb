"""Whom a danger at a junction concerns, where it happens, and which drives shall arrive together.

Those are causes and sufferers of dangers, then all whom the ego meets.
"""

from collections.abc import Iterable

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.limits import (
    CLOSE_FOLLOWING_S,
    COMFORTABLE_ACCELERATION_MPS2,
    COMFORTABLE_BRAKING_MPS2,
    HOLDS_S,
    PASSING_LAG_S,
    TAILGATING_HEADWAY_S,
)
from scegen.concretization.meetings import (
    BYSTANDER,
    DANGER,
    DANGER_TO_OTHERS,
    ORDINARY,
    STRUCTURAL,
    Meeting,
    drives_meet,
    first_ground,
)
from scegen.concretization.setup import Setup
from scegen.scenario.acts import GAINING, ActKind
from scegen.scenario.functional import Hazard
from scegen.scenario.hazards import HAZARDS, Arrangement, Case, Motion
from scegen.scenario.vocabulary import HazardKind, Maneuver

_CLEAR_OF_WALKER_M, _CLEAR_BEHIND_M, _CLEAR_OF_OTHER_M = 1.3, 0.7, 3.0
_BEFORE_S = 1.5
"""Who gains speed begins to so long before the place where it matters."""
_HALF_WAY = 0.6


def culprits(scene: Setup, hazard: Hazard) -> list[DriveDraft]:
    """The drives that cause a hazard."""
    return [scene.drives[name] for name in hazard.by if name in scene.drives]


def victims(scene: Setup, hazard: Hazard, culprit: DriveDraft) -> list[DriveDraft]:
    """The drives that suffer it; none where those who do are on foot."""
    return [scene.drives[n] for n in hazard.to if n in scene.drives and n != culprit.id]


def pairs(scene: Setup, hazard: Hazard) -> list[tuple[DriveDraft, DriveDraft]]:
    """(cause, sufferer) of a hazard for which they must arrive together, drives only.

    None where a danger is made by where somebody walks or stands, not by how anybody drives.
    """
    row = HAZARDS[hazard.kind]
    if row.moves is Motion.STILL or Arrangement.OVER in row.needs.get(Case.ANYWHERE, ()):
        return []
    return [(c, v) for c in culprits(scene, hazard) for v in victims(scene, hazard, c)]


def same_arm(first: DriveDraft, second: DriveDraft) -> bool:
    """Whether both enter on the same arm."""
    return first.drive.entry == second.drive.entry


def ahead_on_arm(scene: Setup, draft: DriveDraft) -> list[DriveDraft]:
    """Those who come before it on the same arm, the first first."""
    same = (other for other in scene.drives.values() if same_arm(other, draft))
    ahead = (other for other in same if other.drive.rank < draft.drive.rank)
    return sorted(ahead, key=lambda other: other.drive.rank)


def join_traffic(scene: Setup) -> None:
    """Who turns into a road that another drives along at a speed that is said gets as fast."""
    drives = [d for d in scene.drives.values() if d.drive.turn is Maneuver.STRAIGHT]
    steady = [d for d in drives if scene.has_said_speed(d.id) and not scene.speed_acts(d.id)]
    for draft in scene.drives.values():
        for other in steady if not scene.has_said_speed(draft.id) else ():
            if draft.drive.exit == other.drive.exit and not same_arm(draft, other):
                draft.joins_mps = min(other.speed_mps, draft.body.top_speed_mps)


def _gains_speed_s(scene: Setup, draft: DriveDraft, other: DriveDraft, s_m: float) -> float:
    """How much later another comes to who joins its road there, so as not to drive into it."""
    slower = max(other.speed_mps - draft.course.speed_at(s_m), 0.0)
    joins = draft.drive.exit == other.drive.exit and draft.joins_mps >= other.speed_mps
    way_m = slower**2 / (2 * COMFORTABLE_ACCELERATION_MPS2) + draft.body.length_m
    apart = joins and not scene.contact_wanted(draft.id, other.id)
    return way_m / other.speed_mps if apart else 0.0


def event_s_m(scene: Setup, draft: DriveDraft, whom: Iterable[str]) -> float:
    """Where on its way a driver's danger to others happens.

    Of one in the ring already, half way round; where it meets a sufferer; else on its entry arm,
    before it slows to turn.
    """
    if draft.drive.circulating:
        laid = draft.laid
        return laid.path_s_m((laid.turning_starts_m + laid.turning_ends_m) / 2)
    for victim in (scene.drives[n] for n in whom if n in scene.drives and n != draft.id):
        point = drives_meet(draft, victim)
        if point is not None:
            return point.first_s_m
    base = [mark.s_m for mark in draft.road_changes() if mark.s_m > 1.0]
    return min([draft.junction_s_m - 10.0, *base]) - 5.0


def stops_for_walkers(scene: Setup, draft: DriveDraft, *names: str) -> tuple[float, float] | None:
    """Where the reference point must rest for those who cross, and how long until they have.

    For all of them, or those of some names.
    """
    stops = []
    for walk in (scene.walks[n] for n in names or scene.walks if n in scene.walks):
        if (shared := first_ground(draft, walk)) is not None:
            over = min(shared.other_leaves_m, walk.path.length_m)
            clear = over + _CLEAR_BEHIND_M - walk.setback_m
            stops.append((shared.enter_m - _CLEAR_OF_WALKER_M, clear / walk.speed_mps))
    if not stops:
        return None
    return min(place for place, _ in stops), max(clear for _, clear in stops)


def happens_s_m(scene: Setup, draft: DriveDraft, kind: HazardKind, act: ActKind) -> float:
    """Where a change of speed is to be over (or a gain of it to begin), as far as nobody says.

    Who causes no danger by it does so for those who endanger it, or whom it endangers.
    """
    hazards = scene.functional.hazards
    hit_by = _hit_by(scene) if act is ActKind.STOP and draft is scene.ego else ()
    about = [hit_by] * bool(hit_by) + [h.to for h in hazards if draft.id in h.by and h.kind is kind]
    about += [h.by for h in hazards if draft.id in h.to]
    about += [h.to for h in hazards if draft.id in h.by]
    place = event_s_m(scene, draft, about[0] if about else ())
    if act in GAINING:
        return place - _BEFORE_S * draft.speed_mps
    walkers = stops_for_walkers(scene, draft)
    if walkers is not None:
        return walkers[0]
    if draft is scene.ego and not hit_by:
        # The ego brakes to avoid, the others brake in its way.
        place -= draft.body.length_m / 2 + _CLEAR_OF_OTHER_M
    return place


def _hit_by(scene: Setup) -> tuple[str, ...]:
    """Who drives into an ego that has stopped, where their ways meet."""
    ego = scene.ego
    stops = any(act.kind is ActKind.STOP for act in scene.speed_acts(ego.id))
    hits = (d for d in scene.drives.values() if stops and scene.contact_wanted(ego.id, d.id))
    return tuple(d.id for d in hits if d is not ego and drives_meet(ego, d) is not None)


def conflict_meetings(scene: Setup, arranged: list[Meeting]) -> list[Meeting]:
    """Meetings by priority: dangers to or by the ego, between others, then all others' with it.

    Where the text names dangers, vehicles without a part in them pass a little after the ego.
    ``arranged`` are meetings that manoeuvres need already.
    """
    meetings = _side_by_side(scene)
    involved = {frozenset((m.first, m.second)) for m in (*arranged, *meetings)}
    named: set[str] = set()
    for hazard in scene.functional.hazards:
        named |= {*hazard.by, *hazard.to}
        for cause, sufferer in pairs(scene, hazard):
            key = frozenset((cause.id, sufferer.id))
            if key not in involved and not scene.runs_into_standing(cause.id):
                priority = DANGER if scene.ego.id in key else DANGER_TO_OTHERS
                reason = f"{hazard.kind}: arrives together"
                if same_arm(cause, sufferer) and drives_meet(cause, sufferer) is None:
                    found = [_close(scene, hazard, cause, sufferer, priority)]
                else:
                    found = _meeting(scene, priority, (cause, sufferer), 0.0, reason)
                meetings += found
                if found:
                    involved.add(key)
    return [*meetings, *_ordinary(scene, involved, named)]


def _ordinary(scene: Setup, involved: set[frozenset[str]], named: set[str]) -> list[Meeting]:
    """The first of each queue that the ego's way meets; the others queue up."""
    meetings: list[Meeting] = []
    ego = scene.ego.id
    # A queue of which one meets the ego in danger is placed by that one.
    taken = {
        (d.drive.entry, d.entry_lane)
        for d in scene.drives.values()
        if frozenset((d.id, ego)) in involved
    }
    hit_by = _hit_by(scene)
    for draft in sorted(scene.drives.values(), key=lambda d: d.drive.rank):
        queue = (draft.drive.entry, draft.entry_lane)
        if draft.id == ego or queue in taken:
            continue
        collide = scene.contact_wanted(ego, draft.id)
        bystander = bool(scene.functional.hazards) and draft.id not in named and not collide
        priority = DANGER if collide else BYSTANDER if bystander else ORDINARY
        lag = PASSING_LAG_S if bystander else 0.0
        if draft.id in hit_by:  # it has come to rest by then
            lag = scene.ego.speed_mps / (2 * COMFORTABLE_BRAKING_MPS2) + HOLDS_S
        found = _meeting(scene, priority, (scene.ego, draft), lag, "arrives together")
        if found:
            meetings += found
            taken.add(queue)
    return meetings


def _meeting(
    scene: Setup, priority: int, two: tuple[DriveDraft, DriveDraft], lag_s: float, reason: str
) -> list[Meeting]:
    first, second = two
    point = drives_meet(first, second)
    if point is None:
        return []
    places = point.first_s_m, point.second_s_m
    lag_s += _gains_speed_s(scene, first, second, places[0])
    lag_s -= _gains_speed_s(scene, second, first, places[1])
    return [Meeting(priority, first.id, second.id, *places, lag_s, reason)]


def _close(
    scene: Setup, hazard: Hazard, cause: DriveDraft, sufferer: DriveDraft, priority: int
) -> Meeting:
    """On one arm: level in neighbouring lanes, close behind each other in one."""
    place = max(5.0, event_s_m(scene, cause, hazard.to))
    place = min([place, *(mark.s_m for mark in cause.marks if mark.hazard is hazard.kind)])
    if cause.entry_lane != sufferer.entry_lane:
        return Meeting(priority, cause.id, sufferer.id, place, place, 0.0, f"{hazard.kind}: level")
    lead, follow = cause, sufferer
    if sufferer.drive.rank < cause.drive.rank:
        lead, follow = sufferer, cause
    reason = f"{hazard.kind}: close behind"
    headway_s = CLOSE_FOLLOWING_S
    if hazard.kind is HazardKind.TAILGATING:
        headway_s = sum(TAILGATING_HEADWAY_S) / 2
        if not scene.has_said_speed(follow.id):
            follow.speed_mps = lead.speed_mps
    bodies = lead.body.rear_m + follow.body.front_m
    return Meeting(priority, lead.id, follow.id, place, place - bodies, headway_s, reason)


def _side_by_side(scene: Setup) -> list[Meeting]:
    """Those who travel beside another are level with it half way along the arm.

    Where one turns across the other, they are so there.
    """
    found = []
    # The second in the same lane drives in a line with the first.
    taken: set[tuple[str, int]] = set()
    for draft in scene.drives.values():
        beside = scene.drives.get(draft.drive.beside or "")
        if beside is None or (beside.id, draft.entry_lane) in taken:
            continue
        taken.add((beside.id, draft.entry_lane))
        point = drives_meet(beside, draft)
        place = draft.junction_s_m * _HALF_WAY
        priority, places, words = STRUCTURAL + 1, (place, place), "side by side"
        if point is not None:
            priority, places = DANGER, (point.first_s_m, point.second_s_m)
            words += ", one turns across the other"
        found.append(Meeting(priority, beside.id, draft.id, *places, 0.0, words))
    return found

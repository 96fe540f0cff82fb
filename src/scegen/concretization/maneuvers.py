"""Lane changes and overtakes that are asked for as manoeuvres, not as dangers."""

from __future__ import annotations

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.hazards.aside import come_into_lane
from scegen.concretization.hazards.parties import ahead_on_arm, same_arm
from scegen.concretization.meetings import DANGER, STRUCTURAL, Meeting, drives_meet
from scegen.concretization.passing import pass_drive
from scegen.concretization.setup import Setup
from scegen.concretization.stationary import goes_round_a_thing
from scegen.concretization.tale import SIDEWAYS
from scegen.errors import MotionInfeasibleError
from scegen.scenario.vocabulary import HazardKind, Maneuver


def shape_maneuvers(scene: Setup) -> list[Meeting]:
    """Lane changes and overtakes of those who have none yet, and the meetings they need."""
    meetings: list[Meeting] = []
    for draft in scene.drives.values():
        maneuver = _goes(scene, draft)
        if draft.lane_changes or maneuver not in SIDEWAYS:
            continue
        passed = _passed(scene, draft)
        if passed is not None:
            comes_back = maneuver is Maneuver.OVERTAKE
            meetings += pass_drive(scene, draft, passed, comes_back=comes_back)
        elif draft.drive.maneuver in SIDEWAYS and not _has_cause(scene, draft):
            meetings += _free_change(scene, draft)
    return [*meetings, *_side_by_side(scene, meetings)]


def _goes(scene: Setup, draft: DriveDraft) -> Maneuver:
    """What it does beside its turn: who overtakes as a danger does so, too."""
    overtakes = HazardKind.OVERTAKING in scene.kinds_by(draft.id)
    return Maneuver.OVERTAKE if overtakes else draft.drive.maneuver


def _passed(scene: Setup, draft: DriveDraft) -> DriveDraft | None:
    """The vehicle ahead on the same arm that a lane change or overtake goes round.

    The one that the text calls slow, else the nearest.
    """
    ahead = [
        other
        for other in ahead_on_arm(scene, draft)
        if other.drive.beside is None and other.drive.reverses is None
    ]
    slow = [other for other in ahead if HazardKind.SLOW_DRIVING in scene.kinds_by(other.id)]
    return next(reversed(slow or ahead), None)


def _has_cause(scene: Setup, draft: DriveDraft) -> bool:
    """Whether it goes round what stands or lies in its lane, or "overtakes" without leaving it.

    That is who passes one that is parked beside the lanes, or one that reverses into its way.
    """
    arms = {draft.drive.entry, draft.drive.exit}
    standing = {s.standing.in_lane for s in scene.stands.values() if s.standing.arm in arms}
    past = False in standing
    past |= any(other.drive.reverses is not None for other in ahead_on_arm(scene, draft))
    stays = past and draft.drive.maneuver is Maneuver.OVERTAKE
    return stays or True in standing or goes_round_a_thing(scene, draft)


def _free_change(scene: Setup, draft: DriveDraft) -> list[Meeting]:
    """A change into the lane of one beside it, rather the ego's, or into the one that leads on."""
    if scene.ring and scene.lanes_in(draft) < 2:
        raise MotionInfeasibleError("there is no second lane to change into", where=draft.id)
    if scene.lanes_in(draft) < 2 and draft.drive.maneuver is Maneuver.OVERTAKE:
        raise MotionInfeasibleError(
            f"nobody is ahead of it on arm {draft.drive.entry} whom it could overtake",
            where=draft.id,
            hint="Let another vehicle enter on that arm before it, or let it drive straight on.",
        )
    near = [
        other
        for other in scene.drives.values()
        if (other.id == draft.drive.beside or other.drive.beside == draft.id)
        and same_arm(other, draft)
        and abs(other.entry_lane - draft.entry_lane) == 1
        and other.entry_lane in scene.entry_lanes(draft)
        and not other.lane_changes
    ]
    beside = max(near, key=lambda other: other is scene.ego, default=None)
    return come_into_lane(scene, draft, beside)


def _side_by_side(scene: Setup, meetings: list[Meeting]) -> list[Meeting]:
    """Those who travel beside another are level with it half way along the arm.

    Where one turns across the other, they are so there.
    """
    arranged = {frozenset((m.first, m.second)) for m in meetings}
    found = []
    # The second in the same lane drives in a line with the first.
    taken: set[tuple[str, int]] = set()
    for draft in scene.drives.values():
        beside = scene.drives.get(draft.drive.beside or "")
        if beside is None or not same_arm(draft, beside):
            continue
        if frozenset((beside.id, draft.id)) in arranged or (beside.id, draft.entry_lane) in taken:
            continue
        taken.add((beside.id, draft.entry_lane))
        point = drives_meet(beside, draft)
        place = draft.junction_s_m * 0.6
        priority, places, words = STRUCTURAL + 1, (place, place), "side by side"
        if point is not None:
            priority, places = DANGER, (point.first_s_m, point.second_s_m)
            words += ", one turns across the other"
        found.append(Meeting(priority, beside.id, draft.id, *places, 0.0, words))
    return found

"""Who is where when: turns meetings and queues into starting places.

Every vehicle has a timeline as if it started at the outer end of its arm, and an offset by which
its timeline is late against the scenario's clock. Arranging the meetings fixes the offsets
against the ego's, each next to the wanted one at which it is in nobody's way; one common shift then
makes the approach long enough.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import inf

from scegen.concretization.clearance import same_lane, touches
from scegen.concretization.drafts import DriveDraft, Wait
from scegen.concretization.lights import WAITS_S, lay_lights, wait_for_green
from scegen.concretization.limits import APPROACH_S, HEADWAY_S, LEAD_IN_S
from scegen.concretization.meetings import ORDINARY, Meeting
from scegen.concretization.priorities import Manners, patient_ones
from scegen.concretization.setup import Setup, require_room
from scegen.motion.rules.giving_way import must_give_way

_ARM_MARGIN_M = 1.0
_BEFORE_JUNCTION_M = 5.0
_SAME_S = 0.01
_ROUNDS = 4
"""So often all are arranged anew because the scenario has to begin earlier than was assumed."""
_DANGER_WITHIN_S = 1.5
"""Those who meet in danger may be this much off their meeting to spare others."""
_ROOM_S = 0.3
_STEP_S = 0.5
LONGEST_S = 40.0


def arrange(scene: Setup, meetings: Sequence[Meeting], begins_s: float) -> None:
    """Fix how late every drive is on the ego's timeline, on which all begin at ``begins_s``."""
    scene.ego.offset_s = 0.0
    placed = [scene.ego]
    ordered = sorted(meetings, key=lambda m: m.priority)
    dangers = [m for m in ordered if m.priority < ORDINARY]
    while (place := _met(scene, dangers, placed)) is not None:
        make_late(place, begins_s)
        placed.append(place.draft)
    duties = must_give_way(scene.functional, scene.logical)
    patient = patient_ones(scene, ordered, duties)
    by_pair = {frozenset((duty.yields, duty.other)): duty for duty in duties}
    lay_lights(scene, placed)
    manners = Manners(scene, by_pair, patient)
    while len(placed) < len(scene.drives):
        place = _met(scene, ordered, placed) or _in_line(scene, placed) or _free(scene, placed)
        make_late(place, begins_s, manners)
        placed.append(place.draft)


def _met(scene: Setup, meetings: Sequence[Meeting], placed: Sequence[DriveDraft]) -> Placing | None:
    """By the most important meeting of which one side is fixed."""
    for meeting in meetings:
        first, second = scene.drives[meeting.first], scene.drives[meeting.second]
        known = first in placed
        if known == (second in placed):
            continue
        later_s = meeting.lag_s + first.course.time_at(meeting.first_s_m)
        later_s -= second.course.time_at(meeting.second_s_m)
        draft = second if known else first
        offset = first.offset_s + later_s if known else second.offset_s - later_s
        # Those in danger touch nobody else.
        spared = {n for m in meetings if m.priority < ORDINARY for n in m.other_than(draft.id)}
        spared |= {n for n in meeting.other_than(draft.id) if scene.contact_wanted(n, draft.id)}
        clear = [each for each in placed if each.id not in spared]
        near = [each for each in placed if each.id in spared]
        ordinary = meeting.priority >= ORDINARY
        within_s = LONGEST_S if ordinary else _DANGER_WITHIN_S
        return Placing(draft, offset, clear, near, 0, within_s, waits=ordinary)
    return None


def _in_line(scene: Setup, placed: Sequence[DriveDraft]) -> Placing | None:
    """Behind or before the next of its arm and lane that is fixed, at a distance."""
    pairs = [
        (abs(draft.drive.rank - each.drive.rank), n, draft, each)
        for n, draft in enumerate(scene.drives.values())
        for each in placed
        if draft not in placed and same_lane(each, draft)
    ]
    if not pairs:
        return None
    *_, draft, each = min(pairs, key=lambda pair: pair[:2])
    direction = 1 if each.drive.rank < draft.drive.rank else -1
    gap_s = each.course.time_at(draft.arrives_s_m) - draft.course.time_at(draft.arrives_s_m)
    offset = each.offset_s + gap_s + direction * HEADWAY_S
    return Placing(draft, offset, placed, direction=direction, headway_s=HEADWAY_S)


def _free(scene: Setup, placed: Sequence[DriveDraft]) -> Placing:
    """At the junction when the ego is."""
    open_ = [draft for draft in scene.drives.values() if draft not in placed]
    draft, ego = min(open_, key=lambda each: each.drive.rank), scene.ego
    offset = ego.course.time_at(ego.arrives_s_m) - draft.course.time_at(draft.arrives_s_m)
    return Placing(draft, offset, placed)


def schedule(scene: Setup, meetings: Sequence[Meeting]) -> None:
    """Fix how late every drive is on the scenario's clock.

    Everybody starts on its arm, before its first phase and before its first meeting; the ego
    has ``APPROACH_S`` until its own.
    """
    first_s = _first_places(scene, meetings)
    ego, waits = scene.ego, {draft: draft.waits for draft in scene.drives.values()}
    begins_s = 0.0 if ego.backs_out else ego.course.time_at(first_s[ego.id]) - APPROACH_S
    for _ in range(_ROUNDS):
        arrange(scene, meetings, begins_s)
        assumed_s, begins_s = begins_s, min([begins_s, *_latest_s(scene, first_s)])
        if begins_s >= assumed_s - _SAME_S:
            break
        _wait_again(waits)
    for draft in scene.drives.values():
        draft.offset_s -= begins_s


def _latest_s(scene: Setup, first_s: Mapping[str, float]) -> Iterator[float]:
    """When every drive must be under way at the latest, on the ego's timeline."""
    for name, draft in scene.drives.items():
        if draft.backs_out:
            # It stands near where it starts until its time has come.
            yield draft.offset_s
        elif scene.stands_at_line(name):
            goes = draft.course.going_on
            yield inf if goes is None else draft.offset_s + goes.begins_s - WAITS_S
        elif not (draft.stands or scene.sets_off(name)):
            places = [first_s[name], draft.junction_s_m - _BEFORE_JUNCTION_M]
            places += [mark.s_m for mark in draft.speed_changes() if mark.s_m > 0.5]
            places += [draft.laid.path_s_m(change.position_m) for change in draft.lane_changes]
            lead_in = draft.course.time_at(max(0.0, min(places))) - LEAD_IN_S
            yield draft.offset_s + max(0.0, lead_in)


def require_arms(scene: Setup) -> None:
    """Ask for arms on which everybody can start where it is when the scenario begins.

    Raises:
        NeedsLongerArms: they are too short for somebody.
    """
    short_m = {
        name: draft.body.rear_m + _ARM_MARGIN_M - draft.course.s_at(-draft.offset_s)
        for name, draft in scene.drives.items()
        if not draft.backs_out
    }
    for who in sorted(short_m, key=lambda name: -short_m[name])[:1]:
        require_room(who, -short_m[who], 0.0, 0.0)


def _first_places(scene: Setup, meetings: Sequence[Meeting]) -> dict[str, float]:
    """Where each drive has its first meeting, or the inner end of its arm."""
    places = {name: draft.arrives_s_m for name, draft in scene.drives.items()}
    for meeting in meetings:
        if meeting.priority < 0:
            continue
        places[meeting.first] = min(places[meeting.first], meeting.first_s_m)
        places[meeting.second] = min(places[meeting.second], meeting.second_s_m)
    return places


@dataclass(frozen=True, slots=True)
class Placing:
    """A drive that is to be so late, and whom it must keep ``clear`` of among those placed.

    ``near`` are those whom it may touch. ``direction`` 1 looks later, -1 earlier, 0 both ways, as
    far as ``within_s``. ``headway_s`` is kept to those of its lane; who ``waits`` does so for its
    light and for whoever has right of way.
    """

    draft: DriveDraft
    offset_s: float
    clear: Sequence[DriveDraft]
    near: Sequence[DriveDraft] = ()
    direction: int = 1
    within_s: float = LONGEST_S
    headway_s: float = _ROOM_S
    waits: bool = True


def make_late(place: Placing, begins_s: float, manners: Manners | None = None) -> None:
    """Let a drive be as late as is next to its placing and lets it touch none of the others.

    Where none is free, the first that is free of those of its lane. With ``manners`` nobody takes
    another's way, of those placed, either.
    """
    draft, manners = place.draft, manners if place.waits else None
    people = [draft, *place.clear, *place.near]
    before = {each: each.waits for each in people}
    line = [each for each in place.clear if same_lane(draft, each)]
    others = [each for each in place.clear if each not in line]
    usual: float | None = None
    for k in range(int(place.within_s / _STEP_S) + 1):
        for sign in (place.direction,) if place.direction else (1, -1):
            draft.offset_s = place.offset_s + sign * k * _STEP_S
            if touches(draft, line, place.headway_s, begins_s):
                continue
            usual = draft.offset_s if usual is None else usual
            if manners is not None:
                wait_for_green(manners.scene, draft, line)
                if not manners.settle(draft, people):
                    _wait_again(before)
                    continue
            waiting = [each for each, waits in before.items() if each.waits != waits]
            if not (
                touches(draft, others, _ROOM_S, begins_s)
                or (draft in waiting and touches(draft, line, place.headway_s, begins_s))
                or any(touches(one, people, _ROOM_S, begins_s) for one in waiting)
            ):
                return
            _wait_again(before)
    draft.offset_s = place.offset_s if usual is None else usual
    if manners is not None:
        wait_for_green(manners.scene, draft, line)


def _wait_again(before: Mapping[DriveDraft, Wait | None]) -> None:
    """Let everybody wait as it did."""
    for draft, waits in before.items():
        draft.waits = waits

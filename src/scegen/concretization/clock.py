"""Who is where when: turns meetings and queues into starting places.

Every vehicle has a timeline as if it started at the outer end of its arm, and an offset by which
its timeline is late against the scenario's clock. Arranging the meetings fixes the offsets
against the ego's; one common shift then makes the approach long enough.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from math import inf

import numpy as np

from scegen.concretization.clearance import LONGEST_S, clear_offset
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.lights import lights_of, stands_at_red
from scegen.concretization.limits import APPROACH_S, HEADWAY_S, LEAD_IN_S, QUEUE_GAP_M
from scegen.concretization.meetings import BYSTANDER, ORDINARY, Meeting, shared_length_m
from scegen.concretization.priorities import Manners, Waits, patient_ones
from scegen.concretization.setup import Setup
from scegen.motion.rules.giving_way import must_give_way

_ARM_MARGIN_M = 1.0
_BEFORE_JUNCTION_M = 5.0
_SAME_S = 0.01
_ROUNDS = 4
"""So often all are arranged anew because the scenario has to begin earlier than was assumed."""
_DANGER_WITHIN_S = 1.5
"""Those who meet in danger may be this much off their meeting to spare others."""


def arrange(scene: Setup, meetings: Sequence[Meeting], begins_s: float) -> dict[str, float]:
    """The offset of every drive against the ego's timeline (s), on which all begin at a time."""
    offsets = {scene.ego.id: 0.0}
    ordered = sorted(meetings, key=lambda m: m.priority)
    dangers = [m for m in ordered if m.priority < ORDINARY]
    while _arrange_one(scene, dangers, offsets, begins_s, None):
        continue
    duties = must_give_way(scene.functional, scene.logical)
    manners = Manners(lights_of(scene, offsets), duties, patient_ones(scene, ordered, duties))
    while len(offsets) < len(scene.drives):
        if _arrange_one(scene, ordered, offsets, begins_s, manners):
            continue
        if _queue_one(scene, offsets, begins_s, manners):
            continue
        free = [n for n in scene.drives if n not in offsets]
        name = min(free, key=lambda n: scene.drives[n].drive.rank)
        draft, ego = scene.drives[name], scene.ego
        # At the junction when the ego is.
        offset = ego.course.time_at(ego.arrives_s_m) - draft.course.time_at(draft.arrives_s_m)
        offsets[name] = clear_offset(
            draft, offset, _placed(scene, offsets), offsets, begins_s, manners=manners
        )
    scene.signals = manners.lights.plan if manners.lights is not None else None
    return offsets


def _partners(meetings: Sequence[Meeting], name: str) -> set[str]:
    """Those whom one meets in danger."""
    risky = [m for m in meetings if m.priority < ORDINARY and name in {m.first, m.second}]
    return {other for m in risky for other in (m.first, m.second) if other != name}


def _placed(
    scene: Setup, offsets: dict[str, float], *, without: Collection[str] = ()
) -> list[DriveDraft]:
    return [d for n, d in scene.drives.items() if n in offsets and n not in without]


def _arrange_one(
    scene: Setup,
    meetings: Sequence[Meeting],
    offsets: dict[str, float],
    begins_s: float,
    manners: Manners | None,
) -> bool:
    """Arrange the most important meeting of which one side is fixed."""
    for meeting in meetings:
        known, other = meeting.first in offsets, meeting.second in offsets
        if known == other:
            continue
        first, second = scene.drives[meeting.first], scene.drives[meeting.second]
        gap = second.course.time_at(meeting.second_s_m) - first.course.time_at(meeting.first_s_m)
        if known:
            partner, draft = first, second
            offset = offsets[first.id] + meeting.lag_s - gap
        else:
            partner, draft = second, first
            offset = offsets[second.id] - meeting.lag_s + gap
        if meeting.priority >= 0:
            # Those in danger touch nobody else; who has no part in one touches nobody.
            bystander = meeting.priority >= BYSTANDER
            spared = set() if bystander else _partners(meetings, draft.id)
            if not bystander and scene.contact_wanted(partner.id, draft.id):
                spared.add(partner.id)
            offset = clear_offset(
                draft,
                offset,
                _placed(scene, offsets, without=spared),
                offsets,
                begins_s,
                direction=1 if bystander else 0,
                within_s=LONGEST_S if meeting.priority >= ORDINARY else _DANGER_WITHIN_S,
                manners=manners if meeting.priority >= ORDINARY else None,
                meeting=[scene.drives[n] for n in spared if n in offsets],
            )
        offsets[draft.id] = offset
        return True
    return False


def _queue_one(
    scene: Setup, offsets: dict[str, float], begins_s: float, manners: Manners | None
) -> bool:
    """Line one vehicle up behind or before those of its arm and lane that are fixed."""
    for name, draft in sorted(scene.drives.items(), key=lambda item: item[1].drive.rank):
        if name in offsets:
            continue
        same = [d for d in scene.drives.values() if d.id in offsets and same_lane(d, draft)]
        if not same:
            continue
        ahead = [d for d in same if d.drive.rank < draft.drive.rank]
        if ahead:
            offset = max(_behind(d, offsets[d.id], draft, begins_s) for d in ahead)
            direction = 1
        else:
            offset = min(_before(draft, d, offsets[d.id], begins_s) for d in same)
            direction = -1
        others = _placed(scene, offsets)
        offsets[name] = clear_offset(
            draft, offset, others, offsets, begins_s, direction=direction, manners=manners
        )
        return True
    return False


def same_lane(first: DriveDraft, second: DriveDraft) -> bool:
    """Whether two drives start on the same arm in the same lane."""
    return (
        first.drive.entry == second.drive.entry
        and first.entry_lane == second.entry_lane
        and first.id != second.id
    )


def _behind(lead: DriveDraft, lead_s: float, follow: DriveDraft, begins_s: float) -> float:
    """The earliest offset of one that keeps its distance behind another from its start on."""
    shared = shared_length_m(lead, follow)
    offset = lead_s + headway_s(lead, follow, shared, inf)
    while True:
        # Who comes later starts farther out, where the one ahead may be nearer.
        place = _place_m(follow, begins_s - offset)
        later = lead_s + headway_s(lead, follow, shared, place)
        if later <= offset + _SAME_S:
            return offset
        offset = later


def _before(lead: DriveDraft, follow: DriveDraft, follow_s: float, begins_s: float) -> float:
    """The latest offset of one that is kept at a distance by another from that one's start on."""
    place = _place_m(follow, begins_s - follow_s)
    return follow_s - headway_s(lead, follow, shared_length_m(lead, follow), place)


def _place_m(draft: DriveDraft, time_s: float) -> float:
    """Where a drive is at a time of its course; who backs out stands where it starts before."""
    return draft.course.s_at(max(time_s, 0.0) if draft.backs_out else time_s)


def headway_s(lead: DriveDraft, follow: DriveDraft, shared_m: float, from_m: float) -> float:
    """How much later than ``lead`` ``follow`` must be to keep its distance from a place on (s).

    At every place of their shared way from there on, its end at least, the follower's reference
    point comes two seconds after the leader's, and its bumper stays behind.
    """
    end = max(1.0, min(shared_m, float(follow.course.s_m[-1])))
    s = np.append(np.arange(min(from_m, end), end, 2.0), end)
    bodies = QUEUE_GAP_M + lead.body.rear_m + follow.body.front_m
    mine = follow.course.times_at(s)
    by_time = lead.course.times_at(s) + HEADWAY_S
    by_place = lead.course.times_at(s + bodies)
    return float(np.max(np.maximum(by_time, by_place) - mine))


def schedule(scene: Setup, meetings: Sequence[Meeting]) -> dict[str, float]:
    """Offsets on the scenario's clock.

    Everybody starts on its arm, before its first phase and before its first meeting; the ego
    has ``APPROACH_S`` until its own.
    """
    first_s = _first_places(scene, meetings)
    ego, waits = scene.ego, Waits.of(scene.drives.values())
    begins_s = 0.0 if ego.backs_out else ego.course.time_at(first_s[ego.id]) - APPROACH_S
    for _ in range(_ROUNDS):
        offsets = arrange(scene, meetings, begins_s)
        assumed_s, begins_s = begins_s, min([begins_s, *_latest_s(scene, offsets, first_s)])
        if begins_s >= assumed_s - _SAME_S:
            break
        waits.restore()
    return {name: offset - begins_s for name, offset in offsets.items()}


def _latest_s(
    scene: Setup, offsets: Mapping[str, float], first_s: Mapping[str, float]
) -> Iterator[float]:
    """When every drive must be under way at the latest, on the ego's timeline."""
    for name, draft in scene.drives.items():
        if draft.backs_out:
            # It stands near where it starts until its time has come.
            yield offsets[name]
        elif not (
            draft.stands
            or stands_at_red(scene.functional.participant(name))
            or scene.sets_off(name)
        ):
            places = [first_s[name], draft.junction_s_m - _BEFORE_JUNCTION_M]
            places += [mark.s_m for mark in draft.speed_changes() if mark.s_m > 0.5]
            places += [draft.laid.path_s_m(change.position_m) for change in draft.lane_changes]
            lead_in = draft.course.time_at(max(0.0, min(places))) - LEAD_IN_S
            yield offsets[name] + max(0.0, lead_in)


def shortfall(scene: Setup, offsets_s: Mapping[str, float]) -> tuple[float, str]:
    """By how much the arms are too short (m), and for whom."""
    short_m = {
        name: draft.body.rear_m + _ARM_MARGIN_M - draft.course.s_at(-offsets_s[name])
        for name, draft in scene.drives.items()
        if not draft.backs_out
    }
    who = max(short_m, key=lambda name: short_m[name], default="")
    return short_m.get(who, 0.0), who


def _first_places(scene: Setup, meetings: Sequence[Meeting]) -> dict[str, float]:
    """Where each drive has its first meeting, or the inner end of its arm."""
    places = {name: draft.arrives_s_m for name, draft in scene.drives.items()}
    for meeting in meetings:
        if meeting.priority < 0:
            continue
        places[meeting.first] = min(places[meeting.first], meeting.first_s_m)
        places[meeting.second] = min(places[meeting.second], meeting.second_s_m)
    return places

"""Right of way while starts are chosen: nobody is placed where it takes another's way.

Who has to give way waits at its line, or slows down before it, until the other has passed; where
that does not do, it is placed to come at another time.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import inf

from scegen.concretization.clearance import grounds_s
from scegen.concretization.drafts import DriveDraft, Wait
from scegen.concretization.limits import STOPS_FOR_S
from scegen.concretization.meetings import ORDINARY, Meeting
from scegen.concretization.setup import Setup
from scegen.motion.rules.giving_way import CLEAR_S, TOGETHER_S, Duty
from scegen.scenario.control import STOPS
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.vocabulary import Control

_ROOM_S = 0.3
"""More than a claim asks for: starts are rounded, and simulators step."""
_AFTER_S = 0.6
"""Who waits comes onto the ground so long after the other has left it: it looks at the other's
tail, and is quicker than the 1 to 2 s lost by the first at a light (``lights``); this program's own
choice."""
_MORE_S = 1e-3
_BRAKES_S = 0.6
"""So long at least it slows down."""
_LONGEST_S = 25.0
"""Nobody is let wait longer for others: of a stream somebody comes later instead."""


@dataclass(frozen=True)
class Manners:
    """What whoever is placed keeps to: its light, and the right of way of those placed before.

    The light is the scene's. ``duties`` are by the two whom they are between, ``patient`` those who
    may be let wait at their line.
    """

    scene: Setup
    duties: Mapping[frozenset[str], Duty]
    patient: frozenset[str]

    def settle(self, draft: DriveDraft, people: Sequence[DriveDraft]) -> bool:
        """Let those wait who would take another's way where a drive is as late as it is.

        Returns whether nobody takes another's way then.
        """
        changed = {draft.id}
        for _ in range(2 * len(people)):
            pairs = ((a, b) for a in people for b in people if a.id in changed and b is not a)
            taken = next(filter(None, (self._taken(one, two) for one, two in pairs)), None)
            if taken is None:
                return True
            late, other = taken
            if late.id not in self.patient or not self._lets_by(late, other):
                return False
            changed.add(late.id)
        return False

    def _taken(self, one: DriveDraft, two: DriveDraft) -> tuple[DriveDraft, DriveDraft] | None:
        """Who of two takes the other's way, and the other."""
        duty = self.duties.get(frozenset((one.id, two.id)))
        if duty is None:
            return None
        yields, other = (one, two) if duty.yields == one.id else (two, one)
        if duty.by_arrival and _rests_s(yields) < _rests_s(other) - TOGETHER_S - _ROOM_S:
            yields, other = other, yields
        return (yields, other) if self._takes_way(yields, other) else None

    def _takes_way(self, late: DriveDraft, other: DriveDraft) -> bool:
        """Whether one that gives way comes before the other is gone, and is not long gone."""
        later_s = late.offset_s - other.offset_s
        return any(
            later_s + own.enter_m < own.other_leaves_m + _ROOM_S
            and later_s + own.leave_m + CLEAR_S + _ROOM_S > own.other_enters_m
            for own in grounds_s(late, other)
        )

    def _lets_by(self, late: DriveDraft, other: DriveDraft) -> bool:
        """Let one wait until another is before it, and gone as it comes; whether it can."""
        before, late.waits = late.waits, Wait(STOPS_FOR_S)
        on, stop = late.course.going_on, late.course.stop
        again = on.begins_s if on is not None else inf
        stops_s = stop.begins_s if stop is not None else again
        rests_s = again - STOPS_FOR_S
        # One that would still come too soon waits until the other is gone.
        early = before is None or before.lets_by != other.id
        free_s = self._free_s(late, again if early else None, other) + other.offset_s
        wait_s = max(free_s - late.offset_s - rests_s, stops_s + _BRAKES_S - rests_s)
        if late.stops_at_line:
            wait_s = max(wait_s, STOPS_FOR_S)
        late.waits = Wait(wait_s, other.id)
        return (before is None or wait_s > before.time_s + _MORE_S) and wait_s < _LONGEST_S

    def _free_s(self, late: DriveDraft, again_s: float | None, other: DriveDraft) -> float:
        """When one may go on: the other is before it, and a little gone as it comes.

        If it does not go on at some time anyway, only as the other has left all that they share.
        """
        soonest = -inf
        for shared in grounds_s(late, other):
            comes, gone = shared.other_enters_m, shared.other_leaves_m
            if gone == inf:  # where both go on along one way, where it is ahead
                gone = comes + other.body.length_m / max(other.course.fastest_mps, 1.0)
            needs = 0.0 if again_s is None else shared.enter_m - again_s
            soonest = max(soonest, comes, gone + _AFTER_S - max(needs, 0.0))
        return soonest


def patient_ones(
    scene: Setup, meetings: Iterable[Meeting], duties: Iterable[Duty]
) -> frozenset[str]:
    """Those who may be let wait: who is said to, and of whom nothing is told nor whom they meet.

    Where the text asks for no danger and tells of no good end, a near miss with the ego is looked
    for: those who meet it do not wait.
    """
    functional = scene.functional
    asked = {d.yields for d in duties if d.rule is None and d.other in scene.drives}
    asked = {name for name in asked if name in scene.drives and _is_free(scene.drives[name])}
    if scene.road.control is Control.SIGNALS or functional.spacings:
        return frozenset(asked)
    outcome, ego = functional.outcome, functional.ego.id
    hazards = functional.hazards
    told = {name for h in hazards for name in (*h.by, *h.to)}
    near = outcome is None and not hazards
    if outcome is not None and outcome.kind is not OutcomeKind.AVOIDED:
        told |= {*outcome.between}
        near = len(outcome.between) < 2
    for meeting in meetings:
        pair = {meeting.first, meeting.second}
        if meeting.priority < ORDINARY or (near and ego in pair):
            told |= pair
    return frozenset(asked) | frozenset(
        draft.id
        for draft in scene.drives.values()
        if draft.id not in told
        and _is_free(draft)
        and not scene.acts_of(draft.id)
        and (scene.road.control in STOPS | {Control.YIELD} or not scene.has_said_speed(draft.id))
    )


def _is_free(draft: DriveDraft) -> bool:
    """Whether nothing else fixes how it comes to its line."""
    does = draft.marks or draft.steps or draft.reversal or draft.lane_changes
    stands = draft.stands or draft.drive.circulating
    return not (does or stands)


def _rests_s(draft: DriveDraft) -> float:
    """When a drive comes to rest at its line; never if it does not."""
    phase = draft.course.stop
    if phase is None:
        return inf
    return draft.offset_s + draft.course.profile.settles_s(phase.begins_s)

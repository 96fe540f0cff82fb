"""Lanes in which those meet whom the logical scenario or a danger says to meet.

The outermost lane is taken where nothing is said; where each then has a lane of its own, so that
a conflict is none, other lanes that lead to the same exits are looked at. Where two leave by one
arm and none of their lanes do, one of them moves over into the other's lane behind the junction.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

from scegen.concretization.drafts import DriveDraft, Setup
from scegen.concretization.hazards.rule import Rule, pairs
from scegen.concretization.lane_choice import routes_of
from scegen.concretization.meetings import ways_touch
from scegen.concretization.passing import change_length_m
from scegen.concretization.room import NeedsLongerArms
from scegen.motion.paths import END_MARGIN_M
from scegen.motion.routing import walk_route
from scegen.scenario.concrete import LaneChange
from scegen.scenario.functional import Hazard
from scegen.scenario.logical import ConflictKind
from scegen.scenario.vocabulary import JunctionKind, Maneuver

_MEETS = frozenset({ConflictKind.CROSSING, ConflictKind.MERGING})
_BEHIND_JUNCTION_M = 2.0
_SIDEWAYS = frozenset({Maneuver.LANE_CHANGE, Maneuver.OVERTAKE})


@dataclass(frozen=True, slots=True)
class _Lanes:
    """Lanes of a drive, as in the scenario files."""

    entry_lane: int
    ring_lane: int | None
    exit_lane: int

    @classmethod
    def of(cls, draft: DriveDraft) -> _Lanes:
        return cls(draft.entry_lane, draft.ring_lane, draft.exit_lane)

    def give(self, draft: DriveDraft) -> None:
        draft.entry_lane, draft.ring_lane = self.entry_lane, self.ring_lane
        draft.exit_lane = self.exit_lane


@dataclass(frozen=True, slots=True)
class _Couple:
    """Two from different arms who are to meet; in a danger, or only if nobody else does."""

    first: DriveDraft
    second: DriveDraft
    danger: bool = False
    last_resort: bool = False


def choose_lanes_that_meet(scene: Setup, rules: list[tuple[Rule, Hazard]]) -> None:
    """Change lanes where those who are to meet do not, and can: dangers first, then the ego's.

    Conflicts among others count only where nobody else meets; somebody moves over only for a
    danger, or where else nobody would meet at all.
    """
    if any(stand.standing.in_lane for stand in scene.stands.values()):
        return
    fixed = _bound_to_lanes(scene)
    apart: list[_Couple] = []
    met = False
    for couple in _wanted(scene, rules):
        if couple.last_resort and met:
            break
        if _meet(scene, couple.first, couple.second) or _change(scene, couple, fixed):
            fixed |= {couple.first.id, couple.second.id}
            met = True
        else:
            apart.append(couple)
    for couple in apart:
        if (couple.danger or not met) and _move_over(scene, couple, fixed):
            fixed |= {couple.first.id, couple.second.id}
            met = True


def _bound_to_lanes(scene: Setup) -> set[str]:
    """Those whose lanes follow from something else."""
    bound: set[str] = set()
    for draft in scene.drives.values():
        if draft.drive.beside is not None:
            bound |= {draft.id, draft.drive.beside}
        if draft.drive.maneuver in _SIDEWAYS:
            bound |= {d.id for d in scene.drives.values() if d.drive.entry == draft.drive.entry}
    return bound


def _wanted(scene: Setup, rules: list[tuple[Rule, Hazard]]) -> Iterator[_Couple]:
    """Who is to meet, the most important first."""
    for rule, hazard in rules:
        if rule.meets:
            for cause, sufferer in pairs(scene, hazard):
                if cause.drive.entry != sufferer.drive.entry:
                    yield _Couple(cause, sufferer, danger=True)
    ego = scene.functional.ego.id
    meeting = [c for c in scene.logical.conflicts if c.kind in _MEETS]
    for conflict in sorted(meeting, key=lambda c: ego not in {c.first, c.second}):
        if conflict.first in scene.drives and conflict.second in scene.drives:
            first, second = scene.drives[conflict.first], scene.drives[conflict.second]
            yield _Couple(first, second, last_resort=ego not in {first.id, second.id})


def _change(scene: Setup, couple: _Couple, fixed: set[str]) -> bool:
    """Give two drives lanes in which they meet, as few new ones as possible; whether there are."""
    first, second = couple.first, couple.second
    own = _Lanes.of(first), _Lanes.of(second)
    choices = [
        [lanes] if draft.id in fixed else [lanes, *_others(scene, draft, lanes)]
        for draft, lanes in zip((first, second), own, strict=True)
    ]
    ordered = sorted(product(*choices), key=lambda c: (c[0] != own[0]) + (c[1] != own[1]))
    for tried in ordered[1:]:
        for draft, lanes in zip((first, second), tried, strict=True):
            lanes.give(draft)
        if _meet(scene, first, second):
            _note(scene, first, own[0], second)
            _note(scene, second, own[1], first)
            return True
    own[0].give(first)
    own[1].give(second)
    return False


def _move_over(scene: Setup, couple: _Couple, fixed: set[str]) -> bool:
    """Let one of two who leave by one arm change into the other's lane there; whether it can.

    Rather not the ego: its way is the text's.
    """
    first, second = couple.first, couple.second
    ring = scene.road.kind is JunctionKind.ROUNDABOUT
    if ring or not scene.network.junctions or first.drive.exit != second.drive.exit:
        return False
    ends = {d.id: _end(scene, d) for d in (first, second)}
    orders = [(first, second), (second, first)]
    for draft, other in sorted(orders, key=lambda order: order[0] is scene.ego):
        lane = ends[other.id][0]
        if draft.id in fixed or draft.lane_changes or abs(lane - ends[draft.id][0]) != 1:
            continue
        change = LaneChange(
            position_m=round(ends[draft.id][1] + _BEHIND_JUNCTION_M, 3),
            length_m=round(change_length_m(draft.cruise_mps), 3),
            lane_after=lane,
        )
        if change.position_m + change.length_m > ends[draft.id][2] - END_MARGIN_M:
            over = change.position_m + change.length_m - ends[draft.id][2] + END_MARGIN_M
            raise NeedsLongerArms(over + 1.0, draft.id)
        draft.lane_changes.append(change)
        if _meet(scene, draft, other):
            reason = f"moves over behind the junction, so that its way and that of {other.id} meet"
            scene.note(f"{draft.id}.exit_lane", lane, reason, ends[draft.id][0])
            return True
        draft.lane_changes.clear()
    return False


def _end(scene: Setup, draft: DriveDraft) -> tuple[int, float, float]:
    """Lane in which a drive ends, where its exit arm begins on the way and where that ends, m."""
    own = _Lanes.of(draft)
    stretches, lane = walk_route(scene.network, draft.motion(), draft.id)
    draft.lay(scene.network)
    begins_m = draft.laid.turning_ends_m
    own.give(draft)
    draft.laid_, draft.course_ = None, None
    return lane, begins_m, stretches[-1].end_m


def _others(scene: Setup, draft: DriveDraft, own: _Lanes) -> list[_Lanes]:
    """The other lanes that lead to a drive's exit, outermost first."""
    found = {_Lanes(r.entry_lane, r.ring_lane, r.exit_lane) for r in routes_of(scene, draft)}
    return sorted(found - {own}, key=lambda o: (-o.entry_lane, -(o.ring_lane or 0), -o.exit_lane))


def _meet(scene: Setup, first: DriveDraft, second: DriveDraft) -> bool:
    """Whether their ways touch in the lanes that they have now; the lanes stay as they are."""
    own = _Lanes.of(first), _Lanes.of(second)
    for draft in (first, second):
        draft.lay(scene.network)
    touch = ways_touch(first, second)
    for draft, lanes in zip((first, second), own, strict=True):
        lanes.give(draft)
        draft.laid_, draft.course_ = None, None
    return touch


def _note(scene: Setup, draft: DriveDraft, before: _Lanes, other: DriveDraft) -> None:
    """Say which lanes were changed."""
    for name in ("entry_lane", "ring_lane", "exit_lane"):
        was, now = getattr(before, name), getattr(draft, name)
        if was != now and now is not None:
            reason = f"so that its way and that of {other.id} meet"
            scene.note(f"{draft.id}.{name}", now, reason, was)

"""From a solution to a logical scenario: names, ranks, conflicts, parameter ranges."""

from __future__ import annotations

from functools import lru_cache

from scegen.enumeration.conflicts import conflict_table, conflicts_of, shared_conflict
from scegen.enumeration.problem import Problem
from scegen.enumeration.ranges import offset_range, speed_range
from scegen.enumeration.ranks import queues
from scegen.enumeration.slugs import slug_of
from scegen.enumeration.solving import Solution
from scegen.scenario.arms import exit_arm, turn_name
from scegen.scenario.functional import Participant
from scegen.scenario.logical import (
    Assignment,
    Conflict,
    ConflictKind,
    Crossing,
    Drive,
    LogicalScenario,
    ParameterRange,
    Side,
    Standing,
)
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver

BLOCKING = frozenset({HazardKind.OBSTACLE, HazardKind.STOPPING})
"""Hazards by which a parked vehicle stands in the travelled lane."""
HIDING = BLOCKING | {HazardKind.OCCLUSION}

_MANNERS = {m.value: m for m in (Maneuver.LANE_CHANGE, Maneuver.OVERTAKE, Maneuver.STAY)}


@lru_cache(maxsize=65536)
def _drive(
    name: str, way: tuple[int, int, str], angles: tuple[float, ...], rank: int, beside: str | None
) -> Drive:
    """Equal drives of thousands of scenarios are one object."""
    entry, move, manner = way
    turn = turn_name(angles, entry, move)
    return Drive(
        participant=name,
        entry=entry,
        move=move,
        exit=exit_arm(entry, move, len(angles)),
        turn=turn,
        maneuver=_MANNERS.get(manner, turn),
        rank=rank,
        beside=beside,
    )


class Builder:
    """Makes the logical scenarios of one problem."""

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        self._functional = problem.functional
        self._table = conflict_table(problem.functional.junction)
        # Thousands of scenarios share these; they are made once.
        self._orders: dict[
            tuple[tuple[int, ...], tuple[tuple[str, str, str], ...]],
            tuple[dict[str, int], dict[str, str]],
        ] = {}
        self._speeds: dict[tuple[str, bool], ParameterRange] = {}
        self._offsets: dict[tuple[Assignment, Assignment], ParameterRange | None] = {}

    def scenario(self, solution: Solution, *, index: int, class_size: int) -> LogicalScenario:
        """The scenario that a solution describes."""
        assignments = self._assignments(solution)
        conflicts = tuple(shared_conflict(*met) for met in conflicts_of(self._table, assignments))
        return LogicalScenario(
            index=index,
            slug=slug_of(self._functional.junction, assignments),
            pattern=solution.pattern,
            class_size=class_size,
            assignments=assignments,
            conflicts=conflicts,
            parameters=self._parameters(assignments, conflicts),
        )

    def _assignments(self, solution: Solution) -> tuple[Assignment, ...]:
        problem = self._problem
        ranks, beside = self._order(solution)
        made: dict[str, Assignment] = {}
        for vehicle, way in zip(problem.vehicles, solution.drives, strict=True):
            name = vehicle.id
            made[name] = _drive(name, way, problem.angles_deg, ranks[name], beside.get(name))
        for crosser, (arm, side) in zip(problem.crossers, solution.crossings, strict=True):
            made[crosser.id] = Crossing(participant=crosser.id, arm=arm, start=Side(side))
        for participant in self._functional.participants:
            if participant.parked:
                made[participant.id] = self._standing(participant, made)
        return tuple(made[member.id] for member in self._functional.participants)

    def _order(self, solution: Solution) -> tuple[dict[str, int], dict[str, str]]:
        key = (tuple(entry for entry, _, _ in solution.drives), solution.places)
        if key not in self._orders:
            ranks: dict[str, int] = {}
            beside: dict[str, str] = {}
            for queue in queues(self._problem, solution):
                ranks |= queue.ranks() or {}
                beside |= queue.beside
            self._orders[key] = ranks, beside
        return self._orders[key]

    def _standing(self, parked: Participant, made: dict[str, Assignment]) -> Standing:
        """A parked vehicle stands on the arm where the one whom it hinders enters."""
        arm = next(
            found.entry
            for name in (*self._hindered_by(parked.id), self._functional.ego.id)
            if isinstance(found := made.get(name), Drive)
        )
        if parked.entries and arm not in parked.entries:
            arm = min(parked.entries)
        kerb = Side(self._functional.junction.driving_side.value)
        said = parked.approaches & {Approach.LEFT, Approach.RIGHT}
        side = Side(next(iter(said)).value) if len(said) == 1 else kerb
        blocks = any(h.kind in BLOCKING and parked.id in h.by for h in self._functional.hazards)
        return Standing(participant=parked.id, arm=arm, side=side, in_lane=blocks)

    def _hindered_by(self, name: str) -> list[str]:
        hindered = [
            sufferer
            for hazard in self._functional.hazards
            if hazard.kind in HIDING and name in hazard.by
            for sufferer in hazard.to
        ]
        return hindered + [r.reference for r in self._functional.relations if r.participant == name]

    def _parameters(
        self, assignments: tuple[Assignment, ...], conflicts: tuple[Conflict, ...]
    ) -> tuple[ParameterRange, ...]:
        ego = next(a for a in assignments if a.participant == self._functional.ego.id)
        met = {
            (c.second if c.first == ego.participant else c.first): c.kind
            for c in conflicts
            if ego.participant in {c.first, c.second}
        }
        speeds = [self._speed(a) for a in assignments if not isinstance(a, Standing)]
        offsets = [
            self._offset(ego, a, met.get(a.participant, ConflictKind.NONE))
            for a in assignments
            if a is not ego
        ]
        return (*speeds, *(offset for offset in offsets if offset is not None))

    def _speed(self, assignment: Assignment) -> ParameterRange:
        stays = isinstance(assignment, Drive) and assignment.maneuver is Maneuver.STAY
        key = (assignment.participant, stays)
        if key not in self._speeds:
            self._speeds[key] = speed_range(self._functional, assignment)
        return self._speeds[key]

    def _offset(
        self, ego: Assignment, other: Assignment, kind: ConflictKind
    ) -> ParameterRange | None:
        key = (ego, other)  # the two say how their paths meet
        if key not in self._offsets:
            self._offsets[key] = offset_range(self._functional, ego, other, kind)
        return self._offsets[key]

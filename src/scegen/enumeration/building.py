"""From a solution to a logical scenario: names, ranks, conflicts, parameter ranges."""

from __future__ import annotations

from scegen.enumeration.problem import Problem
from scegen.enumeration.ranks import queues
from scegen.enumeration.reading import Solution, Way
from scegen.enumeration.sharing import Kept, Share, Sharing, conflicts_among
from scegen.enumeration.slugs import MOST_SPELT_OUT, slug_of
from scegen.scenario.functional import Participant
from scegen.scenario.logical import Assignment, Crossing, Drive, LogicalScenario, Side, Standing
from scegen.scenario.vocabulary import Approach, HazardKind

MOST_ORDERS = 4096
"""Orders of arrival and slugs that are kept; a stream of millions must not fill the memory."""

Entries = tuple[tuple[int, ...], tuple[tuple[str, str, str], ...]]
"""Entries of the vehicles, and the places said of them."""
Order = list[Kept[Way, Share]]
"""The shares of every vehicle in its rank, by way."""

_FIELDS = set(LogicalScenario.model_fields)

BLOCKING = frozenset({HazardKind.OBSTACLE, HazardKind.STOPPING})
"""Hazards by which a parked vehicle stands in the travelled lane."""
HIDING = BLOCKING | {HazardKind.OCCLUSION}


class Builder:
    """Makes the logical scenarios of one problem."""

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        self._functional = problem.functional
        self._sharing = Sharing(problem)
        self._orders: dict[Entries, Order] = {}
        self._slugs: dict[tuple[int, ...], str] = {}

    def scenario(self, solution: Solution, *, index: int, class_size: int) -> LogicalScenario:
        """The scenario that a solution describes."""
        shares = self._shares(solution)
        pattern = solution.pattern
        # Every part was validated when it was made; to do so again takes longer than all the rest.
        return LogicalScenario.model_construct(
            _FIELDS,
            index=index,
            slug=self._slug(pattern, shares),
            pattern=pattern,
            class_size=class_size,
            assignments=tuple([share.assignment for share in shares]),
            conflicts=tuple(conflicts_among(shares)),
            deadlock=self._sharing.deadlock(shares),
            parameters=tuple(self._sharing.parameters(shares)),
        )

    def _shares(self, solution: Solution) -> list[Share]:
        """What everybody does, in the order of the description."""
        problem, sharing = self._problem, self._sharing
        rows = self._order(solution)
        made = [row[way] for row, way in zip(rows, solution.drives, strict=True)]
        if len(made) == len(self._functional.participants):
            return made
        names = [v.id for v in problem.vehicles]
        by_name = dict(zip(names, made, strict=True))
        for crosser, (arm, side) in zip(problem.crossers, solution.crossings, strict=True):
            by_name[crosser.id] = sharing.other(
                Crossing(participant=crosser.id, arm=arm, start=Side(side))
            )
        assignments = {name: share.assignment for name, share in by_name.items()}
        for participant in self._functional.participants:
            if participant.parked:
                by_name[participant.id] = sharing.other(self._standing(participant, assignments))
        return [by_name[member.id] for member in self._functional.participants]

    def _order(self, solution: Solution) -> Order:
        """The vehicles in the order in which they arrive, which entries and places decide."""
        key = (tuple([entry for entry, _, _ in solution.drives]), solution.places)
        found = self._orders.get(key)
        if found is None:
            ranks: dict[str, int] = {}
            beside: dict[str, str] = {}
            for queue in queues(self._problem, solution):
                ranks |= queue.ranks() or {}
                beside |= queue.beside
            found = [
                self._sharing.drives(slot, ranks[vehicle.id], beside.get(vehicle.id))
                for slot, vehicle in enumerate(self._problem.vehicles)
            ]
            if len(self._orders) >= MOST_ORDERS:
                self._orders.clear()
            self._orders[key] = found
        return found

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

    def _slug(self, pattern: tuple[int, ...], shares: list[Share]) -> str:
        """Of many drivers the slug tells the pattern alone, so there are few."""
        slug = self._slugs.get(pattern)
        if slug is None:
            slug = slug_of(self._functional.junction, tuple(s.assignment for s in shares))
            if len(pattern) <= MOST_SPELT_OUT:
                return slug
            if len(self._slugs) >= MOST_ORDERS:
                self._slugs.clear()
            self._slugs[pattern] = slug
        return slug

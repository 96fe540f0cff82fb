"""Vehicles that nothing said relates to another; they share only the room on the arms.

The solver lists the states of all others. How many ways there are to add the unrelated follows
from the room that a state leaves, so it is worked out once for equal room.
"""

import math
from collections import Counter

from scegen.enumeration.capacity import Kind, Room, Slot, placements, rows_of_placements
from scegen.enumeration.patterns import Row
from scegen.enumeration.problem import Problem, related_among
from scegen.enumeration.reading import COUNTED, Solution
from scegen.enumeration.sharing import Kept
from scegen.enumeration.statements import QUEUE_LIMIT, group_ways
from scegen.enumeration.symmetry import Symmetry


def unrelated_of(problem: Problem) -> frozenset[str]:
    """Vehicles about whose way and place nothing is said in relation to others."""
    if problem.settled:
        return frozenset()
    related = problem.dependent | related_among(problem.facts)
    return frozenset(v.id for v in problem.vehicles) - related


class Unrelated:
    """Adds the unrelated vehicles of a problem to states of the others."""

    def __init__(self, problem: Problem, symmetry: Symmetry, names: frozenset[str]) -> None:
        self.names = names
        self._problem = problem
        self._symmetry = symmetry
        self._kinds = [i for i, g in enumerate(symmetry.groups) if g.members[0] in names]
        self._counted = problem.functional.groups
        junction = problem.functional.junction
        self._does = [
            [group_ways(junction, group.maneuvers, entry) for entry in range(problem.arms)]
            for group in self._counted
        ]
        self._crowded = len(problem.vehicles) > QUEUE_LIMIT
        singles = [Kind(1, 1, self._slots(name, 0, 1)) for name in sorted(names)]
        self.assignments: Kept[Room, int] = Kept(lambda room: placements(singles, room))
        """Ways to add them, each told apart, by the room there is."""
        self.scenarios: Kept[tuple[Room, int], int] = Kept(lambda key: self._turned(*key))
        """Ways to add them, up to swaps, that turning by so many arms maps onto themselves."""
        self.rows: Kept[Room, dict[tuple[Row, ...], int]] = Kept(self._rows)
        """Ways to put them on the arms, by the rows of moves that they then choose from."""

    def _turned(self, room: Room, turn: int) -> int:
        around = Room(room.arms[: self._orbits(turn)], room.groups)
        return placements(self._carried_round(turn), around)

    def _orbits(self, turn: int) -> int:
        """How many arms a rotation leaves apart from one another."""
        return math.gcd(turn, self._problem.arms) if turn else self._problem.arms

    def _rows(self, room: Room) -> dict[tuple[Row, ...], int]:
        vehicles = [
            [
                (arm, uses, tuple(sorted(Counter(moves).items())))
                for arm in range(self._problem.arms)
                for uses, moves in self._moves(name, arm).items()
            ]
            for name in sorted(self.names)
        ]
        return rows_of_placements(vehicles, room)

    def room(self, state: Solution) -> Room:
        """What a state of the others leaves."""
        problem = self._problem
        queue = Counter[int]()
        left = [group.number for group in self._counted]
        for vehicle, way in zip(problem.vehicles, state.drives, strict=True):
            if vehicle.id in self.names:
                continue
            queue[way[0]] += 1
            if way[1] != COUNTED:
                uses = self._uses(vehicle.id, *way)
                left = [number - use for number, use in zip(left, uses, strict=True)]
        arms = range(problem.arms) if self._crowded else ()
        return Room(tuple(QUEUE_LIMIT - queue[arm] for arm in arms), tuple(left))

    def _carried_round(self, turn: int) -> list[Kind]:
        """The groups under a rotation: one of each cycle stands for all that it is carried to."""
        arms, images = self._problem.arms, self._symmetry.rotations[turn]
        orbits = self._orbits(turn)
        kinds, seen = [], set[int]()
        for first in self._kinds:
            cycle, group = 0, first
            while group not in seen:
                seen.add(group)
                cycle, group = cycle + 1, images[group]
            if cycle:
                members = self._symmetry.groups[first].members
                slots = self._slots(members[0], turn, cycle)
                kinds.append(Kind(len(members), arms // orbits // cycle, slots))
        return kinds

    def _slots(self, name: str, turn: int, cycle: int) -> tuple[Slot, ...]:
        """Where one may enter, and its choices there; a rotation makes arms one."""
        arms = self._problem.arms
        orbits = self._orbits(turn)
        carried = arms // orbits
        return tuple(
            Slot(orbit, tuple(use * carried for use in uses), len(moves))
            for orbit in range(orbits)
            for step in range(cycle)
            for uses, moves in self._moves(name, (orbit + turn * step) % arms).items()
        )

    def _moves(self, name: str, arm: int) -> dict[tuple[int, ...], list[int]]:
        """What one may choose at an arm (moves, one for each manner), by the groups it uses up."""
        found: dict[tuple[int, ...], list[int]] = {}
        if arm in self._problem.entries.get(name, (arm,)):
            for move, manner in self._problem.wanted.get((name, arm), ()):
                found.setdefault(self._uses(name, arm, move, manner), []).append(move)
        return found

    def _uses(self, name: str, arm: int, move: int, manner: str) -> tuple[int, ...]:
        return tuple(
            int(name in group.members and (move, manner) in does[arm])
            for group, does in zip(self._counted, self._does, strict=True)
        )

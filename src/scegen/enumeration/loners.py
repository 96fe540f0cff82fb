"""Loners: vehicles that nothing said ties to another; they share only the room on the arms.

The solver lists the states of all others. How many ways there are to add the loners follows from
the room that a state leaves, so it is worked out once for equal room.
"""

from __future__ import annotations

import math
from collections import Counter
from functools import cached_property

from scegen.enumeration import predicates as p
from scegen.enumeration.patterns import Row
from scegen.enumeration.problem import Problem
from scegen.enumeration.programs import Part
from scegen.enumeration.reading import Solution
from scegen.enumeration.rooms import Kind, Room, placements, rows_of_placements
from scegen.enumeration.solving import Space
from scegen.enumeration.statements import QUEUE_LIMIT
from scegen.enumeration.symmetry import Symmetry

_JOINED = frozenset({"behind", "ahead", "together"})
"""Demands of hazards that put two on one arm; "into" may."""


def loners_of(space: Space) -> frozenset[str]:
    """Vehicles about whose way and place nothing is said in relation to others.

    There are none where the program itself put the vehicles on the arms, or where what is said
    crowds them: then who stands where matters to all.
    """
    if Part.BALANCE not in space.parts or space.crowding:
        return frozenset()
    related = set(space.problem.tied)
    for fact in space.problem.facts:
        if isinstance(fact, p.Approach):
            related |= {fact.id, fact.reference}
    return frozenset(v.id for v in space.problem.vehicles) - related


class Loners:
    """Adds the loners of a problem to states of the others."""

    def __init__(self, problem: Problem, symmetry: Symmetry, names: frozenset[str]) -> None:
        self.names = names
        self._problem = problem
        self._symmetry = symmetry
        self._groups = [i for i, g in enumerate(symmetry.groups) if g.members[0] in names]
        self._limited = {name for name in problem.entries if name in names}
        self._assignments: dict[Room, int] = {}
        self._scenarios: dict[tuple[Room, int], int] = {}
        self._rows: dict[Room, dict[tuple[Row, ...], int]] = {}

    def assignments(self, room: Room) -> int:
        """Ways to add them, each told apart."""
        if room not in self._assignments:
            self._assignments[room] = placements(self._singles, room)
        return self._assignments[room]

    def scenarios(self, room: Room, turn: int) -> int:
        """Ways to add them, up to swaps, that turning by so many arms maps onto themselves."""
        key = room, turn
        if key not in self._scenarios:
            places = range(math.gcd(turn, len(room)) if turn else len(room))
            around = tuple(room[place] for place in places)
            self._scenarios[key] = placements(self._carried_round(turn), around)
        return self._scenarios[key]

    def rows(self, room: Room) -> dict[tuple[Row, ...], int]:
        """Ways to put them on the arms, by the rows of moves that they then choose from."""
        if room not in self._rows:
            arms = range(self._problem.arms)
            vehicles = [
                (name in self._limited, tuple(self._row(name, arm) for arm in arms))
                for name in sorted(self.names)
            ]
            self._rows[room] = rows_of_placements(vehicles, room)
        return self._rows[room]

    def room(self, state: Solution) -> Room:
        """What a state of the others leaves: the fair share of leaders, and the queue's end.

        The fair share binds where somebody stands whose entry the text leaves open (balance.lp).
        """
        problem = self._problem
        attached = self._attached(state)
        leaders, queue, shared = Counter[int](), Counter[int](), set[int]()
        for vehicle, (entry, _, _) in zip(problem.vehicles, state.drives, strict=True):
            if vehicle.id in self.names:
                continue
            queue[entry] += 1
            if vehicle.id not in attached:
                leaders[entry] += 1
                if vehicle.id not in problem.entries:
                    shared.add(entry)
        room = []
        for arm in range(problem.arms):
            end = QUEUE_LIMIT - queue[arm]
            fair = max(min(problem.fair_share - leaders[arm], end), 0)
            room.append((fair if arm in shared else end, fair))
        return tuple(room)

    def _attached(self, state: Solution) -> set[str]:
        """Those whom the text puts on the arm of another who is listed before them."""
        problem = self._problem
        entry = {v.id: d[0] for v, d in zip(problem.vehicles, state.drives, strict=True)}
        pairs = [
            (d.by, d.to)
            for d in problem.demands
            if d.what in _JOINED or (d.what == "into" and entry[d.by] == entry[d.to])
        ]
        pairs += [(name, reference) for name, reference, _ in state.places]
        leader = {vehicle.id: vehicle.id for vehicle in problem.vehicles}
        first = {name: place for place, name in enumerate(problem.names)}
        for one, other in pairs:
            low, high = sorted((leader[one], leader[other]), key=first.__getitem__)
            leader = {name: low if led == high else led for name, led in leader.items()}
        return {name for name, led in leader.items() if led != name}

    @cached_property
    def _singles(self) -> list[Kind]:
        arms = range(self._problem.arms)
        return [
            Kind(
                1, 1, tuple((arm, self._choices(name, arm)) for arm in arms), name in self._limited
            )
            for name in sorted(self.names)
        ]

    def _carried_round(self, turn: int) -> list[Kind]:
        """The groups under a rotation: one of each cycle stands for all that it is carried to."""
        arms, images = self._problem.arms, self._symmetry.rotations[turn]
        orbits = math.gcd(turn, arms) if turn else arms
        kinds, seen = [], set[int]()
        for first in self._groups:
            cycle, group = 0, first
            while group not in seen:
                seen.add(group)
                cycle, group = cycle + 1, images[group]
            if cycle:
                members = self._symmetry.groups[first].members
                slots = tuple(
                    (orbit, self._choices(members[0], (orbit + turn * step) % arms))
                    for orbit in range(orbits)
                    for step in range(cycle)
                )
                share = arms // orbits // cycle
                kinds.append(Kind(len(members), share, slots, members[0] in self._limited))
        return kinds

    def _choices(self, name: str, arm: int) -> int:
        return sum(manners for _, manners in self._row(name, arm) or ())

    def _row(self, name: str, arm: int) -> Row | None:
        """(move, number of manners) that a loner may choose at an arm, None if it may not enter."""
        wanted = self._problem.wanted.get((name, arm), ())
        if arm not in self._problem.entries.get(name, (arm,)) or not wanted:
            return None
        return tuple(sorted(Counter(move for move, _ in wanted).items()))

"""Counting without listing: how many assignments, how many scenarios, how large each class.

The solver lists *states*: entries, and the moves of those whose moves matter to others. All
other moves are independent, so a state stands for a product: c cars at an arm with a choices
each make a**c assignments, or C(c+a-1, c) if the cars are interchangeable. Vehicles that nothing
relates to others are not in the states at all, but added by the room that a state leaves.
Rotations divide by Burnside's lemma: the number of classes is the mean number of scenarios that a
rotation fixes.
"""

import math
from collections import Counter
from collections.abc import Hashable
from dataclasses import dataclass, field
from functools import cached_property

from scegen.enumeration.capacity import Room
from scegen.enumeration.class_sizes import Choice, Chosen, ClassSizes, arrangements
from scegen.enumeration.patterns import Polynomial, Row, product
from scegen.enumeration.problem import Problem
from scegen.enumeration.reading import COUNTED, Solution
from scegen.enumeration.solving import states
from scegen.enumeration.symmetry import Symmetry
from scegen.enumeration.unrelated import Unrelated, unrelated_of
from scegen.errors import InputError
from scegen.scenario.vocabulary import Reduction

MAX_STATES = 200_000
"""More states than this are not counted: it would take minutes."""


@dataclass
class Census:
    """Sums over all states.

    ``fixed[r]`` is the number of scenarios, up to swaps, that turning by r arms maps onto
    themselves. ``placed`` sums the assignments of entries by the room that they leave to the
    unrelated, the choices that they leave to the independent vehicles (one row each), and the
    dependent moves.
    """

    problem: Problem
    symmetry: Symmetry
    total: int = 0
    states: int = 0
    fixed: Counter[int] = field(default_factory=Counter)
    unrelated: Unrelated | None = None
    anchor: str | None = None
    placed: Counter[tuple[Room, tuple[Row, ...], tuple[int, ...]]] = field(default_factory=Counter)

    def __post_init__(self) -> None:
        slot = {name: place for place, name in enumerate(self.problem.names)}
        slots = [[slot[name] for name in g.members] for g in self.symmetry.groups]
        self._sizes = ClassSizes(self.symmetry, self.problem.arms, slots)

    def count(self, reduction: Reduction) -> int:
        """Number of scenarios under a reduction."""
        if reduction is Reduction.NONE:
            return self.total
        if reduction is Reduction.EXACT:
            return sum(self.fixed.values()) // len(self.symmetry.rotations)
        same = self._one_row()
        if same is not None:
            row, number, _ = same
            return math.comb(number + len(row) - 1, number)
        return len(self._patterns)

    def class_size(self, reduction: Reduction, solution: Solution) -> int:
        """Number of assignments that the reduction holds to be this scenario."""
        if reduction is Reduction.NONE:
            return 1
        if reduction is Reduction.EXACT:
            return self._sizes.of(self._made(solution))
        counts = Counter(move for _, move, _ in solution.drives)
        same = self._one_row()
        if same is None:
            return self._patterns[tuple(counts[d] for d in range(self.problem.arms))]
        row, number, entries = same
        ways = math.factorial(number)
        for move, manners in row:
            ways = ways // math.factorial(counts[move]) * manners ** counts[move]
        return ways * entries

    def class_key(self, reduction: Reduction, solution: Solution) -> Hashable:
        """Equal for two assignments exactly if the reduction holds them to be one scenario."""
        if reduction is Reduction.NONE:
            return solution
        if reduction is Reduction.PATTERN:
            return solution.pattern
        return self._sizes.key(self._made(solution))

    @cached_property
    def loose(self) -> Counter[tuple[tuple[Row, ...], tuple[int, ...]]]:
        """The assignments of entries by rows and dependent moves, with the unrelated."""
        if self.unrelated is None:
            return Counter({(rows, tied): n for (_, rows, tied), n in self.placed.items()})
        out: Counter[tuple[tuple[Row, ...], tuple[int, ...]]] = Counter()
        for (room, rows, tied), number in self.placed.items():
            for more, ways in self.unrelated.rows[room].items():
                out[tuple(sorted((*rows, *more))), tied] += number * ways
        return out

    def _one_row(self) -> tuple[Row, int, int] | None:
        """If all vehicles choose from the same moves everywhere: the row, vehicles, entries."""
        rows = {row for key, tied in self.loose for row in key}
        if len(rows) != 1 or any(sum(tied) for _, tied in self.loose):
            return None
        return next(iter(rows)), len(self.problem.vehicles), sum(self.loose.values())

    @cached_property
    def _patterns(self) -> Polynomial:
        return product(self.loose)

    def _made(self, solution: Solution) -> tuple[Choice, ...]:
        """What everybody chose, and the places of those who have several to choose from."""
        if not self.problem.open_places:
            return (*solution.drives, *solution.on_foot)
        stances = dict.fromkeys(self.problem.names, "none")
        open_pairs = set(self.problem.open_places)
        stances |= {v: word for v, ref, word in solution.places if (v, ref) in open_pairs}
        vehicles = zip(self.problem.vehicles, solution.drives, strict=True)
        stands = [(*drive, stances[vehicle.id]) for vehicle, drive in vehicles]
        return (*stands, *solution.on_foot)

    def _turned(self, chosen: Chosen, turn: int) -> Counter[tuple[int, Choice]]:
        images, arms = self.symmetry.rotations[turn], self.problem.arms
        return Counter(
            (images[group], ((int(choice[0]) + turn) % arms, *choice[1:]))
            for group, members in enumerate(chosen)
            for choice in members
        )

    def add(self, state: Solution) -> None:
        """Add what one state stands for."""
        chosen = self._sizes.groups(self._made(state))
        room = Room((), ())
        alone, ways = frozenset[str](), 1
        if self.unrelated is not None:
            room, alone = self.unrelated.room(state), self.unrelated.names
            ways = self.unrelated.assignments[room]
            groups = zip(self.symmetry.groups, chosen, strict=True)
            chosen = tuple(() if g.members[0] in alone else choices for g, choices in groups)
        rows = [
            self._row(vehicle.id, entry)
            for vehicle, (entry, move, _) in zip(self.problem.vehicles, state.drives, strict=True)
            if move == COUNTED and vehicle.id not in alone
        ]
        turned = 1 if self.anchor is None else len(self.symmetry.rotations)
        labelled = turned * math.prod(arrangements(members) for members in chosen)
        self.states += 1
        self.total += labelled * ways * math.prod(sum(n for _, n in row) for row in rows)
        moves = Counter(move for _, move, _ in state.drives if move != COUNTED)
        tied = tuple(moves[d] for d in range(self.problem.arms))
        self.placed[room, tuple(sorted(rows)), tied] += labelled
        # Every rotation but 0 moves one who is one of a kind: it fixes nothing.
        for turn in self.symmetry.rotations if self.symmetry.anchor is None else [0]:
            fixed = self._fixed_by(chosen, turn)
            if fixed and self.unrelated is not None:
                fixed *= self.unrelated.scenarios[room, turn]
            self.fixed[turn] += turned * fixed

    def _row(self, vehicle: str, entry: int) -> Row:
        """(move, number of manners) that a vehicle may choose at an entry."""
        found = Counter(move for move, _ in self.problem.wanted.get((vehicle, entry), ()))
        return tuple(sorted(found.items()))

    def _fixed_by(self, chosen: Chosen, turn: int) -> int:
        """Scenarios in a state, up to swaps, that the rotation maps onto themselves.

        The members at a cell choose a multiset; cells on one cycle must choose alike.
        """
        cells = self._turned(chosen, 0)
        if turn and self._turned(chosen, turn) != cells:
            return 0
        ways, seen = 1, set[Hashable]()
        images, arms = self.symmetry.rotations[turn], self.problem.arms
        for first, members in cells.items():
            group, choice = first
            if first in seen or choice[1] != COUNTED:
                continue
            name = self.symmetry.groups[group].members[0]
            options = len(self.problem.wanted[name, int(choice[0])])
            ways *= math.comb(members + options - 1, members)
            cell = first
            while cell not in seen:
                seen.add(cell)
                group, choice = cell
                cell = (images[group], ((int(choice[0]) + turn) % arms, *choice[1:]))
        return ways


def census_of(problem: Problem, symmetry: Symmetry) -> Census:
    """Go through all states.

    Raises:
        InputError: there are too many states to count.
    """
    alone = unrelated_of(problem)
    anchor = symmetry.anchor_among(set(problem.names) - alone)
    unrelated = Unrelated(problem, symmetry, alone) if alone else None
    out = Census(problem, symmetry, unrelated=unrelated, anchor=anchor)
    for state in states(problem, symmetry, anchor=anchor, without=alone):
        if out.states >= MAX_STATES:
            raise InputError(
                f"more than {MAX_STATES:,} ways to place the participants on the arms: "
                "too many to count",
                where="participants",
                hint="Say more about where they come from, or describe fewer different ones.",
            )
        out.add(state)
    return out

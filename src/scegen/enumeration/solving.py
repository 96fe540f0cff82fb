"""From a problem to solutions: which encodings and facts each question takes."""

from collections.abc import Iterator
from itertools import pairwise

from clorm import Predicate
from clorm.clingo import Control

from scegen.enumeration import predicates as p
from scegen.enumeration.problem import Problem
from scegen.enumeration.programs import PROBLEM_PARTS, Part, grounded, satisfiable
from scegen.enumeration.reading import COUNTED, Solution, read_solutions
from scegen.enumeration.symmetry import Symmetry
from scegen.scenario.vocabulary import Reduction

ABOUT_ONE = (p.Vehicle, p.Position, p.Entries, p.Entry, p.Maneuvers, p.Wants, p.WantsMove)
"""Facts about one participant that nobody else is concerned by."""

_AT_RANDOM = ("--rand-freq=1", "--sign-def=rnd", "--restart-on-model", "--enum-mode=record")


def has_solution(problem: Problem) -> bool:
    """Whether there is an assignment that satisfies a problem."""
    if problem.settled:
        return True
    # Where a group counts its members, everybody's move matters to whether there is a solution.
    deciding = problem.names if problem.functional.groups else sorted(problem.dependent)
    decides = (p.Decides(name) for name in deciding)
    return satisfiable(grounded((*problem.facts, *decides), PROBLEM_PARTS))


def solutions(
    problem: Problem, symmetry: Symmetry, reduction: Reduction, *, limit: int = 0
) -> Iterator[Solution]:
    """Every scenario once, in rising order; ``limit`` 0 means all."""
    control = listing_program(problem, symmetry, reduction)
    yield from read_solutions(problem, control, limit=limit)


def listing_program(
    problem: Problem, symmetry: Symmetry, reduction: Reduction, *, at_random: bool = False
) -> Control:
    """The grounded program whose answer sets are the scenarios, in order or at random."""
    facts = [*problem.facts, *(p.Decides(v.id) for v in problem.vehicles)]
    parts = [*PROBLEM_PARTS]
    options = list(_AT_RANDOM)
    if not at_random:
        parts.append(Part.ORDER)
        options = ["--heuristic=Domain"]
    if reduction is Reduction.PATTERN:
        facts += _trade_facts(problem)
        parts.append(Part.PATTERN)
        options.append("--project=project")
    elif reduction is Reduction.EXACT:
        facts += group_facts(problem, symmetry)
        parts.append(Part.INTERCHANGEABLE)
        if len(symmetry.rotations) > 1:
            facts += _rotation_facts(problem, symmetry)
            parts.append(Part.ROTATIONS)
    return grounded(facts, parts, *options)


def states(
    problem: Problem,
    symmetry: Symmetry,
    *,
    anchor: str | None = None,
    without: frozenset[str] = frozenset(),
) -> Iterator[Solution]:
    """Every choice of entries, tied moves and crossings, up to swaps of interchangeable ones.

    What is left open are the independent moves, which counting multiplies in, and everything
    about the vehicles named in ``without``, whose entries are set to no arm. With an anchor a
    state stands for as many as there are rotations: one of each turned set.
    """
    if problem.settled:
        yield Solution(
            tuple((problem.entries[v.id][0], COUNTED, "none") for v in problem.vehicles), (), ()
        )
        return
    facts = [f for f in problem.facts if not isinstance(f, ABOUT_ONE) or f.id not in without]
    facts += group_facts(problem, symmetry)
    facts += [p.Decides(name) for name in sorted(problem.dependent)]
    parts = [*PROBLEM_PARTS, Part.INTERCHANGEABLE, Part.STATE]
    if anchor is not None:
        facts += [p.Anchor(anchor), *(p.Rotation(turn) for turn in symmetry.rotations if turn)]
        parts.append(Part.ROTATIONS)
    yield from read_solutions(problem, grounded(facts, parts))


def group_facts(problem: Problem, symmetry: Symmetry) -> list[Predicate]:
    """Members of each group in a row."""
    facts: list[Predicate] = [p.OpenPlace(*pair) for pair in problem.open_places]
    for group in symmetry.groups:
        facts += [p.Next(first, second) for first, second in pairwise(group.members)]
    return facts


def _rotation_facts(problem: Problem, symmetry: Symmetry) -> list[Predicate]:
    facts: list[Predicate] = [p.Rotation(turn) for turn in symmetry.rotations if turn]
    if symmetry.anchor is not None:
        return [*facts, p.Anchor(symmetry.anchor)]
    cells: dict[tuple[int, int, int, str], int] = {}
    for index, group in enumerate(symmetry.groups):
        facts.append(p.Size(index, len(group.members)))
        facts += [p.Member(name, index) for name in group.members]
    for entry in range(problem.arms):
        for index, group in enumerate(symmetry.groups):
            if group.entries is None or entry in group.entries:
                for move, manner in problem.wanted.get((group.members[0], entry), ()):
                    cells[index, entry, move, manner] = len(cells)
    facts += [p.Cell(cell, *key) for key, cell in cells.items()]
    for turn, images in symmetry.rotations.items():
        if turn:
            facts += [
                p.Turned(turn, cell, cells[images[g], (e + turn) % problem.arms, d, m])
                for (g, e, d, m), cell in cells.items()
            ]
    return facts


def _trade_facts(problem: Problem) -> list[Predicate]:
    """Vehicles may trade moves if they are free of each other and have the same to choose from.

    Of whom a group counts some, the manner counts, too: who changes lanes does not "turn left".
    """
    last: dict[tuple[frozenset[tuple[int, str]], frozenset[int]], str] = {}
    facts: list[Predicate] = []
    for vehicle in problem.vehicles:
        own = frozenset(
            i for i, g in enumerate(problem.functional.groups) if vehicle.id in g.members
        )
        per_entry = {
            frozenset(
                (move, manner if own else "")
                for move, manner in problem.wanted.get((vehicle.id, entry), ())
            )
            for entry in problem.entries.get(vehicle.id, range(problem.arms))
        }
        if vehicle.id in problem.dependent or len(per_entry) != 1:
            continue
        key = per_entry.pop(), own
        if key in last:
            facts.append(p.Trades(last[key], vehicle.id))
        last[key] = vehicle.id
    return facts

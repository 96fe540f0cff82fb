"""Who arrives first at an arm, and who travels beside whom."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise, permutations, product

from scegen.enumeration import predicates as p
from scegen.enumeration.directions import lanes_told
from scegen.enumeration.on_foot import ALONG
from scegen.enumeration.problem import Problem
from scegen.enumeration.reading import Solution
from scegen.enumeration.statements import ALONG_WORDS
from scegen.scenario.acts import SLOWING
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.in_line import is_ahead_at_first
from scegen.scenario.spacings import START, Measure
from scegen.scenario.vocabulary import Approach, Maneuver, Side

_IN_LINE = frozenset({"ahead", "behind"})
_FAR = frozenset({Measure.GAP_M, Measure.HEADWAY_S})


@dataclass
class Queue:
    """The vehicles of one entry arm, with what is known of their order."""

    names: list[str]
    after: dict[str, set[str]] = field(default_factory=dict)
    beside: dict[str, tuple[str, Side]] = field(default_factory=dict)

    def ranks(self) -> dict[str, int] | None:
        """Rank by name: as said, otherwise in listing order; those side by side share one.

        Of several beside one who are said to follow each other, the first that is listed does.
        None if what is said goes round in a circle.
        """
        rows = [[name] for name in self.names]
        for name, (reference, _) in self.beside.items():
            row = next(row for row in rows if name in row)
            other = next(row for row in rows if reference in row)
            if row is not other and not self._in_line(row, other):
                first, second = sorted((row, other), key=rows.index)
                first += second
                rows.remove(second)
        ranks: dict[str, int] = {}
        for rank in range(len(rows)):
            row = next((row for row in rows if self._may_go(row, ranks)), [])
            if not row:
                return None
            rows.remove(row)
            ranks |= dict.fromkeys(row, rank)
        return ranks

    def put_before(self, first: str, second: str) -> None:
        """Let one go before another if nothing else that is said forbids it."""
        waiting = self.after.setdefault(second, set())
        if first not in waiting:
            waiting.add(first)
            if self.ranks() is None:
                waiting.remove(first)

    def come_from_behind(self, name: str) -> None:
        """Let one who is to pass somebody have somebody ahead or beside, if the words allow it."""
        ranks = self.ranks() or {}
        foremost = [other for other, rank in ranks.items() if rank == 0]
        if foremost == [name] and len(ranks) > 1:
            self.put_before(next(other for other in ranks if other != name), name)

    def _in_line(self, row: list[str], other: list[str]) -> bool:
        """Whether one of a row is said to follow one of the other."""
        follows = self.after.get
        return any(a in follows(b, ()) or b in follows(a, ()) for a in row for b in other)

    def _may_go(self, row: list[str], ranks: dict[str, int]) -> bool:
        waiting_for = set[str]().union(*(self.after.get(name, set()) for name in row))
        return all(name in ranks for name in waiting_for & set(self.names))


def queues(problem: Problem, solution: Solution) -> list[Queue]:
    """One queue for each arm in whose lanes somebody comes or stands."""
    entry_of = {v.id: d[0] for v, d in zip(problem.vehicles, solution.drives, strict=True)}
    names = {
        arm: [n for n, entry in entry_of.items() if entry == arm] for arm in range(problem.arms)
    }
    for walker, (arm, way) in zip(problem.crossers, solution.on_foot, strict=True):
        if in_entering_lane(problem, way):
            entry_of[walker.id] = arm
            names[arm].insert(0, walker.id)  # where nothing is said, the others come up to it
    found = {arm: Queue(members) for arm, members in names.items() if members}
    for name, reference, word in _sayings(problem, solution):
        if entry_of.get(name) is None or entry_of.get(name) != entry_of.get(reference):
            continue
        queue = found[entry_of[name]]
        if word == Approach.BEHIND:
            queue.after.setdefault(name, set()).add(reference)
        elif word == Approach.AHEAD:
            queue.after.setdefault(reference, set()).add(name)
        else:
            queue.beside[name] = reference, Side(word.removeprefix("adjacent_"))
    circulating = {v.id for v in problem.vehicles if v.circulating}
    for queue in found.values():
        inside = [name for name in queue.names if name in circulating]
        after = [name for name in queue.names if name not in circulating]
        for first, second in (
            *product(inside, after),
            *_by_distance(problem.functional, queue.names),
        ):
            queue.put_before(first, second)
        for name in queue.names:
            if problem.functional.participant(name).maneuvers == {Maneuver.OVERTAKE}:
                queue.come_from_behind(name)
    return list(found.values())


def in_entering_lane(problem: Problem, way: str) -> bool:
    """Whether one who goes this way on foot is in a lane of those who enter on the arm."""
    along = ALONG.get(way)
    kerb = problem.functional.junction.kerb
    return along is not None and along.in_lane and along.side is kerb


def _sayings(problem: Problem, solution: Solution) -> list[tuple[str, str, str]]:
    """(participant, reference, word): places chosen, said of those on foot, demanded by dangers."""
    implied = {"behind": Approach.BEHIND, "ahead": Approach.AHEAD, "into": Approach.AHEAD}
    hazards = [(d.by, d.to, implied[d.what].value) for d in problem.demands if d.what in implied]
    drivers = {v.id for v in problem.vehicles}
    on_foot = [
        (f.id, f.reference, f.word)
        for f in problem.facts
        if isinstance(f, p.Says) and f.id not in drivers and f.word in ALONG_WORDS
    ]
    return [*solution.places, *on_foot, *hazards]


def _by_distance(functional: FunctionalScenario, names: list[str]) -> list[tuple[str, str]]:
    """(earlier, later) of those of whom it is said how far from one they are in their lane."""
    still = {START, *(act.id for act in functional.acts if act.kind in SLOWING)}
    places: dict[tuple[Measure, str], list[tuple[float, str]]] = {}
    for told in (s for s in functional.spacings if s.measure in _FAR and s.at in still):
        for who, other in permutations((told.participant, told.reference)):
            behind = is_ahead_at_first(functional, who, other) is False
            far = -told.value.middle if behind else told.value.middle
            places.setdefault((told.measure, other), []).append((far, who))
    files = (sorted(told, reverse=True) for told in places.values())
    lines = ([name for _, name in file if name in names] for file in files)
    return [pair for line in lines for pair in pairwise(line)]


def lanes_of(
    problem: Problem, solution: Solution, beside: Mapping[str, tuple[str, Side]]
) -> dict[str, int]:
    """The lanes that are said, and those that follow from them for others in line and beside."""
    people = problem.functional.participants
    told = {v.id: lanes_told(problem.functional, v) for v in people}
    lanes = {name: min(those) for name, those in told.items() if len(those) == 1}
    if not lanes:
        return lanes
    kerb = problem.functional.junction.kerb
    off = [(name, other, 1 if side is kerb else -1) for name, (other, side) in beside.items()]
    off += [(name, other, 0) for name, other, word in solution.places if word in _IN_LINE]
    off += [(other, name, -by) for name, other, by in off]
    for _ in off:
        for name, other, by in off:
            if other in lanes and name not in lanes:
                lanes[name] = lanes[other] + by
    return lanes

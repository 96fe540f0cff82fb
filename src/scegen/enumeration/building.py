"""From a solution to a logical scenario: names, ranks, conflicts, parameter ranges."""

from collections import Counter
from typing import Any

from scegen.enumeration import predicates as p
from scegen.enumeration.arrival import lanes_of, queues
from scegen.enumeration.on_foot import ALONG, CROSSINGS, Place, assignment_of
from scegen.enumeration.parking import standing
from scegen.enumeration.problem import Problem
from scegen.enumeration.ranges import said_numbers
from scegen.enumeration.reading import Solution, Way
from scegen.enumeration.resolving import act_resolver, hazard_resolver
from scegen.enumeration.sharing import Kept, Share, Sharing, conflicts_among
from scegen.scenario.arms import ring_move
from scegen.scenario.functional import Participant
from scegen.scenario.junction import Junction
from scegen.scenario.logical import Assignment, Crossing, Drive, LogicalScenario
from scegen.scenario.vocabulary import JunctionKind, Maneuver, Side

MOST_ORDERS = 4096
"""Orders of arrival and slugs that are kept; a stream of millions must not fill the memory."""

Choice = Way | tuple[int, str] | None
"""Of one who drives, of one who crosses, of one who is parked."""
Row = Kept[Any, Share]
"""The shares of one participant, by choices of its own kind."""
Entries = tuple[tuple[int, ...], tuple[tuple[str, str, str], ...], tuple[tuple[int, str], ...]]
"""Entries of the vehicles, if there are several, the places said of them, and who is on foot."""

_FIELDS = set(LogicalScenario.model_fields)
MAX_LENGTH = 40
MOST_SPELT_OUT = 4


class Builder:
    """Makes the logical scenarios of one problem, of shares that many of them have in common."""

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        self._functional = problem.functional
        self._sharing = Sharing(problem)
        self._orders: dict[Entries, list[Row]] = {}
        self._slugs: dict[tuple[int, ...], str] = {}
        members = [member.id for member in self._functional.participants]
        listed = {name: place for place, name in enumerate(problem.names)}
        # The last place holds the None of those who are parked.
        self._places = [listed.get(name, -1) for name in members]
        # Who walks or stands along an arm has a rank; who crosses is hidden by who is parked there.
        self._by_ways = any(
            isinstance(fact, p.OnFoot) and fact.way in ALONG for fact in problem.facts
        ) or any(member.parked for member in self._functional.participants)
        self._one_order = all(len(problem.entries.get(v.id, ())) == 1 for v in problem.vehicles)
        self._hazards = hazard_resolver(self._functional, problem.sides)
        self._acts = act_resolver(self._functional)
        self._numbers = said_numbers(self._functional)
        self._ego = members.index(self._functional.ego.id)

    def scenario(self, solution: Solution, *, index: int, class_size: int) -> LogicalScenario:
        """The scenario that a solution describes."""
        shares = self._shares(solution)
        ego, pattern = shares[self._ego], solution.pattern
        assignments = tuple([share.assignment for share in shares])
        conflicts = conflicts_among(shares)
        offsets = [ego.offsets[share] for share in shares if share is not ego]
        parameters = [share.speed for share in shares] + offsets
        # Every part was validated when it was made; to do so again takes longer than all the rest.
        return LogicalScenario.from_valid(
            {
                "index": index,
                "slug": self._slug(pattern, assignments),
                "pattern": pattern,
                "class_size": class_size,
                "assignments": assignments,
                "hazards": self._hazards(assignments, conflicts),
                "acts": self._acts(assignments),
                "conflicts": conflicts,
                "deadlock": self._sharing.deadlock(shares),
                "parameters": (*(one for one in parameters if one is not None), *self._numbers),
            },
            _FIELDS,
        )

    def _shares(self, solution: Solution) -> tuple[Share, ...]:
        """What everybody does, in the order of the description."""
        if self._sharing.full:
            self._orders.clear()
            self._sharing.forget()
        chosen: tuple[Choice, ...] = (*solution.drives, *solution.on_foot, None)
        rows = zip(self._order(solution), self._places, strict=True)
        return tuple([row[chosen[place]] for row, place in rows])

    def _order(self, solution: Solution) -> list[Row]:
        """The shares of everybody by choice, as they arrive by their entries and places."""
        entries = () if self._one_order else tuple([entry for entry, _, _ in solution.drives])
        key = entries, solution.places, solution.on_foot if self._by_ways else ()
        found = self._orders.get(key)
        if found is None:
            if len(self._orders) >= MOST_ORDERS:
                self._orders.clear()
            found = self._orders[key] = self._rows(solution)
        return found

    def _rows(self, solution: Solution) -> list[Row]:
        problem, sharing = self._problem, self._sharing
        ranks: dict[str, int] = {}
        beside: dict[str, tuple[str, Side]] = {}
        for queue in queues(problem, solution):
            ranks |= queue.ranks() or {}
            beside |= queue.beside
        lanes = lanes_of(problem, solution, beside)
        slots = {vehicle.id: slot for slot, vehicle in enumerate(problem.vehicles)}
        entry_of = {name: solution.drives[slot][0] for name, slot in slots.items()}
        crossers = {crosser.id for crosser in problem.crossers}
        crossed = [(arm, CROSSINGS[way]) for arm, way in solution.on_foot if way in CROSSINGS]
        rows: list[Row] = []
        for member in self._functional.participants:
            name = member.id
            place = Place(ranks.get(name, 0), lanes.get(name), beside.get(name))
            if name in slots:
                rows.append(sharing.drives[slots[name], place])
            elif name in crossers:
                rows.append(self._on_foot(name, place))
            else:
                rows.append(self._standings(member, entry_of, crossed))
        return rows

    def _on_foot(self, name: str, place: Place) -> Row:
        def share(choice: tuple[int, str]) -> Share:
            return self._sharing.others[assignment_of(name, *choice, place)]

        return Kept(share)

    def _standings(
        self, parked: Participant, entry_of: dict[str, int], crossed: list[tuple[int, Side]]
    ) -> Row:
        assignment = standing(self._functional, parked, entry_of, crossed)
        return Kept(lambda _: self._sharing.others[assignment])

    def _slug(self, pattern: tuple[int, ...], assignments: tuple[Assignment, ...]) -> str:
        """Of many drivers the slug tells the pattern alone, so there are few."""
        if len(pattern) <= MOST_SPELT_OUT:
            return _slug_of(self._functional.junction, assignments)
        if pattern not in self._slugs:
            if len(self._slugs) >= MOST_ORDERS:
                self._slugs.clear()
            self._slugs[pattern] = _slug_of(self._functional.junction, assignments)
        return self._slugs[pattern]


def _slug_of(junction: Junction, assignments: tuple[Assignment, ...]) -> str:
    """Such as ``0left-2straight``: who enters at arm 0 turns left, who enters at 2 goes straight.

    With more than four drivers, or too long, the pattern: ``moves-1x3-2x7`` (three make move 1,
    seven move 2).
    """
    drives = [a for a in assignments if isinstance(a, Drive)]
    words = [_word(junction, drive) for drive in drives]
    words += [f"{a.arm}cross{a.start[0]}" for a in assignments if isinstance(a, Crossing)]
    spelt = "-".join(words)
    if len(drives) <= MOST_SPELT_OUT and len(spelt) <= MAX_LENGTH:
        return spelt
    counts = sorted(Counter(drive.move for drive in drives).items())
    return "moves-" + "-".join(f"{move}x{times}" for move, times in counts)


def _word(junction: Junction, drive: Drive) -> str:
    beside = "" if drive.maneuver is drive.turn else drive.maneuver.value.replace("_", "")
    if drive.reverses is not None:
        beside = drive.reverses.value.replace("_", "")
    return f"{drive.entry}{beside}{_way(junction, drive)}"


def _way(junction: Junction, drive: Drive) -> str:
    if junction.kind is JunctionKind.ROUNDABOUT:
        return f"exit{ring_move(junction, drive.move) or junction.arms}"
    return "uturn" if drive.turn is Maneuver.U_TURN else drive.turn.value

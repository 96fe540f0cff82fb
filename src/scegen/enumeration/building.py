"""From a solution to a logical scenario: names, ranks, conflicts, parameter ranges."""

from __future__ import annotations

from operator import itemgetter
from typing import Any

from scegen.enumeration import predicates as p
from scegen.enumeration.arrival import lanes_of, queues
from scegen.enumeration.on_foot import ALONG, CROSSINGS, Place, assignment_of
from scegen.enumeration.parking import standing
from scegen.enumeration.partial import PartialScenario
from scegen.enumeration.problem import Problem
from scegen.enumeration.ranges import said_numbers
from scegen.enumeration.reading import Solution, Way
from scegen.enumeration.resolving import act_resolver, hazard_resolver
from scegen.enumeration.sharing import Kept, Share, Sharing
from scegen.enumeration.slugs import MOST_SPELT_OUT, slug_of
from scegen.scenario.functional import Participant
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.vocabulary import Side

MOST_ORDERS = 4096
"""Orders of arrival and slugs that are kept; a stream of millions must not fill the memory."""
MOST_PARTS = 1024
"""Ways of the last participants that are kept; there are no more if they are parted well."""

Choice = Way | tuple[int, str] | None
"""Of one who drives, of one who crosses, of one who is parked."""
Row = Kept[Any, Share]
"""The shares of one participant, by choices of its own kind."""
Entries = tuple[tuple[int, ...], tuple[tuple[str, str, str], ...], tuple[tuple[int, str], ...]]
"""Entries of the vehicles, if there are several, the places said of them, and who is on foot."""

_FIELDS = set(LogicalScenario.model_fields)


class _Order:
    """One order of arrival: the shares of each participant by choice, and what is made of them."""

    __slots__ = ("back", "front", "rows")

    def __init__(self, rows: list[Row]) -> None:
        self.rows = rows
        self.front: tuple[tuple[Choice, ...], PartialScenario] = (), PartialScenario(())
        self.back: dict[tuple[Choice, ...], PartialScenario] = {}


class Builder:
    """Makes the logical scenarios of one problem, joined from a part in front and one behind.

    Kept are the front of the scenario before, and the backs of its order of arrival.
    """

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        self._functional = problem.functional
        self._sharing = Sharing(problem)
        self._orders: dict[Entries, _Order] = {}
        self._now: _Order | None = None
        self._slugs: dict[tuple[int, ...], str] = {}
        members = [member.id for member in self._functional.participants]
        self._vehicles_only = members == [vehicle.id for vehicle in problem.vehicles]
        listed = {name: place for place, name in enumerate(problem.names)}
        # The last place holds the None of those who are parked.
        self._arrange = itemgetter(*(listed.get(name, -1) for name in members), -1)
        self._part_at = self._best_parting()
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
        front, back = self._parts(solution)
        at = self._ego - self._part_at
        ego = back.shares[at] if at >= 0 else front.shares[self._ego]
        pattern = solution.pattern
        assignments = front.assignments + back.assignments
        conflicts = front.conflicts_before(back)
        # Every part was validated when it was made; to do so again takes longer than all the rest.
        return LogicalScenario.from_valid(
            {
                "index": index,
                "slug": self._slug(pattern, front, back),
                "pattern": pattern,
                "class_size": class_size,
                "assignments": assignments,
                "hazards": self._hazards(assignments, conflicts),
                "acts": self._acts(assignments),
                "conflicts": conflicts,
                "deadlock": self._sharing.deadlock(front.line + back.line),
                "parameters": front.speeds
                + back.speeds
                + front.offsets[ego]
                + back.offsets[ego]
                + self._numbers,
            },
            _FIELDS,
        )

    def _best_parting(self) -> int:
        """The first of the last participants who together have few choices, at most half of all."""
        choices: dict[str, int] = {}
        for (name, _), wanted in self._problem.wanted.items():
            choices[name] = max(choices.get(name, 1), len(wanted))
        members = [member.id for member in self._functional.participants]
        part_at, combinations = len(members), 1
        while part_at > len(members) // 2:
            combinations *= choices.get(members[part_at - 1], 2)
            if combinations > MOST_PARTS:
                break
            part_at -= 1
        return part_at

    def _parts(self, solution: Solution) -> tuple[PartialScenario, PartialScenario]:
        """What the first do and what the last do, in the order of the description."""
        if self._sharing.full:
            self._orders.clear()
            self._sharing.forget()
        order = self._order(solution)
        if order is not self._now:
            # Listings are sorted by entries, so an order does not come back soon.
            if self._now is not None:
                self._now.back.clear()
            self._now = order
        chosen: tuple[Choice, ...] = solution.drives
        if not self._vehicles_only:
            chosen = self._arrange((*chosen, *solution.on_foot, None))[:-1]
        part_at = self._part_at
        first, last = chosen[:part_at], chosen[part_at:]
        if order.front[0] != first:
            order.front = first, _part(order.rows[:part_at], first)
        back = order.back.get(last)
        if back is None:
            if len(order.back) >= MOST_PARTS:
                order.back.clear()
            back = order.back[last] = _part(order.rows[part_at:], last)
        return order.front[1], back

    def _order(self, solution: Solution) -> _Order:
        """The order in which the vehicles arrive, which entries and places decide."""
        entries = () if self._one_order else tuple([entry for entry, _, _ in solution.drives])
        key = entries, solution.places, solution.on_foot if self._by_ways else ()
        found = self._orders.get(key)
        if found is None:
            if len(self._orders) >= MOST_ORDERS:
                self._orders.clear()
            found = self._orders[key] = _Order(self._rows(solution))
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
                rows.append(sharing.drives(slots[name], place))
            elif name in crossers:
                rows.append(self._on_foot(name, place))
            else:
                rows.append(self._standings(member, entry_of, crossed))
        return rows

    def _on_foot(self, name: str, place: Place) -> Row:
        def share(choice: tuple[int, str]) -> Share:
            return self._sharing.other(assignment_of(name, *choice, place))

        return Kept(share)

    def _standings(
        self, parked: Participant, entry_of: dict[str, int], crossed: list[tuple[int, Side]]
    ) -> Row:
        assignment = standing(self._functional, parked, entry_of, crossed)
        return Kept(lambda _: self._sharing.other(assignment))

    def _slug(self, pattern: tuple[int, ...], front: PartialScenario, back: PartialScenario) -> str:
        """Of many drivers the slug tells the pattern alone, so there are few."""
        slug = self._slugs.get(pattern)
        if slug is None:
            slug = slug_of(self._functional.junction, front.assignments + back.assignments)
            if len(pattern) <= MOST_SPELT_OUT:
                return slug
            if len(self._slugs) >= MOST_ORDERS:
                self._slugs.clear()
            self._slugs[pattern] = slug
        return slug


def _part(rows: list[Row], chosen: tuple[Choice, ...]) -> PartialScenario:
    return PartialScenario(tuple([row[choice] for row, choice in zip(rows, chosen, strict=True)]))

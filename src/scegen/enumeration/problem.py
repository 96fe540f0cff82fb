"""A functional scenario made ready for the solver: facts, derived tables, entry policy."""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

from clorm import Predicate

from scegen.enumeration import answers as a
from scegen.enumeration import predicates as p
from scegen.enumeration.dangers import say_dangers
from scegen.enumeration.directions import on_its_road
from scegen.enumeration.presuming import Parties, parties
from scegen.enumeration.programs import Part, consequences
from scegen.enumeration.statements import ALONG_WORDS, QUEUE_LIMIT, stated
from scegen.errors import InfeasibleError
from scegen.scenario.acts import ActKind
from scegen.scenario.arms import arm_angles_deg
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.hazards import HAZARDS, Arrangement, Case
from scegen.scenario.size import require_few_enough
from scegen.scenario.vocabulary import HazardKind

Choice = tuple[int, str]
"""A symbolic move and its manner (plain, lane_change, overtake, stay)."""


@dataclass(frozen=True)
class Problem:
    """Everything that the encodings and the counting need.

    ``entries`` are the arms to which a participant is limited, absent where the text leaves
    them open. ``settled`` says that every entry is known and every move open, so nothing need be
    solved. ``wanted[vehicle, entry]`` are the choices that the words allow there. ``dependent``
    are the vehicles whose moves matter to others; the moves of all others are independent.
    ``demands`` are :data:`~scegen.enumeration.answers.Needs` in rising order,
    ``sides`` both sides of each danger as far as they are said or presumed, ``presumed`` the
    dangers, by statement, of which something is presumed.
    """

    functional: FunctionalScenario
    facts: tuple[Predicate, ...]
    words: tuple[str, ...]
    notes: tuple[str, ...]
    entries: dict[str, tuple[int, ...]]
    settled: bool
    wanted: dict[tuple[str, int], tuple[Choice, ...]]
    demands: tuple[Predicate, ...]
    dependent: frozenset[str]
    sides: tuple[Parties, ...]
    presumed: dict[int, int]

    @property
    def arms(self) -> int:
        """Number of arms of the junction."""
        return self.functional.junction.arms

    @cached_property
    def vehicles(self) -> tuple[Participant, ...]:
        """Those who enter and leave."""
        return self.functional.vehicles

    @cached_property
    def crossers(self) -> tuple[Participant, ...]:
        """Those who cross an arm."""
        return self.functional.crossers

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Vehicles, then crossers, as they are listed."""
        return tuple(m.id for m in (*self.vehicles, *self.crossers))

    @cached_property
    def angles_deg(self) -> tuple[float, ...]:
        """Directions of the arms."""
        return arm_angles_deg(self.functional.junction)

    @cached_property
    def open_places(self) -> tuple[tuple[str, str], ...]:
        """(vehicle, reference) where more than one place on the same arm is allowed."""
        along = (f for f in self.facts if isinstance(f, p.Says) and f.word in ALONG_WORDS)
        said = Counter((f.id, f.reference) for f in along)
        drivers = {v.id for v in self.vehicles}
        found = [pair for pair, words in said.items() if words > 1 and pair[0] in drivers]
        return (*found, *((f.id, f.reference) for f in self.facts if isinstance(f, p.ComesBeside)))

    @cached_property
    def besides(self) -> tuple[tuple[str, str], ...]:
        """Who comes into whose lane."""
        return tuple((f.id, f.reference) for f in self.facts if isinstance(f, p.ComesInto))


def build_problem(
    functional: FunctionalScenario, left_open: frozenset[int] = frozenset(), *, ranked: bool = True
) -> Problem:
    """Read the statements and derive what follows from the words alone.

    Of the dangers ``left_open``, by their place, nothing is presumed. ``ranked``: arms are told
    apart by their signs.

    Raises:
        InfeasibleError: too many vehicles, an ego that does not drive, or somebody who comes the
            other way of a one-way road.
    """
    functional = on_its_road(functional)
    vehicles = functional.vehicles
    _check_size(functional)
    said = stated(functional)
    wordless = _wordless(functional)
    sides = tuple(
        parties(functional, hazard, left_open=index in left_open)
        for index, hazard in enumerate(functional.hazards)
    )
    presumed: dict[int, int] = {}
    derived: list[Predicate] = []
    if not wordless:
        presumed = say_dangers(said, functional, sides, left_open, ranked=ranked)
        shown = (a.Wanted, a.Needs, a.Dependent)
        derived = consequences(said.facts, (Part.ARMS, Part.WORDS), shown)
    needs = [fact for fact in derived if isinstance(fact, a.Needs)]
    demands = tuple(sorted(needs, key=lambda d: (d.statement, d.by, d.to, d.what)))
    said.facts += _besides(said.facts, demands)
    entries = {
        m.id: tuple(sorted(m.entries)) for m in (*vehicles, *functional.crossers) if m.entries
    }
    _check_queues(entries, vehicles, functional.junction.arms)
    dependent = {fact.id for fact in derived if isinstance(fact, a.Dependent)}
    related = related_among(said.facts)
    # Of a group whose members are related to others, who does what is said matters to all.
    dependent |= {name for g in functional.groups for name in g.members if name in related}
    return Problem(
        functional=functional,
        facts=tuple(said.facts),
        words=tuple(said.words),
        notes=(*said.notes, *_given_up(functional, left_open)),
        entries=entries,
        settled=wordless and all(len(entries.get(v.id, ())) == 1 for v in vehicles),
        wanted=_every_move(functional) if wordless else _wanted(derived),
        demands=demands,
        dependent=frozenset(dependent),
        sides=sides,
        presumed=presumed,
    )


def related_among(facts: Iterable[Predicate]) -> set[str]:
    """Those whose place is told in relation to another's."""
    told = (fact for fact in facts if isinstance(fact, p.Approach))
    return {name for fact in told for name in (fact.id, fact.reference)}


def _given_up(functional: FunctionalScenario, left_open: frozenset[int]) -> list[str]:
    notes = []
    for hazard in (functional.hazards[index] for index in sorted(left_open)):
        why = "whom it concerns is not said, and nobody fits whom it could"
        if hazard.by and hazard.to:
            why = "who causes it and who suffers it cannot be as is usual of it"
        notes.append(f"{hazard.kind}: {why}: left open.")
    return notes


def _wordless(functional: FunctionalScenario) -> bool:
    """Whether the text leaves all moves open and nobody's matters to anybody else."""
    told = functional.hazards, functional.relations, functional.groups, functional.acts
    moves = any(v.maneuvers or v.approaches or v.lanes for v in functional.vehicles)
    return not (moves or any(told) or functional.outcome or functional.crossers)


def _besides(facts: Iterable[Predicate], demands: Iterable[Predicate]) -> list[Predicate]:
    """Who comes into another's lane starts beside it, where no words say where it starts."""
    facts = tuple(facts)
    kinds = {f.statement: HazardKind(f.kind) for f in facts if isinstance(f, p.Hazard)}
    placed = {frozenset((f.id, f.reference)) for f in facts if isinstance(f, p.Approach)}
    found: list[Predicate] = []
    for demand in demands:
        row = HAZARDS[kinds[demand.statement]]
        comes = ActKind.CHANGE_LANE in row.acts or Case.PLAIN_ROAD in row.needs
        if demand.what != Arrangement.TOGETHER or not comes:
            continue
        found.append(p.ComesInto(demand.statement, demand.by, demand.to))
        if frozenset((demand.by, demand.to)) not in placed:
            found.append(p.ComesBeside(demand.statement, demand.by, demand.to))
            placed.add(frozenset((demand.by, demand.to)))
    return found


def _every_move(functional: FunctionalScenario) -> dict[tuple[str, int], tuple[Choice, ...]]:
    """What words.lp derives where nothing is said: any move but the U-turn."""
    arms = functional.junction.arms
    moves = tuple((move, "plain") for move in range(1, arms))
    return {(v.id, entry): moves for v in functional.vehicles for entry in range(arms)}


def _wanted(derived: Iterable[Predicate]) -> dict[tuple[str, int], tuple[Choice, ...]]:
    choices: dict[tuple[str, int], list[Choice]] = {}
    for fact in derived:
        if isinstance(fact, a.Wanted):
            choices.setdefault((fact.id, fact.entry), []).append((fact.move, fact.manner))
    return {key: tuple(sorted(found)) for key, found in choices.items()}


def _check_size(functional: FunctionalScenario) -> None:
    require_few_enough(len(functional.participants))
    if functional.ego not in functional.vehicles:
        raise InfeasibleError(
            "the ego must drive through the junction, not park or cross it",
            where=f"participants.{functional.ego.id}",
            hint="Give the role ego to a vehicle that drives.",
        )


def _check_queues(
    entries: dict[str, tuple[int, ...]], vehicles: tuple[Participant, ...], arms: int
) -> None:
    if len(vehicles) > QUEUE_LIMIT * arms:
        raise InfeasibleError(
            f"{len(vehicles)} vehicles enter at {arms} arms, and each road holds {QUEUE_LIMIT}",
            where="participants",
            hint="Describe fewer vehicles or more arms.",
        )
    fixed = Counter(entries[v.id][0] for v in vehicles if len(entries.get(v.id, ())) == 1)
    for arm, number in sorted(fixed.items()):
        if number > QUEUE_LIMIT:
            raise InfeasibleError(
                f"{number} vehicles enter at arm {arm}, and its road holds {QUEUE_LIMIT}",
                where=f"participants entering at arm {arm}",
                hint="Describe fewer vehicles or more arms.",
            )

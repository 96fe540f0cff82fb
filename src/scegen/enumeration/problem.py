"""A functional scenario made ready for the solver: facts, derived tables, entry policy."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

from clorm import Predicate

from scegen.enumeration import answers as a
from scegen.enumeration import predicates as p
from scegen.enumeration.programs import Part, consequences
from scegen.enumeration.statements import ALONG, QUEUE_LIMIT, say_entries, stated
from scegen.errors import InfeasibleError
from scegen.scenario.arms import arm_angles_deg
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.vocabulary import HazardKind

MAX_VEHICLES = 60
"""More vehicles than this are refused: no approach roads are built for them."""

Choice = tuple[int, str]
"""A symbolic move and its manner (plain, lane_change, overtake, stay)."""


@dataclass(frozen=True)
class Demand:
    """What a hazard of this kind demands of ``by`` and ``to``."""

    kind: HazardKind
    by: str
    to: str
    what: str


@dataclass(frozen=True)
class Problem:
    """Everything that the encodings and the counting need.

    ``entries`` are the arms to which a participant is limited, absent where the text leaves
    them open; ``spread`` says that the program put the vehicles on the arms in turn.
    ``settled`` says that every entry is known and every move open, so nothing need be solved.
    ``wanted[vehicle, entry]`` are the choices that the words allow there. ``tied`` are the
    vehicles whose moves matter to others; the moves of all others are independent.
    """

    functional: FunctionalScenario
    facts: tuple[Predicate, ...]
    words: tuple[str, ...]
    notes: tuple[str, ...]
    entries: dict[str, tuple[int, ...]]
    spread: bool
    settled: bool
    wanted: dict[tuple[str, int], tuple[Choice, ...]]
    demands: tuple[Demand, ...]
    tied: frozenset[str]

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

    @property
    def fair_share(self) -> int:
        """Vehicles per arm if they spread evenly, rounded up."""
        return math.ceil(len(self.vehicles) / self.arms)

    @cached_property
    def open_places(self) -> tuple[tuple[str, str], ...]:
        """(vehicle, reference) where more than one place on the same arm is allowed."""
        said = Counter((f.id, f.reference) for f in self.facts if _says_along(f))
        drivers = {v.id for v in self.vehicles}
        return tuple(pair for pair, words in said.items() if words > 1 and pair[0] in drivers)


def _says_along(fact: Predicate) -> bool:
    return isinstance(fact, p.Says) and fact.word in {word.value for word in ALONG}


def build_problem(functional: FunctionalScenario, *, notes: tuple[str, ...] = ()) -> Problem:
    """Read the statements and derive what follows from the words alone.

    ``notes`` are what is already to be said of it.

    Raises:
        InfeasibleError: too many vehicles, or an ego that does not drive.
    """
    vehicles = functional.vehicles
    _check_size(functional)
    said = stated(functional)
    wordless = _wordless(functional)
    derived = (
        []
        if wordless
        else consequences(
            said.facts, (Part.ARMS, Part.WORDS), (a.Wanted, a.Needs, a.TurnsLeft, a.Tied)
        )
    )
    demands = _demands(said.facts, derived)
    entries = {
        m.id: tuple(sorted(m.entries)) for m in (*vehicles, *functional.crossers) if m.entries
    }
    spread = not (
        any(v.maneuvers or v.approaches or v.entries for v in vehicles)
        or any(r.participant in {v.id for v in vehicles} for r in functional.relations)
        or demands
        or any(isinstance(fact, a.TurnsLeft) for fact in derived)
    )
    if spread:
        # As in the source paper: car i enters at arm i mod n.
        for index, vehicle in enumerate(vehicles):
            entries[vehicle.id] = (index % functional.junction.arms,)
            say_entries(said, vehicle.id, entries[vehicle.id])
        said.notes.append("Nothing is said about entries: the vehicles take the arms in turn.")
    _check_queues(entries, vehicles, spread=spread)
    return Problem(
        functional=functional,
        facts=tuple(said.facts),
        words=tuple(said.words),
        notes=(*notes, *said.notes),
        entries=entries,
        spread=spread,
        settled=wordless and all(len(entries.get(v.id, ())) == 1 for v in vehicles),
        wanted=_every_move(functional) if wordless else _wanted(derived),
        demands=demands,
        tied=frozenset(fact.id for fact in derived if isinstance(fact, a.Tied)),
    )


def _wordless(functional: FunctionalScenario) -> bool:
    """Whether the text leaves all moves open and nobody's matters to anybody else."""
    return not (
        functional.hazards
        or functional.relations
        or functional.crossers
        or any(v.maneuvers or v.approaches for v in functional.vehicles)
    )


def _every_move(functional: FunctionalScenario) -> dict[tuple[str, int], tuple[Choice, ...]]:
    """What words.lp derives where nothing is said: any move but the U-turn."""
    arms = functional.junction.arms
    moves = tuple((move, "plain") for move in range(1, arms))
    return {(v.id, entry): moves for v in functional.vehicles for entry in range(arms)}


def _demands(said: Iterable[Predicate], derived: Iterable[Predicate]) -> tuple[Demand, ...]:
    kinds = {f.statement: HazardKind(f.kind) for f in said if isinstance(f, p.Hazard)}
    found = [
        Demand(kinds[fact.statement], fact.by, fact.to, fact.what)
        for fact in derived
        if isinstance(fact, a.Needs)
    ]
    return tuple(sorted(found, key=lambda d: (d.kind, d.by, d.to, d.what)))


def _wanted(derived: Iterable[Predicate]) -> dict[tuple[str, int], tuple[Choice, ...]]:
    choices: dict[tuple[str, int], list[Choice]] = {}
    for fact in derived:
        if isinstance(fact, a.Wanted):
            choices.setdefault((fact.id, fact.entry), []).append((fact.move, fact.manner))
    return {key: tuple(sorted(found)) for key, found in choices.items()}


def _check_size(functional: FunctionalScenario) -> None:
    vehicles = functional.vehicles
    if len(functional.participants) > MAX_VEHICLES:
        raise InfeasibleError(
            f"{len(functional.participants)} participants are more than one junction holds "
            f"(at most {MAX_VEHICLES})",
            where="participants",
            hint="Describe fewer participants.",
        )
    if functional.ego not in vehicles:
        raise InfeasibleError(
            "the ego must drive through the junction, not park or cross it",
            where=f"participants.{functional.ego.id}",
            hint="Give the role ego to a vehicle that drives.",
        )


def _check_queues(
    entries: dict[str, tuple[int, ...]], vehicles: tuple[Participant, ...], *, spread: bool
) -> None:
    fixed = Counter(entries[v.id][0] for v in vehicles if len(entries.get(v.id, ())) == 1)
    for arm, number in sorted(fixed.items()):
        if number > QUEUE_LIMIT:
            raise InfeasibleError(
                f"{number} vehicles enter at arm {arm}, and its road holds {QUEUE_LIMIT}",
                where="participants" if spread else f"participants entering at arm {arm}",
                hint="Describe fewer vehicles or more arms.",
            )

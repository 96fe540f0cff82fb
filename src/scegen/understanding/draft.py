"""The scenario in the making: participants with what is known of them, and why."""

from dataclasses import dataclass, field
from typing import Any

from scegen.errors import InfeasibleError
from scegen.scenario.size import require_few_enough
from scegen.scenario.vocabulary import (
    ANIMALS,
    Approach,
    CrossedArm,
    HazardKind,
    Maneuver,
    ParticipantKind,
)
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.words.tokens import Token

TURNS = frozenset({Maneuver.LEFT, Maneuver.RIGHT, Maneuver.U_TURN})
_OVERRIDABLE = frozenset({Maneuver.STRAIGHT})
_ON_THE_WAY = frozenset({Maneuver.LANE_CHANGE})
"""What comes before a turn at the junction ("cuts in and turns right")."""
IMPLIED = (
    "crossing", "lanes", "passing", "access", "from_kerb",
    "unmoved",  # nobody who drives reacts
    "side_road",  # somebody comes from the left or right; it takes one unless lanes are meant
)  # fmt: skip
_WAITS_TO_CROSS = "nobody walks along the road and then crosses it: it stands until it crosses"


@dataclass(slots=True)
class Danger:
    """A hazard in the making."""

    kind: HazardKind
    basis: Basis
    by: list[Entity]
    to: list[Entity]
    items: list[Any] = field(default_factory=list)


@dataclass(slots=True)
class Placement:
    """Where ``entity`` is or comes from, seen from ``reference``; None stands for the ego."""

    entity: Entity
    reference: Entity | None
    approaches: set[Approach]
    basis: Basis


@dataclass(slots=True)
class Note:
    """Words that matter but that no field holds."""

    i: int
    j: int
    instead: str


@dataclass(slots=True)
class Draft:
    """Everything that has been understood so far."""

    text: str = ""
    tokens: list[Token] = field(default_factory=list)
    entities: list[Entity] = field(default_factory=list)
    dangers: list[Danger] = field(default_factory=list)
    placements: list[Placement] = field(default_factory=list)
    notes: list[Note] = field(default_factory=list)
    kerb: str = "right"
    """The side of the road on which traffic keeps."""
    ramp: Basis | None = None
    """Words for a ramp, or a lane that ends."""
    implied: dict[str, Basis] = field(default_factory=dict)
    """What is so of the road, or of all (of `IMPLIED`), with the first words that tell so."""
    used: dict[str, CrossedArm] = field(default_factory=dict)
    """How who drives comes to a kind of road of the junction."""
    lying: list[Any] = field(default_factory=list)
    """The things that lie in the way, in the order of the text."""

    @property
    def ego(self) -> Entity | None:
        """The ego, if the text names one."""
        return next((e for e in self.entities if e.ego), None)

    def causing(self, *kinds: HazardKind) -> list[Entity]:
        """Who causes hazards of these kinds; of any kind where none is given."""
        return [e for d in self.dangers if not kinds or d.kind in kinds for e in d.by]

    def suffering(self, *kinds: HazardKind) -> list[Entity]:
        """Who suffers them."""
        return [e for d in self.dangers if not kinds or d.kind in kinds for e in d.to]

    def placements_of(self, entity: Entity) -> list[Placement]:
        """What is said of where a participant is, from whomever it is seen."""
        return [p for p in self.placements if p.entity is entity]

    def only(self, entity: Entity, approach: Approach) -> bool:
        """Whether it is said to be at one place and no other, as the ego sees it."""
        found = (p for p in self.placements_of(entity) if not p.reference or p.reference.ego)
        return any(p.approaches == {approach} for p in found)

    def add(self, kind: ParticipantKind, basis: Basis) -> Entity:
        """A new participant.

        Raises:
            InfeasibleError: if there are too many.
        """
        require_few_enough(len(self.entities) + 1)
        entity = Entity(len(self.entities), kind, basis)
        self.entities.append(entity)
        return entity

    def note(self, i: int, j: int, instead: str) -> None:
        """Reports words that no field holds."""
        self.notes.append(Note(i, j, instead))

    def note_at(self, basis: Basis | None, instead: str) -> None:
        """Reports the words that something rests on, if there are any."""
        if basis is not None and basis.i is not None and basis.j is not None:
            self.note(basis.i, basis.j, instead)

    def hazard(
        self, kind: HazardKind, basis: Basis, by: list[Entity], to: list[Entity] | None = None
    ) -> None:
        """Adds a hazard; the same hazard from another participant joins it.

        Who goes over the road may be an animal.
        """
        to = to or []
        if kind is HazardKind.CROSSING_PEDESTRIAN and by and all(e.kind in ANIMALS for e in by):
            kind = HazardKind.CROSSING_ANIMAL
        for danger in self.dangers:
            like = len({any(e.ego for e in who) for who in (danger.by, by) if who}) < 2
            alike = {e.index for e in danger.to} == {e.index for e in to}
            same = not danger.to or not to or alike
            if danger.kind is kind and like and same:
                danger.by += [e for e in by if e not in danger.by]
                danger.to += [e for e in to if e not in danger.to]
                return
        self.dangers.append(Danger(kind, basis, list(dict.fromkeys(by)), list(to)))

    def place(
        self, entity: Entity, reference: Entity | None, approaches: set[Approach], basis: Basis
    ) -> None:
        """Says where a participant comes from, seen from another (None: the ego)."""
        if entity is not reference and approaches:
            self.placements.append(Placement(entity, reference, approaches, basis))

    def maneuver(
        self,
        entity: Entity,
        values: set[Maneuver],
        basis: Basis,
        alternative: int | None = None,
        *,
        later: bool = False,
    ) -> None:
        """Says what a participant does.

        Driving straight before a turn is no contradiction, turning both ways is one, unless
        the text offers them as alternatives or one after the other.

        Raises:
            InfeasibleError: if the text lets one vehicle turn both left and right.
        """
        known = entity.maneuvers
        both_ways = known & TURNS and values & TURNS and not values & known
        either = alternative is not None and alternative == entity.turn_alternative
        if both_ways and not either:
            if not later:
                self._contradiction(entity, values, basis)
            self.note_at(basis, "one junction is built; this later turn is left out")
            return
        if alternative is None and values & TURNS:
            known = known - _OVERRIDABLE - _ON_THE_WAY if entity.turn_alternative is None else known
        if alternative is None and values in (_OVERRIDABLE, _ON_THE_WAY) and known & TURNS:
            return
        if alternative is None and entity.turn_alternative is None and values < known <= TURNS:
            known = set()  # "both turn: V1 goes left": now it is said which way
        if Maneuver.CROSS in values:
            if Maneuver.STRAIGHT in known and not entity.is_vehicle:
                self.note_at(entity.maneuver_basis, _WAITS_TO_CROSS)
            known = known - {Maneuver.STAY, Maneuver.STRAIGHT}
        entity.maneuvers = set(known | values)
        entity.maneuver_basis = _joined(entity.maneuver_basis, basis, bool(known))
        entity.turn_alternative = alternative or entity.turn_alternative

    def _contradiction(self, entity: Entity, values: set[Maneuver], basis: Basis) -> None:
        first = f"{min(entity.maneuvers & TURNS)}{self._quoted(entity.maneuver_basis)}"
        second = f"{min(values & TURNS)}{self._quoted(basis)}"
        who = "the ego" if entity.ego else f"one {entity.kind}"
        msg = f"contradictory maneuvers: {who} is said to turn {first} and to turn {second}"
        raise InfeasibleError(
            msg,
            where="description",
            hint="At one junction a vehicle turns once; say 'left or right' to allow both.",
        )

    def _quoted(self, basis: Basis | None) -> str:
        if basis is None or basis.i is None or basis.j is None:
            return ""
        return f" ('{self.text[self.tokens[basis.i].start : self.tokens[basis.j - 1].end]}')"


def _joined(old: Basis | None, new: Basis, keep: bool) -> Basis:
    """Words that together carry a set of alternatives, as one stretch of text."""
    if old is None or not keep or old.i is None or new.i is None:
        return new
    return Basis(min(old.i, new.i), max(old.j or 0, new.j or 0), new.reason)

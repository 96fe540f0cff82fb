"""Builds the scenario from the draft: junction, participants, hazards and the evidence."""

from __future__ import annotations

from scegen.scenario.functional import (
    ARM_COUNTS,
    Evidence,
    FunctionalScenario,
    Hazard,
    Junction,
    Participant,
    Relation,
    Unsupported,
)
from scegen.scenario.vocabulary import (
    Approach,
    Control,
    DrivingSide,
    EvidenceSource,
    JunctionKind,
    Maneuver,
    ParticipantKind,
    Role,
)
from scegen.understanding.draft import Basis, Danger, Draft, Entity
from scegen.understanding.junctions import JunctionReading
from scegen.understanding.surroundings import Surroundings
from scegen.understanding.tokens import Token
from scegen.understanding.viewpoint import choose_ego, settle_positions, suffers

_ROUNDABOUT_ARMS = 4


class Builder:
    """Puts the parts together.

    Args:
        draft: participants, hazards and positions.
        reading: what the text says about the junction.
        surroundings: what it says about everything else.
        tokens: the tokens of the text.
    """

    def __init__(
        self,
        draft: Draft,
        reading: JunctionReading,
        surroundings: Surroundings,
        tokens: list[Token],
    ) -> None:
        self._draft = draft
        self._reading = reading
        self._around = surroundings
        self._tokens = tokens
        self._evidence: list[Evidence] = []

    def build(self) -> FunctionalScenario:
        """The functional scenario with its evidence."""
        ego, ego_basis = choose_ego(self._draft)
        relations = settle_positions(self._draft, ego)
        junction = self._junction()
        self._name(ego)
        participants = tuple(
            self._participant(e, ego_basis, junction) for e in self._draft.entities
        )
        linked = tuple(
            Relation(participant=a.name, reference=b.name, approaches=frozenset(approaches))
            for a, b, approaches, _ in relations
        )
        for number, relation in enumerate(relations):
            self._prove(f"relations.{number}", relation[3])
        hazards = tuple(self._hazard(d, ego) for d in self._draft.dangers)
        for name, basis in self._around.bases.items():
            self._prove(f"environment.{name}", basis)
        return FunctionalScenario(
            description=self._draft.text,
            junction=junction,
            participants=participants,
            relations=linked,
            hazards=hazards,
            environment=self._around.environment(),
            evidence=tuple(self._evidence),
            unsupported=self._unsupported(),
        )

    def _span(self, i: int, j: int) -> tuple[int, int]:
        return self._tokens[i].start, self._tokens[j - 1].end

    def _prove(self, name: str, basis: Basis | None, default: str | None = None) -> None:
        """Adds the evidence of one field."""
        if basis is None:
            self._evidence.append(
                Evidence(field=name, source=EvidenceSource.DEFAULT, reason=default or "not said")
            )
            return
        reason = "; ".join(filter(None, (basis.reason, self._slips(basis)))) or None
        source = EvidenceSource.INFERRED if reason else EvidenceSource.STATED
        start = end = text = None
        if basis.i is not None and basis.j is not None:
            start, end = self._span(basis.i, basis.j)
            text = self._draft.text[start:end]
        self._evidence.append(
            Evidence(field=name, source=source, text=text, start=start, end=end, reason=reason)
        )

    def _slips(self, basis: Basis) -> str:
        """Misspelt words among those that a field rests on."""
        words = self._tokens[basis.i : basis.j] if basis.i is not None else []
        return "; ".join(f"'{t.text}' is read as '{t.low}'" for t in words if t.slip)

    def _junction(self) -> Junction:
        kind, kind_basis = self._kind()
        arms, arms_basis = self._arms(kind, kind_basis)
        control = self._reading.control or Control.UNCONTROLLED
        self._prove("junction.kind", kind_basis, "no junction is named: a straight road")
        self._prove("junction.arms", arms_basis)
        self._prove("junction.control", self._reading.control_basis, "no control is named")
        lanes, ring, lanes_basis = self._lanes(kind, arms)
        self._prove("junction.lanes", lanes_basis, "one lane per direction unless more are said")
        if ring is not None:
            self._prove("junction.ring_lanes", lanes_basis)
        if self._around.speed_limit_mps is not None:
            self._prove("junction.speed_limit_mps", self._around.limit_basis)
        self._prove("junction.driving_side", self._around.side_basis, "right-hand traffic")
        return Junction(
            kind=kind,
            arms=arms,
            lanes=lanes,
            ring_lanes=ring,
            speed_limit_mps=self._around.speed_limit_mps,
            driving_side=self._around.side or DrivingSide.RIGHT,
            control=control,
        )

    def _kind(self) -> tuple[JunctionKind, Basis | None]:
        reading = self._reading
        if reading.kind is not None:
            return reading.kind, reading.kind_basis
        if reading.named is not None:
            reason = "an intersection without a shape is read as four-way"
            return JunctionKind.FOUR_WAY, Basis(reading.named.i, reading.named.j, reason)
        access = self._draft.access
        if access is not None and reading.straight is None:
            reason = "a side road or driveway meets the road like the stem of a T"
            return JunctionKind.T, Basis(access.i, access.j, reason)
        implied = self._draft.crossing_implied or self._lateral() or self._regulated()
        if implied is not None:
            reason = f"{implied.reason}: there must be an intersection, read as four-way"
            return JunctionKind.FOUR_WAY, Basis(implied.i, implied.j, reason)
        return JunctionKind.STRAIGHT, reading.straight or reading.road

    def _lateral(self) -> Basis | None:
        lateral = {Approach.LEFT, Approach.RIGHT}
        for placement in self._draft.placements:
            if placement.approaches == lateral and placement.entity.moving_vehicle:
                return Basis(placement.basis.i, placement.basis.j, "a vehicle comes across")
        return None

    def _regulated(self) -> Basis | None:
        basis = self._reading.control_basis
        if basis is None or self._reading.control is Control.UNCONTROLLED:
            return None
        return Basis(basis.i, basis.j, "priority is regulated")

    def _arms(self, kind: JunctionKind, basis: Basis | None) -> tuple[int, Basis]:
        reading = self._reading
        if reading.arms is not None:
            return reading.arms, reading.arms_basis or Basis(reason="from the words")
        if kind is JunctionKind.ROUNDABOUT:
            reason = f"the number of exits is not said; {_ROUNDABOUT_ARMS} are assumed"
            return _ROUNDABOUT_ARMS, Basis(reason=reason)
        arms = max(ARM_COUNTS[kind][0], 2)
        if basis is not None and basis.reason is None:
            return arms, Basis(basis.i, basis.j)
        return arms, Basis(reason=f"follows from the shape {kind.value}")

    def _lanes(
        self, kind: JunctionKind, arms: int
    ) -> tuple[tuple[int, ...], int | None, Basis | None]:
        around = self._around
        ring = kind is JunctionKind.ROUNDABOUT
        if around.lanes is not None:
            doubled = 2 if ring and around.lanes > 1 else None
            return (around.lanes,) * arms, doubled, around.lanes_basis
        implied = self._draft.lanes_implied
        adjacent = next(
            (e for e in self._draft.entities if Approach.ADJACENT in e.approaches), None
        )
        if implied is None and adjacent is not None:
            basis = adjacent.approach_basis or adjacent.basis
            implied = Basis(basis.i, basis.j, "vehicles side by side need a second lane")
        if implied is None and around.highway is not None:
            reason = "highways have two lanes per direction unless said otherwise"
            implied = Basis(around.highway.i, around.highway.j, reason)
        if implied is None:
            return (), None, None
        return (2,) * arms, (2 if ring else None), implied

    def _name(self, ego: Entity) -> None:
        counts: dict[str, int] = {}
        named = ego.basis.i is not None and ego.ego and not self._designated(ego)
        for entity in self._draft.entities:
            if entity is ego and (named or ego.basis.i is None):
                entity.name = "ego"
                continue
            stem = f"parked_{entity.kind.value}" if entity.parked else entity.kind.value
            counts[stem] = counts.get(stem, 0) + 1
            entity.name = f"{stem}_{counts[stem]}"

    def _designated(self, ego: Entity) -> bool:
        return "ego" not in ego.named_by

    def _participant(self, entity: Entity, ego_basis: Basis, junction: Junction) -> Participant:
        path = f"participants.{entity.name}"
        self._prove(f"{path}.kind", entity.counted or entity.basis)
        role = Role.EGO if entity.ego else Role.OTHER
        if role is Role.EGO:
            self._prove(f"{path}.role", ego_basis)
        else:
            self._prove(f"{path}.role", None, "everybody but the ego")
        maneuvers = self._maneuvers(entity, junction)
        entries = frozenset(a for a in entity.entries if a < junction.arms)
        for name, value, basis in (
            ("parked", entity.parked, entity.parked_basis),
            ("approaches", entity.approaches, entity.approach_basis),
            ("maneuvers", maneuvers, entity.maneuver_basis),
            ("entries", entries, entity.entry_basis),
            ("speed_mps", entity.speed, entity.speed_basis),
        ):
            if value:
                self._prove(f"{path}.{name}", basis or entity.basis)
        for basis in self._further_words(entity):
            self._prove(f"{path}.approaches", basis)
        return Participant(
            id=entity.name,
            kind=entity.kind,
            role=role,
            parked=entity.parked,
            approaches=frozenset(entity.approaches),
            maneuvers=frozenset(maneuvers),
            entries=entries,
            speed_mps=entity.speed,
        )

    def _further_words(self, entity: Entity) -> list[Basis]:
        """Other words that say the same of where somebody comes from."""
        if not entity.approaches:
            return []
        found = [entity.by_heading] if entity.by_heading is not None else []
        found += [
            p.basis
            for p in self._draft.placements
            if p.entity is entity and p.approaches & entity.approaches and p.basis.i is not None
        ]
        return [b for b in dict.fromkeys(found) if b != entity.approach_basis]

    def _maneuvers(self, entity: Entity, junction: Junction) -> set[Maneuver]:
        basis = entity.basis
        if entity.parked:
            entity.maneuver_basis = Basis(basis.i, basis.j, "a parked vehicle stays")
            return {Maneuver.STAY}
        if entity.maneuvers:
            return entity.maneuvers
        if entity.kind is ParticipantKind.PEDESTRIAN:
            reason = "nothing else is said: somebody on foot crosses"
            entity.maneuver_basis = Basis(basis.i, basis.j, reason)
            return {Maneuver.CROSS}
        straight = junction.kind is JunctionKind.STRAIGHT or entity.on_straight
        if straight and entity.moves is not None:
            reason = "on a straight road, or one without a junction, one drives straight on"
            entity.maneuver_basis = Basis(entity.moves.i, entity.moves.j, reason)
            return {Maneuver.STRAIGHT}
        return set()

    def _hazard(self, danger: Danger, ego: Entity) -> Hazard:
        to = [e for e in danger.to if e not in danger.by]
        field = f"hazards.{danger.kind.value}"
        self._prove(field, danger.basis)
        if not to and danger.by:
            to, reason = suffers(self._draft, danger, ego)
            if to:
                self._prove(f"{field}.to", Basis(reason=reason))
        return Hazard(
            kind=danger.kind,
            by=tuple(e.name for e in danger.by),
            to=tuple(e.name for e in to),
        )

    def _unsupported(self) -> tuple[Unsupported, ...]:
        found = []
        for note in sorted(self._draft.notes, key=lambda n: (n.i, n.j)):
            start, end = self._span(note.i, note.j)
            found.append(
                Unsupported(
                    text=self._draft.text[start:end], start=start, end=end, instead=note.instead
                )
            )
        return tuple(found)

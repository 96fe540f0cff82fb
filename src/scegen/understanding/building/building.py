"""Builds the scenario from the draft: participants, hazards, and what is left over."""

from collections.abc import Collection
from dataclasses import dataclass, field
from typing import Any

from scegen.scenario.environment import Environment
from scegen.scenario.evidence import Unsupported
from scegen.scenario.functional import FunctionalScenario, Hazard, Participant, Relation
from scegen.scenario.junction import Junction
from scegen.scenario.roadway import Strip
from scegen.scenario.signals import AtLight
from scegen.scenario.vocabulary import Approach, Control, HazardKind, JunctionKind, Maneuver, Role
from scegen.understanding.building.beside import (
    abreast,
    alongside,
    at_the_edge,
    both_change_lanes,
    from_the_strip,
    in_one_lane,
    in_the_way,
    settle_ramp,
)
from scegen.understanding.building.in_lane import (
    lanes_of,
    past_people,
    settle_along,
    settle_numbers,
    side_by_side,
)
from scegen.understanding.building.layout import Layout
from scegen.understanding.building.unsaid import maneuvers_of, some_of
from scegen.understanding.building.viewpoint import (
    next_to,
    settle_arms,
    settle_positions,
    settle_roads,
)
from scegen.understanding.building.writing import Proofs, Writer
from scegen.understanding.draft import Danger, Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import Happenings
from scegen.understanding.meaning.manner import onto_the_road
from scegen.understanding.road.junctions import JunctionReading
from scegen.understanding.road.lengthwise import Lengthwise
from scegen.understanding.road.surroundings import Surroundings

_ON_THE_WAY = frozenset({
    HazardKind.FAILURE_TO_YIELD, HazardKind.UNPROTECTED_LEFT_TURN, HazardKind.CROSSING_PEDESTRIAN,
    HazardKind.CROSSING_CYCLIST, HazardKind.CROSSING_ANIMAL,
})  # fmt: skip
"""Dangers to those who drive."""
_COMING_IN = (HazardKind.CUT_IN, HazardKind.MERGING_CONFLICT, HazardKind.SWERVING)
_NO_LIGHT = "no light stands there for it that could show that; left open"
_NOT_SAID = (None, None)
_FIELDS = set(FunctionalScenario.model_fields)


@dataclass(slots=True)
class Builder:
    """Puts the parts together.

    Attributes:
        draft: participants, hazards and positions.
        ego: who the ego is, and why.
        happenings: acts, spacings, things and the outcome.
        reading: what the text says about the junction.
        around: what it says about everything else.
        along: what it says about the road along its length.
        proofs: the evidence.
    """

    draft: Draft
    ego: tuple[Entity, Basis]
    happenings: Happenings
    reading: JunctionReading
    around: Surroundings
    along: Lengthwise
    proofs: Proofs = field(init=False)

    def __post_init__(self) -> None:
        self.proofs = Proofs(self.draft.text, self.draft.tokens)

    def build(self) -> FunctionalScenario:
        """The functional scenario with its evidence."""
        ego, ego_basis = self.ego
        for entity in self.draft.entities:
            entity.ego = entity is ego  # "the cops we are": several are called so, one is it
        settle_arms(self.draft, ego)
        relations = settle_positions(self.draft, ego)
        if Strip.PAVEMENT not in self.along.without:
            at_the_edge(self.draft, self.happenings)
        junction = Layout(self.draft, self.reading, self.around, self.along, self.proofs).build()
        onto_the_road(self.draft, junction.driving_side)
        if junction.kind is JunctionKind.STRAIGHT:
            in_the_way(self.draft, ego)
            abreast(self.draft, ego)
            in_one_lane(self.draft, self.happenings)
            both_change_lanes(self.draft, ego)
            from_the_strip(self.draft, ego)
            settle_along(self.draft, ego, self.happenings)
            relations = side_by_side(past_people(relations), self.draft)
            if junction.auxiliary is not None:
                named = lanes_of(ego, junction)
                beside = not named or junction.through_lanes in named
                settle_ramp(self.draft, ego, junction.auxiliary, self.along, beside_ego=beside)
        else:
            alongside(self.draft, ego)
            settle_roads(self.draft, junction)
        settle_numbers(self.draft, ego, junction)
        self._name(ego)
        groups = some_of(self.draft, self.happenings, junction.kind, self.proofs)
        participants = tuple(self._participant(e, ego_basis, junction) for e in self.draft.entities)
        linked = tuple(
            Relation(participant=a.name, reference=b.name, approaches=frozenset(approaches))
            for a, b, approaches, _ in relations
        )
        for number, (*_, basis) in enumerate(relations):
            self.proofs.add(f"relations.{number}", basis)
        hazards = tuple(self._hazard(d) for d in self.draft.dangers if not _met_by_none(d, ego))
        conditions = self.around.conditions
        for name, (_, basis) in conditions.items():
            self.proofs.add(f"environment.{name}", basis)
        writer = Writer(self.happenings, ego, self.proofs, junction.lanes_wide_m)
        parts: dict[str, Any] = {
            "level": "functional",
            "description": self.draft.text,
            "junction": junction,
            "participants": participants,
            "relations": linked,
            "groups": groups,
            "hazards": hazards,
            "objects": writer.objects(),
            "spacings": writer.spacings(),
            "acts": writer.acts(),
            "outcome": writer.outcome(),
            "environment": Environment(**{name: value for name, (value, _) in conditions.items()}),
            "evidence": tuple(self.proofs.evidence),
            "unsupported": self._unsupported(),
        }
        scenario = FunctionalScenario.from_valid(parts, _FIELDS)  # each is checked where it is made
        for misfit in scenario.misfits():
            raise ValueError(misfit)
        return scenario

    def _name(self, ego: Entity) -> None:
        counts: dict[str, int] = {}
        called = ego.basis.i is None or "ego" in ego.named_by
        for entity in self.draft.entities:
            if entity is ego and called:
                entity.name = "ego"
                continue
            stem = f"parked_{entity.kind.value}" if entity.parked else entity.kind.value
            counts[stem] = counts.get(stem, 0) + 1
            entity.name = f"{stem}_{counts[stem]}"

    def _participant(self, entity: Entity, ego_basis: Basis, junction: Junction) -> Participant:
        path = f"participants.{entity.name}"
        self.proofs.add(f"{path}.kind", entity.counted or entity.basis)
        role, who = Role.OTHER, None
        if entity.ego:
            role, who = Role.EGO, ego_basis
        self.proofs.add(f"{path}.role", who, "everybody but the ego")
        values = self._values(entity, junction)
        for name, (value, basis) in values.items():
            if value:
                self.proofs.add(f"{path}.{name}", basis or entity.basis)
        for words in self._further_words(entity):
            self.proofs.add(f"{path}.approaches", words)
        said = {name: value for name, (value, _) in values.items()}
        return Participant(id=entity.name, kind=entity.kind, role=role, **said)

    def _values(self, entity: Entity, junction: Junction) -> dict[str, tuple[Any, Basis | None]]:
        """The fields of a participant, each with the words for it."""
        beside = _beside(entity)
        seen = {Approach.ADJACENT, Approach(beside[0])} if beside else entity.approaches
        if (along := self._in_next_lane(entity)) is not None:
            seen = seen | along[0]
        maneuvers = maneuvers_of(entity, junction, self.draft)
        circulates = entity.told.get("circulates")
        nobody = self.draft.implied if entity.is_vehicle and not entity.still else {}
        unmoved = entity.told.get("unmoved") or nobody.get("unmoved")
        ring = junction.kind is JunctionKind.ROUNDABOUT and circulates is not None
        light = self._light(entity, maneuvers, junction)
        delay = entity.green_delay if light[0] is AtLight.WAITS else None
        there = Maneuver.CROSS in maneuvers and junction.kind is not JunctionKind.STRAIGHT
        return {
            "parked": (entity.parked, entity.parked_basis),
            "approaches": (frozenset(seen), entity.approach_basis),
            "maneuvers": (frozenset(maneuvers), entity.maneuver_basis),
            "entries": (
                frozenset(a for a in entity.entries if a < junction.arms),
                entity.entry_basis,
            ),
            "lanes": (
                lanes_of(entity, junction),
                entity.start_lane[1] if entity.start_lane is not None else None,
            ),
            "circulating": (ring, circulates),
            "on_call": (entity.on_call is not None, entity.on_call),
            "unresponsive": (unmoved is not None, unmoved),
            "strip": entity.strip or _NOT_SAID,
            # on a road without a junction there is but one way to cross
            "crosses": entity.crosses if there and entity.crosses is not None else _NOT_SAID,
            "light": light,
            "green_delay_s": (delay.value, delay.basis) if delay is not None else _NOT_SAID,
            "speed_mps": (entity.speed, entity.speed_basis),
            **{name: (amount.value, amount.basis) for name, amount in entity.sizes.items()},
        }

    def _light(
        self, entity: Entity, maneuvers: Collection[Maneuver], junction: Junction
    ) -> tuple[AtLight | None, Basis | None]:
        """How it meets its light; reported where none stands for it, or can show that."""
        if entity.light is None:
            return None, None
        light, basis = entity.light
        afoot = not entity.is_vehicle or set(maneuvers) == {Maneuver.CROSS}
        shown = light in {AtLight.GREEN, AtLight.RED} or not afoot
        stands = entity.parked or Maneuver.STAY in maneuvers
        if junction.control is Control.SIGNALS and shown and not stands:
            return light, basis
        self.draft.note_at(basis, _NO_LIGHT)
        return None, None

    def _further_words(self, entity: Entity) -> list[Basis]:
        """Other words that say the same of where somebody comes from."""
        if not entity.approaches:
            return []
        found = [entity.by_heading] if entity.by_heading is not None else []
        placed = self.draft.placements_of(entity)
        found += [p.basis for p in placed if p.approaches & entity.approaches]
        told = [b for b in dict.fromkeys(found) if b.i is not None and b != entity.approach_basis]
        aside = (_beside(entity), self._in_next_lane(entity))
        return [*told, *(words for _, words in filter(None, aside))]

    def _in_next_lane(self, entity: Entity) -> tuple[set[Approach], Basis] | None:
        """Whether it is ahead or behind there; where one comes in ahead, that is where it ends."""
        along = entity.in_next_lane
        if along is None or not next_to(entity):
            return None
        into = [a.entity for a in self.happenings.acts if a.into is not None and a.into.ego]
        ego, own = self.draft.ego, entity.speed
        slower = own and ego is not None and ego.speed and own.high < ego.speed.low
        if slower and entity.by_ramp is not None and along[0] == {Approach.BEHIND}:
            return None  # "a truck at 80 km/h merges 20 m behind us": it falls back to there
        comes_in = entity in (*into, *self.draft.causing(*_COMING_IN))
        return None if comes_in and along[0] == {Approach.AHEAD} else along

    def _hazard(self, danger: Danger) -> Hazard:
        on_foot = danger.kind in {HazardKind.CROSSING_PEDESTRIAN, HazardKind.CROSSING_ANIMAL}
        # who stands or is overtaken hides those who come out in front: they meet somebody else
        passed = self.draft.suffering(HazardKind.OVERTAKING) if on_foot else []
        unmet = (*danger.by, *passed, *(e for e in danger.to if on_foot and (e.parked or e.stays)))
        to = [e for e in danger.to if e not in unmet]
        self.proofs.add(f"hazards.{danger.kind.value}", danger.basis)
        return Hazard(
            kind=danger.kind,
            by=tuple(e.name for e in (*danger.by, *danger.items)),
            to=tuple(e.name for e in to),
        )

    def _unsupported(self) -> tuple[Unsupported, ...]:
        found = []
        notes = sorted(self.draft.notes, key=lambda n: (n.i, n.j))
        for i, j, instead in dict.fromkeys((n.i, n.j, n.instead) for n in notes):
            start, end = self.proofs.span(i, j)
            text = self.draft.text[start:end]
            found.append(Unsupported(text=text, start=start, end=end, instead=instead))
        return tuple(found)


def _met_by_none(danger: Danger, ego: Entity) -> bool:
    """``the ego waits at the line, a bus turns left in front of it``: it is in no danger."""
    return ego.stays and danger.kind in _ON_THE_WAY and all(e is ego for e in danger.to)


def _beside(entity: Entity) -> tuple[str, Basis] | None:
    """On which side of the ego the lane of somebody beside it lies, with the words for that."""
    return entity.beside if entity.approaches == {Approach.ADJACENT} else None

"""What a functional scenario says about entries and moves, as numbered statements and facts.

Every statement keeps the words for it, so that a contradiction can be told to the user.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from clorm import Predicate

from scegen.enumeration import predicates as p
from scegen.scenario.arms import arm_angles_deg, seen_from, turn_deg, turn_name
from scegen.scenario.functional import FunctionalScenario, Junction, Participant
from scegen.scenario.vocabulary import Approach, DrivingSide, JunctionKind, Maneuver

QUEUE_LIMIT = 12
"""Vehicles that one approach road holds: 12 cars with their gaps fill about 120 m."""

ALONG = frozenset({Approach.AHEAD, Approach.BEHIND, Approach.ADJACENT})
"""Words that put two vehicles on one arm."""


@dataclass
class Stated:
    """Statements in the order of their numbers, the facts they come to, and remarks."""

    words: list[str] = field(default_factory=list)
    facts: list[Predicate] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    def number(self, words: str) -> int:
        """Register a statement."""
        self.words.append(words)
        self.facts.append(p.Statement(len(self.words) - 1))
        return len(self.words) - 1


def junction_facts(junction: Junction) -> list[Predicate]:
    """The arms, what the moves are called, and who sees whom from where."""
    angles = arm_angles_deg(junction)
    arms = range(junction.arms)
    facts: list[Predicate] = [p.Arms(junction.arms)]
    for entry in arms:
        facts += [p.Turn(entry, move, turn_name(angles, entry, move).value) for move in arms]
        bend = min(arms[1:], key=lambda move: (abs(turn_deg(angles, entry, move)), move))
        facts.append(p.Straightest(entry, bend))
        facts += [
            p.Sees(entry, other, word.value)
            for other in arms
            if other != entry
            for word in sorted(seen_from(angles, entry, other))
        ]
    facts += [p.Lanes(arm, number) for arm, number in enumerate(junction.lanes)]
    if junction.kind is JunctionKind.ROUNDABOUT:
        facts.append(p.Ring())
    if junction.driving_side is DrivingSide.LEFT:
        facts.append(p.LeftHand())
    return facts


def stated(functional: FunctionalScenario) -> Stated:
    """All statements about who enters where and does what."""
    out = Stated()
    vehicles, crossers = functional.vehicles, functional.crossers
    out.facts += junction_facts(functional.junction)
    out.facts += [p.Vehicle(v.id) for v in vehicles] + [p.VehicleCount(len(vehicles))]
    out.facts += [p.Crosser(c.id) for c in crossers] + [p.Ego(functional.ego.id)]
    out.facts += [p.Position(m.id, i) for i, m in enumerate((*vehicles, *crossers), start=1)]
    limit = out.number(f"at most {QUEUE_LIMIT} vehicles fit on one arm")
    out.facts.append(p.QueueLimit(limit, QUEUE_LIMIT))
    for vehicle in vehicles:
        _maneuvers(out, vehicle, functional.junction)
    for participant in (*vehicles, *crossers):
        if participant.entries:
            say_entries(out, participant.id, tuple(sorted(participant.entries)))
    _approaches(out, functional)
    _hazards(out, functional)
    for crosser in crossers:
        number = out.number(f"{crosser.id} crosses an arm that the ego uses (the default)")
        out.facts.append(p.DefaultPlace(number, crosser.id))
    return out


def say_entries(out: Stated, name: str, arms: tuple[int, ...]) -> None:
    """State that a participant enters at (or crosses) one of these arms."""
    number = out.number(f"{name} is limited to arm {_either(arms)}")
    out.facts.append(p.Entries(number, name))
    out.facts += [p.Entry(name, arm) for arm in arms]


def _maneuvers(out: Stated, vehicle: Participant, junction: Junction) -> None:
    if not vehicle.maneuvers:
        return
    words = [m for m in Maneuver if m in vehicle.maneuvers]
    number = out.number(f"{vehicle.id} does: {_either(words)}")
    out.facts.append(p.Maneuvers(number, vehicle.id))
    for word in words:
        if word.startswith("exit_"):
            exit_number = int(word.removeprefix("exit_"))
            if exit_number > junction.arms:
                continue
            # Traffic goes round counter-clockwise where it keeps right, clockwise where left.
            right = junction.driving_side is DrivingSide.RIGHT
            move = exit_number if right else junction.arms - exit_number
            out.facts.append(p.WantsMove(vehicle.id, move % junction.arms))
        elif word is Maneuver.CROSS:
            # A set with other words in it is a vehicle's: it crosses the junction.
            out.facts.append(p.Wants(vehicle.id, Maneuver.STRAIGHT.value))
        else:
            out.facts.append(p.Wants(vehicle.id, word.value))


def _approaches(out: Stated, functional: FunctionalScenario) -> None:
    ego = functional.ego.id
    known = {m.id for m in (*functional.vehicles, *functional.crossers)}
    drivers = {v.id for v in functional.vehicles}
    sayings = [(m.id, ego, m.approaches) for m in functional.participants if m.approaches]
    sayings += [(r.participant, r.reference, r.approaches) for r in functional.relations]
    for name, reference, approaches in sayings:
        if functional.participant(name).parked:
            continue  # where a parked vehicle stands is not enumerated
        words = _places([a for a in Approach if a in approaches])
        told = f"{name} comes from {_either(words)}, seen from {reference}"
        if name == reference or name not in known or reference not in drivers:
            out.notes.append(f"Not used: {told}.")
            continue
        number = out.number(told)
        out.facts.append(p.Approach(number, name, reference))
        out.facts += [p.Says(name, reference, word.value) for word in words]


def _places(words: list[Approach]) -> list[Approach]:
    """``adjacent`` together with a side is one place: the lane beside, on that side."""
    sides = [word for word in words if word in {Approach.LEFT, Approach.RIGHT}]
    if Approach.ADJACENT in words and len(sides) == 1:
        return [word for word in words if word not in sides]
    return words


def _hazards(out: Stated, functional: FunctionalScenario) -> None:
    explained = {evidence.field for evidence in functional.evidence}
    for hazard in functional.hazards:
        by, to = ", ".join(hazard.by) or "not said", ", ".join(hazard.to) or "not said"
        number = out.number(f"hazard {hazard.kind} (by {by}; to {to})")
        out.facts.append(p.Hazard(number, hazard.kind.value))
        out.facts += [p.By(number, name) for name in hazard.by]
        out.facts += [p.To(number, name) for name in hazard.to]
        if not hazard.to and f"hazards.{hazard.kind}.to" in explained:
            out.facts.append(p.LeftOpen(number))  # see guesses.py


def _either(words: tuple[int, ...] | list[Maneuver] | list[Approach]) -> str:
    return " or ".join(str(word) for word in words)

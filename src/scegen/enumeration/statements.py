"""What a functional scenario says about entries and moves, as numbered statements and facts.

Every statement keeps the words for it, so that a contradiction can be told to the user.
"""

from dataclasses import dataclass, field

from clorm import Predicate

from scegen.enumeration import predicates as p
from scegen.enumeration.directions import lanes_told
from scegen.enumeration.on_foot import way_facts, ways_of
from scegen.scenario.acts import ActKind
from scegen.scenario.arms import arm_angles_deg, ring_move, seen_from, turn_deg, turn_name
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.in_line import in_next_lane, words_between
from scegen.scenario.junction import Junction
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.roadway import AuxiliaryLane
from scegen.scenario.vocabulary import (
    Approach,
    CrossedArm,
    DrivingSide,
    HazardKind,
    JunctionKind,
    Maneuver,
)

QUEUE_LIMIT = 12
"""Vehicles that one approach road holds: 12 cars with their gaps fill about 120 m."""

ALONG_WORDS = frozenset({"ahead", "behind", "adjacent_left", "adjacent_right"})
"""Words that put two vehicles on one arm."""

MANNERS: dict[Maneuver, tuple[str, ...]] = {
    Maneuver.LANE_CHANGE: ("lane_change_left", "lane_change_right"),
    Maneuver.MERGE: ("lane_change_left", "lane_change_right"),
    Maneuver.EXIT: ("lane_change_left", "lane_change_right"),
    Maneuver.OVERTAKE: ("overtake",),
    Maneuver.STAY: ("stay",),
}
"""What the solver calls maneuvers that are no turns."""

_ARM_WORDS = {CrossedArm.ENTRY: "comes", CrossedArm.EXIT: "leaves"}
_ASIDE = frozenset({Approach.LEFT, Approach.RIGHT})


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
    ending = junction.auxiliary in {AuxiliaryLane.ON_RAMP, AuxiliaryLane.LANE_DROP}
    facts += [
        p.Lanes(arm, number + (1 if ending and arm == 0 else 0))
        for arm, number in enumerate(junction.lanes)
    ]
    if junction.kind is JunctionKind.ROUNDABOUT:
        facts.append(p.Ring())
    if junction.driving_side is DrivingSide.LEFT:
        facts.append(p.LeftHand())
    return facts


def stated(functional: FunctionalScenario) -> Stated:
    """All statements about who enters where and does what, but for dangers, acts and outcome."""
    out = Stated()
    vehicles, crossers = functional.vehicles, functional.crossers
    out.facts += junction_facts(functional.junction)
    out.facts += [p.Vehicle(v.id) for v in vehicles] + [p.VehicleCount(len(vehicles))]
    out.facts += [p.OnStrip(v.id) for v in vehicles if v.strip is not None]
    out.facts += [p.SquareToRoad(v.id) for v in vehicles if _backs_square(functional, v)]
    out.facts += [p.Crosser(c.id) for c in crossers] + [p.Ego(functional.ego.id)]
    out.facts += [p.Position(m.id, i) for i, m in enumerate((*vehicles, *crossers), start=1)]
    limit = out.number(f"at most {QUEUE_LIMIT} vehicles fit on one arm")
    out.facts.append(p.QueueLimit(limit, QUEUE_LIMIT))
    for vehicle in vehicles:
        _maneuvers(out, vehicle, functional.junction)
    for participant in (*vehicles, *crossers):
        if participant.entries:
            _entries(out, participant.id, tuple(sorted(participant.entries)))
    for vehicle in vehicles:
        if lanes := sorted(lanes_told(functional, vehicle)):
            number = out.number(f"{vehicle.id} is in lane {_either(tuple(lanes))}")
            out.facts.append(p.InLanes(number, vehicle.id))
            out.facts += [p.Lane(vehicle.id, lane) for lane in lanes]
    _approaches(out, functional)
    _groups(out, functional)
    if crossers:
        out.facts += way_facts()
    for crosser in crossers:
        out.facts += [p.OnFoot(crosser.id, way) for way in ways_of(functional, crosser)]
        number = out.number(f"{crosser.id} is where the ego drives (the default)")
        out.facts.append(p.DefaultPlace(number, crosser.id))
        if crosser.crosses is not None:
            told = _ARM_WORDS[crosser.crosses]
            number = out.number(f"{crosser.id} crosses the arm by which whom it meets {told}")
            out.facts.append(p.SaysArm(number, crosser.id, crosser.crosses.value))
    return out


def _entries(out: Stated, name: str, arms: tuple[int, ...]) -> None:
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
            if junction.kind is JunctionKind.ROUNDABOUT and exit_number <= junction.arms:
                out.facts.append(p.WantsMove(vehicle.id, ring_move(junction, exit_number)))
        elif word in {Maneuver.MERGE, Maneuver.EXIT}:
            out.facts.append(p.Wants(vehicle.id, Maneuver.LANE_CHANGE.value))
            side = junction.kerb if word is Maneuver.EXIT else junction.kerb.opposite
            out.facts.append(p.Goes(vehicle.id, side.value))
        elif word is Maneuver.CROSS:
            # A set with other words in it is a vehicle's: it crosses the junction.
            out.facts.append(p.Wants(vehicle.id, Maneuver.STRAIGHT.value))
        else:
            out.facts.append(p.Wants(vehicle.id, word.value))


def _approaches(out: Stated, functional: FunctionalScenario) -> None:
    known = {m.id for m in (*functional.vehicles, *functional.crossers)}
    drivers = {v.id for v in functional.vehicles}
    reversing = {n for h in functional.hazards if h.kind is HazardKind.REVERSING for n in h.by}
    for name, reference, approaches in functional.sayings:
        if functional.participant(name).parked:
            continue  # where a parked vehicle stands is not enumerated
        said = [a for a in Approach if a in approaches]
        told = f"{name} comes from {_either(said)}, seen from {reference}"
        if name == reference or name not in known or reference not in drivers:
            out.notes.append(f"Not used: {told}.")
            continue
        number = out.number(told)
        out.facts.append(p.Approach(number, name, reference))
        open_road = functional.junction.kind is JunctionKind.STRAIGHT and name not in reversing
        open_road &= not _passes_behind(functional, name, reference)
        on_foot = name not in drivers
        words = _places(said, open_road=open_road and not on_foot)
        out.facts += [p.Says(name, reference, word) for word in words]


def _places(words: list[Approach], *, open_road: bool) -> list[str]:
    """The words for places: ``adjacent`` is on either side, or with a side on that one.

    Whether that is ahead or behind there makes no difference to lanes and arms. On a road without
    a junction nobody comes from the side but out of the next lane.
    """
    sides = [word for word in words if word in {Approach.LEFT, Approach.RIGHT}]
    others = [word.value for word in words if word not in sides and word is not Approach.ADJACENT]
    if in_next_lane(words) is not None:
        others = []
    if Approach.ADJACENT in words:
        lanes = sides if len(sides) == 1 else [Approach.LEFT, Approach.RIGHT]
        arms = [] if len(sides) == 1 else sides
    else:
        lanes, arms = (sides, []) if open_road else ([], sides)
    return [*others, *(word.value for word in arms), *(f"adjacent_{side}" for side in lanes)]


def _groups(out: Stated, functional: FunctionalScenario) -> None:
    drivers = {v.id for v in functional.vehicles}
    for index, group in enumerate(functional.groups):
        members = [name for name in group.members if name in drivers]
        words = _either([m for m in Maneuver if m in group.maneuvers])
        of = f"{group.number} of {len(group.members)} ({group.members[0]}, …)"
        number = out.number(f"{of} do: {words}")
        out.facts.append(p.SomeOf(number, index, group.number, len(members)))
        out.facts += [p.InGroup(index, name) for name in members]
        out.facts += [
            p.GroupWay(index, entry, move, manner)
            for entry in range(functional.junction.arms)
            for move, manner in group_ways(functional.junction, group.maneuvers, entry)
        ]


def group_ways(
    junction: Junction, words: frozenset[Maneuver], entry: int
) -> frozenset[tuple[int, str]]:
    """The moves and manners from an arm that are one of these maneuvers."""
    angles, arms = arm_angles_deg(junction), range(junction.arms)
    found: set[tuple[int, str]] = set()
    for word in words:
        if word.startswith("exit_"):
            found.add((ring_move(junction, int(word.removeprefix("exit_"))), "plain"))
        elif word in MANNERS:
            found |= {(move, manner) for move in arms for manner in MANNERS[word]}
        else:
            found |= {(m, "plain") for m in arms if turn_name(angles, entry, m) is word}
    return frozenset(found)


def _either(words: tuple[int, ...] | list[Maneuver] | list[Approach]) -> str:
    return " or ".join(str(word) for word in words)


def _backs_square(functional: FunctionalScenario, vehicle: Participant) -> bool:
    """Whether one that backs out goes straight back, as far as the words go.

    It stands beside the lanes, or others come past from a side of it, or it stops there, or at a
    junction it is said to go straight or to be hit; who is said to turn does that.
    """
    name, outcome = vehicle.id, functional.outcome
    if vehicle.maneuvers - {Maneuver.STRAIGHT}:
        return False
    if vehicle.strip is not None or any(
        _passes_behind(functional, other.id, name) for other in functional.vehicles
    ):
        return True
    hit = outcome is not None and outcome.kind is OutcomeKind.COLLISION and name in outcome.between
    own = [act.kind for act in functional.acts if act.participant == name]
    hit |= own[:2] == [ActKind.REVERSE, ActKind.STOP]
    if functional.junction.kind is JunctionKind.STRAIGHT:
        return hit and bool(vehicle.approaches) and vehicle.approaches <= _ASIDE
    return hit or bool(vehicle.maneuvers)


def _passes_behind(functional: FunctionalScenario, name: str, reference: str) -> bool:
    """Whether somebody comes from one side of another, who reverses towards it."""
    said = words_between(functional, name, reference)
    return frozenset() < said <= _ASIDE and any(
        hazard.kind is HazardKind.REVERSING
        and reference in hazard.by
        and (not hazard.to or name in hazard.to)
        for hazard in functional.hazards
    )

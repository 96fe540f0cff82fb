"""Concrete scenario (PEGASUS level 3): every number that the simulator files are made of.

The file is meant to be edited by hand: change a number, generate from it again. Positions
along a drive are metres travelled from the outer end of the entry arm.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from scegen.scenario.bodies import BODIES, LENGTHS_M, WIDTHS_M, Body
from scegen.scenario.environment import Environment
from scegen.scenario.functional import Hazard
from scegen.scenario.junction import MAX_LANES
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.model import CheckedModel, FrozenModel, Identifier
from scegen.scenario.objects import StaticObject
from scegen.scenario.reversing import Reversal
from scegen.scenario.road_parameters import RoadParameters
from scegen.scenario.roadway import Strip
from scegen.scenario.signals import SignalPlan
from scegen.scenario.vocabulary import HazardKind, ParticipantKind, Role, Side

MOST_RATE_MPS2 = 20.0
"""Twice of what a tyre holds on a dry road: beyond what any body brakes or gains speed with."""
LATEST = 1.3
"""A scenario whose ego is late is over after this many times its duration."""


class AtTime(FrozenModel):
    """Fires when the simulation time reaches ``time_s``."""

    measured: ClassVar = "time_s"
    type: Literal["time"] = "time"
    time_s: float = Field(ge=0)


class Travelled(FrozenModel):
    """Fires when ``participant`` has travelled ``distance_m`` since its start."""

    measured: ClassVar = "distance_m"
    type: Literal["travelled"] = "travelled"
    participant: Identifier
    distance_m: float = Field(ge=0)


class DistanceBelow(FrozenModel):
    """Fires when the straight distance to ``participant`` falls below ``distance_m``.

    Measured between the entities' reference points (freespace off).
    """

    measured: ClassVar = "distance_m"
    type: Literal["distance_below"] = "distance_below"
    participant: Identifier
    distance_m: float = Field(gt=0)


class ArrivalBelow(FrozenModel):
    """Fires when ``participant`` would reach a place within less than ``time_s``.

    The place is where it is after ``place_m`` of its way from its start. Time to arrival is the
    straight distance of its reference point from there, divided by its speed; it is undefined
    while it stands, and once the place lies behind it.
    """

    measured: ClassVar = "time_s"
    type: Literal["arrival_below"] = "arrival_below"
    participant: Identifier
    place_m: float = Field(ge=0)
    time_s: float = Field(gt=0)


class StoodStill(FrozenModel):
    """Fires when ``participant`` has stood still for ``duration_s`` without a break."""

    measured: ClassVar = "duration_s"
    type: Literal["stood_still"] = "stood_still"
    participant: Identifier
    duration_s: float = Field(gt=0)


Trigger = Annotated[
    AtTime | Travelled | DistanceBelow | ArrivalBelow | StoodStill, Field(discriminator="type")
]
"""``measured`` names the field whose value decides when a trigger fires."""


class SpeedPhase(FrozenModel):
    """When ``trigger`` fires, change speed linearly to ``target_speed_mps`` at ``rate_mps2``.

    ``hazard`` names the danger that the phase serves, ``act`` the act of the description that it
    is. Phases start in order: a phase can only fire once its predecessor has fired.
    """

    trigger: Trigger
    target_speed_mps: float = Field(ge=0, le=100)
    rate_mps2: float = Field(gt=0, le=MOST_RATE_MPS2)
    hazard: HazardKind | None = None
    act: Identifier | None = None

    @property
    def numbers(self) -> dict[str, float]:
        """Its numbers by their places in it."""
        measured = self.trigger.measured
        return {
            f"trigger.{measured}": float(getattr(self.trigger, measured)),
            "target_speed_mps": self.target_speed_mps,
            "rate_mps2": self.rate_mps2,
        }


class OnContact(FrozenModel):
    """What a collision does to one who takes part in it.

    As soon as its box touches that of ``participant``, an object or somebody who takes part, its
    speed program is over, and it comes to rest at ``rate_mps2``.
    """

    participant: Identifier
    rate_mps2: float = Field(gt=0, le=400)


MOST_STRIPS = 3
"""So many strips lie beside the lanes at most; they are numbered after them."""
MOST_OFFSET_M = 12.0
"""So far beside the middle of its lane may somebody drive or stand."""


class LaneChange(FrozenModel):
    """A change of lane baked into the path.

    At ``position_m`` along the drive the vehicle starts to move into ``lane_after``, and has
    arrived ``length_m`` later, ``offset_m`` to its own left of that lane's centre. A change within
    the lane has the same lane after it. Lanes count from 1 at the centre line outwards; 0 stands
    for the lane of oncoming traffic next to the centre line. In a ring, 1 is the innermost lane.
    """

    position_m: float = Field(ge=0)
    length_m: float = Field(gt=0)
    lane_after: int = Field(ge=0, le=MAX_LANES + MOST_STRIPS)
    offset_m: float = Field(default=0.0, ge=-MOST_OFFSET_M, le=MOST_OFFSET_M)
    hazard: HazardKind | None = None


class DriveMotion(FrozenModel):
    """A way along the road. It starts ``start_m`` along the drive, in lane ``entry_lane``.

    There it keeps ``offset_m`` to its own left of the lane's centre. The numbers beyond the
    outermost lane are those of the strips beside it, outwards; lane 0 that of the oncoming traffic
    next to the centre line.
    ``turning_starts_m`` and ``turning_ends_m`` are where the junction (or ring) begins and
    ends on its way; they follow from the road and are checked, not obeyed. ``reversal`` is a
    part of the way that it drives backwards.
    """

    type: Literal["drive"] = "drive"
    entry: int = Field(ge=0)
    entry_lane: int = Field(ge=0, le=MAX_LANES + MOST_STRIPS)
    exit: int = Field(ge=0)
    exit_lane: int = Field(ge=0, le=MAX_LANES + MOST_STRIPS)
    ring_lane: int | None = Field(default=None, ge=1, le=2)
    start_m: float = Field(ge=0)
    offset_m: float = Field(default=0.0, ge=-MOST_OFFSET_M, le=MOST_OFFSET_M)
    turning_starts_m: float
    turning_ends_m: float
    lane_changes: tuple[LaneChange, ...] = ()
    reversal: Reversal | None = None


class CrossingMotion(FrozenModel):
    """Walks or rides across arm ``arm``, ``from_junction_m`` before its inner end.

    Starts ``setback_m`` outside the carriageway on ``start_side``, seen by entering traffic;
    stops after ``stops_after_m`` on its way, or goes across (None).
    """

    type: Literal["crossing"] = "crossing"
    arm: int = Field(ge=0)
    start_side: Side
    from_junction_m: float = Field(ge=0)
    setback_m: float = Field(ge=0)
    stops_after_m: float | None = Field(default=None, gt=0)


class StandingMotion(FrozenModel):
    """Stands on arm ``arm``, ``from_junction_m`` before its inner end (rear axle), on ``side``.

    ``strip`` is the one beside the lanes on which it stands; None: the one for standing vehicles.
    """

    type: Literal["standing"] = "standing"
    arm: int = Field(ge=0)
    side: Side
    from_junction_m: float = Field(ge=0)
    in_lane: bool = False
    strip: Strip | None = None


def door_of(vehicle: str) -> str:
    """The name of a vehicle's door."""
    return f"{vehicle[:35]}_door"


class SwingingMotion(FrozenModel):
    """The door of ``vehicle``, on the side of the traffic; it swings open as it moves.

    ``stands``, ``kind`` and its sizes are where that vehicle stands and what it is.
    """

    type: Literal["swinging"] = "swinging"
    vehicle: Identifier
    kind: ParticipantKind
    stands: StandingMotion
    length_m: float | None = None
    width_m: float | None = None

    @property
    def of(self) -> Body:
        """Its vehicle's size."""
        return BODIES[self.kind].sized(self.length_m, self.width_m)

    @property
    def arm(self) -> int:
        """The arm on which its vehicle stands."""
        return self.stands.arm


Motion = Annotated[
    DriveMotion | CrossingMotion | StandingMotion | SwingingMotion, Field(discriminator="type")
]


class ConcreteParticipant(FrozenModel):
    """A participant with its way and its speed program (empty = keeps ``speed_mps``).

    ``on_contact`` is None where nothing it touches stops it, ``length_m`` and ``width_m`` where it
    is as large as its kind usually is.
    """

    id: Identifier
    kind: ParticipantKind
    role: Role = Role.OTHER
    parked: bool = False
    speed_mps: float = Field(ge=0, le=100)
    motion: Motion
    speed_program: tuple[SpeedPhase, ...] = ()
    on_contact: OnContact | None = None
    length_m: float | None = Field(default=None, ge=LENGTHS_M[0], le=LENGTHS_M[1])
    width_m: float | None = Field(default=None, ge=WIDTHS_M[0], le=WIDTHS_M[1])

    @property
    def body(self) -> Body:
        """Its size and its limits."""
        return BODIES[self.kind].sized(self.length_m, self.width_m)


class Rejected(FrozenModel):
    """A value that somebody proposed and that was not taken: whose, which, why not."""

    by: str
    value: str
    why: str


class Change(FrozenModel):
    """Provenance: who set a parameter, from what, to what, and why.

    ``rejected`` is a value that was proposed instead; ``after`` is None if nothing took its place.
    """

    parameter: str
    by: str
    before: float | None = None
    after: float | None = None
    reason: str
    rejected: Rejected | None = None


class ConcreteScenario(CheckedModel):
    """All numbers of one scenario; ``hazards`` may name objects as their cause.

    ``signals`` is what its lights show, on its own clock; None where there are none.
    """

    level: Literal["concrete"] = "concrete"
    name: str = Field(pattern=r"^[A-Za-z0-9_-]+$", max_length=100)
    description: str = ""
    seed: int = Field(ge=0)
    logical: LogicalScenario
    road: RoadParameters
    participants: tuple[ConcreteParticipant, ...] = Field(min_length=1)
    objects: tuple[StaticObject, ...] = ()
    environment: Environment = Environment()
    hazards: tuple[Hazard, ...] = ()
    duration_s: float = Field(gt=0, le=600)
    signals: SignalPlan | None = None
    provenance: tuple[Change, ...] = ()

    def misfits(self) -> Iterator[str]:
        """See CheckedModel."""
        egos = [p.id for p in self.participants if p.role is Role.EGO]
        if len(egos) != 1:
            yield f"exactly one participant must have the role ego, found {egos or 'none'}"
        ids = [p.id for p in self.participants]
        everything = [entity.id for entity in self.entities]
        if len(set(everything)) != len(everything):
            yield f"ids of participants and objects are not unique: {sorted(everything)}"
        for participant in self.participants:
            if isinstance(motion := participant.motion, SwingingMotion):
                on = {p.id: (p.body, p.motion) for p in self.participants}
                if on.get(motion.vehicle) != (motion.of, motion.stands):
                    yield f"{participant.id} does not hang on {motion.vehicle}, as that one stands"
            for phase in participant.speed_program:
                reference = getattr(phase.trigger, "participant", None)
                if reference is not None and reference not in ids:
                    yield f"a trigger of {participant.id} names the unknown {reference!r}"
            struck = participant.on_contact
            if struck is not None and struck.participant not in {*everything} - {participant.id}:
                yield f"on_contact of {participant.id} names the unknown {struck.participant!r}"

    def changed(
        self, people: Iterable[ConcreteParticipant], changes: Iterable[Change] = (), **more: object
    ) -> ConcreteScenario:
        """The scenario with these participants in place of its own, and what is told of that."""
        told = (*self.provenance, *changes)
        return self.but(participants=tuple(people), provenance=told, **more)

    def with_participant(self, fresh: ConcreteParticipant) -> ConcreteScenario:
        """The scenario with this version of a participant in place of its own."""
        return self.changed(fresh if p.id == fresh.id else p for p in self.participants)

    @property
    def latest_end_s(self) -> float:
        """When the scenario ends if the ego has not come as far as planned by ``duration_s``."""
        return LATEST * self.duration_s

    @property
    def entities(self) -> tuple[ConcreteParticipant | StaticObject, ...]:
        """The participants, then the objects: whoever has a body."""
        return (*self.participants, *self.objects)

    @property
    def ego_first(self) -> tuple[ConcreteParticipant, ...]:
        """The participants as files list them: for who does not know its name, the ego is first."""
        return tuple(sorted(self.participants, key=lambda p: p.role is not Role.EGO))

    @property
    def ego(self) -> ConcreteParticipant:
        """The vehicle under test."""
        return next(p for p in self.participants if p.role is Role.EGO)

    def participant(self, name: str) -> ConcreteParticipant:
        """The participant with this id; KeyError if there is none."""
        return {p.id: p for p in self.participants}[name]

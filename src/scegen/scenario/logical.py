"""Logical scenarios (PEGASUS level 2): who enters and leaves where, and parameter ranges.

One functional scenario has a set of logical ones; the set says how it was reduced and how
many assignments stand behind every scenario, so that nothing is merged in silence.
"""

from enum import StrEnum
from typing import Literal

from pydantic import Field

from scegen.scenario.acts import Act
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.model import FrozenModel, Identifier
from scegen.scenario.parameters import ParameterRange
from scegen.scenario.vocabulary import ArmsMode, Maneuver, Reduction, Side


class Reverses(StrEnum):
    """How one that reverses comes to do so.

    ``backs_up``: it stops on its way and goes back on it. The others come out backwards, rear
    first, into the lane of whoever suffers it, and drive on from there: ``out_of_arm`` from the
    arm where it enters, ``from_right`` and ``from_left`` from beside a road without a junction;
    or they stand ``square`` to the road, on that arm or beside that lane, and go straight back.
    """

    BACKS_UP = "backs_up"
    OUT_OF_ARM = "out_of_arm"
    FROM_RIGHT = "from_right"
    FROM_LEFT = "from_left"
    SQUARE = "square"


class Heading(StrEnum):
    """Which way somebody walks along an arm: as the traffic that enters on it, or against it."""

    INWARD = "inward"
    OUTWARD = "outward"


class InLine(FrozenModel):
    """The place of one who uses a lane of an arm, among the others there.

    ``rank`` orders those of one arm, 0 = foremost, the first at the junction; it is shared by
    those side by side. Who is said to be ahead or behind is in the same lane. ``lane`` is counted
    from 1 at the centre line outwards, None where the text does not limit it. ``beside`` names the
    one next to whom it is, in the next lane, and ``beside_on`` the side of that one on which.
    """

    participant: Identifier
    rank: int = Field(default=0, ge=0)
    lane: int | None = Field(default=None, ge=0)
    beside: Identifier | None = None
    beside_on: Side | None = None


class Drive(InLine):
    """A vehicle's assignment: enters at arm ``entry``, makes move ``move``, leaves at ``exit``.

    ``turn`` names the movement by geometry; ``maneuver`` is what it does beside (a lane
    change, an overtake), or the same as ``turn``; ``stay``: it stands in its lane all the time,
    with everything else as for one who drives. ``changes_to`` is its own side to which it changes
    lane, None where it does not. ``circulating``: it is in the ring at the start, as if it had
    entered at ``entry``. ``reverses`` says how it comes to drive backwards, None if it does not.
    """

    type: Literal["drive"] = "drive"
    entry: int = Field(ge=0)
    move: int = Field(ge=0)
    exit: int = Field(ge=0)
    turn: Maneuver
    maneuver: Maneuver
    changes_to: Side | None = None
    circulating: bool = False
    reverses: Reverses | None = None


class Crossing(FrozenModel):
    """A pedestrian's or cyclist's assignment: crosses arm ``arm``, starting on side ``start``."""

    type: Literal["crossing"] = "crossing"
    participant: Identifier
    arm: int = Field(ge=0)
    start: Side


class Standing(InLine):
    """Who stands beside the lanes of arm ``arm``, and a pedestrian who stands in one.

    ``side`` is the side of the road, seen by traffic that enters on the arm. ``in_lane`` says that
    it blocks a lane of the traffic that keeps to that side, instead of standing beside it: where
    traffic keeps right, the right is the side of who enters, the left of who leaves.
    """

    type: Literal["standing"] = "standing"
    arm: int = Field(ge=0)
    side: Side = Side.RIGHT
    in_lane: bool = False


class Walking(InLine):
    """A pedestrian's assignment: walks along arm ``arm``, on side ``side`` as of a Standing.

    ``in_lane``: in a lane of the traffic that keeps to that side, instead of beside it.
    """

    type: Literal["walking"] = "walking"
    arm: int = Field(ge=0)
    side: Side = Side.RIGHT
    in_lane: bool = False
    heading: Heading = Heading.INWARD


Assignment = Drive | Crossing | Standing | Walking


class ConflictKind(StrEnum):
    """How the paths of two participants meet."""

    CROSSING = "crossing"
    MERGING = "merging"
    DIVERGING = "diverging"
    FOLLOWING = "following"
    NONE = "none"


MEETING = frozenset({ConflictKind.CROSSING, ConflictKind.MERGING})
"""Where two come into one place from different ways."""


class Rule(StrEnum):
    """Why one of two gives way, or why it cannot be said in advance who does.

    ``signal`` and ``first_come`` name nobody: the light decides, or who is first on the ring.
    """

    ON_CALL = "on_call"
    SIGN = "sign"
    PRIORITY_TO_RIGHT = "priority_to_right"
    ONCOMING = "oncoming"
    RING = "ring"
    U_TURN = "u_turn"
    SIGNAL = "signal"
    FIRST_COME = "first_come"
    CROSSWALK = "crosswalk"
    NO_CROSSWALK = "no_crosswalk"
    AHEAD = "ahead"
    LANE_CHANGE = "lane_change"


class Conflict(FrozenModel):
    """A pair of participants whose paths meet.

    ``yields`` must give way by ``rule``; None if neither need, or if nobody can say in advance.
    """

    first: Identifier
    second: Identifier
    kind: ConflictKind
    yields: Identifier | None = None
    rule: Rule | None = None


class LogicalScenario(FrozenModel):
    """One distinct traffic scenario.

    ``pattern`` is the multiset of the drivers' symbolic moves, sorted (the source paper's
    caption); ``class_size`` counts the assignments that the reduction holds to be this one.
    ``hazards`` are the functional ones with everybody named who causes and who suffers them,
    ``acts`` the functional ones with the side to which they go and into whose lane.
    ``deadlock`` are those of whom each must wait for another of them, if all who are first on
    their arms arrive at once.
    """

    index: int = Field(ge=0)
    slug: str = Field(pattern=r"^[a-z0-9-]+$")
    pattern: tuple[int, ...]
    class_size: int = Field(default=1, ge=1)
    assignments: tuple[Assignment, ...]
    hazards: tuple[Hazard, ...] = ()
    acts: tuple[Act, ...] = ()
    conflicts: tuple[Conflict, ...] = ()
    deadlock: tuple[Identifier, ...] = ()
    parameters: tuple[ParameterRange, ...] = ()

    @property
    def name(self) -> str:
        """Its number and its slug, as people call it."""
        return f"{self.index:03d}-{self.slug}"

    @property
    def drives(self) -> tuple[Drive, ...]:
        """The assignments of vehicles that drive."""
        return tuple(a for a in self.assignments if isinstance(a, Drive))

    @property
    def crossings(self) -> tuple[Crossing, ...]:
        """The assignments of those who cross an arm."""
        return tuple(a for a in self.assignments if isinstance(a, Crossing))

    @property
    def standings(self) -> tuple[Standing, ...]:
        """The assignments of parked vehicles, and of pedestrians who stand."""
        return tuple(a for a in self.assignments if isinstance(a, Standing))

    def stand_before(self, participant: str) -> tuple[str, ...]:
        """Who stands on its arm before somebody who drives: nobody before one who does not."""
        lined = {drive.participant: drive for drive in self.drives}
        if (own := lined.get(participant)) is None:
            return ()
        return tuple(
            drive.participant
            for drive in self.drives
            if drive.maneuver is Maneuver.STAY
            and drive.entry == own.entry
            and drive.rank < own.rank
        )

    def assignment(self, participant: str) -> Assignment:
        """The assignment of one participant; KeyError if it has none."""
        return {a.participant: a for a in self.assignments}[participant]


class Certificate(FrozenModel):
    """What the enumeration claims: ``total`` assignments fall into ``count`` scenarios.

    ``matching`` of these are as asked for (``--where``); None if all are, or if the list ends
    before all were looked at. ``complete``: the list holds all that are as asked for.
    ``group_order`` is the number of symmetries by which the reduction ``exact`` divides (rotations
    times swaps), ``symmetry`` tells them in words. ``looked_at`` sums the class sizes of all
    scenarios that were looked at: where none is missing, it is the total.
    """

    total: int = Field(ge=0)
    count: int = Field(ge=0)
    complete: bool
    method: str
    matching: int | None = None
    group_order: int | None = None
    symmetry: str | None = None
    looked_at: int | None = None


class LogicalSet(FrozenModel):
    """All logical scenarios of one functional scenario, under one reduction."""

    level: Literal["logical"] = "logical"
    functional: FunctionalScenario
    reduction: Reduction
    arms: ArmsMode
    certificate: Certificate
    notes: tuple[str, ...] = ()
    scenarios: tuple[LogicalScenario, ...]

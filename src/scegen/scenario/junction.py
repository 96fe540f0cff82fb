"""The road network that a description speaks of."""

from collections.abc import Iterator

from pydantic import Field

from scegen.scenario.bends import Bend
from scegen.scenario.model import ArmSet, CheckedModel, VocabularySet
from scegen.scenario.roadway import (
    AUXILIARY_LENGTHS_M,
    BESIDE_AN_AUXILIARY_LANE,
    LANE_WIDTH_M,
    LANE_WIDTHS_M,
    NOT_BESIDE_A_SHOULDER,
    PLAIN_ROAD_STRIPS,
    AuxiliaryLane,
    Carriageway,
    Strip,
)
from scegen.scenario.vocabulary import Control, DrivingSide, JunctionKind, Side

MAX_ARMS = 8
MAX_LANES = 4
"""Lanes per direction on a road without a junction; at junctions one less."""
ARM_COUNTS: dict[JunctionKind, tuple[int, int]] = {
    JunctionKind.STRAIGHT: (2, 2),
    JunctionKind.T: (3, 3),
    JunctionKind.Y: (3, 3),
    JunctionKind.FOUR_WAY: (4, 4),
    JunctionKind.SKEWED: (4, 4),
    JunctionKind.MULTI_WAY: (3, MAX_ARMS),
    JunctionKind.ROUNDABOUT: (3, 6),
}
"""Fewest and most arms of each junction kind."""


class Junction(CheckedModel):
    """The road network that a description speaks of.

    ``arm_angles_deg`` are the directions of the arms seen from the centre, in degrees
    counter-clockwise from east, one per arm in rising order; empty means the kind's own.
    ``lanes`` is the number of lanes per direction of each arm; empty means as many as are needed;
    ``lane_width_m`` is how wide each is, None as wide as usual.
    ``crosswalks`` are the arms that a marked crosswalk runs across, on a road without a junction
    one arm at most: who crosses does so there. ``strips`` lie all along the lanes. A road without a
    junction may have another ``carriageway`` than the usual, a ``bend``, which the ego enters at
    arm 0 if its side is said, and an ``auxiliary`` lane beside those in the direction that enters
    at arm 0, the ego's; ``lanes`` does not count it; ``auxiliary_length_m`` is how long it has its
    full width, None as long as is usual and needed.
    """

    kind: JunctionKind
    arms: int = Field(ge=2, le=MAX_ARMS)
    arm_angles_deg: tuple[float, ...] = ()
    lanes: tuple[int, ...] = ()
    lane_width_m: float | None = Field(default=None, ge=LANE_WIDTHS_M[0], le=LANE_WIDTHS_M[1])
    ring_lanes: int | None = Field(default=None, ge=1, le=2)
    speed_limit_mps: float | None = Field(default=None, gt=0, le=70)
    driving_side: DrivingSide = DrivingSide.RIGHT
    control: Control = Control.UNCONTROLLED
    crosswalks: ArmSet = frozenset()
    carriageway: Carriageway = Carriageway.UNDIVIDED
    strips: VocabularySet[Strip] = frozenset()
    bend: Bend | None = None
    auxiliary: AuxiliaryLane | None = None
    auxiliary_length_m: float | None = Field(
        default=None, ge=AUXILIARY_LENGTHS_M[0], le=AUXILIARY_LENGTHS_M[1]
    )

    @property
    def through_lanes(self) -> int:
        """Lanes that go on beside an auxiliary one; where none are said, as few as are usual."""
        usual = 2 if self.carriageway is Carriageway.DIVIDED else 1
        return self.lanes[0] if self.lanes else usual

    @property
    def kerb(self) -> Side:
        """The side on which those who enter have the kerb."""
        return Side(self.driving_side.value)

    @property
    def lanes_wide_m(self) -> float:
        """How wide its lanes are, where nothing is said as wide as is usual."""
        return self.lane_width_m or LANE_WIDTH_M

    def misfits(self) -> Iterator[str]:
        """See CheckedModel."""
        fewest, most = ARM_COUNTS[self.kind]
        if not fewest <= self.arms <= most:
            wanted = f"{fewest}" if fewest == most else f"{fewest} to {most}"
            yield f"a {self.kind} junction has {wanted} arms, not {self.arms}"
        if self.arm_angles_deg and len(self.arm_angles_deg) != self.arms:
            yield f"arm_angles_deg gives {len(self.arm_angles_deg)} angles for {self.arms} arms"
        if list(self.arm_angles_deg) != sorted(a % 360 for a in self.arm_angles_deg):
            yield "arm_angles_deg must rise from arm to arm within [0, 360)"
        if self.lanes and len(self.lanes) != self.arms:
            yield f"lanes gives {len(self.lanes)} numbers for {self.arms} arms"
        most = MAX_LANES if self.kind is JunctionKind.STRAIGHT else MAX_LANES - 1
        if any(not 1 <= count <= most for count in self.lanes):
            yield "lanes per direction must be 1, 2 or 3; on a road without a junction also 4"
        if self.ring_lanes is not None and self.kind is not JunctionKind.ROUNDABOUT:
            yield "ring_lanes is only for a roundabout"
        if self.bend is not None and self.arm_angles_deg:
            yield "a road has a bend or arm_angles_deg, not both"
        if self.bend is not None and self.auxiliary is not None:
            yield "a road has a bend or an auxiliary lane, not both"
        if any(not 0 <= arm < self.arms for arm in self.crosswalks):
            yield f"crosswalks names an arm outside 0..{self.arms - 1}"
        if self.kind is JunctionKind.STRAIGHT and len(self.crosswalks) > 1:
            yield "a road without a junction has one crosswalk at most"
        if self.crosswalks and self.auxiliary is not None:
            yield "a road has a crosswalk or an auxiliary lane, not both"
        yield from self._fits_along()

    def _fits_along(self) -> Iterator[str]:
        """What lies along the road goes with its kind, and with what else lies there."""
        if self.kind is not JunctionKind.STRAIGHT:
            for field in ("carriageway", "bend", "auxiliary"):
                if getattr(self, field) != Junction.model_fields[field].default:
                    yield f"{field} is only for a road without a junction, kind straight"
            if interrupted := self.strips & PLAIN_ROAD_STRIPS:
                yield f"strips: {min(interrupted)} is only for a road without a junction"
        beside = self.strips & NOT_BESIDE_A_SHOULDER
        if Strip.HARD_SHOULDER in self.strips and beside:
            yield f"strips: a road has a hard_shoulder or a {min(beside)}, not both"
        if self.auxiliary_length_m is not None and self.auxiliary is None:
            yield "auxiliary_length_m is of an auxiliary lane; say which in auxiliary"
        beside = self.strips - BESIDE_AN_AUXILIARY_LANE
        if self.auxiliary is not None and beside:
            yield f"strips: no {min(beside)} lies beside an auxiliary lane"

"""All numbers that determine a road network."""

from pydantic import Field

from scegen.scenario.junction import MAX_ARMS, MAX_LANES
from scegen.scenario.model import ArmSet, FrozenModel, VocabularySet
from scegen.scenario.roadway import LANE_WIDTH_M, LANE_WIDTHS_M, AuxiliaryLane, Carriageway, Strip
from scegen.scenario.vocabulary import Control, DrivingSide, JunctionKind


class ArmRoad(FrozenModel):
    """One arm of the junction.

    ``angle_deg`` is its direction seen from the centre, counter-clockwise from east;
    ``angle_to_previous_deg`` the angle from the arm before it. ``lanes_in`` lead to the
    junction, ``lanes_out`` away from it; in right-hand traffic the road, which runs towards
    the junction, has them as its right and left lanes. Only a one-way road has none of one kind.
    """

    id: int = Field(ge=0)
    length_m: float = Field(gt=0, le=2000)
    angle_deg: float = Field(ge=0, lt=360)
    angle_to_previous_deg: float
    lanes_in: int = Field(ge=0, le=MAX_LANES)
    lanes_out: int = Field(ge=0, le=MAX_LANES)
    lane_width_m: float = Field(default=LANE_WIDTH_M, ge=LANE_WIDTHS_M[0], le=LANE_WIDTHS_M[1])
    speed_limit_mps: float = Field(gt=0, le=70)


class Turn(FrozenModel):
    """A way through a crossing beside the usual ones; with ``radius_m`` it turns so tightly."""

    entry: int = Field(ge=0)
    lane_in: int = Field(ge=1, le=3)
    exit: int = Field(ge=0)
    lane_out: int = Field(ge=1, le=3)
    radius_m: float | None = Field(default=None, ge=3.0, le=50.0)


class Auxiliary(FrozenModel):
    """A lane beside the outermost of those that enter at arm 0, for a part of the road.

    ``length_m`` is how long it has its full width: an acceleration lane and one that ends from the
    inner end of arm 1 on, an exit lane up to the inner end of arm 0. Over ``taper_m`` it narrows
    to nothing after that, or widens before.
    """

    kind: AuxiliaryLane
    length_m: float = Field(gt=0, le=1000)
    taper_m: float = Field(gt=0, le=200)


class RoadParameters(FrozenModel):
    """All that determines the road network.

    ``corner_radius_m`` is the kerb radius between neighbouring arms, on a road without a junction
    that of its centre line in the bend that the arms' angles make; ``ring_radius_m`` the
    radius of the outermost ring lane's centre; None lets the road package choose.
    ``parking_lanes`` are arms with a strip for standing vehicles beside the travelled lanes;
    ``u_turns`` arms where turning back is possible; ``turns`` more ways through the crossing;
    ``controlled_arms`` are those whose entering traffic the control's signs or lights stand for.
    ``strips`` lie all along the lanes; ``carriageway`` and ``auxiliary`` are for a road without a
    junction.
    """

    kind: JunctionKind
    arms: tuple[ArmRoad, ...] = Field(min_length=2, max_length=MAX_ARMS)
    driving_side: DrivingSide = DrivingSide.RIGHT
    control: Control = Control.UNCONTROLLED
    corner_radius_m: float | None = Field(default=None, gt=0, le=5000)
    ring_radius_m: float | None = Field(default=None, gt=0, le=200)
    ring_lanes: int = Field(default=1, ge=1, le=2)
    crosswalks: ArmSet = frozenset()
    parking_lanes: ArmSet = frozenset()
    u_turns: ArmSet = frozenset()
    turns: tuple[Turn, ...] = ()
    controlled_arms: ArmSet = frozenset()
    carriageway: Carriageway = Carriageway.UNDIVIDED
    strips: VocabularySet[Strip] = frozenset()
    auxiliary: Auxiliary | None = None

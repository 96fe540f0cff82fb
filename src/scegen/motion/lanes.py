"""Lane numbers of the scenario files and lane ids of the roads, both ways.

Number 1 is the lane next to the centre line (or the median), 0 the oncoming lane next to it; the
strips beside the outermost lane have the numbers after it, outwards. In a ring, 1 is the
innermost lane.
"""

from collections.abc import Set as AbstractSet

from scegen.errors import MotionInfeasibleError
from scegen.road.model import LaneType, Road
from scegen.scenario.vocabulary import DrivingSide

STANDING = frozenset({LaneType.PARKING, LaneType.SHOULDER})
"""Types of the strips on which vehicles stand."""
_STRIPS = frozenset({LaneType.BIKING, LaneType.PARKING, LaneType.SHOULDER, LaneType.SIDEWALK})


def arm_lane_id(road: Road, number: int, *, inbound: bool) -> int:
    """The id of lane ``number`` of an arm for traffic towards (``inbound``) or from the junction.

    Raises:
        MotionInfeasibleError: the arm has no such lane or strip.
    """
    side = _side(road, inbound=inbound)
    if number == 0:
        side, inbound = -side, not inbound
    lanes = [*road.driving(side), *_strips(road, side)]
    if max(number, 1) > len(lanes):
        count = len(road.driving(side))
        direction = "towards" if inbound else "away from"
        raise MotionInfeasibleError(
            f"arm {road.arm} has no lane {number}: {count} lead {direction} the junction",
            hint="Choose another lane or give the arm more lanes.",
        )
    return lanes[max(number, 1) - 1]


def strip_number(road: Road, kinds: AbstractSet[LaneType], *, inbound: bool) -> int:
    """The number of the strip of one of these types beside the lanes of an arm.

    Raises:
        MotionInfeasibleError: the arm has no such strip.
    """
    side = _side(road, inbound=inbound)
    driving = len(road.driving(side))
    for number, lane in enumerate(_strips(road, side), start=driving + 1):
        if road.lane(lane).type in kinds:
            return number
    msg = f"arm {road.arm} has no {' or '.join(sorted(kinds))} lane beside its lanes"
    raise MotionInfeasibleError(msg, where="road.strips")


def _side(road: Road, *, inbound: bool) -> int:
    """The sign of the lanes for traffic towards or from the junction."""
    return -1 if inbound == (road.driving_side is DrivingSide.RIGHT) else 1


def _strips(road: Road, side: int) -> list[int]:
    """The strips beside the driving lanes of one side, outwards."""
    driving = road.driving(side)
    through = road.successor is not None and road.successor.element == "road"
    kinds = _STRIPS if through else STANDING  # the others end at a junction
    beyond = [x.id for x in road.lanes if x.id * side > 0 and x.type in kinds]
    return sorted((i for i in beyond if driving and abs(i) > abs(driving[-1])), key=abs)


def ring_lane_ids(road: Road) -> tuple[int, ...]:
    """Ids of a ring road's driving lanes from the innermost outwards."""
    turns_left = sum(s.length_m * s.curvature_1pm for s in road.line.segments) > 0
    driving = [lane.id for lane in road.lanes if lane.type is LaneType.DRIVING]
    return tuple(sorted(driving, key=road.lane_centre_t_m, reverse=turns_left))


def ring_lane_id(road: Road, number: int) -> int:
    """The id of ring lane ``number``.

    Raises:
        MotionInfeasibleError: the ring has no such lane.
    """
    ids = ring_lane_ids(road)
    if not 1 <= number <= len(ids):
        raise MotionInfeasibleError(
            f"the ring has {len(ids)} lane(s), so none with number {number}",
            hint="Give the ring two lanes, or leave out the change of ring lane.",
        )
    return ids[number - 1]


def ring_lane_number(road: Road, lane_id: int) -> int:
    """The number of a ring lane, 1 = innermost."""
    return ring_lane_ids(road).index(lane_id) + 1


def is_ring(road: Road) -> bool:
    """Whether the road is a piece of a roundabout's ring between two of its junctions."""
    return road.arm is None and road.junction is None

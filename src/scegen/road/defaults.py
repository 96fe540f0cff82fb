"""Road parameters for a functional junction, where the description leaves them open."""

from collections.abc import Set as AbstractSet
from math import ceil, radians

from scegen.scenario.arms import arm_angles_deg
from scegen.scenario.control import controlled_arms
from scegen.scenario.junction import Junction
from scegen.scenario.road_parameters import ArmRoad, Auxiliary, RoadParameters
from scegen.scenario.roadway import BAYS, Carriageway, Strip
from scegen.scenario.speed_limits import usual_limit_mps

ARM_LENGTH_M = 120.0
_BESIDE_BEND_M = 20.0
"""So much of each arm at least is straight, before a bend."""
AUXILIARY_LENGTH_M = 250.0
AUXILIARY_TAPER_M = 60.0
"""Usual on motorways: an acceleration or exit lane of some 250 m, and 60 m of taper."""


def plan_road(
    junction: Junction,
    *,
    arm_length_m: float = ARM_LENGTH_M,
    min_lanes: int = 1,
    crosswalks: AbstractSet[int] = frozenset(),
    parking_lanes: AbstractSet[int] = frozenset(),
    u_turns: AbstractSet[int] = frozenset(),
) -> RoadParameters:
    """The parameters of a road network for a junction.

    Args:
        junction: what the description says of the road.
        arm_length_m: length of every arm road; where it bends, no less than its half of the bend.
        min_lanes: fewest lanes per direction, for scenarios that need room side by side.
        crosswalks: arms with a marked crosswalk, beside those that the description names.
        parking_lanes: arms with a strip for standing vehicles; a hard shoulder is one already.
        u_turns: arms at which vehicles may turn back.
    """
    radius, bend = None, junction.bend
    lanes = junction.lanes or (1,) * junction.arms
    limit = junction.speed_limit_mps or usual_limit_mps(junction)
    if bend is not None:
        junction = junction.but(speed_limit_mps=limit)
        radius = bend.radius_at_m(limit)
        arc_m = radius * radians(abs(bend.turn_deg(limit)))
        arm_length_m = max(arm_length_m, ceil(arc_m / 2) + _BESIDE_BEND_M)
    angles = arm_angles_deg(junction)
    # On a one-way road traffic comes in at arm 0 and goes out at arm 1.
    one_way = junction.carriageway is Carriageway.ONE_WAY
    if junction.strips & BAYS:
        parking_lanes = frozenset(range(junction.arms))
    shoulder = Strip.HARD_SHOULDER in junction.strips
    arms = tuple(
        ArmRoad(
            id=arm,
            length_m=arm_length_m,
            angle_deg=angles[arm],
            angle_to_previous_deg=(angles[arm] - angles[arm - 1]) % 360.0,
            lanes_in=0 if one_way and arm == 1 else max(lanes[arm], min_lanes),
            lanes_out=0 if one_way and arm == 0 else max(lanes[arm], min_lanes),
            lane_width_m=junction.lanes_wide_m,
            speed_limit_mps=round(limit, 3),
        )
        for arm in range(junction.arms)
    )
    auxiliary = None
    if junction.auxiliary is not None:
        length = junction.auxiliary_length_m or AUXILIARY_LENGTH_M
        auxiliary = Auxiliary(kind=junction.auxiliary, length_m=length, taper_m=AUXILIARY_TAPER_M)
    return RoadParameters(
        kind=junction.kind,
        arms=arms,
        driving_side=junction.driving_side,
        control=junction.control,
        ring_lanes=junction.ring_lanes or 1,
        crosswalks=junction.crosswalks | crosswalks,
        parking_lanes=frozenset(parking_lanes if not shoulder else ()),
        u_turns=frozenset(u_turns),
        controlled_arms=controlled_arms(junction),
        corner_radius_m=radius,
        carriageway=junction.carriageway,
        strips=junction.strips,
        auxiliary=auxiliary,
    )

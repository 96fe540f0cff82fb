"""Checks of road parameters that need no geometry."""

from itertools import pairwise

from scegen.errors import RoadInfeasibleError
from scegen.scenario.junction import ARM_COUNTS
from scegen.scenario.road_parameters import RoadParameters
from scegen.scenario.roadway import PLAIN_ROAD_STRIPS, Carriageway
from scegen.scenario.vocabulary import JunctionKind

MIN_ARM_LENGTH_M = 15.0
"""An arm road carries a stop line, perhaps a crosswalk, and a vehicle before it."""
_ANGLE_TOLERANCE_DEG = 0.01


def check_parameters(parameters: RoadParameters) -> None:
    """Refuse parameters that contradict themselves.

    Raises:
        RoadInfeasibleError: with the field and the numbers.
    """
    _check_arms(parameters)
    _check_angles(parameters)
    _check_carriageway(parameters)
    count = len(parameters.arms)
    for field in ("crosswalks", "parking_lanes", "u_turns"):
        unknown = sorted(arm for arm in getattr(parameters, field) if not 0 <= arm < count)
        if unknown:
            msg = f"there is no arm {unknown[0]}; arms are 0 to {count - 1}"
            raise RoadInfeasibleError(msg, where=field)


def _check_arms(parameters: RoadParameters) -> None:
    fewest, most = ARM_COUNTS[parameters.kind]
    count = len(parameters.arms)
    if not fewest <= count <= most:
        wanted = f"{fewest}" if fewest == most else f"{fewest} to {most}"
        msg = f"a {parameters.kind} has {wanted} arms, not {count}"
        raise RoadInfeasibleError(msg, where="arms")
    if [arm.id for arm in parameters.arms] != list(range(count)):
        msg = f"arm ids must be 0 to {count - 1} in order, not {[a.id for a in parameters.arms]}"
        raise RoadInfeasibleError(msg, where="arms")
    for arm in parameters.arms:
        if arm.length_m < MIN_ARM_LENGTH_M:
            msg = f"{arm.length_m:g} m is too short for an arm, at least {MIN_ARM_LENGTH_M:g} m"
            raise RoadInfeasibleError(msg, where=f"arms[{arm.id}].length_m")


def _check_carriageway(parameters: RoadParameters) -> None:
    """Only a one-way road has an arm without lanes one way; medians and strips end at no junction.

    Ways through a crossing lie where the centre lines of its arms are.
    """
    plain = parameters.kind is JunctionKind.STRAIGHT and not parameters.u_turns
    special = {
        "carriageway": parameters.carriageway is not Carriageway.UNDIVIDED,
        "auxiliary": parameters.auxiliary is not None,
        "strips": bool(parameters.strips & PLAIN_ROAD_STRIPS),
    }
    for field, given in special.items():
        if not plain and given:
            msg = f"{field} is only for a road without a junction, on which nobody turns back"
            raise RoadInfeasibleError(msg, where=field)
    counts = [(arm.lanes_in, arm.lanes_out) for arm in parameters.arms]
    one_way = parameters.carriageway is Carriageway.ONE_WAY
    if one_way and (counts[0][1], counts[1][0]) != (0, 0):
        msg = "a one-way road leads in at arm 0 and out at arm 1: no lanes out of 0 and in from 1"
        raise RoadInfeasibleError(msg, where="arms")
    for arm in () if one_way else parameters.arms:
        if not arm.lanes_in or not arm.lanes_out:
            msg = "has no lanes one way, which only a one-way road may have"
            raise RoadInfeasibleError(msg, where=f"arms[{arm.id}]")
    if one_way and not counts[0][0]:
        raise RoadInfeasibleError("has no lane", where="arms[0].lanes_in")


def _check_angles(parameters: RoadParameters) -> None:
    angles = [arm.angle_deg for arm in parameters.arms]
    if any(b <= a for a, b in pairwise(angles)):
        msg = f"arm angles must rise from arm to arm, not {angles}"
        raise RoadInfeasibleError(msg, where="arms")
    for arm in parameters.arms:
        gap = (arm.angle_deg - angles[arm.id - 1]) % 360.0
        off = abs((arm.angle_to_previous_deg - gap + 180.0) % 360.0 - 180.0)
        if off > _ANGLE_TOLERANCE_DEG:
            msg = (
                f"angle_to_previous_deg says {arm.angle_to_previous_deg:g}, "
                f"but the angles lie {gap:g} deg apart"
            )
            raise RoadInfeasibleError(msg, where=f"arms[{arm.id}]")

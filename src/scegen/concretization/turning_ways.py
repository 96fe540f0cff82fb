"""Turns that a scenario needs and that the usual lane markings of its road do not give."""

from __future__ import annotations

from itertools import combinations
from math import radians, tan

from scegen.concretization.abreast import turns_across
from scegen.concretization.tale import may_endanger
from scegen.errors import MotionInfeasibleError
from scegen.road.lane_choice import lane_ways
from scegen.scenario.arms import arm_angles_deg, seen_from
from scegen.scenario.concrete import RoadParameters, Turn
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Drive, LogicalScenario
from scegen.scenario.vocabulary import Approach, DrivingSide, JunctionKind, Maneuver

_STEERING = tan(radians(38.0))
"""Front wheels turn by about so much: the rear axle then runs on a radius of wheelbase / this."""
_HALF_CIRCLE_LANES = 2
_MOST_LANES = 3
_BULB_RADIUS_M = 4.0
"""What a road of one lane per direction with room beside it allows one who swings out first."""
_LATE_RADIUS_M = 6.5


def least_radius_m(drive: Drive, functional: FunctionalScenario) -> float:
    """The tightest circle of a vehicle's rear axle."""
    return functional.participant(drive.participant).body.wheelbase_m / _STEERING


def _turn_back(logical: LogicalScenario) -> list[Drive]:
    return [drive for drive in logical.drives if drive.entry == drive.exit]


def lanes_to_turn_back(functional: FunctionalScenario, logical: LogicalScenario) -> int:
    """Lanes per direction on which a half circle is wide enough, on a road without a junction."""
    drives = _turn_back(logical)
    if functional.junction.kind is not JunctionKind.STRAIGHT or not drives:
        return 1
    if functional.junction.lanes:
        return 1
    radius = max(least_radius_m(drive, functional) for drive in drives)
    wide = [
        count
        for count in range(_HALF_CIRCLE_LANES, _MOST_LANES + 1)
        if _half_circle_m(count, functional.junction.lanes_wide_m) >= radius
    ]
    return wide[0] if wide else _MOST_LANES


def _half_circle_m(lanes: int, width_m: float) -> float:
    """Radius of a half circle from the outermost lane to the outermost one of the other way."""
    return (2 * lanes - 1) * width_m / 2


def with_turns(
    functional: FunctionalScenario, logical: LogicalScenario, road: RoadParameters
) -> RoadParameters:
    """The road with all that the scenario needs beside the usual ways.

    Raises:
        MotionInfeasibleError: the road is too narrow for somebody to turn back on it.
    """
    turns = [
        *_half_circles(functional, logical, road),
        *turns_across(functional, logical, road),
        *_late_turns(functional, logical, road),
    ]
    update: dict[str, object] = {}
    if turns:
        update["turns"] = tuple(turns)
    if road.kind is JunctionKind.STRAIGHT and road.u_turns:
        # Strips beside the lanes: one who turns back needs more room than the lanes.
        update["parking_lanes"] = frozenset(arm.id for arm in road.arms)
    return road.model_copy(update=update) if update else road


def _half_circles(
    functional: FunctionalScenario, logical: LogicalScenario, road: RoadParameters
) -> list[Turn]:
    """Turning back on a road without a junction, from kerb to kerb."""
    if road.kind is not JunctionKind.STRAIGHT:
        return []
    found = []
    for drive in _turn_back(logical):
        arm = road.arms[drive.entry]
        count = min(arm.lanes_in, arm.lanes_out)
        radius = max(_half_circle_m(count, arm.lane_width_m), _BULB_RADIUS_M)
        needed = least_radius_m(drive, functional)
        if radius < needed:
            kind = functional.participant(drive.participant).kind
            raise MotionInfeasibleError(
                f"a {kind} turns back on a circle of {2 * needed:.1f} m across at the rear axle; "
                f"{count} lane(s) per direction have room for {2 * radius:.1f} m",
                where=drive.participant,
                hint="Say that the road has more lanes, or let it turn back at a junction.",
            )
        found.append(
            Turn(
                entry=drive.entry,
                lane_in=count,
                exit=drive.exit,
                lane_out=count,
                radius_m=round(min(radius, 50.0), 3),
            )
        )
    return list(dict.fromkeys(found))


def _late_turns(
    functional: FunctionalScenario, logical: LogicalScenario, road: RoadParameters
) -> list[Turn]:
    """Two from opposite arms who both turn across the oncoming lane, each behind the other.

    On the widest arcs they pass in front of each other and never meet; who goes on to the middle
    and turns there crosses the other's way twice.
    """
    if road.kind in {JunctionKind.STRAIGHT, JunctionKind.ROUNDABOUT}:
        return []
    across = Maneuver.LEFT if road.driving_side is DrivingSide.RIGHT else Maneuver.RIGHT
    angles = arm_angles_deg(functional.junction)
    turning = [drive for drive in logical.drives if drive.turn is across]
    late: dict[str, Drive] = {}
    for first, second in combinations(turning, 2):
        if first.entry == second.entry or not _meant(functional, first, second):
            continue
        if Approach.OPPOSITE in seen_from(angles, first.entry, second.entry):
            late |= {first.participant: first, second.participant: second}
    usual = lane_ways(road.arms, road.driving_side)
    found: dict[tuple[int, int, int, int], Turn] = {}
    for drive in late.values():
        radius = max(_LATE_RADIUS_M, 1.1 * least_radius_m(drive, functional))
        for way in usual:
            if (way.entry, way.exit) == (drive.entry, drive.exit):
                key = (way.entry, way.lane_in, way.exit, way.lane_out)
                tightest = max(radius, (found[key].radius_m or 0.0) if key in found else 0.0)
                found[key] = Turn(
                    entry=way.entry,
                    lane_in=way.lane_in,
                    exit=way.exit,
                    lane_out=way.lane_out,
                    radius_m=round(tightest, 3),
                )
    return list(found.values())


def _meant(functional: FunctionalScenario, first: Drive, second: Drive) -> bool:
    """Whether these two are to meet: a danger between them, or the ego and nothing else said."""
    pair = {first.participant, second.participant}
    if not functional.hazards:
        others = {d.id for d in functional.vehicles} | {c.id for c in functional.crossers}
        return functional.ego.id in pair and len(others) == len(pair)
    return may_endanger(functional, pair)

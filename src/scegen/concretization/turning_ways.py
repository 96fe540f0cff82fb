"""Who drives beside whom, and how tightly who turns back on a road without a junction does so."""

from __future__ import annotations

from collections.abc import Iterator
from math import radians, tan

from scegen.concretization.tale import outward, side_of
from scegen.errors import MotionInfeasibleError
from scegen.scenario.bodies import Body
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Drive, LogicalScenario
from scegen.scenario.road_parameters import RoadParameters, Turn
from scegen.scenario.vocabulary import JunctionKind
from scegen.scenario.wording import counted, with_article

_STEERING = tan(radians(38.0))
"""Front wheels turn by about so much: the rear axle then runs on a radius of wheelbase / this."""
_HALF_CIRCLE_LANES = 2
_MOST_LANES = 3
_BULB_RADIUS_M = 4.0
"""What a road of one lane per direction with room beside it allows one who swings out first."""


def is_outward(functional: FunctionalScenario, name: str, reference: str) -> bool | None:
    """Whether one is said to be on the kerb's side of another; None if no side is said."""
    side = side_of(functional, name, reference)
    return None if side is None else outward(functional, side) > 0


def abreast(logical: LogicalScenario) -> Iterator[tuple[Drive, Drive]]:
    """Each who drives beside another, and that other."""
    by_name = {drive.participant: drive for drive in logical.drives}
    for drive in logical.drives:
        other = by_name.get(drive.beside or "")
        if other is not None and other.entry == drive.entry:
            yield drive, other


def at_odds(functional: FunctionalScenario, drive: Drive, other: Drive) -> bool:
    """Whether the danger is between the two: no other is asked for."""
    pair = {drive.participant, other.participant}
    if not functional.hazards:
        return functional.ego.id in pair
    return any(
        pair & {*hazard.by} and (pair <= {*hazard.by, *hazard.to} or not hazard.to)
        for hazard in functional.hazards
    )


def least_radius_m(body: Body) -> float:
    """The tightest circle of a vehicle's rear axle."""
    return body.wheelbase_m / _STEERING


def turning_back(logical: LogicalScenario) -> list[Drive]:
    """Those who leave by the arm by which they come."""
    return [drive for drive in logical.drives if drive.entry == drive.exit]


def lanes_to_turn_back(functional: FunctionalScenario, logical: LogicalScenario) -> int:
    """Lanes per direction on which a half circle is wide enough, on a road without a junction."""
    drives, junction = turning_back(logical), functional.junction
    if junction.kind is not JunctionKind.STRAIGHT or junction.lanes or not drives:
        return 1
    radius = max(least_radius_m(functional.participant(d.participant).body) for d in drives)
    wide = [
        count
        for count in range(_HALF_CIRCLE_LANES, _MOST_LANES + 1)
        if _half_circle_m(count, junction.lanes_wide_m) >= radius
    ]
    return wide[0] if wide else _MOST_LANES


def _half_circle_m(lanes: int, width_m: float) -> float:
    """Radius of a half circle from the outermost lane to the outermost one of the other way."""
    return (2 * lanes - 1) * width_m / 2


def with_half_circles(
    functional: FunctionalScenario, logical: LogicalScenario, road: RoadParameters
) -> RoadParameters:
    """A road without a junction on which those turn back who do, from kerb to kerb.

    It has strips beside its lanes: who turns back needs more room than these.

    Raises:
        MotionInfeasibleError: the road is too narrow for somebody to turn back on it.
    """
    turns: dict[Turn, None] = {}
    for drive in turning_back(logical):
        arm = road.arms[drive.entry]
        count = min(arm.lanes_in, arm.lanes_out)
        radius = max(_half_circle_m(count, arm.lane_width_m), _BULB_RADIUS_M)
        needed = least_radius_m(functional.participant(drive.participant).body)
        if radius < needed:
            kind = functional.participant(drive.participant).kind
            raise MotionInfeasibleError(
                f"{with_article(kind)} turns back on a circle of {2 * needed:.1f} m across at the "
                f"rear axle; {counted(count, 'lane')} per direction "
                f"{'has' if count == 1 else 'have'} room for {2 * radius:.1f} m",
                where=drive.participant,
                hint="Say that the road has more lanes, or let it turn back at a junction.",
            )
        lanes, radius = {"lane_in": count, "lane_out": count}, round(min(radius, 50.0), 3)
        turns[Turn(entry=drive.entry, exit=drive.exit, radius_m=radius, **lanes)] = None
    strips = frozenset(arm.id for arm in road.arms)
    return road.model_copy(update={"turns": tuple(turns), "parking_lanes": strips})

"""The road that a logical scenario needs, beyond what its description says."""

from collections.abc import Iterable

from scegen.concretization.limits import LATERAL_MPS2
from scegen.concretization.tale import SIDEWAYS, SWERVING, changes_before_turning
from scegen.concretization.turning_ways import lanes_to_turn_back, turning_back, with_turns
from scegen.errors import RoadInfeasibleError
from scegen.motion.lanes import is_ring
from scegen.road import build_network, plan_road
from scegen.road.ring_layout import MAX_RING_RADIUS_M, lay_out_ring
from scegen.scenario.control import has_crosswalk
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.hazards import FROM_BESIDE
from scegen.scenario.logical import Drive, LogicalScenario, Standing
from scegen.scenario.road_parameters import RoadParameters
from scegen.scenario.roadway import BAYS
from scegen.scenario.speed_limits import implied_limit_mps
from scegen.scenario.vocabulary import HazardKind, JunctionKind, Maneuver

FIRST_ARM_M = 100.0
_PER_FURTHER_DRIVE_M, _FEW_DRIVES = 45.0, 3
"""Where many take part, most start so far out that the first arms would be too short."""
LONGEST_ARM_M = 1500.0
_RING_CHANGE_ROOM_M = 16.0
_SPARE = 1.05
_RING_RADII_M = (20.0, 24.0, 28.0, 32.0, 36.0, 40.0, 50.0)
_SIDE_BY_SIDE_HAZARDS = frozenset({HazardKind.CUT_IN, HazardKind.OVERTAKING})


def plan(
    functional: FunctionalScenario,
    logical: LogicalScenario,
    arm_length_m: float,
    least_lanes: int = 0,
) -> RoadParameters:
    """Road parameters with the lanes, strips and ring that the scenario needs."""
    kinds = {hazard.kind for hazard in functional.hazards}
    limit = round(implied_limit_mps(functional), 6)
    crossed = {crossing.arm for crossing in logical.crossings}
    parameters = plan_road(
        functional.junction.but(speed_limit_mps=limit),
        arm_length_m=arm_length_m,
        min_lanes=least_lanes
        or max(_min_lanes(functional, logical), lanes_to_turn_back(functional, logical)),
        crosswalks=frozenset(arm for arm in crossed if has_crosswalk(functional.junction, arm)),
        parking_lanes=frozenset(s.arm for s in standing_in_bays(functional, logical)),
        u_turns=frozenset(turning_back(functional, logical).values()),
    )
    parameters = with_turns(functional, logical, parameters)
    if functional.junction.kind is not JunctionKind.ROUNDABOUT:
        return parameters
    if HazardKind.CUT_IN in kinds:
        parameters = _with_wide_ring(parameters)
    return _with_fast_ring(functional, parameters)


def first_arm_m(logical: LogicalScenario) -> float:
    """How long the arms are tried to be first: laying everything again costs more than road."""
    return FIRST_ARM_M + _PER_FURTHER_DRIVE_M * max(0, len(logical.drives) - _FEW_DRIVES)


def standing_in_bays(functional: FunctionalScenario, logical: LogicalScenario) -> list[Standing]:
    """Those who stand on the strip for standing vehicles."""
    return [
        s
        for s in logical.standings
        if not s.in_lane and functional.participant(s.participant).strip in {None, *BAYS}
    ]


def _min_lanes(functional: FunctionalScenario, logical: LogicalScenario) -> int:
    """Two lanes per direction where somebody drives beside, changes lanes or overtakes.

    Numbers of lanes that the text gives are kept, and overtaking then uses the oncoming lane.
    """
    if functional.junction.lanes:
        return 1
    roundabout = functional.junction.kind is JunctionKind.ROUNDABOUT
    drives = logical.drives
    kinds = {hazard.kind for hazard in functional.hazards}
    beside = bool(passing_who_hides(functional, drives)) or any(d.beside for d in drives)
    sideways = any(drive.maneuver in SIDEWAYS and _among(drive, drives) for drive in drives)
    plain = functional.junction.kind is JunctionKind.STRAIGHT
    beside_kinds = _SIDE_BY_SIDE_HAZARDS | (FROM_BESIDE if plain else frozenset())
    together = any(_among(drive, drives) for drive in drives) and bool(kinds & beside_kinds)
    swerves = roundabout and bool(kinds & SWERVING)
    changes = any(changes_before_turning(functional, drive) for drive in drives)
    wide = sideways or swerves or changes or (together and not roundabout)
    return 2 if beside or (wide and HazardKind.ONCOMING_LANE not in kinds) else 1


def passing_who_hides(
    functional: FunctionalScenario, drives: Iterable[Drive]
) -> list[tuple[str, str]]:
    """(who goes by, who stands) of those on one arm of whom one hides others by standing there."""
    hides = {n for h in functional.hazards if h.kind is HazardKind.OCCLUSION for n in h.by}
    stands = [d for d in drives if d.participant in hides and d.maneuver is Maneuver.STAY]
    pairs = ((d, s) for s in stands for d in drives if d.entry == s.entry and d is not s)
    return [(drive.participant, other.participant) for drive, other in pairs]


def _among(drive: Drive, drives: tuple[Drive, ...]) -> bool:
    """Whether somebody else enters on the same arm."""
    return any(other.entry == drive.entry and other is not drive for other in drives)


def _with_wide_ring(parameters: RoadParameters) -> RoadParameters:
    """Two ring lanes, and the smallest ring with room for a lane change between two arms."""
    two = parameters.but(ring_lanes=2)
    for radius in _RING_RADII_M:
        wide = two.but(ring_radius_m=radius)
        try:
            network = build_network(wide)
        except RoadInfeasibleError:
            continue
        ring_m = (road.length_m for road in network.roads if is_ring(road))
        if min(ring_m, default=0.0) >= _RING_CHANGE_ROOM_M:
            return wide
    return two


def _with_fast_ring(functional: FunctionalScenario, parameters: RoadParameters) -> RoadParameters:
    """A ring as large as whoever is said to circulate so fast needs in comfort."""
    said = [p.speed_mps.middle for p in functional.participants if p.circulating and p.speed_mps]
    radii_m = lay_out_ring(parameters).radii_m
    wide_m = max(arm.lane_width_m for arm in parameters.arms)  # so much wider than its ways in
    least_m = _SPARE * max(said, default=0.0) ** 2 / LATERAL_MPS2 + wide_m
    if least_m <= radii_m[0]:
        return parameters
    radius_m = round(least_m + radii_m[-1] - radii_m[0], 1)
    return parameters.but(ring_radius_m=min(radius_m, MAX_RING_RADIUS_M))

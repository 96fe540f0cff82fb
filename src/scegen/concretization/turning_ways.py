"""Turns and lanes that a scenario needs and that the usual lane markings of its road do not give.

Who drives beside whom: where the text names the side, that side; else, where two beside each other
turn different ways, the sides on which one turns across the other's nose: that is what such a text
tells of. And who turns back, or turns late behind another.
"""

from collections.abc import Iterator
from dataclasses import asdict
from itertools import combinations
from math import radians, tan

from scegen.concretization.tale import at_odds, outward, side_of
from scegen.errors import MotionInfeasibleError
from scegen.road.lane_choice import lane_ways
from scegen.scenario.arms import arm_angles_deg, seen_from
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Drive, LogicalScenario
from scegen.scenario.road_parameters import RoadParameters, Turn
from scegen.scenario.vocabulary import Approach, DrivingSide, JunctionKind, Maneuver
from scegen.scenario.wording import counted, with_article

_WITHOUT_TURNS = frozenset({JunctionKind.STRAIGHT, JunctionKind.ROUNDABOUT})
_STEERING = tan(radians(38.0))
"""Front wheels turn by about so much: the rear axle then runs on a radius of wheelbase / this."""
_HALF_CIRCLE_LANES = 2
_MOST_LANES = 3
_BULB_RADIUS_M = 4.0
"""What a road of one lane per direction with room beside it allows one who swings out first."""
_LATE_RADIUS_M = 6.5


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


def outer_of(functional: FunctionalScenario, drive: Drive, other: Drive) -> tuple[str, str] | None:
    """(on the kerb's side, on the centre line's side) of two; None if either will do."""
    names = drive.participant, other.participant
    said, back = is_outward(functional, *names), is_outward(functional, *names[::-1])
    said = not back if said is None and back is not None else said
    if said is None:
        first, second = _bend(functional, drive), _bend(functional, other)
        turnless = functional.junction.kind in _WITHOUT_TURNS or first == second == 0
        if turnless or not at_odds(functional, *names):
            return None
        # Of two who turn alike one cuts across the other: rather not the ego.
        cuts = other.participant == functional.ego.id
        said = first < second if first != second else (first > 0) is not cuts
    return names if said else names[::-1]


def _bend(functional: FunctionalScenario, drive: Drive) -> int:
    """1 for a turn towards the kerb, -1 for one across the oncoming lane, 0 for straight on."""
    if drive.turn is Maneuver.U_TURN:
        return -2
    if drive.turn not in {Maneuver.LEFT, Maneuver.RIGHT}:
        return 0
    return 1 if drive.turn.value == functional.junction.driving_side.value else -1


def lanes_abreast(
    functional: FunctionalScenario, logical: LogicalScenario, road: RoadParameters
) -> dict[str, int]:
    """Lanes of those two by two beside each other of whom one turns across the other."""
    lanes: dict[str, int] = {}
    if road.kind in _WITHOUT_TURNS:
        return lanes
    for drive, other in abreast(logical):
        count = road.arms[drive.entry].lanes_in
        found = outer_of(functional, drive, other)
        if found is None or count < 2 or lanes.keys() & {drive.participant, other.participant}:
            continue
        outer, _ = found
        bends = {d.participant: _bend(functional, d) for d in (drive, other)}
        inside = 1 if min(bends.values()) < 0 else count - 1
        lanes |= {name: inside + 1 if name == outer else inside for name in bends}
    return lanes


def turns_across(
    functional: FunctionalScenario, logical: LogicalScenario, road: RoadParameters
) -> tuple[Turn, ...]:
    """The ways that these lanes need and that the usual markings do not give."""
    lanes = lanes_abreast(functional, logical, road)
    usual = lane_ways(road.arms, road.driving_side)
    found: list[Turn] = []
    for drive in logical.drives:
        lane = lanes.get(drive.participant)
        ways = [w for w in usual if (w.entry, w.exit) == (drive.entry, drive.exit)]
        if lane is None or not ways or any(w.lane_in == lane for w in ways):
            continue
        others = (other for other in logical.drives if other is not drive)
        together = any(o.exit == drive.exit and o.participant in lanes for o in others)
        out = ways[0].lane_out if together else min(lane, road.arms[drive.exit].lanes_out)
        found.append(Turn(entry=drive.entry, lane_in=lane, exit=drive.exit, lane_out=out))
    return tuple(dict.fromkeys(found))


def least_radius_m(name: str, functional: FunctionalScenario) -> float:
    """The tightest circle of a vehicle's rear axle."""
    return functional.participant(name).body.wheelbase_m / _STEERING


def turns_back_from_kerb(functional: FunctionalScenario, name: str) -> bool:
    """Whether one that is parked at first turns back as it pulls out."""
    participant = functional.participant(name)
    return participant.parked and participant.maneuvers == {Maneuver.U_TURN}


def turning_back(functional: FunctionalScenario, logical: LogicalScenario) -> dict[str, int]:
    """Those who leave by the arm by which they come, or on which they are parked."""
    kerb = (s for s in logical.standings if turns_back_from_kerb(functional, s.participant))
    back = {drive.participant: drive.entry for drive in logical.drives if drive.entry == drive.exit}
    return back | {standing.participant: standing.arm for standing in kerb}


def lanes_to_turn_back(functional: FunctionalScenario, logical: LogicalScenario) -> int:
    """Lanes per direction on which a half circle is wide enough, on a road without a junction."""
    back, junction = turning_back(functional, logical), functional.junction
    if junction.kind is not JunctionKind.STRAIGHT or junction.lanes or not back:
        return 1
    radius = max(least_radius_m(name, functional) for name in back)
    counts = range(_HALF_CIRCLE_LANES, _MOST_LANES)
    wide = (n for n in counts if _half_circle_m(n, junction.lanes_wide_m) >= radius)
    return next(wide, _MOST_LANES)


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
    if turns:
        road = road.but(turns=tuple(turns))
    if road.kind is JunctionKind.STRAIGHT and road.u_turns:
        # Strips beside the lanes: one who turns back needs more room than the lanes.
        road = road.but(parking_lanes=frozenset(arm.id for arm in road.arms))
    return road


def _half_circles(
    functional: FunctionalScenario, logical: LogicalScenario, road: RoadParameters
) -> list[Turn]:
    """Turning back on a road without a junction, from kerb to kerb."""
    if road.kind is not JunctionKind.STRAIGHT:
        return []
    found = []
    for name, entry in turning_back(functional, logical).items():
        arm = road.arms[entry]
        count = min(arm.lanes_in, arm.lanes_out)
        radius = max(_half_circle_m(count, arm.lane_width_m), _BULB_RADIUS_M)
        needed = least_radius_m(name, functional)
        if radius < needed:
            kind = functional.participant(name).kind
            raise MotionInfeasibleError(
                f"{with_article(kind)} turns back on a circle of {2 * needed:.1f} m across at the "
                f"rear axle; {counted(count, 'lane')} per direction "
                f"{'has' if count == 1 else 'have'} room for {2 * radius:.1f} m",
                where=name,
                hint="Say that the road has more lanes, or let it turn back at a junction.",
            )
        least = round(min(radius, 50.0), 3)
        found.append(Turn(entry=entry, lane_in=count, exit=entry, lane_out=count, radius_m=least))
    return list(dict.fromkeys(found))


def _late_turns(
    functional: FunctionalScenario, logical: LogicalScenario, road: RoadParameters
) -> list[Turn]:
    """Two from opposite arms who both turn across the oncoming lane, each behind the other.

    On the widest arcs they pass in front of each other and never meet; who goes on to the middle
    and turns there crosses the other's way twice.
    """
    if road.kind in _WITHOUT_TURNS:
        return []
    across = Maneuver.LEFT if road.driving_side is DrivingSide.RIGHT else Maneuver.RIGHT
    angles = arm_angles_deg(functional.junction)
    turning = [drive for drive in logical.drives if drive.turn is across]
    late: dict[str, Drive] = {}
    # Two are to meet if a danger is between them, or they are the ego and the only other.
    many = len({each.id for each in (*functional.vehicles, *functional.crossers)}) != 2
    for first, second in combinations(turning, 2):
        at_all = at_odds(functional, first.participant, second.participant)
        meant = first.entry != second.entry and at_all and (bool(functional.hazards) or not many)
        if meant and Approach.OPPOSITE in seen_from(angles, first.entry, second.entry):
            late |= {first.participant: first, second.participant: second}
    radii = {
        (drive.entry, drive.exit): max(
            _LATE_RADIUS_M, 1.1 * least_radius_m(drive.participant, functional)
        )
        for drive in sorted(
            late.values(), key=lambda each: least_radius_m(each.participant, functional)
        )
    }
    return [
        Turn(**asdict(way), radius_m=round(radii[way.entry, way.exit], 3))
        for way in lane_ways(road.arms, road.driving_side)
        if (way.entry, way.exit) in radii
    ]

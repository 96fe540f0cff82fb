"""Who drives beside whom, and the turns across each other that this may need.

Where the text names the side, that side; else, where two beside each other turn different ways,
the sides on which one turns across the other's nose: that is what such a text tells of. The usual
lane markings allow no such turn, so the crossing gets one more way.
"""

from __future__ import annotations

from collections.abc import Iterator

from scegen.concretization.tale import may_endanger, outward, side_of
from scegen.road.lane_choice import lane_ways
from scegen.scenario.concrete import RoadParameters, Turn
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Drive, LogicalScenario
from scegen.scenario.vocabulary import JunctionKind, Maneuver

_WITHOUT_TURNS = frozenset({JunctionKind.STRAIGHT, JunctionKind.ROUNDABOUT})


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
    said = is_outward(functional, drive.participant, other.participant)
    if said is None:
        back = is_outward(functional, other.participant, drive.participant)
        said = None if back is None else not back
    if said is not None:
        names = drive.participant, other.participant
        return names if said else names[::-1]
    if functional.junction.kind in _WITHOUT_TURNS or not _at_odds(functional, drive, other):
        return None
    first, second = _bend(functional, drive), _bend(functional, other)
    if first == second:
        if first == 0:
            return None
        # One cuts across the other: rather not the ego.
        cutter = drive if other.participant == functional.ego.id else other
        rest = other if cutter is drive else drive
        inner, outer = (cutter, rest) if first > 0 else (rest, cutter)
        return outer.participant, inner.participant
    return (
        (drive.participant, other.participant)
        if first < second
        else (other.participant, drive.participant)
    )


def _at_odds(functional: FunctionalScenario, drive: Drive, other: Drive) -> bool:
    """Whether the danger is between the two: no other is asked for."""
    if not functional.hazards:
        return functional.ego.id in {drive.participant, other.participant}
    return may_endanger(functional, {drive.participant, other.participant})


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
    if not lanes:
        return ()
    usual = lane_ways(road.arms, road.driving_side)
    found: list[Turn] = []
    for drive in logical.drives:
        lane = lanes.get(drive.participant)
        ways = [w for w in usual if (w.entry, w.exit) == (drive.entry, drive.exit)]
        if lane is None or not ways or any(w.lane_in == lane for w in ways):
            continue
        together = [
            other
            for other in logical.drives
            if other is not drive and other.exit == drive.exit and other.participant in lanes
        ]
        out = ways[0].lane_out if together else min(lane, road.arms[drive.exit].lanes_out)
        found.append(Turn(entry=drive.entry, lane_in=lane, exit=drive.exit, lane_out=out))
    return tuple(dict.fromkeys(found))

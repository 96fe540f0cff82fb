"""Which incoming lane leads to which outgoing lane.

The rule is the usual one of road markings: the lane next to the kerb serves the turns towards
its own side, the lane next to the centre line the opposite turns, and straight on keeps the
lane. Ways from one entry never cross: its lanes and their targets, both counted from the kerb
side, are in the same order.
"""

from bisect import bisect_left
from dataclasses import dataclass

from scegen.scenario.arms import STRAIGHT_WITHIN_DEG, turn_deg
from scegen.scenario.road_parameters import ArmRoad
from scegen.scenario.vocabulary import DrivingSide

_CLEARLY_DEG = 1.0
"""An exit is the straight one only if it bends less than all others by this much."""


@dataclass(frozen=True, slots=True, order=True)
class LaneWay:
    """From lane ``lane_in`` of arm ``entry`` to lane ``lane_out`` of arm ``exit`` (numbers)."""

    entry: int
    lane_in: int
    exit: int
    lane_out: int


@dataclass(frozen=True, slots=True)
class _Entry:
    """One entry: its exits from the kerb side on, and the bends towards them (deg, absolute)."""

    arm: ArmRoad
    exits: tuple[ArmRoad, ...]
    bends_deg: tuple[float, ...]
    main: int | None
    kerb_exits: int

    def rank(self, exit_index: int, lane_out: int) -> tuple[int, int]:
        """Order of targets counted from the kerb side."""
        return exit_index, -lane_out


def _entry(arms: tuple[ArmRoad, ...], number: int, side: DrivingSide) -> _Entry:
    angles = tuple(arm.angle_deg for arm in arms)
    moves = list(range(1, len(arms)))
    if side is DrivingSide.LEFT:
        moves.reverse()
    sign = 1 if side is DrivingSide.RIGHT else -1
    turns = [sign * turn_deg(angles, number, move) for move in moves]
    exits = tuple(arms[(number + move) % len(arms)] for move in moves)
    # Rounded, so that a mirror image is judged alike.
    bends = tuple(round(abs(turn), 6) for turn in turns)
    kerb_exits = sum(turn < 0 for turn in turns)
    return _Entry(arms[number], exits, bends, _main(bends, kerb_exits), kerb_exits)


def _main(bends_deg: tuple[float, ...], kerb_exits: int) -> int | None:
    """The exit that all lanes share: straight on, or the nearest to it on a one-sided entry."""
    order = sorted(range(len(bends_deg)), key=lambda i: bends_deg[i])
    best = order[0]
    if kerb_exits in {0, len(bends_deg)}:
        return best
    tied = len(order) > 1 and bends_deg[order[1]] - bends_deg[best] < _CLEARLY_DEG
    return best if bends_deg[best] <= STRAIGHT_WITHIN_DEG and not tied else None


def _straight_lanes(entry: _Entry, main: int) -> list[tuple[int, int]]:
    """(lane in, lane out) straight on: same number; surplus lanes drop out if they can turn."""
    lanes, room = entry.arm.lanes_in, entry.exits[main].lanes_out
    first, last = 1, lanes
    while last - first + 1 > room and main > 0 and last > first:
        last -= 1
        if last - first + 1 > room and main < len(entry.exits) - 1 and last > first:
            first += 1
    while last - first + 1 > room and main < len(entry.exits) - 1 and last > first:
        first += 1
    return [(lane, min(lane - first + 1, room)) for lane in range(first, last + 1)]


def _basic_ways(entry: _Entry) -> set[tuple[int, int, int]]:
    """(lane in, index of exit, lane out) by the rule."""
    kerb_lane, count = entry.arm.lanes_in, len(entry.exits)
    split = entry.main if entry.main is not None else entry.kerb_exits
    after = split + 1 if entry.main is not None else split
    ways = {(kerb_lane, i, entry.exits[i].lanes_out) for i in range(split)}
    ways |= {(1, i, 1) for i in range(after, count)}
    if entry.main is not None:
        ways |= {(a, entry.main, b) for a, b in _straight_lanes(entry, entry.main)}
    return ways


def _with_way_out(entry: _Entry, ways: set[tuple[int, int, int]]) -> None:
    """Give every incoming lane a target between those of its neighbours, a free one if any."""
    targets = [
        (i, lane) for i, arm in enumerate(entry.exits) for lane in range(arm.lanes_out, 0, -1)
    ]
    ranks = [entry.rank(*target) for target in targets]
    # Innermost first: what the lane next to the centre line leaves over goes outwards.
    for lane in range(1, entry.arm.lanes_in + 1):
        if any(way[0] == lane for way in ways):
            continue
        lowest = max((entry.rank(i, o) for a, i, o in ways if a > lane), default=ranks[0])
        highest = min((entry.rank(i, o) for a, i, o in ways if a < lane), default=ranks[-1])
        between = targets[bisect_left(ranks, lowest) : bisect_left(ranks, highest) + 1]
        taken = {(i, o) for _, i, o in ways}
        exit_index, lane_out = min(
            between, key=lambda t: (t in taken, entry.bends_deg[t[0]], abs(t[1] - lane))
        )
        ways.add((lane, exit_index, lane_out))


def _reach(entry: _Entry, ways: set[tuple[int, int, int]], exit_index: int, lane_out: int) -> int:
    """The incoming lane that can also serve a target without crossing the other ways."""
    rank = entry.rank(exit_index, lane_out)
    kerb_side = [a for a, i, o in ways if entry.rank(i, o) < rank]
    centre_side = [a for a, i, o in ways if entry.rank(i, o) > rank]
    fit = range(max(centre_side, default=1), min(kerb_side, default=entry.arm.lanes_in) + 1)
    return min(fit, key=lambda lane: (abs(lane - lane_out), lane))


def lane_ways(arms: tuple[ArmRoad, ...], side: DrivingSide) -> tuple[LaneWay, ...]:
    """All ways through a crossing, in order, U-turns left out.

    Every incoming lane has a way out, every outgoing lane a way in, and every pair of
    different arms at least one way.
    """
    entries = [_entry(arms, number, side) for number in range(len(arms))]
    chosen = [_basic_ways(entry) for entry in entries]
    for entry, ways in zip(entries, chosen, strict=True):
        _with_way_out(entry, ways)
    reached = {
        (entry.exits[i].id, o)
        for entry, ways in zip(entries, chosen, strict=True)
        for _, i, o in ways
    }
    for arm in arms:
        for lane in range(1, arm.lanes_out + 1):
            if (arm.id, lane) in reached:
                continue
            # The straightest entry takes it on; of two alike, the one that turns kerbwards.
            _, index, number = min(
                (entry.bends_deg[entry.exits.index(arm)], entry.exits.index(arm), n)
                for n, entry in enumerate(entries)
                if entry.arm.id != arm.id
            )
            lane_in = _reach(entries[number], chosen[number], index, lane)
            chosen[number].add((lane_in, index, lane))
    return tuple(
        sorted(
            LaneWay(entry.arm.id, a, entry.exits[i].id, o)
            for entry, ways in zip(entries, chosen, strict=True)
            for a, i, o in ways
        )
    )

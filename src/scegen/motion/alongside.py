"""A drive along a road without a crossing: from lane to lane, past a ramp or by way of it.

The parts of such a road have their lanes side by side, so a change of lane may run across a joint.
A lane that begins or ends is used where it has its full width; on a ramp there is one lane.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from scegen.errors import MotionInfeasibleError
from scegen.motion.lanes import arm_lane_id
from scegen.motion.stretches import Shift, Stretch, lane_offset_d_m, stretch
from scegen.road.model import LaneType, Road, RoadNetwork, RouteStep
from scegen.scenario.concrete import DriveMotion, LaneChange

_ROUNDING_M = 1e-6
_ENDS_M = 0.05
"""A change of lane may so far run beyond the end of a lane."""


@dataclass(frozen=True, slots=True)
class _Change:
    """A change of lane from lane number ``before`` and ``kept_m`` left of that lane's centre."""

    asked: LaneChange
    before: int
    kept_m: float

    @property
    def begins_m(self) -> float:
        return self.asked.position_m

    @property
    def ends_m(self) -> float:
        return self.asked.position_m + self.asked.length_m

    @property
    def middle_m(self) -> float:
        return self.asked.position_m + self.asked.length_m / 2


@dataclass
class _Way:
    """What is known of a drive: its changes in order, and its stretches so far."""

    network: RoadNetwork
    motion: DriveMotion
    who: str
    changes: list[_Change]
    done: list[Stretch] = field(default_factory=list)

    @property
    def parts(self) -> int:
        """Of how many roads the way consists."""
        return len(self.network.routes[self.motion.entry, self.motion.exit][0].steps)

    def number_at(self, station_m: float, *, begun: bool = False) -> int:
        """The lane there: after a change from its middle on, or as soon as it has ``begun``."""
        passed = [
            c.asked.lane_after
            for c in self.changes
            if (c.begins_m if begun else c.middle_m) < station_m - _ROUNDING_M
        ]
        return passed[-1] if passed else self.motion.entry_lane

    def step(self, number: int, part: int) -> RouteStep:
        """The road and lane of a lane number on one part of the way.

        Raises:
            MotionInfeasibleError: there is no such lane.
        """
        entry, leaving = self.motion.entry, self.motion.exit
        for route in self.network.routes[entry, leaving]:
            if route.entry_lane == number:
                return route.steps[part]
        if number == 0 and (leaving, entry) in self.network.routes:
            back = self.network.routes[leaving, entry][0].steps[-1 - part]
            return replace(back, forward=not back.forward)
        if 0 < part < self.parts - 1:
            raise self._refused(f"there is no lane {number} beside the ramp")
        arm, inbound = (entry, True) if part == 0 else (leaving, False)
        road = self.network.arm_road(arm)
        return RouteStep(road.id, arm_lane_id(road, number, inbound=inbound), forward=inbound)

    def _refused(self, message: str) -> MotionInfeasibleError:
        return MotionInfeasibleError(
            message, where=self.who, hint="Move or shorten the change of lane, or leave it out."
        )

    def lay(self, part: int) -> None:
        """One more road, with all changes that run on it."""
        begins = self.done[-1].end_m if self.done else 0.0
        step = self.step(self.number_at(begins, begun=True), part)
        road = self.network.road(step.road)
        piece = stretch(road, step.lane, begins, forward=step.forward)
        piece = replace(piece, lane=self.step(self.number_at(begins), part).lane)
        kept = self.motion.offset_m
        lanes: list[tuple[float, int]] = []
        shifts: list[Shift] = []
        for change in self.changes:
            if change.ends_m <= begins + _ROUNDING_M:
                kept = change.asked.offset_m
            elif change.begins_m < piece.end_m - _ROUNDING_M:
                sides = [self.step(n, part) for n in (change.before, change.asked.lane_after)]
                if any(side.road != road.id for side in sides):
                    raise self._refused(
                        f"the lane change from {change.begins_m:.1f} to {change.ends_m:.1f} m runs "
                        f"on the ramp or where it parts from the road ({road.name})"
                    )
                self._check_median(change, road, sides)
                before, after = (lane_offset_d_m(road, x.lane, forward=step.forward) for x in sides)
                shift = Shift(
                    change.begins_m,
                    change.asked.length_m,
                    before + change.kept_m,
                    after + change.asked.offset_m,
                )
                shifts.append(shift)
                if begins < change.middle_m < piece.end_m:
                    lanes.append((change.middle_m, sides[1].lane))
        offset = shifts[0].from_d_m if shifts else piece.d_m + kept
        self.done.append(replace(piece, d_m=offset, shifts=tuple(shifts), lane_after=tuple(lanes)))

    def _check_median(self, change: _Change, road: Road, sides: list[RouteStep]) -> None:
        """Nobody drives across a median."""
        median = any(lane.type is LaneType.MEDIAN for lane in road.lanes)
        if median and sides[0].lane * sides[1].lane < 0:
            raise MotionInfeasibleError(
                f"the lane change at {change.begins_m:.1f} m leads across the median",
                where=self.who,
                hint="Change into another lane of this direction, or leave out the median.",
            )

    def check_extents(self) -> None:
        """Whoever uses a lane that begins or ends does so where it is.

        Raises:
            MotionInfeasibleError: with the places of the lane and of the drive.
        """
        for piece in self.done:
            for lane in piece.road.lanes:
                if lane.extent is None:
                    continue
                used = [(a, b) for a, b, number in piece.lanes() if number == lane.id]
                used += [
                    (c.begins_m, c.ends_m) for c in self.changes if self._touches(c, piece, lane.id)
                ]
                within = lane.extent.from_m + lane.extent.opens_m, lane.extent.to_m
                for begins, ends in used:
                    low, high = max(begins, self.motion.start_m, piece.start_m), ends
                    high = min(high, piece.end_m)
                    places = sorted(self._s_m(piece, u) for u in (low, high))
                    if low < high and not (
                        within[0] - _ENDS_M <= places[0] and places[1] <= within[1] + _ENDS_M
                    ):
                        raise self._refused(
                            f"is in a lane from {low:.1f} to {high:.1f} m that is not there all "
                            f"the way ({piece.road.name}, {within[1] - within[0]:.0f} m long)"
                        )

    def _touches(self, change: _Change, piece: Stretch, lane: int) -> bool:
        """Whether a change leads from or into a lane of a road that it runs on."""
        if not change.begins_m < piece.end_m or not change.ends_m > piece.start_m:
            return False
        part = self.done.index(piece)
        steps = (self.step(n, part) for n in (change.before, change.asked.lane_after))
        return any((x.road, x.lane) == (piece.road.id, lane) for x in steps)

    def _s_m(self, piece: Stretch, station_m: float) -> float:
        """The place on a road's reference line of a station."""
        travelled = (station_m - piece.start_m) / piece.scale
        return travelled if piece.forward else piece.road.length_m - travelled


def along_plain(
    network: RoadNetwork, motion: DriveMotion, who: str
) -> tuple[tuple[Stretch, ...], int]:
    """The stretches of a drive along a road without a crossing, and the lane in which it ends.

    Raises:
        MotionInfeasibleError: no such lane, one that is not there, or a change across a median.
    """
    changes, before, kept = [], motion.entry_lane, motion.offset_m
    for asked in motion.lane_changes:
        changes.append(_Change(asked, before, kept))
        before, kept = asked.lane_after, asked.offset_m
    way = _Way(network, motion, who, changes)
    for part in range(way.parts):
        way.lay(part)
    end_m = way.done[-1].end_m
    for change in changes:
        if change.ends_m > end_m + _ROUNDING_M:
            raise MotionInfeasibleError(
                f"the lane change from {change.begins_m:.1f} to {change.ends_m:.1f} m ends beyond "
                f"the road, which is {end_m:.1f} m long",
                where=who,
                hint="Move it, shorten it or choose a longer road.",
            )
    way.check_extents()
    return tuple(way.done), before

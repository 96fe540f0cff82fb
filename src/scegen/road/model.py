"""The road network as geometry and topology, before any file format.

Conventions, which export and motion rely on:

* Arm roads run from their outer end (s = 0) to the junction, reference line on the centre
  line. In right-hand traffic the lanes towards the junction are right lanes (ids -1, -2, ...),
  those away from it left lanes (1, 2, ...); in left-hand traffic the other way round. Lane
  number k of the scenario files (1 = next to the centre line) is the k-th driving lane of its side.
* Connecting roads of crossings have exactly one driving lane, travelled along s, with the
  reference line on the lane's centre (lane offset half its width). Its id is -1 in right-hand
  traffic and 1 in left-hand traffic, because OpenDRIVE lets right lanes run along s only where
  traffic keeps right (ASAM OpenDRIVE 1.7, 9.1). Take lane ids from routes and connections.
* Ring roads of a roundabout run in the direction of traffic; their lanes are -1 and -2 (1 and 2
  in left-hand traffic), where ring lane number k of the scenario files, 1 = innermost, is the
  lane with |id| = k.
* A ``straight`` is two arm roads joined end to end; it has no junction, unless a ramp joins or
  leaves. Then a connecting road for each direction, on the same reference line and with the same
  lanes, joins the arm roads, and one more the ramp, whose lane is the one beyond the outermost.
"""

from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property

from scegen.road.geometry import Pose, ReferenceLine
from scegen.scenario.vocabulary import DrivingSide


class LaneType(StrEnum):
    """OpenDRIVE lane types in use (e_laneType)."""

    DRIVING = "driving"
    PARKING = "parking"
    SIDEWALK = "sidewalk"
    SHOULDER = "shoulder"
    BIKING = "biking"
    BORDER = "border"
    MEDIAN = "median"


class ContactPoint(StrEnum):
    """Which end of a road a link meets."""

    START = "start"
    END = "end"


@dataclass(frozen=True, slots=True)
class Extent:
    """The part of its road that a lane has, from ``from_m`` to ``to_m`` along the reference line.

    It widens over the first ``opens_m`` and narrows over the last ``closes_m``, in an S.
    """

    from_m: float
    to_m: float
    opens_m: float = 0.0
    closes_m: float = 0.0

    def share(self, s_m: float) -> float:
        """Its width at a place, as a share of the full one."""
        if not self.from_m <= s_m <= self.to_m:
            return 0.0
        opened = (s_m - self.from_m) / self.opens_m if self.opens_m else 1.0
        left = (self.to_m - s_m) / self.closes_m if self.closes_m else 1.0
        p = min(opened, left, 1.0)
        return p * p * (3.0 - 2.0 * p)


@dataclass(frozen=True, slots=True)
class Lane:
    """A lane of one width. ``id`` as in OpenDRIVE: negative right of the reference line.

    ``predecessor`` and ``successor`` are lane ids of the linked road (None where there is
    none, or where a junction's connections say it). ``extent`` is the part of the road that has it,
    None if all has; ids count all lanes of a side, those that begin or end among them.
    """

    id: int
    type: LaneType
    width_m: float
    predecessor: int | None = None
    successor: int | None = None
    extent: Extent | None = None

    def width_at_m(self, s_m: float | None) -> float:
        """Its width at a place of the road, with None the full one."""
        if self.extent is None or s_m is None:
            return self.width_m
        return self.width_m * self.extent.share(s_m)


_STOP_LINE_M = 0.4
_OFF_CROSSWALK_M = 1.2


@dataclass(frozen=True, slots=True)
class RoadLink:
    """What a road end is joined to: another road's end, or a junction (contact None)."""

    element: str  # "road" or "junction"
    id: int
    contact: ContactPoint | None = None


@dataclass(frozen=True, slots=True)
class Crosswalk:
    """A marked crosswalk over the full carriageway, its middle at ``s_m`` on its road."""

    id: int
    s_m: float
    width_m: float
    t_min_m: float
    t_max_m: float


@dataclass(frozen=True, slots=True)
class Road:
    """A road: reference line, lanes, links. ``lane_offset_m`` shifts lane 0 to the left.

    ``speed_limit_mps`` holds on all its lanes; ``junction`` is the id of the junction that a
    connecting road belongs to, None otherwise. ``arm`` is the arm number of an arm road.
    """

    id: int
    name: str
    line: ReferenceLine
    lanes: tuple[Lane, ...]
    speed_limit_mps: float
    driving_side: DrivingSide
    lane_offset_m: float = 0.0
    junction: int | None = None
    arm: int | None = None
    predecessor: RoadLink | None = None
    successor: RoadLink | None = None
    crosswalks: tuple[Crosswalk, ...] = ()

    @property
    def goes_on(self) -> bool:
        """Whether it leads past a ramp or to one, with what lies beside its lanes."""
        return self.junction is not None and len(self.lanes) > 1

    @property
    def length_m(self) -> float:
        """Length of the reference line."""
        return self.line.length_m

    @property
    def stop_line_m(self) -> float:
        """How far before its inner end an arm has its line for entering traffic.

        Outside a crosswalk it lies ``_OFF_CROSSWALK_M`` before that (MUTCD 3B.16: 4 ft).
        """
        before = [self.length_m - c.s_m + c.width_m / 2 + _OFF_CROSSWALK_M for c in self.crosswalks]
        return max(before, default=0.0) + _STOP_LINE_M

    def lane(self, lane_id: int) -> Lane:
        """The lane with this id; KeyError if there is none."""
        for candidate in self.lanes:
            if candidate.id == lane_id:
                return candidate
        raise KeyError(lane_id)

    def lane_centre_t_m(self, lane_id: int, s_m: float | None = None) -> float:
        """Offset of a lane's centre from the reference line (m, left positive).

        At ``s_m``, if lanes inside it begin or end on this road; else where all are there.
        """
        sign = 1 if lane_id > 0 else -1
        inside = sum(
            lane.width_at_m(s_m)
            for lane in self.lanes
            if lane.id * sign > 0 and abs(lane.id) < abs(lane_id)
        )
        return self.lane_offset_m + sign * (inside + self.lane(lane_id).width_at_m(s_m) / 2)

    def driving(self, sign: int) -> list[int]:
        """Ids of the driving lanes of one side (+1 left, -1 right), from the middle outwards."""
        ids = [x.id for x in self.lanes if x.id * sign > 0 and x.type is LaneType.DRIVING]
        return sorted(ids, key=abs)

    @property
    def crosswalk_end_m(self) -> float:
        """Where the crosswalk nearest to its end ends; without any, its end."""
        ends = (crosswalk.s_m + crosswalk.width_m / 2 for crosswalk in self.crosswalks)
        return min(max(ends, default=self.length_m), self.length_m)

    def edge_t_m(self, sign: int, s_m: float | None = None) -> float:
        """Offset of the outer edge of the last driving lane on one side (+1 left, -1 right).

        Of a side without any, that of the reference line; ``s_m`` as for a lane's centre.
        """
        ids = self.driving(sign)
        if not ids:
            return self.lane_offset_m
        half = self.lane(ids[-1]).width_at_m(s_m) / 2
        return self.lane_centre_t_m(ids[-1], s_m) + sign * half


@dataclass(frozen=True, slots=True)
class Connection:
    """One way into a junction: incoming lane → lane of a connecting road, met at its start."""

    id: int
    incoming_road: int
    connecting_road: int
    from_lane: int
    to_lane: int


@dataclass(frozen=True, slots=True)
class JunctionArea:
    """A junction of OpenDRIVE: the connections that lead through it."""

    id: int
    name: str
    connections: tuple[Connection, ...]


@dataclass(frozen=True, slots=True)
class RouteStep:
    """A stretch of a route: one lane of one road, travelled along s (``forward``) or against."""

    road: int
    lane: int
    forward: bool


@dataclass(frozen=True, slots=True)
class Route:
    """A drivable way from an arm's outer end to another's, lane by lane, without lane changes.

    ``entry_lane``, ``exit_lane`` and ``ring_lane`` are numbers as in the scenario files
    (``ring_lane`` None away from roundabouts).
    """

    entry: int
    entry_lane: int
    exit: int
    exit_lane: int
    ring_lane: int | None
    steps: tuple[RouteStep, ...]


@dataclass(frozen=True)
class RoadNetwork:
    """Roads and junctions of one scenario; ``arm_roads[i]`` is the id of arm i's road.

    ``routes`` holds every route by (entry, exit), U-turns included where they are asked for;
    it is filled by the builder and is complete: each lane of each arm is on some route.
    ``plain``: a road without a crossing, its lanes side by side from arm to arm; where a ramp joins
    or leaves there is a junction nevertheless.
    """

    name: str
    driving_side: DrivingSide
    roads: tuple[Road, ...]
    junctions: tuple[JunctionArea, ...]
    arm_roads: tuple[int, ...]
    routes: dict[tuple[int, int], tuple[Route, ...]] = field(default_factory=dict)
    plain: bool = False

    @cached_property
    def _by_id(self) -> dict[int, Road]:
        return {road.id: road for road in self.roads}

    def road(self, road_id: int) -> Road:
        """The road with this id; KeyError if there is none."""
        return self._by_id[road_id]

    def arm_road(self, arm: int) -> Road:
        """The road of an arm."""
        return self.road(self.arm_roads[arm])

    def pose_at(self, step: RouteStep, travelled_m: float, left_m: float = 0.0) -> Pose:
        """The pose on a lane's centre after ``travelled_m`` in driving direction on that step.

        ``left_m`` shifts it to the driver's left.
        """
        road = self.road(step.road)
        t = road.lane_centre_t_m(step.lane)
        if step.forward:
            return road.line.pose(travelled_m, t + left_m)
        back = road.line.pose(road.length_m - travelled_m, t - left_m)
        return back.reversed()

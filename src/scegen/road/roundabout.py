"""Roundabouts: a small junction per arm, joined by the roads of the ring."""

from itertools import product
from math import cos, pi, radians, sin

from scegen.errors import RoadInfeasibleError
from scegen.road.cross_section import (
    CONNECTING_ROADS_FROM,
    JUNCTIONS_FROM,
    RINGS_FROM,
    arm_line,
    arm_road,
    lane_in,
    lane_out,
    pose_in,
    pose_out,
    side_sign,
)
from scegen.road.fillet import chain, connect
from scegen.road.geometry import Pose, ReferenceLine
from scegen.road.links import LaneEnd, arm_route, connecting_road
from scegen.road.model import (
    Connection,
    ContactPoint,
    JunctionArea,
    Lane,
    LaneType,
    Road,
    RoadLink,
    RoadNetwork,
    Route,
    RouteStep,
)
from scegen.road.ring_layout import RingLayout, lay_out_ring
from scegen.scenario.road_parameters import RoadParameters


def build_roundabout(parameters: RoadParameters, name: str) -> RoadNetwork:
    """A ring around the origin, counter-clockwise where traffic keeps right.

    Raises:
        RoadInfeasibleError: if the ring is too small for its arms, or arms are too close.
    """
    return _Roundabout(parameters, lay_out_ring(parameters)).network(name)


def lane_pairs(from_count: int, to_count: int) -> list[tuple[int, int]]:
    """Which of two groups of lanes join: equal numbers, and what is left over the outermost."""
    last = min(from_count, to_count)
    if last == 1:
        return [(a, b) for a in range(1, from_count + 1) for b in range(1, to_count + 1)]
    most = max(from_count, to_count)
    return [(min(k, from_count), min(k, to_count)) for k in range(1, most + 1)]


class _Roundabout:
    """Collects the roads, junction by junction; ``sign`` 1 is counter-clockwise."""

    def __init__(self, parameters: RoadParameters, layout: RingLayout) -> None:
        self.parameters = parameters
        self.layout = layout
        self.sign = side_sign(parameters.driving_side)
        self.count = len(parameters.arms)
        self.arms = [
            arm_road(
                parameters,
                arm,
                arm_line(arm, distance),
                RoadLink("junction", self.junction(arm.id)),
            )
            for arm, distance in zip(parameters.arms, layout.distances_m, strict=True)
        ]
        self.rings = [self._ring(arm) for arm in range(self.count)]
        self.connecting: list[Road] = []
        # (kind, arm, from lane number, to lane number) → connecting road
        self.ways: dict[tuple[str, int, int, int], Road] = {}
        self.junctions = [self._join(arm) for arm in range(self.count)]

    def junction(self, arm: int) -> int:
        """Id of the junction at an arm."""
        return JUNCTIONS_FROM + arm

    def next_arm(self, arm: int, by: int = 1) -> int:
        """The arm that the ring reaches next."""
        return (arm + self.sign * by) % self.count

    def angle(self, arm: int, side: int) -> float:
        """Direction (rad) at which the junction of an arm ends (side 1) or begins (-1)."""
        centre = radians(self.parameters.arms[arm].angle_deg)
        return centre + self.sign * side * self.layout.half_rad[arm]

    def ring_pose(self, angle: float, lane: int) -> Pose:
        """On the centre of a ring lane, in driving direction."""
        radius = self.layout.radii_m[lane - 1]
        return Pose(radius * cos(angle), radius * sin(angle), angle + self.sign * pi / 2)

    def _arc(self, begin: float, end: float, lane: int) -> ReferenceLine:
        radius = self.layout.radii_m[lane - 1]
        span = (self.sign * (end - begin)) % (2 * pi)
        return chain(self.ring_pose(begin, lane), [(span * radius, self.sign / radius)])

    def _ring(self, arm: int) -> Road:
        """The road of the ring that leaves the junction of an arm."""
        following = self.next_arm(arm)
        width = self.layout.lane_width_m
        lanes = [
            Lane(-self.sign * k, LaneType.DRIVING, width)
            for k in range(1, len(self.layout.radii_m) + 1)
        ]
        return Road(
            id=RINGS_FROM + arm,
            name=f"ring_{arm}",
            line=self._arc(self.angle(arm, 1), self.angle(following, -1), 1),
            lanes=tuple(sorted(lanes, key=lambda lane: -lane.id)),
            speed_limit_mps=min(road.speed_limit_mps for road in self.arms),
            driving_side=self.parameters.driving_side,
            lane_offset_m=self.sign * width / 2,
            predecessor=RoadLink("junction", self.junction(arm)),
            successor=RoadLink("junction", self.junction(following)),
        )

    def _join(self, arm: int) -> JunctionArea:
        """All ways through the junction of one arm."""
        road, ring = self.arms[arm], self.rings[arm]
        before = self.rings[self.next_arm(arm, -1)]
        begin, end = self.angle(arm, -1), self.angle(arm, 1)
        ring_lanes = len(self.layout.radii_m)
        connections: list[Connection] = []

        def add(
            way: tuple[str, int, int, int],
            line: ReferenceLine | None,
            source: LaneEnd,
            target: LaneEnd,
        ) -> None:
            if line is None:
                msg = f"no way {way[0]} the ring at arm {arm}, from lane {way[2]} to lane {way[3]}"
                raise RoadInfeasibleError(msg, where=f"arms[{arm}]")
            made = connecting_road(
                CONNECTING_ROADS_FROM + len(self.connecting),
                self.junction(arm),
                line,
                source,
                target,
            )
            self.connecting.append(made)
            self.ways[way] = made
            connections.append(
                Connection(len(connections), source.road.id, made.id, source.lane, made.lanes[0].id)
            )

        from_ring = {k: LaneEnd(before, -self.sign * k) for k in range(1, ring_lanes + 1)}
        to_ring = {
            k: LaneEnd(ring, -self.sign * k, ContactPoint.START) for k in range(1, ring_lanes + 1)
        }
        for lane in range(1, ring_lanes + 1):
            arc = self._arc(begin, end, lane)
            add(("along", arm, lane, lane), arc, from_ring[lane], to_ring[lane])
        for lane, number in lane_pairs(ring_lanes, self.parameters.arms[arm].lanes_out):
            line = connect(self.ring_pose(begin, lane), pose_out(road, number))
            target = LaneEnd(road, lane_out(road, number))
            add(("out of", arm, lane, number), line, from_ring[lane], target)
        for number, lane in lane_pairs(self.parameters.arms[arm].lanes_in, ring_lanes):
            line = connect(pose_in(road, number), self.ring_pose(end, lane))
            source = LaneEnd(road, lane_in(road, number))
            add(("into", arm, number, lane), line, source, to_ring[lane])
        return JunctionArea(self.junction(arm), f"roundabout_arm_{arm}", tuple(connections))

    def _routes(self, entry: int, leaving: int) -> tuple[Route, ...]:
        into = [way for way in self.ways if way[:2] == ("into", entry)]
        out_of = [way for way in self.ways if way[:2] == ("out of", leaving)]
        passed = (self.sign * (leaving - entry)) % self.count or self.count
        found: list[Route] = []
        for (_, _, number_in, lane), (_, _, lane_at_exit, number_out) in product(into, out_of):
            if lane != lane_at_exit:
                continue
            roads = [self.ways["into", entry, number_in, lane]]
            for k in range(passed):
                arm = self.next_arm(entry, k)
                if k:
                    roads.append(self.ways["along", arm, lane, lane])
                roads.append(self.rings[arm])
            roads.append(self.ways["out of", leaving, lane, number_out])
            steps = [
                RouteStep(
                    road.id, -self.sign * (lane if road.junction is None else 1), forward=True
                )
                for road in roads
            ]
            lanes = number_in, number_out
            found.append(arm_route(self.arms, (entry, leaving), lanes, steps, lane))
        return tuple(sorted(found, key=lambda r: (r.entry_lane, r.ring_lane or 0, r.exit_lane)))

    def network(self, name: str) -> RoadNetwork:
        """Everything collected."""
        pairs = [
            (entry, leaving)
            for entry, leaving in product(range(self.count), repeat=2)
            if entry != leaving or entry in self.parameters.u_turns
        ]
        return RoadNetwork(
            name=name,
            driving_side=self.parameters.driving_side,
            roads=(*self.arms, *self.rings, *self.connecting),
            junctions=tuple(self.junctions),
            arm_roads=tuple(road.id for road in self.arms),
            routes={pair: self._routes(*pair) for pair in pairs},
        )

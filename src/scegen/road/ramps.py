"""Ramps: a lane that comes from beside a road, or leads off it, at an acute angle.

The two arm roads of a plain road are parted where a ramp joins or leaves. Between them lies a
junction as long as the ramp's lane needs to part from the others: a connecting road for each
direction goes straight on, and another leads from or to the ramp. Where the arms have an auxiliary
lane, its inner end is at the origin, and the ramp's lane goes on in it.
"""

from dataclasses import dataclass, replace
from math import acos, radians, sin

from scegen.errors import RoadInfeasibleError
from scegen.road.cross_section import (
    BORDER_WIDTH_M,
    CONNECTING_ROADS_FROM,
    JUNCTIONS_FROM,
    arm_line,
    arm_road,
    lane_in,
    lane_out,
    side_sign,
    verge,
)
from scegen.road.fillet import chain
from scegen.road.geometry import ReferenceLine, Segment
from scegen.road.links import LaneEnd, arm_route, connecting_road
from scegen.road.model import (
    Connection,
    ContactPoint,
    Extent,
    JunctionArea,
    Lane,
    LaneType,
    Road,
    RoadLink,
    RoadNetwork,
    Route,
    RouteStep,
)
from scegen.scenario.road_parameters import RoadParameters
from scegen.scenario.roadway import AuxiliaryLane

RAMP_RADIUS_M = 300.0
"""Driven at 100 km/h with less than 3 m/s2 sideways."""
PARALLEL_M = 60.0
RAMP_ANGLE_RAD = radians(10.0)
"""A ramp runs beside the road for a while, and comes from (or goes) there at an acute angle."""
RAMP_ROAD = 9
RAMPS = frozenset({AuxiliaryLane.ON_RAMP, AuxiliaryLane.OFF_RAMP})
_APART_M = 0.5
_LEAST_RAMP_M = 10.0


def gore_m(parameters: RoadParameters) -> float:
    """Length of the junction at which a ramp joins or leaves; 0 where there is none."""
    if parameters.auxiliary is None or parameters.auxiliary.kind not in RAMPS:
        return 0.0
    return 2 * RAMP_RADIUS_M * sin(_swing_rad(parameters))


def _swing_rad(parameters: RoadParameters) -> float:
    """By how much the ramp's lane turns, and back, to part from the road with its strips."""
    aside = sum(width for _, width in verge(parameters, 0)) + BORDER_WIDTH_M + _APART_M
    return acos(1 - aside / (2 * RAMP_RADIUS_M))


@dataclass
class _Parts:
    """What the network is made of; the gore is on arm 0 if a ramp joins, on arm 1 if one leaves."""

    parameters: RoadParameters
    arms: tuple[Road, Road]
    joins: bool

    @property
    def sign(self) -> int:
        return side_sign(self.parameters.driving_side)

    @property
    def lanes(self) -> int:
        """Driving lanes of the ramp's direction, the auxiliary one left out."""
        return self.parameters.arms[0].lanes_in

    def through(self, number: int, entry: int) -> Road:
        """The connecting road of one direction, with all that its arm has on that side."""
        source, target = self.arms[entry], self.arms[1 - entry]
        start = source.line.end
        line = ReferenceLine((Segment(start, gore_m(self.parameters)),))
        count = self.parameters.arms[entry].lanes_in
        own = [x for x in source.lanes if x.id * -self.sign > 0]
        lanes = [
            replace(lane, predecessor=lane.id, successor=-lane.id, extent=None)
            for lane in own
            if entry == 1 or abs(lane.id) <= abs(lane_in(source, count))
        ]
        if entry == 0:
            lanes += self._ending_verge(len(lanes))
        return Road(
            id=CONNECTING_ROADS_FROM + number,
            name=f"through_{entry}",
            line=line,
            lanes=tuple(sorted(lanes, key=lambda lane: -lane.id)),
            speed_limit_mps=source.speed_limit_mps,
            driving_side=source.driving_side,
            junction=JUNCTIONS_FROM,
            predecessor=RoadLink("road", source.id, ContactPoint.END),
            successor=RoadLink("road", target.id, ContactPoint.END),
        )

    def _ending_verge(self, inside: int) -> list[Lane]:
        """The strips beside the lanes, which end where the ramp's lane comes too near."""
        whole = gore_m(self.parameters)
        straight = whole / 2
        found = []
        for k, (kind, width) in enumerate(verge(self.parameters, 0), start=inside + 1):
            lane = Lane(-self.sign * k, kind, width)
            if self.joins:
                extent = Extent(0.0, straight, closes_m=straight)
                found.append(replace(lane, predecessor=lane.id, extent=extent))
            else:
                extent = Extent(whole - straight, whole, opens_m=straight)
                found.append(replace(lane, successor=-lane.id, extent=extent))
        return found

    def ramp(self) -> tuple[Road, Road]:
        """The ramp and the connecting road from it (or to it)."""
        main = self.arms[1] if self.joins else self.arms[0]
        number = self.lanes + 1
        aux = LaneEnd(main, lane_out(main, number) if self.joins else lane_in(main, number))
        # Away from the main road: the way of who leaves, or of who joins looked back along.
        away = main.line.pose(main.length_m, main.lane_centre_t_m(aux.lane))
        arc = RAMP_RADIUS_M * _swing_rad(self.parameters)
        # As far from the origin as the end of the road beside it, so that places agree.
        beside = 0 if self.joins else 1
        length = self.arms[beside].length_m + gore_m(self.parameters) - 2 * arc
        if length < _LEAST_RAMP_M:
            msg = f"arm {beside} is too short for the ramp beside it"
            raise RoadInfeasibleError(msg, where=f"arms[{beside}].length_m")
        outward = (self.sign if self.joins else -self.sign) / RAMP_RADIUS_M
        near = chain(away, [(arc, outward), (arc, -outward)])
        parallel = min(PARALLEL_M, length)
        bend = min(RAMP_RADIUS_M * RAMP_ANGLE_RAD, length - parallel)
        rest = length - parallel - bend
        far = chain(near.end, [(parallel, 0.0), (bend, outward), (rest, 0.0)])
        ramp = self._ramp_road(far.reversed() if self.joins else far)
        end = LaneEnd(ramp, -self.sign, ContactPoint.END if self.joins else ContactPoint.START)
        line = near.reversed() if self.joins else near
        source, target = (end, aux) if self.joins else (aux, end)
        road = connecting_road(CONNECTING_ROADS_FROM, JUNCTIONS_FROM, line, source, target)
        border = Lane(-2 * self.sign, LaneType.BORDER, BORDER_WIDTH_M)
        lanes = sorted((*road.lanes, border), key=lambda lane: -lane.id)
        return ramp, replace(road, lanes=tuple(lanes))

    def _ramp_road(self, line: ReferenceLine) -> Road:
        """The ramp, along its traffic: a lane with its middle on the line, a border either side."""
        width = self.parameters.arms[0].lane_width_m
        lanes = (
            Lane(-self.sign, LaneType.DRIVING, width),
            Lane(-2 * self.sign, LaneType.BORDER, BORDER_WIDTH_M),
            Lane(self.sign, LaneType.BORDER, BORDER_WIDTH_M),
        )
        link = RoadLink("junction", JUNCTIONS_FROM)
        return Road(
            id=RAMP_ROAD,
            name="ramp",
            line=line,
            lanes=tuple(sorted(lanes, key=lambda lane: -lane.id)),
            speed_limit_mps=self.parameters.arms[0].speed_limit_mps,
            driving_side=self.parameters.driving_side,
            lane_offset_m=self.sign * width / 2,
            predecessor=None if self.joins else link,
            successor=link if self.joins else None,
        )


def build_ramp(parameters: RoadParameters, name: str) -> RoadNetwork:
    """A straight road that a ramp joins, or that one leaves; the auxiliary lane at the origin.

    Raises:
        RoadInfeasibleError: the arm beside the ramp is too short for it.
    """
    auxiliary = parameters.auxiliary
    joins = auxiliary is not None and auxiliary.kind is AuxiliaryLane.ON_RAMP
    link = RoadLink("junction", JUNCTIONS_FROM)
    away = (gore_m(parameters), 0.0) if joins else (0.0, gore_m(parameters))
    first, second = (
        arm_road(parameters, arm, arm_line(arm, distance), link)
        for arm, distance in zip(parameters.arms, away, strict=True)
    )
    parts = _Parts(parameters, (first, second), joins)
    ramp, connecting = parts.ramp()
    entries = [entry for entry in (0, 1) if parameters.arms[entry].lanes_in]
    through = {entry: parts.through(1 + entry, entry) for entry in entries}
    routes: dict[tuple[int, int], tuple[Route, ...]] = {}
    for entry, road in through.items():
        routes[entry, 1 - entry] = tuple(
            arm_route(
                parts.arms,
                (entry, 1 - entry),
                (number, number),
                [RouteStep(road.id, lane_in(parts.arms[entry], number), forward=True)],
            )
            for number in range(1, parameters.arms[entry].lanes_in + 1)
        )
    number = parts.lanes + 1
    lane = -parts.sign
    steps = [RouteStep(road.id, lane, forward=True) for road in (ramp, connecting)]
    if joins:
        steps.append(RouteStep(second.id, lane_out(second, number), forward=False))
    else:
        steps.append(RouteStep(first.id, lane_in(first, number), forward=True))
        steps.reverse()
    routes[0, 1] += (Route(0, number, 1, number, None, tuple(steps)),)
    pairs = [(route.steps[0], route.steps[1]) for found in routes.values() for route in found]
    connections = tuple(
        Connection(k, a.road, b.road, a.lane, b.lane) for k, (a, b) in enumerate(pairs)
    )
    return RoadNetwork(
        name=name,
        driving_side=parameters.driving_side,
        roads=(first, second, ramp, connecting, *through.values()),
        junctions=(JunctionArea(JUNCTIONS_FROM, "ramp", connections),),
        arm_roads=(first.id, second.id),
        routes=routes,
        plain=True,
    )

"""Connecting roads: one lane through a junction, linked at both ends; routes over them."""

from collections.abc import Sequence
from dataclasses import dataclass

from scegen.road.cross_section import lane_in, lane_out, side_sign
from scegen.road.geometry import ReferenceLine
from scegen.road.model import ContactPoint, Lane, LaneType, Road, RoadLink, Route, RouteStep


@dataclass(frozen=True, slots=True)
class LaneEnd:
    """A lane of a road, at the end (or start) where it meets a junction."""

    road: Road
    lane: int
    contact: ContactPoint = ContactPoint.END

    @property
    def link(self) -> RoadLink:
        """The road end, as a link."""
        return RoadLink("road", self.road.id, self.contact)

    @property
    def width_m(self) -> float:
        """Width of the lane."""
        return self.road.lane(self.lane).width_m


def connecting_road(
    road_id: int, junction: int, line: ReferenceLine, source: LaneEnd, target: LaneEnd
) -> Road:
    """A road of one driving lane, centred on ``line``, as wide and as fast as both ends allow."""
    width = min(source.width_m, target.width_m)
    sign = side_sign(source.road.driving_side)
    lane = Lane(-sign, LaneType.DRIVING, width, predecessor=source.lane, successor=target.lane)
    return Road(
        id=road_id,
        name=f"{source.road.name}_{abs(source.lane)}_to_{target.road.name}_{abs(target.lane)}",
        line=line,
        lanes=(lane,),
        speed_limit_mps=min(source.road.speed_limit_mps, target.road.speed_limit_mps),
        driving_side=source.road.driving_side,
        lane_offset_m=sign * width / 2,
        junction=junction,
        predecessor=source.link,
        successor=target.link,
    )


def arm_route(
    arms: Sequence[Road],
    ends: tuple[int, int],
    lanes: tuple[int, int],
    between: Sequence[RouteStep] = (),
    ring_lane: int | None = None,
) -> Route:
    """From a lane of one arm to a lane of another (numbers), over the steps between them."""
    source, target = (arms[arm] for arm in ends)
    first = RouteStep(source.id, lane_in(source, lanes[0]), forward=True)
    last = RouteStep(target.id, lane_out(target, lanes[1]), forward=False)
    return Route(ends[0], lanes[0], ends[1], lanes[1], ring_lane, (first, *between, last))

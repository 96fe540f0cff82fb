"""Road networks as OpenDRIVE 1.7 text.

Written through scenariogeneration's low-level classes with our own geometry: its automatic
adjustment is not used. Road, lane and junction ids are those of the network.
"""

import xml.etree.ElementTree as ET
from collections.abc import Iterable
from copy import deepcopy
from dataclasses import replace

from scegen.export.library import xodr
from scegen.export.signs import add_controllers, entry_sign, lights_afoot, name_catalogue
from scegen.road.fillet import wrapped
from scegen.road.model import (
    ContactPoint,
    Crosswalk,
    JunctionArea,
    Lane,
    LaneType,
    Road,
    RoadLink,
    RoadNetwork,
)
from scegen.road.sections import Section, sections, width_pieces
from scegen.scenario.signals import SignalPlan
from scegen.scenario.vocabulary import Control

_DATE = "2025-01-01T00:00:00"
"""A fixed date, so that the same network gives the same bytes."""
_VENDOR = "ML-SceGen"
_DIGITS = 9
_MARK_WIDTH_M = 0.12


def write_opendrive(
    network: RoadNetwork,
    *,
    control: Control = Control.UNCONTROLLED,
    controlled_arms: Iterable[int] | None = None,
    signals: SignalPlan | None = None,
) -> str:
    """The network as OpenDRIVE 1.7 (ASAM, 2021), the same text for the same input.

    Frame and units are those of the network (m, rad, x east, y north). At the entries of the
    ``controlled_arms``, all if left out, stands the sign or light of ``control``, if that is stop,
    yield or signals; ``signals`` says which lights show the same, as controllers.
    """
    document = xodr.OpenDrive(network.name, revMajor="1", revMinor="7")
    arms = range(len(network.arm_roads)) if controlled_arms is None else controlled_arms
    signed = {network.arm_roads[arm] for arm in arms}
    groups = signals.groups if signals is not None else ()
    crossed = {network.arm_roads[arm] for group in groups if group.afoot for arm in group.arms}
    for road in network.roads:
        written = _road(road, control if road.id in signed else Control.UNCONTROLLED)
        if road.id in crossed:
            written.signals.extend(lights_afoot(road))
        document.add_road(written)
    for area in network.junctions:
        junction = xodr.Junction(area.name, area.id)
        for connection in _connections(area):
            junction.add_connection(connection)
        document.add_junction(junction)
    root = document.get_element()
    _complete_header(root, network)
    name_catalogue(root)
    if signals is not None:
        add_controllers(root, network, signals)
    for item in root.iter("object"):
        _repeat_outline(item)
    ET.indent(root)
    return f'<?xml version="1.0"?>\n{ET.tostring(root, encoding="unicode")}\n'


def _number(value: float) -> float:
    """Rounded far below any tolerance; never -0.0."""
    return round(value, _DIGITS) + 0.0


def _coefficient(value: float) -> float:
    """To nine digits: those of high powers are small."""
    return float(f"{value:.9g}") + 0.0


def _road(road: Road, control: Control) -> xodr.Road:
    written = xodr.Road(
        road.id,
        _plan_view(road),
        _lanes(road),
        road_type=-1 if road.junction is None else road.junction,
        name=road.name,
        rule=xodr.TrafficRule.RHT if road.driving_side == "right" else xodr.TrafficRule.LHT,
    )
    if road.predecessor is not None:
        written.add_predecessor(*_link(road.predecessor))
    if road.successor is not None:
        written.add_successor(*_link(road.successor))
    written.add_type(_type(road), 0, speed=_number(road.speed_limit_mps))
    written.add_elevation(0, 0, 0, 0, 0)
    # Appended, not added: adding draws on ids that are counted over the whole process.
    written.objects.extend(_crosswalk(crosswalk) for crosswalk in road.crosswalks)
    sign = entry_sign(road, control)
    if sign is not None:
        written.signals.append(sign)
    return written


def _type(road: Road) -> xodr.RoadType:
    """A road with a hard shoulder beyond a median is a motorway."""
    types = {lane.type for lane in road.lanes}
    motorway = {LaneType.MEDIAN, LaneType.SHOULDER} <= types
    return xodr.RoadType.motorway if motorway else xodr.RoadType.town


def _link(link: RoadLink) -> tuple[xodr.ElementType, int, xodr.ContactPoint | None]:
    element = xodr.ElementType.road if link.element == "road" else xodr.ElementType.junction
    return element, link.id, _contact(link.contact)


def _contact(contact: ContactPoint | None) -> xodr.ContactPoint | None:
    if contact is None:
        return None
    return xodr.ContactPoint.start if contact is ContactPoint.START else xodr.ContactPoint.end


def _plan_view(road: Road) -> xodr.PlanView:
    view = xodr.PlanView()
    for segment in road.line.segments:
        length = _number(segment.length_m)
        shape = (
            xodr.Arc(_number(segment.curvature_1pm), length=length)
            if segment.curvature_1pm
            else xodr.Line(length)
        )
        start = segment.start
        view.add_fixed_geometry(
            shape, _number(start.x_m), _number(start.y_m), _number(wrapped(start.heading_rad))
        )
    return view


def _lanes(road: Road) -> xodr.Lanes:
    lanes = xodr.Lanes()
    for part in sections(road):
        seen = replace(road, lanes=part.lanes)
        centre = xodr.Lane(lane_type=xodr.LaneType.none)
        centre.add_roadmark(_road_mark(seen, 0))
        section = xodr.LaneSection(_number(part.from_m), centre)
        for lane in sorted(part.lanes, key=lambda lane: abs(lane.id)):
            written = _lane(lane, part)
            written.add_roadmark(_road_mark(seen, lane.id))
            if lane.id > 0:
                section.add_left_lane(written)
            else:
                section.add_right_lane(written)
        lanes.add_lanesection(section)
    if road.lane_offset_m:
        lanes.add_laneoffset(xodr.LaneOffset(0, _number(road.lane_offset_m)))
    return lanes


def _lane(lane: Lane, part: Section) -> xodr.Lane:
    (_, first), *others = width_pieces(lane, part)
    written = xodr.Lane(xodr.LaneType[lane.type.value], *map(_coefficient, first))
    for begins, shape in others:
        written.add_lane_width(*map(_coefficient, shape), soffset=_number(begins))
    if lane.predecessor is not None:
        written.add_link("predecessor", lane.predecessor)
    if lane.successor is not None:
        written.add_link("successor", lane.successor)
    return written


def _connections(area: JunctionArea) -> list[xodr.Connection]:
    """One for each pair of an incoming and a connecting road, with all the lanes that it links."""
    written: dict[tuple[int, int], xodr.Connection] = {}
    for connection in area.connections:
        pair = connection.incoming_road, connection.connecting_road
        if pair not in written:
            written[pair] = xodr.Connection(*pair, xodr.ContactPoint.start, connection.id)
        written[pair].add_lanelink(connection.from_lane, connection.to_lane)
    return list(written.values())


def _crosswalk(crosswalk: Crosswalk) -> xodr.Object:
    middle = (crosswalk.t_min_m + crosswalk.t_max_m) / 2
    along, across = crosswalk.width_m / 2, (crosswalk.t_max_m - crosswalk.t_min_m) / 2
    written = xodr.Object(
        _number(crosswalk.s_m),
        _number(middle),
        Type=xodr.ObjectType.crosswalk,
        subtype="",
        id=str(crosswalk.id),
        name=f"crosswalk_{crosswalk.id}",
        zOffset=0.0,
        length=_number(2 * along),
        width=_number(2 * across),
        height=0.0,
    )
    outline = xodr.Outline(closed=True, outer=True, id=0)
    for corner, (u, v) in enumerate(((-1, -1), (1, -1), (1, 1), (-1, 1))):
        outline.add_corner(
            xodr.CornerLocal(_number(u * along), _number(v * across), 0.0, 0.0, id=corner)
        )
    written.add_outline(outline)
    return written


def _repeat_outline(item: ET.Element) -> None:
    """CARLA reads an outline only outside ``outlines``, with its first corner repeated."""
    outlines = item.find("outlines")
    if outlines is None:
        return
    copy = deepcopy(outlines[0])
    last = deepcopy(copy[0])
    last.set("id", str(len(copy)))
    copy.append(last)
    item.insert(list(item).index(outlines), copy)


def _complete_header(root: ET.Element, network: RoadNetwork) -> None:
    """Date, vendor, and the rectangle around all reference lines (m)."""
    header = root.find("header")
    if header is None:
        return
    poses = [road.line.pose(road.length_m * k / 16) for road in network.roads for k in range(17)]
    header.set("date", _DATE)
    header.set("vendor", _VENDOR)
    header.set("north", f"{max(pose.y_m for pose in poses):.3f}")
    header.set("south", f"{min(pose.y_m for pose in poses):.3f}")
    header.set("east", f"{max(pose.x_m for pose in poses):.3f}")
    header.set("west", f"{min(pose.x_m for pose in poses):.3f}")


def _road_mark(road: Road, lane_id: int) -> xodr.RoadMark:
    """The mark on the outer border of a lane; of lane 0, the centre line.

    Solid at the edges of the carriageways, broken between lanes of one direction and on the
    centre line of a road with one lane each way; none inside junctions, but where one direction of
    a road goes straight on through.
    """
    if road.junction is not None and not road.goes_on:
        return xodr.RoadMark(xodr.RoadMarkType.none)
    if lane_id == 0:
        return _centre_mark(road)
    lane = road.lane(lane_id)
    outer = next((x for x in road.lanes if x.id == lane_id + (1 if lane_id > 0 else -1)), None)
    if lane.type is LaneType.MEDIAN:
        return _line(xodr.RoadMarkType.solid, xodr.LaneChange.none)
    if lane.type is not LaneType.DRIVING:
        return xodr.RoadMark(xodr.RoadMarkType.none)
    if outer is not None and outer.type is LaneType.DRIVING:
        return _line(xodr.RoadMarkType.broken, xodr.LaneChange.both)
    return _line(xodr.RoadMarkType.solid, xodr.LaneChange.none)


def _centre_mark(road: Road) -> xodr.RoadMark:
    if any(lane.type is LaneType.MEDIAN for lane in road.lanes):
        return xodr.RoadMark(xodr.RoadMarkType.none)
    if len(road.driving(1)) == len(road.driving(-1)) == 1:
        return _line(xodr.RoadMarkType.broken, xodr.LaneChange.both)
    return _line(xodr.RoadMarkType.solid, xodr.LaneChange.none)


def _line(kind: xodr.RoadMarkType, change: xodr.LaneChange) -> xodr.RoadMark:
    return xodr.RoadMark(kind, width=_MARK_WIDTH_M, laneChange=change)

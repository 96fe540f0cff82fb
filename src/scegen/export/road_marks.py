"""Painted lines: which mark stands on the outer border of a lane."""

from __future__ import annotations

from scegen.export.library import xodr
from scegen.road.model import LaneType, Road

_WIDTH_M = 0.12


def road_mark(road: Road, lane_id: int) -> xodr.RoadMark:
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
    return xodr.RoadMark(kind, width=_WIDTH_M, laneChange=change)

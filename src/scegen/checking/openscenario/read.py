"""From an OpenSCENARIO file to a storyboard; what cannot be read becomes a finding."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from math import nan
from typing import Any

import numpy as np
from lxml import etree
from numpy.typing import NDArray

from scegen.checking.documents import LARGEST, Document, usable
from scegen.checking.openscenario.storyboard import (
    EGO_PROPERTY,
    EXTERNAL_PROPERTY,
    Entity,
    LanePoint,
    Storyboard,
    Trajectory,
    WorldPoint,
)
from scegen.checking.results import Finding, error, unchecked

READABLE = "xosc.readable"
BODIES = ("Vehicle", "Pedestrian", "MiscObject", "CatalogReference")

_REFERRING: Any = etree.XPath("//@entityRef/..")
_VERTICES = "Shape/Polyline/Vertex"
_STATED: tuple[Any, ...] = tuple(
    etree.XPath(f"{_VERTICES}/{stated}", smart_strings=False)
    for stated in ("@time", *(f"Position/WorldPosition/@{name}" for name in "xyh"))
)
_COUNT: Any = etree.XPath(f"count({_VERTICES})")
_ODD: Any = etree.XPath(f"{_VERTICES}[count(Position/WorldPosition) != 1]")


class _UnreadableError(Exception):
    """A value that makes no sense, at a line of the file; or only to this reader."""

    def __init__(
        self, element: etree._Element, message: str, found: Callable[..., Finding] = error
    ) -> None:
        self.line = element.sourceline
        self.found = found
        super().__init__(message)


def read_storyboard(document: Document) -> tuple[Storyboard, tuple[Finding, ...]]:
    """Read a scenario; parameters (``$name``) are replaced by their declared values.

    What cannot be read is left out and reported.
    """
    reader = _Reader(document)
    return reader.storyboard(), tuple(reader.findings)


def _plain(trajectory: etree._Element) -> NDArray[np.float64] | None:
    """Time, place and heading of vertices that all state them by usable numbers, as most do."""
    told: list[list[str]] = [column(trajectory) for column in _STATED]
    if len({_COUNT(trajectory), *map(len, told)}) != 1 or _ODD(trajectory):
        return None
    try:
        columns = np.array([list(map(float, column)) for column in told])
    except ValueError:
        return None
    return columns if (np.abs(columns) <= LARGEST).all() else None


class _Reader:
    def __init__(self, document: Document) -> None:
        self.document = document
        self.findings: list[Finding] = []
        self.parameters = document.declared()

    def storyboard(self) -> Storyboard:
        root = self.document.root
        logic = root.find("RoadNetwork/LogicFile")
        return Storyboard(
            name=self.document.name,
            road_file=None if logic is None else self.text(logic, "filepath"),
            entities=tuple(self.entity(e) for e in root.iterfind("Entities/ScenarioObject")),
            starts=self.starts(root),
            trajectories=tuple(self.trajectories(root)),
            references=tuple(self.references(root)),
            lane_points=tuple(self.lane_points(root)),
        )

    def text(self, element: etree._Element, name: str) -> str:
        value = element.get(name, "")
        return self.parameters.get(value, value)

    def worked_out(self, element: etree._Element, name: str) -> str:
        text = self.text(element, name)
        if text.startswith("$"):
            message = f"<{element.tag}> {name}={text!r} is not worked out"
            raise _UnreadableError(element, message, unchecked)
        return text

    def number(self, element: etree._Element, name: str, default: str | None = None) -> float:
        text = self.worked_out(element, name) or default
        value = usable(text)
        if value is None:
            raise _UnreadableError(
                element, f"<{element.tag}> {name}={text!r} is not a usable number"
            )
        return value

    @contextmanager
    def reporting(self) -> Iterator[None]:
        try:
            yield
        except _UnreadableError as problem:
            place = f"{self.document.name}:{problem.line}"
            self.findings.append(problem.found(READABLE, place, str(problem)))

    def entity(self, element: etree._Element) -> Entity:
        body = next((child for child in element if child.tag in BODIES), None)
        properties = {
            (e.get("name", ""), self.text(e, "value")) for e in element.iterfind(".//Property")
        }
        category = ""
        if body is not None:
            names = ("vehicleCategory", "pedestrianCategory", "miscObjectCategory")
            category = next((body.get(name, "") for name in names if body.get(name)), "")
        return Entity(
            name=self.text(element, "name"),
            kind=str(body.tag) if body is not None else "",
            category=category,
            is_ego=EGO_PROPERTY in properties,
            is_external=EXTERNAL_PROPERTY in properties,
            size_m=self.size_m(element.find(".//BoundingBox/Dimensions")),
        )

    def size_m(self, element: etree._Element | None) -> tuple[float, float, float] | None:
        if element is None:
            return None
        with self.reporting():
            length, width, height = (
                self.number(element, name) for name in ("length", "width", "height")
            )
            return length, width, height
        return None

    def starts(self, root: etree._Element) -> dict[str, WorldPoint | LanePoint | None]:
        found: dict[str, WorldPoint | LanePoint | None] = {}
        for private in root.iterfind("Storyboard/Init/Actions/Private"):
            position = self.position(private.find("PrivateAction/TeleportAction/Position"))
            found.setdefault(self.text(private, "entityRef"), position)
        return found

    def position(self, element: etree._Element | None) -> WorldPoint | LanePoint | None:
        if element is None:
            return None
        world, lane = element.find("WorldPosition"), element.find("LanePosition")
        along = element.find("TrajectoryPosition")
        with self.reporting():
            if world is not None:
                return self.world_point(world)
            if along is not None:
                return self.on_trajectory(along)
            return None if lane is None else self.lane_point(lane)
        return None

    def on_trajectory(self, element: etree._Element) -> WorldPoint | None:
        trajectory = element.find("TrajectoryRef/Trajectory")
        if trajectory is None or self.number(element, "t", "0"):
            return None
        return self.trajectory(trajectory, ()).at(self.number(element, "s"))

    def world_point(self, element: etree._Element) -> WorldPoint:
        x, y = self.number(element, "x"), self.number(element, "y")
        return WorldPoint(x, y, self.number(element, "h", "0"))

    def lane_point(self, element: etree._Element) -> LanePoint:
        text = self.worked_out(element, "laneId")
        if not text.lstrip("+-").isdecimal():
            raise _UnreadableError(element, f"<LanePosition> laneId={text!r} is not a lane number")
        return LanePoint(
            self.text(element, "roadId"),
            int(text),
            self.number(element, "s"),
            self.number(element, "offset", "0"),
        )

    def trajectories(self, root: etree._Element) -> Iterator[Trajectory]:
        for group in root.iterfind(".//ManeuverGroup"):
            actors = tuple(self.text(e, "entityRef") for e in group.iterfind("Actors/EntityRef"))
            for action in group.iterfind(".//FollowTrajectoryAction"):
                for element in action.iterfind(".//Trajectory"):
                    with self.reporting():
                        begins_m = self.number(action, "initialDistanceOffset", "0")
                        yield self.trajectory(element, actors, begins_m)

    def trajectory(
        self, element: etree._Element, actors: tuple[str, ...], begins_m: float = 0.0
    ) -> Trajectory:
        if element.find("Shape/Polyline") is None:
            raise _UnreadableError(element, "the trajectory is no polyline", unchecked)
        columns = _plain(element)
        if columns is None:
            rows = [self.vertex(each) for each in element.iterfind(_VERTICES)]
            columns = np.array(rows).reshape(-1, 4).T
        time, x, y, headings = columns
        return Trajectory(element.get("name", "?"), actors, time, x + 1j * y, headings, begins_m)

    def vertex(self, element: etree._Element) -> tuple[float, float, float, float]:
        world = element.find("Position/WorldPosition")
        if world is None:
            raise _UnreadableError(element, "a vertex has no world position", unchecked)
        place = self.world_point(world)
        time = self.number(element, "time") if element.get("time") else nan
        return time, place.x, place.y, place.heading

    def references(self, root: etree._Element) -> Iterator[tuple[str, str]]:
        for element in _REFERRING(root):
            place = f"{self.document.name}:{element.sourceline} <{element.tag}>"
            yield place, self.text(element, "entityRef")

    def lane_points(self, root: etree._Element) -> Iterator[tuple[str, LanePoint]]:
        for element in root.iter("LanePosition"):
            with self.reporting():
                yield f"{self.document.name}:{element.sourceline}", self.lane_point(element)

"""From an OpenDRIVE file to a network; what cannot be read becomes a finding."""

from collections.abc import Callable
from typing import TypeVar

from lxml import etree

from scegen.checking.documents import Document, usable
from scegen.checking.opendrive.curves import Arc, Cubic, Curve, Poly3, Spiral
from scegen.checking.opendrive.network import (
    Connection,
    Geometry,
    Junction,
    Lane,
    LaneSection,
    Link,
    Network,
    Road,
)
from scegen.checking.results import Finding, error

N = TypeVar("N", Road, Junction)
READABLE = "xodr.readable"
MPS = {"m/s": 1.0, "km/h": 1 / 3.6, "mph": 0.44704}
"""Units of speed (OpenDRIVE e_unitSpeed) in m/s."""
SHAPES = frozenset({"line", "arc", "spiral", "poly3", "paramPoly3"})


class _UnreadableError(Exception):
    """An attribute or element that the reader needs is missing or makes no sense."""


def read_network(document: Document) -> tuple[Network, tuple[Finding, ...]]:
    """Read roads and junctions; a road that cannot be read is left out and reported."""
    findings: list[Finding] = []
    roads = _by_id(document, "road", _road, findings)
    junctions = _by_id(document, "junction", _junction, findings)
    if not roads and not findings:
        findings.append(error(READABLE, document.name, "has no road"))
    return Network(document.name, document.version, roads, junctions), tuple(findings)


def _by_id(
    document: Document, tag: str, read: Callable[[etree._Element], N], findings: list[Finding]
) -> dict[str, N]:
    """What can be read of the elements with a tag; the first of those with the same id."""
    found: dict[str, N] = {}
    for element in document.root.iterfind(tag):
        place = f"{tag} {element.get('id', '?')} (line {element.sourceline})"
        try:
            one = read(element)
        except _UnreadableError as problem:
            findings.append(error(READABLE, place, str(problem)))
            continue
        if one.id in found:
            findings.append(error(READABLE, place, f"the id is used by an earlier {tag}"))
        found.setdefault(one.id, one)
    return found


def _text(element: etree._Element, name: str) -> str:
    value = element.get(name)
    if value is None:
        raise _UnreadableError(f"<{element.tag}> has no attribute {name!r}")
    return value


def _number(element: etree._Element, name: str) -> float:
    text = _text(element, name)
    value = usable(text)
    if value is None:
        raise _UnreadableError(f"<{element.tag}> {name}={text!r} is not a usable number")
    return value


def _whole(element: etree._Element, name: str) -> int:
    text = _text(element, name)
    try:
        return int(text)
    except ValueError:
        raise _UnreadableError(f"<{element.tag}> {name}={text!r} is not a lane number") from None


def _poly3(element: etree._Element, start: str, offset: float = 0.0) -> Poly3:
    return Poly3(offset + _number(element, start), *(_number(element, name) for name in "abcd"))


def _road(element: etree._Element) -> Road:
    length = _number(element, "length")
    junction = element.get("junction", "-1")
    geometries = tuple(_geometry(g) for g in element.iterfind("planView/geometry"))
    if not geometries:
        raise _UnreadableError("has no planView geometry")
    return Road(
        id=_text(element, "id"),
        length=length,
        rule=element.get("rule", "RHT"),
        junction=None if junction == "-1" else junction,
        predecessor=_link(element.find("link/predecessor")),
        successor=_link(element.find("link/successor")),
        geometries=geometries,
        lane_offsets=tuple(_poly3(e, "s") for e in element.iterfind("lanes/laneOffset")),
        elevations=tuple(_poly3(e, "s") for e in element.iterfind("elevationProfile/elevation")),
        sections=_sections(element, length),
        speed_limit=_speed_limit(element.find("type/speed")),
        crosswalks=tuple(
            _number(found, "s")
            for found in element.iterfind("objects/object")
            if found.get("type") == "crosswalk"
        ),
    )


def _speed_limit(element: etree._Element | None) -> float | None:
    if element is None or element.get("max") in {"no limit", "undefined"}:
        return None
    unit = element.get("unit", "m/s")
    if unit not in MPS:
        raise _UnreadableError(f"<speed> unit={unit!r} is not a unit of speed")
    return _number(element, "max") * MPS[unit]


def _link(element: etree._Element | None) -> Link | None:
    if element is None:
        return None
    return Link(
        _text(element, "elementType"), _text(element, "elementId"), element.get("contactPoint")
    )


def _geometry(element: etree._Element) -> Geometry:
    shapes = [child for child in element if child.tag in SHAPES]
    kind = str(shapes[0].tag) if shapes else "nothing"
    length = _number(element, "length")
    return Geometry(
        s=_number(element, "s"),
        x=_number(element, "x"),
        y=_number(element, "y"),
        hdg=_number(element, "hdg"),
        length=length,
        kind=kind,
        curve=_curve(shapes[0], length) if shapes else None,
    )


def _curve(shape: etree._Element, length: float) -> Curve | None:
    if shape.tag == "line":
        return Arc()
    if shape.tag == "arc":
        return Arc(_number(shape, "curvature"))
    if shape.tag == "spiral":
        first, last = _number(shape, "curvStart"), _number(shape, "curvEnd")
        return Spiral(first, (last - first) / length if length else 0.0)
    if shape.tag == "paramPoly3":
        u, v = (Poly3(0.0, *(_number(shape, power + axis) for power in "abcd")) for axis in "UV")
        by_length = shape.get("pRange") == "arcLength"
        return Cubic(u, v, 1.0 if by_length else 1.0 / length if length else 0.0)
    return None


def _sections(element: etree._Element, length: float) -> tuple[LaneSection, ...]:
    found = element.findall("lanes/laneSection")
    if not found:
        raise _UnreadableError("has no lane section")
    starts = [_number(section, "s") for section in found]
    return tuple(
        LaneSection(start, end, _lanes(section, start))
        for section, start, end in zip(found, starts, [*starts[1:], length], strict=True)
    )


def _lanes(section: etree._Element, start: float) -> dict[int, Lane]:
    lanes: dict[int, Lane] = {}
    for side in ("left", "center", "right"):
        for element in section.iterfind(f"{side}/lane"):
            lane = _lane(element, start)
            wrong_side = {"left": lane.id <= 0, "center": lane.id != 0, "right": lane.id >= 0}
            if lane.id in lanes or wrong_side[side]:
                raise _UnreadableError(f"lane {lane.id} stands twice or on the wrong side")
            lanes[lane.id] = lane
    for sign in (1, -1):
        ids = sorted(abs(i) for i in lanes if i * sign > 0)
        if ids != list(range(1, len(ids) + 1)):
            raise _UnreadableError(f"lane numbers are not consecutive: {[sign * i for i in ids]}")
    return lanes


def _lane(element: etree._Element, start: float) -> Lane:
    number = _whole(element, "id")
    if element.find("border") is not None:
        raise _UnreadableError(f"lane {number} is given by borders, which this check cannot read")
    widths = tuple(_poly3(e, "sOffset", start) for e in element.iterfind("width"))
    if number != 0 and (not widths or widths[0].s > start + 1e-6):
        raise _UnreadableError(f"lane {number} has no width at the start of its section")
    predecessor, successor = (
        None if link is None else _whole(link, "id")
        for link in (element.find("link/predecessor"), element.find("link/successor"))
    )
    return Lane(number, element.get("type", "none"), widths, predecessor, successor)


def _junction(element: etree._Element) -> Junction:
    direct = element.get("type") == "direct"
    joined = "linkedRoad" if direct else "connectingRoad"
    found = tuple(_connection(e, joined) for e in element.iterfind("connection"))
    return Junction(_text(element, "id"), direct, found)


def _connection(element: etree._Element, joined: str) -> Connection:
    return Connection(
        id=_text(element, "id"),
        incoming=_text(element, "incomingRoad"),
        connecting=_text(element, joined),
        contact=_text(element, "contactPoint"),
        lanes=tuple((_whole(e, "from"), _whole(e, "to")) for e in element.iterfind("laneLink")),
    )

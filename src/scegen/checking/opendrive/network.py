"""A road network as an OpenDRIVE file states it: data read from the file, nothing derived.

Ids are strings, as in the file; lengths are metres, angles radians.
"""

from cmath import exp
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TypeVar

from scegen.checking.opendrive.curves import Curve, Poly3

START, END = "start", "end"


@dataclass(frozen=True, slots=True)
class Geometry:
    """One planView geometry; ``curve`` is None if its ``kind`` is one that is not read."""

    s: float
    x: float
    y: float
    hdg: float
    length: float
    kind: str
    curve: Curve | None

    @property
    def shape(self) -> Curve:
        """Its curve; ValueError if that is not read."""
        if self.curve is None:
            raise ValueError(f"geometry {self.kind!r} has no curve")
        return self.curve

    def point(self, ds: float) -> complex:
        """The point ``ds`` after the start, as x + iy."""
        return complex(self.x, self.y) + exp(1j * self.hdg) * self.shape.point(ds)

    def heading_at(self, ds: float) -> float:
        """The heading ``ds`` after the start."""
        return self.hdg + self.shape.heading(ds)


@dataclass(frozen=True, slots=True)
class Lane:
    """A lane of one section; ``widths`` are counted from the section's start."""

    id: int
    type: str
    widths: tuple[Poly3, ...]
    predecessor: int | None
    successor: int | None

    def link(self, contact: str) -> int | None:
        """The lane it is linked to beyond one end."""
        return self.predecessor if contact == START else self.successor


@dataclass(frozen=True, slots=True)
class LaneSection:
    """A stretch of road with the same lanes."""

    s: float
    end: float
    lanes: dict[int, Lane]


P = TypeVar("P", Poly3, Geometry, LaneSection)


def piece_at(pieces: Sequence[P], s: float) -> P | None:
    """The last piece that has begun at ``s``; None before the first."""
    return next((piece for piece in reversed(pieces) if piece.s <= s + 1e-9), None)


@dataclass(frozen=True, slots=True)
class Link:
    """What a road end is joined to."""

    element: str
    id: str
    contact: str | None

    def __str__(self) -> str:
        """How findings name it."""
        return f"{self.element} {self.id} {self.contact or ''}".rstrip()


@dataclass(frozen=True, slots=True)
class Road:
    """A road as read; ``junction`` is None outside junctions.

    ``speed_limit`` is in m/s, None without one; ``crosswalks`` are the s of crosswalk objects.
    """

    id: str
    length: float
    rule: str
    junction: str | None
    predecessor: Link | None
    successor: Link | None
    geometries: tuple[Geometry, ...]
    lane_offsets: tuple[Poly3, ...]
    elevations: tuple[Poly3, ...]
    sections: tuple[LaneSection, ...]
    speed_limit: float | None
    crosswalks: tuple[float, ...]

    def link(self, contact: str) -> Link | None:
        """What lies beyond one end."""
        return self.predecessor if contact == START else self.successor

    def section(self, contact: str) -> LaneSection:
        """The lane section at one end."""
        return self.sections[0] if contact == START else self.sections[-1]

    def s_at(self, contact: str) -> float:
        """The s of one end."""
        return 0.0 if contact == START else self.length

    @property
    def measurable(self) -> bool:
        """Whether every geometry is of a kind that is read, so that positions can be computed."""
        return all(geometry.curve is not None for geometry in self.geometries)

    def runs_along_s(self, lane_id: int) -> bool:
        """Whether traffic on this lane runs in the direction of s.

        OpenDRIVE 1.7, 9.1: right lanes run along the reference line in right-hand traffic and
        against it in left-hand traffic.
        """
        return (lane_id < 0) == (self.rule == "RHT")

    def leads_to(self, lane_id: int, contact: str) -> bool:
        """Whether traffic on this lane runs towards that end of the road."""
        return self.runs_along_s(lane_id) == (contact == END)


@dataclass(frozen=True, slots=True)
class Connection:
    """A connection of a junction; ``lanes`` are (from, to) pairs.

    In a direct junction ``connecting`` is the linked road itself.
    """

    id: str
    incoming: str
    connecting: str
    contact: str
    lanes: tuple[tuple[int, int], ...]


@dataclass(frozen=True, slots=True)
class Junction:
    """A junction as read; a ``direct`` one joins roads without roads of its own."""

    id: str
    direct: bool
    connections: tuple[Connection, ...]


@dataclass(frozen=True, eq=False)
class Network:
    """Everything that the rules look at; each is itself only."""

    name: str
    version: tuple[str, str]
    roads: dict[str, Road]
    junctions: dict[str, Junction]

    def joined(self, road: Road, contact: str) -> tuple[Road, str] | None:
        """The road to which one end of a road is linked, and which end of that one is meant."""
        link = road.link(contact)
        other = self.roads.get(link.id) if link and link.element == "road" else None
        if link is None or other is None or link.contact not in {START, END}:
            return None
        return other, link.contact

    def connecting_roads(self, junction: str) -> Iterator[Road]:
        """The roads that say they belong to a junction."""
        return (road for road in self.roads.values() if road.junction == junction)


def other_end(contact: str) -> str:
    """The opposite end of a road."""
    return END if contact == START else START


def road_place(road: str, detail: str = "") -> str:
    """How findings name a road."""
    return f"road {road} {detail}".rstrip()


def lane_place(road: str, lane: int, detail: str = "") -> str:
    """How findings name a lane."""
    return f"road {road} lane {lane} {detail}".rstrip()

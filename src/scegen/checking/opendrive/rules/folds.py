"""No lane folds: neither inside a bend tighter than the lane is far out, nor over itself."""

from cmath import exp
from collections.abc import Iterator
from itertools import pairwise

from shapely import unary_union
from shapely.geometry import Polygon

from scegen.checking.opendrive.curves import Arc
from scegen.checking.opendrive.lanes import driving, lane_borders, reference, section_at, stations
from scegen.checking.opendrive.network import LaneSection, Network, Road, lane_place
from scegen.checking.results import Finding, error

MARGIN = 0.05
"""What must be left of 1 - curvature * offset; at 0 the border stands still, below it runs back."""
OVERLAP_M2 = 0.05
"""A U-turn's lane may touch itself where it leaves beside where it came; it may not cover more."""


def check_folds(network: Network) -> Iterator[Finding]:
    """``xodr.lane_fold``: 1 - k·t stays positive at both borders of every lane."""
    for road in network.roads.values():
        if road.measurable and any(g.curve != Arc() for g in road.geometries):
            for section in road.sections:
                for lane in section.lanes:
                    if lane != 0:
                        yield from _fold(road, section, lane)


def _fold(road: Road, section: LaneSection, lane: int) -> Iterator[Finding]:
    for s in stations(section.s, section.end):
        curvature = reference(road, s)[2]
        t = max(lane_borders(road, section, lane, s), key=lambda border: curvature * border)
        if 1 - curvature * t < MARGIN:
            place = lane_place(road.id, lane, f"s = {s:.2f} m")
            message = f"folds: its border is {abs(t):.2f} m inside a bend of {1 / curvature:.2f} m"
            yield error("xodr.lane_fold", place, message)
            return


def check_overlaps(network: Network) -> Iterator[Finding]:
    """``xodr.lane_overlap``: a connecting lane does not run over itself."""
    for road in network.roads.values():
        if road.junction is not None and road.measurable and len(road.sections) == 1:
            for lane in driving(road.sections[0]):
                twice = _covered_twice_m2(road, lane)
                if twice > OVERLAP_M2:
                    message = f"covers {twice:.2f} m² twice"
                    yield error("xodr.lane_overlap", lane_place(road.id, lane), message)


def _covered_twice_m2(road: Road, lane: int) -> float:
    rungs = [_rung(road, lane, s) for s in stations(0.0, road.length)]
    pieces = [Polygon([*first, *reversed(second)]) for first, second in pairwise(rungs)]
    total: float = sum(piece.area for piece in pieces)
    covered: float = unary_union([piece.buffer(0) for piece in pieces]).area
    return total - covered


def _rung(road: Road, lane: int, s: float) -> list[tuple[float, float]]:
    point, heading, _ = reference(road, s)
    borders = lane_borders(road, section_at(road, s), lane, s)
    ends = (point + 1j * t * exp(1j * heading) for t in borders)
    return [(end.real, end.imag) for end in ends]

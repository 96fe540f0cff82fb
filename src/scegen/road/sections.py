"""Lane sections: the parts of a road over which it has the same lanes."""

from dataclasses import dataclass, replace
from itertools import pairwise

from scegen.road.model import Lane, Road

_SAME_M = 1e-6


@dataclass(frozen=True, slots=True)
class Section:
    """From ``from_m`` to ``to_m``: the lanes of that part, numbered and linked among themselves.

    A lane's ``extent`` tells how its width changes, None where it does not.
    """

    from_m: float
    to_m: float
    lanes: tuple[Lane, ...]


def sections(road: Road) -> tuple[Section, ...]:
    """The sections of a road in the order of s; one where all lanes run all along it."""
    cuts = {0.0, road.length_m}
    for lane in road.lanes:
        if lane.extent is not None:
            ends = (lane.extent.from_m, lane.extent.to_m)
            cuts |= {s for s in ends if _SAME_M < s < road.length_m - _SAME_M}
    spans = list(pairwise(sorted(cuts)))
    numbers = [_numbered(road, (low + high) / 2) for low, high in spans]
    return tuple(
        Section(low, high, tuple(_lane(road, numbers, k, lane) for lane in numbers[k]))
        for k, (low, high) in enumerate(spans)
    )


def _numbered(road: Road, s_m: float) -> dict[int, int]:
    """Number in the section by id on the road, of the lanes that are there at ``s_m``."""
    found: dict[int, int] = {}
    for sign in (1, -1):
        there = [x for x in road.lanes if x.id * sign > 0 and _is_at(x, s_m)]
        there.sort(key=lambda lane: abs(lane.id))
        found |= {lane.id: sign * k for k, lane in enumerate(there, start=1)}
    return dict(sorted(found.items(), reverse=True))


def _is_at(lane: Lane, s_m: float) -> bool:
    return lane.extent is None or lane.extent.from_m <= s_m <= lane.extent.to_m


def _lane(road: Road, numbers: list[dict[int, int]], k: int, lane_id: int) -> Lane:
    """A lane as the k-th section has it: linked to itself in the sections beside."""
    lane = road.lane(lane_id)
    before = numbers[k - 1].get(lane_id) if k else lane.predecessor
    after = numbers[k + 1].get(lane_id) if k + 1 < len(numbers) else lane.successor
    return replace(lane, id=numbers[k][lane_id], predecessor=before, successor=after)


def width_pieces(lane: Lane, section: Section) -> list[tuple[float, tuple[float, ...]]]:
    """How a lane's width goes: from so far behind the section's start, as a polynomial from there.

    Tapers are S-shaped, w (3 p^2 - 2 p^3): nothing has a kink.
    """
    extent, width = lane.extent, lane.width_m
    if extent is None:
        return [(0.0, (width, 0.0, 0.0, 0.0))]
    opens, closes = extent.opens_m, extent.closes_m
    pieces: list[tuple[float, tuple[float, ...]]] = []
    if opens:
        pieces.append((extent.from_m, (0.0, 0.0, 3 * width / opens**2, -2 * width / opens**3)))
    if extent.to_m - closes - extent.from_m - opens > _SAME_M:
        pieces.append((extent.from_m + opens, (width, 0.0, 0.0, 0.0)))
    if closes:
        narrows = (width, 0.0, -3 * width / closes**2, 2 * width / closes**3)
        pieces.append((extent.to_m - closes, narrows))
    return [(max(s - section.from_m, 0.0), shape) for s, shape in pieces]

"""A junction from above, as a sketch: where roads lie and which way a movement takes.

Coordinates are those of a tile: its centre is (0, 0), x to the right, y up, in pixels.
"""

from dataclasses import dataclass
from math import asin, atan2, cos, hypot, pi, radians, sin

import numpy as np

from scegen.scenario.arms import arm_angles_deg
from scegen.scenario.junction import Junction
from scegen.scenario.logical import Crossing, Drive, Heading, Reverses, Standing, Walking
from scegen.scenario.roadway import AuxiliaryLane, Carriageway, Strip
from scegen.scenario.vocabulary import DrivingSide, JunctionKind, Maneuver, Side

Point = tuple[float, float]

REACH = 104.0
"""Where arms end."""
_START = 92.0
_BACKS_AT = 0.3 * REACH
_RANK_STEP = 17.0
RING = 34.0
"""Radius of the ring's middle."""
_RING_JOIN, _RING_LEAST = radians(14.0), radians(8.0)
_ARC_STEPS, _CURVE_STEPS = 24, 14
_BOX = 9.0
_MEDIAN = 4.0
_IN_LINE = 0.01
_FROM_BESIDE = frozenset({Reverses.FROM_RIGHT, Reverses.FROM_LEFT})


@dataclass(frozen=True)
class Plan:
    """The sketch of one junction.

    ``lane`` is the width of a lane, ``half`` of each arm's carriageway, ``side`` is +1 where
    traffic keeps right, ``inner`` the distance from the centre at which the arms begin; a
    ``shoulder`` lies beyond the lanes on either side, an ``auxiliary`` lane beside those of the
    direction from arm 0 to arm 1.
    """

    angles: tuple[float, ...]
    lanes: tuple[int, ...]
    lane: float
    side: int
    inner: float
    kind: JunctionKind
    carriageway: Carriageway = Carriageway.UNDIVIDED
    shoulder: bool = False
    auxiliary: AuxiliaryLane | None = None

    @property
    def is_ring(self) -> bool:
        """Whether traffic goes round a ring."""
        return self.kind is JunctionKind.ROUNDABOUT

    @property
    def bends(self) -> bool:
        """Whether two arms do not lie in one line."""
        return len(self.angles) == 2 and abs(sin(self.angles[1] - self.angles[0])) > _IN_LINE

    def half(self, arm: int) -> float:
        """Half the width of an arm's lanes, with the median between them."""
        whole = self.lanes[arm] * self.lane
        return whole / 2 if self.carriageway is Carriageway.ONE_WAY else self.median + whole

    @property
    def median(self) -> float:
        """Half the width of what parts the directions."""
        return _MEDIAN if self.carriageway is Carriageway.DIVIDED else 0.0

    def aside(self, arm: int, number: int) -> float:
        """From the middle of the road to that of a lane, 1 = inner, towards the traffic's side."""
        return self.half(arm) - (self.lanes[arm] - number + 0.5) * self.lane

    def at(self, arm: int, distance: float, right: float = 0.0) -> Point:
        """A point on an arm; ``right`` as seen by traffic that enters there."""
        if distance < 0.0 and self.kind is JunctionKind.STRAIGHT:
            return self.at(1 - arm, -distance, -right)  # beyond the middle, on the other arm
        a = self.angles[arm]
        # Entering traffic heads for the centre: its right is the direction a + 90 degrees.
        return (distance * cos(a) - right * sin(a), distance * sin(a) + right * cos(a))


def make_plan(junction: Junction) -> Plan:
    """The sketch of a junction."""
    angles = tuple(radians(a) for a in arm_angles_deg(junction))
    lanes = junction.lanes or (1,) * junction.arms
    lane = min(15.5, 33.0 / max(lanes))
    shoulder = Strip.HARD_SHOULDER in junction.strips
    widest = max(lanes) * lane
    gaps = [(b - a) % (2 * pi) for a, b in zip(angles, angles[1:] + angles[:1], strict=True)]
    if junction.kind is JunctionKind.ROUNDABOUT:
        inner = RING + lane
    elif junction.kind is JunctionKind.STRAIGHT:
        inner = 0.0
    else:
        # Neighbouring carriageways part where half their width is seen under half their angle.
        inner = max(widest / max(sin(min(g, pi) / 2), 0.45) for g in gaps) + 6.0
    side = 1 if junction.driving_side is DrivingSide.RIGHT else -1
    road = (junction.kind, junction.carriageway, shoulder, junction.auxiliary)
    return Plan(angles, lanes, lane, side, min(inner, 60.0), *road)


def drive_line(plan: Plan, drive: Drive, spread: float, behind: int) -> list[Point]:
    """The way of a vehicle as points.

    ``spread`` shifts it to its right, apart from others on the same arms; so many follow ``behind``
    it on its arm.
    """
    if drive.reverses is Reverses.SQUARE:
        return _square_line(plan, drive)
    if plan.kind is JunctionKind.STRAIGHT:
        return _straight_line(plan, drive, _START - 30.0 * behind, spread)
    start_at = max(_START - _RANK_STEP * behind, plan.inner + 8.0)
    lane_in, lane_out = _lanes_of(plan, drive)
    right_in = plan.side * plan.aside(drive.entry, lane_in) + spread
    right_out = -plan.side * plan.aside(drive.exit, lane_out) - spread
    start = plan.at(drive.entry, start_at, right_in)
    enter = plan.at(drive.entry, plan.inner, right_in)
    leave = plan.at(drive.exit, plan.inner, right_out)
    end = plan.at(drive.exit, REACH - 6.0, right_out)
    if plan.is_ring:
        middle = _round_the_ring(plan, drive, enter, leave, spread)
    else:
        reach = 0.55 * hypot(enter[0] - leave[0], enter[1] - leave[1]) + 2.0
        if drive.entry == drive.exit:
            reach = 1.6 * plan.inner
        middle = _bezier(
            enter,
            plan.at(drive.entry, plan.inner - reach, right_in),
            plan.at(drive.exit, plan.inner - reach, right_out),
            leave,
        )
    return [start, *middle, end]


def _square_line(plan: Plan, drive: Drive) -> list[Point]:
    """Out of its arm and across, or from beside a road without a junction across the lanes."""
    if plan.kind is JunctionKind.STRAIGHT:
        edge = plan.half(drive.entry)
        beside, beyond = plan.side * (edge + plan.lane), -plan.side * edge
        return [plan.at(drive.entry, _BACKS_AT, aside) for aside in (beside, beyond)]
    out = -plan.side * plan.aside(drive.entry, 1)
    away = (plan.inner + _BACKS_AT, -plan.half(drive.entry))
    return [plan.at(drive.entry, distance, out) for distance in away]


def _lanes_of(plan: Plan, drive: Drive) -> tuple[int, int]:
    """Numbers (1 = inner) of the lanes drawn: turning traffic keeps to its side."""
    most_in, most_out = plan.lanes[drive.entry], plan.lanes[drive.exit]
    near = Maneuver.RIGHT if plan.side == 1 else Maneuver.LEFT
    outer_in = drive.turn is near or (drive.turn is Maneuver.STRAIGHT and drive.beside is None)
    lane_in = most_in if outer_in else 1
    lane_out = most_out if outer_in else 1
    if drive.maneuver is Maneuver.LANE_CHANGE and most_in > 1:
        lane_in = 1 if lane_in > 1 else 2
    return lane_in, lane_out


_BEGINS, _ENDS = 0.3, 0.45
"""Where a ramp's lane meets the others and where it is gone, as shares of an arm."""


def auxiliary_area(plan: Plan) -> list[Point]:
    """The outline of the auxiliary lane, with its ramp; nothing if there is none."""
    if plan.auxiliary is None:
        return []
    begins = REACH if plan.auxiliary is AuxiliaryLane.LANE_DROP else _BEGINS * REACH
    ends, gone = -_ENDS * REACH, -(_ENDS + 0.2) * REACH
    outer = [(REACH, _ramp_m(plan, REACH) + plan.lane), (begins, plan.lane), (ends, plan.lane)]
    inner = [(gone, 0.0), (begins, 0.0), (REACH, _ramp_m(plan, REACH))]
    sense = -1.0 if plan.auxiliary is AuxiliaryLane.OFF_RAMP else 1.0
    half = plan.half(0)
    return [plan.at(0, sense * d, plan.side * (half + aside)) for d, aside in (*outer, *inner)]


def _ramp_m(plan: Plan, distance: float) -> float:
    """How far beside the lanes a ramp's lane is; in the drawing it parts more than it does."""
    if plan.auxiliary is AuxiliaryLane.LANE_DROP:
        return 0.0
    share = (distance / REACH - _BEGINS) / (1.0 - _BEGINS)
    return 0.9 * plan.lane * max(share, 0.0)


def _auxiliary_line(plan: Plan, start_at: float, spread: float) -> list[Point]:
    """Out of the auxiliary lane into the outermost, or the other way round onto the ramp."""
    leaves = plan.auxiliary is AuxiliaryLane.OFF_RAMP
    outermost = plan.half(0) - plan.lane / 2
    points = []
    for i in range(_ARC_STEPS + 1):
        along = start_at + i / _ARC_STEPS * (6.0 - REACH - start_at)
        distance = -along if leaves else along
        beside = 1.0 - _ease((0.1 - distance / REACH) / 0.3)
        aside = outermost + beside * plan.lane + _ramp_m(plan, distance)
        points.append(plan.at(0, along, plan.side * aside + spread))
    return points


def _uses_auxiliary(plan: Plan, drive: Drive) -> bool:
    """Whether a change of lane is one out of the auxiliary lane, or into the exit lane."""
    if plan.auxiliary is None or drive.entry != 0 or drive.maneuver is not Maneuver.LANE_CHANGE:
        return False
    kerb = Side.RIGHT if plan.side == 1 else Side.LEFT
    if plan.auxiliary is AuxiliaryLane.OFF_RAMP:
        return drive.changes_to is kerb
    return drive.lane is not None and drive.lane > plan.lanes[0]


def _straight_line(plan: Plan, drive: Drive, start_at: float, spread: float) -> list[Point]:
    """Along a road without a junction, with the shifts that the maneuver makes."""
    if _uses_auxiliary(plan, drive):
        return _auxiliary_line(plan, start_at, spread)
    lane_in, lane_out = _lanes_of(plan, drive)
    first = plan.side * plan.aside(drive.entry, lane_in) + spread
    last = plan.side * plan.aside(drive.exit, lane_out) + spread
    beyond = REACH - 6.0
    shift = last - first
    if drive.maneuver is Maneuver.OVERTAKE:
        shift = -plan.side * plan.lane
    points = []
    for i in range(_ARC_STEPS + 1):
        u = i / _ARC_STEPS
        along = start_at + u * (-beyond - start_at)
        aside = shift * _ease((u - 0.3) / 0.25)
        if drive.maneuver is Maneuver.OVERTAKE:
            aside -= shift * _ease((u - 0.7) / 0.2)
        points.append(plan.at(drive.entry, along, first + aside))
    if drive.reverses in _FROM_BESIDE:
        # It comes out where it starts, from as far beside the road as a lane is wide.
        sign = 1 if drive.reverses is Reverses.FROM_RIGHT else -1
        beside = sign * (plan.half(drive.entry) + plan.lane)
        points.insert(0, plan.at(drive.entry, start_at - plan.lane, beside))
    return points


def _ease(u: float) -> float:
    clipped = min(max(u, 0.0), 1.0)
    return (1 - cos(pi * clipped)) / 2


def _round_the_ring(
    plan: Plan, drive: Drive, enter: Point, leave: Point, spread: float
) -> list[Point]:
    radius = RING + plan.side * spread
    way = plan.side  # counter-clockwise where traffic keeps right
    sweep = (way * (plan.angles[drive.exit] - plan.angles[drive.entry])) % (2 * pi) or 2 * pi
    # It joins the ring ahead of where its lane meets it, and leaves as far before its exit.
    joins = [_beside(plan, arm, p) for arm, p in ((drive.entry, enter), (drive.exit, leave))]
    share = min(1.0, (sweep - _RING_LEAST) / sum(joins))
    begin = plan.angles[drive.entry] + way * share * joins[0]
    sweep -= share * sum(joins)
    turns = (begin + way * sweep * i / _ARC_STEPS for i in range(_ARC_STEPS + 1))
    arc = [_toward((0.0, 0.0), turn, radius) for turn in turns]
    inward = _toward(enter, plan.angles[drive.entry] + pi, 9.0)
    before = _toward(arc[0], begin - way * pi / 2, 6.0)
    after = _toward(arc[-1], begin + way * (sweep + pi / 2), 6.0)
    outward = _toward(leave, plan.angles[drive.exit] + pi, 9.0)
    return [*_bezier(enter, inward, before, arc[0]), *arc, *_bezier(arc[-1], after, outward, leave)]


def _beside(plan: Plan, arm: int, point: Point) -> float:
    """The angle on the ring between the middle of an arm and who drives there at a point."""
    aside = abs(point[1] * cos(plan.angles[arm]) - point[0] * sin(plan.angles[arm]))
    return asin(min(aside / RING, 0.95)) + _RING_JOIN


def _toward(point: Point, angle: float, distance: float) -> Point:
    return point[0] + distance * cos(angle), point[1] + distance * sin(angle)


def _bezier(a: Point, b: Point, c: Point, d: Point) -> list[Point]:
    u = np.linspace(0.0, 1.0, _CURVE_STEPS + 1)[:, None]
    v = 1.0 - u
    ends = v**3 * np.array(a) + u**3 * np.array(d)
    curve = ends + 3 * v * v * u * np.array(b) + 3 * v * u * u * np.array(c)
    return [(x, y) for x, y in curve.tolist()]


def crossing_line(plan: Plan, crossing: Crossing, number: int) -> list[Point]:
    """Straight across an arm, just outside the junction; ``number`` sets several apart."""
    distance = min(plan.inner + 10.0 + 11.0 * number, REACH - 8.0)
    if plan.kind is JunctionKind.STRAIGHT:
        distance = 12.0 + 14.0 * number
    beyond = plan.half(crossing.arm) + 11.0
    sides = (1, -1) if crossing.start is Side.RIGHT else (-1, 1)
    return [plan.at(crossing.arm, distance, side * beyond) for side in sides]


def standing_box(plan: Plan, standing: Standing, number: int) -> list[Point]:
    """The corners of a standing vehicle on its arm."""
    distance = min(plan.inner + 30.0 + 24.0 * number, REACH - 12.0)
    aside = _aside(plan, standing)
    corners = ((-_BOX, -_BOX / 2), (_BOX, -_BOX / 2), (_BOX, _BOX / 2), (-_BOX, _BOX / 2))
    return [plan.at(standing.arm, distance + du, aside + dv) for du, dv in corners]


def walking_line(plan: Plan, walking: Walking) -> list[Point]:
    """Along an arm, towards the junction or away from it."""
    aside = _aside(plan, walking)
    ends = [plan.inner + 40.0, plan.inner + 12.0]
    if walking.heading is Heading.OUTWARD:
        ends.reverse()
    return [plan.at(walking.arm, min(end, REACH - 8.0), aside) for end in ends]


def _aside(plan: Plan, place: Standing | Walking) -> float:
    """From the middle of an arm, to the right of who enters."""
    half = plan.half(place.arm)
    aside = half - plan.lane / 2 if place.in_lane else half + _BOX / 2 + 2.0
    return aside if place.side is Side.RIGHT else -aside


def arrow_head(points: list[Point], size: float) -> list[Point]:
    """A triangle whose tip is the last point."""
    (x0, y0), (x1, y1) = points[-2], points[-1]
    a = atan2(y1 - y0, x1 - x0)
    tip = _toward((x1, y1), a, size * 0.5)
    return [tip, *(_toward(tip, a + pi + turn, size * 1.35) for turn in (-0.45, 0.45))]

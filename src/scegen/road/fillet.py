"""Curves from one lane to another: lines and arcs, joined in position and heading."""

from math import acos, atan2, cos, inf, isclose, pi, sin, sqrt, tan

from scegen.road.geometry import Pose, ReferenceLine, Segment

GOOD_RADIUS_M = 4.5
"""A single arc this wide is taken even where an S-curve would bend less."""
_STRAIGHT_RAD = 1e-9
_SHORT_M = 1e-6


def wrapped(angle_rad: float) -> float:
    """The same direction in (-pi, pi]."""
    turned = angle_rad % (2 * pi)
    return turned - 2 * pi if turned > pi else turned


def smallest_radius_m(line: ReferenceLine) -> float:
    """The tightest radius of a reference line; infinite where it is straight."""
    return min(
        (1 / abs(segment.curvature_1pm) for segment in line.segments if segment.curvature_1pm),
        default=inf,
    )


def seen_from(origin: Pose, target: Pose) -> tuple[float, float, float]:
    """``target`` in the frame of ``origin``: ahead (m), left (m), heading (rad)."""
    dx, dy = target.x_m - origin.x_m, target.y_m - origin.y_m
    c, s = cos(origin.heading_rad), sin(origin.heading_rad)
    return dx * c + dy * s, dy * c - dx * s, wrapped(target.heading_rad - origin.heading_rad)


def chain(start: Pose, pieces: list[tuple[float, float]]) -> ReferenceLine:
    """Segments of (length in m, curvature in 1/m) one after the other; empty ones are left out."""
    segments: list[Segment] = []
    pose = start
    for length_m, curvature_1pm in pieces:
        if length_m > _SHORT_M:
            segments.append(Segment(pose, length_m, curvature_1pm))
            pose = segments[-1].end
    return ReferenceLine(tuple(segments))


def _line_arc_line(start: Pose, end: Pose, most_m: float | None = None) -> ReferenceLine | None:
    """Straight on, one arc, straight on; None where the two rays do not meet ahead of both.

    The widest arc, or one of radius ``most_m`` if that is tighter.
    """
    ahead, left, turn = seen_from(start, end)
    if abs(turn) < _STRAIGHT_RAD or abs(abs(turn) - pi) < _STRAIGHT_RAD:
        return None
    beyond = left / sin(turn)
    before = ahead - beyond * cos(turn)
    tangent = min(before, beyond)
    if tangent <= _SHORT_M:
        return None
    if most_m is not None:
        tangent = min(tangent, most_m * tan(abs(turn) / 2))
    radius = tangent / tan(abs(turn) / 2)
    arc = (radius * abs(turn), (1 if turn > 0 else -1) / radius)
    return chain(start, [(before - tangent, 0.0), arc, (beyond - tangent, 0.0)])


def _arc_to(ahead: float, left: float) -> tuple[float, float]:
    """Length and curvature of the arc that leaves along +x and passes through a point."""
    if abs(left) < 1e-12:
        return ahead, 0.0
    curvature = 2 * left / (ahead * ahead + left * left)
    return 2 * atan2(left, ahead) / curvature, curvature


def _biarc(start: Pose, end: Pose) -> ReferenceLine | None:
    """Two arcs with equal tangent lengths, e.g. the S-curve between offset parallel lanes."""
    ahead, left, turn = seen_from(start, end)
    c, s = cos(turn), sin(turn)
    chord2 = ahead * ahead + left * left
    along = ahead * (1 + c) + left * s
    spread = 2 * (1 - c)
    if spread < 1e-12:
        if along <= _SHORT_M:
            return None
        tangent = chord2 / (2 * along)
    else:
        tangent = (-along + sqrt(along * along + spread * chord2)) / spread
    middle_ahead = (tangent + ahead - tangent * c) / 2
    middle_left = (left - tangent * s) / 2
    first = _arc_to(middle_ahead, middle_left)
    heading = first[0] * first[1]
    rest_ahead, rest_left, _ = seen_from(
        Pose(middle_ahead, middle_left, heading), Pose(ahead, left, turn)
    )
    return chain(start, [first, _arc_to(rest_ahead, rest_left)])


def connect(start: Pose, end: Pose, most_m: float | None = None) -> ReferenceLine | None:
    """The gentlest curve of lines and arcs from ``start`` to ``end``; None if there is none.

    Where one arc suffices, ``most_m`` may ask for a tighter one, which turns later.

    A line where they are in line, line-arc-line where one arc suffices, an S-curve of two arcs
    otherwise. The caller judges the radius.
    """
    ahead, left, turn = seen_from(start, end)
    if abs(turn) < _STRAIGHT_RAD and abs(left) < _SHORT_M:
        return chain(start, [(ahead, 0.0)]) if ahead > _SHORT_M else None
    single = _line_arc_line(start, end, most_m)
    if single is not None and smallest_radius_m(single) >= min(GOOD_RADIUS_M, most_m or inf):
        return single
    double = _biarc(start, end)
    found = [line for line in (single, double) if line is not None and _turns_sensibly(line, turn)]
    return max(found, key=smallest_radius_m, default=None)


def _turns_sensibly(line: ReferenceLine, turn: float) -> bool:
    """No loops: an S-curve may turn at most half a turn more than needed."""
    turned = sum(abs(segment.curvature_1pm) * segment.length_m for segment in line.segments)
    return turned <= abs(turn) + pi


def turn_back(start: Pose, separation_m: float, radius_m: float, sign: int) -> ReferenceLine:
    """A U-turn to the opposite lane ``separation_m`` to the left (sign 1) or right (-1).

    A half circle where the lanes lie two radii apart or more, else a bulb: swing out, turn
    round, swing back, all at ``radius_m``.
    """
    if separation_m >= 2 * radius_m or isclose(separation_m, 2 * radius_m):
        return chain(start, [(pi * separation_m / 2, 2 * sign / separation_m)])
    swing = acos((separation_m / 2 + radius_m) / (2 * radius_m))
    out = (swing * radius_m, -sign / radius_m)
    return chain(start, [out, ((pi + 2 * swing) * radius_m, sign / radius_m), out])


def reach_m(line: ReferenceLine) -> float:
    """How far ahead of its start a line gets (m), sampled every half metre."""
    steps = max(2, round(2 * line.length_m))
    poses = (line.pose(line.length_m * k / steps) for k in range(steps + 1))
    return max(seen_from(line.start, pose)[0] for pose in poses)

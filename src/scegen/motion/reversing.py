"""Ways that are driven backwards in part: the same lines, with the body heading the other way.

Every part is laid out as if it were driven forwards, and then turned round: the vertices in
reverse order, the headings as they were. The rear axle, which is the reference point, thus takes
the very line that it would take forwards, as a real one does. Positions along the path grow all
the while; where the direction changes, the path has a cusp.
"""

from dataclasses import replace
from math import ceil, pi

import numpy as np
from numpy.typing import NDArray

from scegen.errors import MotionInfeasibleError
from scegen.motion.lanes import arm_lane_id
from scegen.motion.model import Array, LaneSpan, Path
from scegen.motion.polyline import CURVE_STEP_M, LINE_STEP_M, LaidDrive, lay_polyline, passed_m
from scegen.motion.routing import walk_route
from scegen.motion.stretches import Stretch
from scegen.road.geometry import Pose
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import DriveMotion
from scegen.scenario.reversing import BacksOut, BacksUp
from scegen.scenario.vocabulary import Side

ROLLS_M = 0.3
"""Everybody rolls forwards so far, at least, before reversing: players take the sense in which a
trajectory is followed from how it begins."""
_CLOSE_M = 0.12
"""esmini leaves out vertices that lie closer together than 0.1 m; where the direction changes it
must be the other one."""


def lay_way(
    network: RoadNetwork,
    motion: DriveMotion,
    stretches: tuple[Stretch, ...],
    end_m: float,
    who: str,
) -> LaidDrive:
    """The way of a drive over its stretches from where it starts to station ``end_m``.

    Raises:
        MotionInfeasibleError: two roads do not meet, or there is no room to reverse.
    """
    reversal, start_m = motion.reversal, motion.start_m
    if isinstance(reversal, BacksUp):
        return _joined(_up_and_back(reversal, stretches, start_m, end_m, who), stretches)
    onwards = lay_polyline(stretches, start_m, end_m)
    if reversal is None:
        return onwards
    if reversal.straight_m is not None:
        inwards = _straight_out(network, motion, reversal, onwards.path.start)
    elif reversal.arm is not None:
        inwards = _into_arm(network, motion, reversal.arm, reversal.setback_m, who)
    else:
        inwards = _beside(network, motion, reversal, onwards.path.start, who)
    inwards = replace(inwards, stations_m=np.full_like(inwards.path.s_m, start_m))
    parts = [_last(inwards, ROLLS_M), _driven_back(inwards)]
    return _joined(parts if reversal.straight_m is not None else [*parts, onwards], stretches)


def _part(
    x_m: Array, y_m: Array, heading_rad: Array, stations_m: Array | None = None,
    spans: tuple[LaneSpan, ...] = (),
) -> LaidDrive:  # fmt: skip
    """A part of a way, its vertices in the order in which they are passed."""
    path = Path(passed_m(x_m, y_m), x_m, y_m, heading_rad, spans)
    return LaidDrive(path, path.s_m if stations_m is None else stations_m, ())


def _last(part: LaidDrive, length_m: float) -> LaidDrive:
    """Its end, of so many metres on a straight line."""
    x, y, heading = (row[-1] for row in (part.path.x_m, part.path.y_m, part.path.heading_rad))
    return _part(
        np.array([x - length_m * np.cos(heading), x]),
        np.array([y - length_m * np.sin(heading), y]),
        np.array([heading, heading]),
        part.stations_m[-1:].repeat(2),
    )


def _driven_back(part: LaidDrive) -> LaidDrive:
    """The same ground in reverse."""
    path = part.path
    spans = tuple(
        replace(span, start_m=path.length_m - span.end_m, end_m=path.length_m - span.start_m)
        for span in reversed(path.spans)
    )
    return _part(
        path.x_m[::-1], path.y_m[::-1], path.heading_rad[::-1], part.stations_m[::-1], spans
    )


def _up_and_back(
    reversal: BacksUp, stretches: tuple[Stretch, ...], start_m: float, end_m: float, who: str
) -> list[LaidDrive]:
    stops_m, back_m = reversal.from_m, reversal.from_m - reversal.length_m
    if not start_m + ROLLS_M <= stops_m < end_m or back_m < 0.0:
        raise MotionInfeasibleError(
            f"cannot stop at {stops_m:.1f} m and go {reversal.length_m:.1f} m back on a way that "
            f"starts at {start_m:.1f} m and ends at {end_m:.1f} m",
            where=who,
            hint=f"It has to come {ROLLS_M:g} m forwards at least, and the way back to lie on its "
            "drive.",
        )
    forth = lay_polyline(stretches, start_m, stops_m)
    back = _driven_back(lay_polyline(stretches, back_m, stops_m))
    return [forth, back, lay_polyline(stretches, back_m, end_m)]


def _into_arm(
    network: RoadNetwork, motion: DriveMotion, arm: int, setback_m: float, who: str
) -> LaidDrive:
    """Forwards from where the drive starts into another arm."""
    routes = network.routes.get((motion.entry, arm), ())
    exits = [route.exit_lane for route in routes if route.entry_lane == motion.entry_lane]
    if not exits or network.plain:
        raise MotionInfeasibleError(
            f"no way leads from arm {arm} backwards into lane {motion.entry_lane} of arm "
            f"{motion.entry}",
            where=who,
            hint="Choose another arm or lane, or let it back up on its own way.",
        )
    inwards = motion.but(
        exit=arm, exit_lane=exits[0], ring_lane=None, lane_changes=(), reversal=None
    )
    stretches, _ = walk_route(network, inwards, who)
    last = stretches[-1]
    if last.start_m + setback_m > last.end_m:
        raise MotionInfeasibleError(
            f"arm {arm} is {last.end_m - last.start_m:.1f} m long; it starts {setback_m:.1f} m "
            "along it",
            where=who,
        )
    return lay_polyline(stretches, motion.start_m, last.start_m + setback_m)


def _straight_out(
    network: RoadNetwork, motion: DriveMotion, reversal: BacksOut, joins: Pose
) -> LaidDrive:
    """Forwards on a straight line to where it stands, on its arm or square to its road."""
    if reversal.arm is not None:
        road = network.arm_road(reversal.arm)
        t = road.lane_centre_t_m(arm_lane_id(road, 1, inbound=False))
        stands = road.line.pose(road.length_m - reversal.setback_m, t).reversed()
    else:
        sign, aside_m = _aside_m(network, motion, reversal)
        beside = joins.shifted(left_m=sign * aside_m)
        stands = replace(beside, heading_rad=joins.heading_rad + sign * pi / 2)
    away_m = reversal.straight_m or 0.0
    away = np.linspace(-away_m, 0.0, max(1, ceil(away_m / LINE_STEP_M)) + 1)
    return _part(
        stands.x_m + away * np.cos(stands.heading_rad),
        stands.y_m + away * np.sin(stands.heading_rad),
        np.full_like(away, stands.heading_rad),
    )


def _aside_m(network: RoadNetwork, motion: DriveMotion, reversal: BacksOut) -> tuple[int, float]:
    """To which side of its lane it stands (1: left), and how far from the middle of that."""
    road, sign = network.arm_road(motion.entry), 1 if reversal.side is Side.LEFT else -1
    t = road.lane_centre_t_m(arm_lane_id(road, motion.entry_lane, inbound=True))
    return sign, abs(road.edge_t_m(sign) - t) + reversal.setback_m


def _beside(
    network: RoadNetwork, motion: DriveMotion, reversal: BacksOut, joins: Pose, who: str
) -> LaidDrive:
    """Forwards from where the drive starts, in a quarter turn and straight on, off the road."""
    (sign, aside_m), radius = _aside_m(network, motion, reversal), reversal.radius_m
    if aside_m < radius:
        raise MotionInfeasibleError(
            f"backs out from {aside_m:.1f} m beside its lane on arm {motion.entry}; a quarter turn "
            f"of {radius:.1f} m needs as much room",
            where=who,
            hint="Set it back farther.",
        )
    steps = ceil(radius * pi / 2 / CURVE_STEP_M)
    turned = np.linspace(0.0, pi / 2, steps + 1)
    # In the frame of where the drive starts: u ahead, v to its left.
    u, v = radius * np.sin(turned), sign * radius * (1.0 - np.cos(turned))
    straight = aside_m - radius
    more = np.linspace(0.0, straight, max(1, ceil(straight / LINE_STEP_M)) + 1)[1:]
    if straight < CURVE_STEP_M / 2:
        more = more[:0]
    u = np.concatenate((u, np.full_like(more, radius)))
    v = np.concatenate((v, sign * (radius + more)))
    angle = np.concatenate((turned, np.full_like(more, pi / 2)))
    c, s = np.cos(joins.heading_rad), np.sin(joins.heading_rad)
    x, y = joins.x_m + u * c - v * s, joins.y_m + u * s + v * c
    return _part(x, y, joins.heading_rad + sign * angle)


def _joined(parts: list[LaidDrive], stretches: tuple[Stretch, ...]) -> LaidDrive:
    """Parts one after another; each begins where the one before it ends."""
    spans: list[LaneSpan] = []
    done = 0.0
    for part in parts:
        spans += [
            replace(s, start_m=s.start_m + done, end_m=s.end_m + done) for s in part.path.spans
        ]
        done += part.path.length_m
    rows = [
        np.array([part.stations_m, part.path.x_m, part.path.y_m, part.path.heading_rad])
        for part in parts
    ]
    kept = [_kept(part.path.s_m, first=not number) for number, part in enumerate(parts)]
    stations, x, y, heading = np.hstack([r[:, k] for r, k in zip(rows, kept, strict=True)])
    return LaidDrive(
        Path(passed_m(x, y), x, y, np.unwrap(heading), tuple(spans)), stations, stretches
    )


def _kept(s_m: Array, *, first: bool) -> NDArray[np.bool_]:
    """Which vertices of a part are written: its first is the last of the part before."""
    keep: NDArray[np.bool_] = (s_m > _CLOSE_M) & (s_m < s_m[-1] - _CLOSE_M)
    keep[0], keep[-1] = first, True
    return keep

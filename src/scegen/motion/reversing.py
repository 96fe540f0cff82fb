"""Ways that are driven backwards in part: the same lines, with the body heading the other way.

Every part is laid out as if it were driven forwards, and then turned round: the vertices in
reverse order, the headings as they were. The rear axle, which is the reference point, thus takes
the very line that it would take forwards, as a real one does. Positions along the path grow all
the while; where the direction changes, the path has a cusp.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import ceil, pi

import numpy as np
from numpy.typing import NDArray

from scegen.errors import MotionInfeasibleError
from scegen.motion.lanes import arm_lane_id
from scegen.motion.model import Array, LaneSpan, Path
from scegen.motion.polyline import CURVE_STEP_M, LINE_STEP_M, LaidDrive, lay_polyline, passed_m
from scegen.motion.routing import walk_route
from scegen.motion.standing import side_sign
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


@dataclass(frozen=True)
class _Part:
    """A part of a way: stations and vertices in the order in which they are passed."""

    stations_m: Array
    x_m: Array
    y_m: Array
    heading_rad: Array
    spans: tuple[LaneSpan, ...] = ()

    @classmethod
    def of(cls, laid: LaidDrive) -> _Part:
        path = laid.path
        return cls(laid.stations_m, path.x_m, path.y_m, path.heading_rad, path.spans)

    def last(self, length_m: float) -> _Part:
        """Its end, of so many metres on a straight line."""
        x, y, heading = self.x_m[-1], self.y_m[-1], self.heading_rad[-1]
        return _Part(
            self.stations_m[-1:].repeat(2),
            np.array([x - length_m * np.cos(heading), x]),
            np.array([y - length_m * np.sin(heading), y]),
            np.array([heading, heading]),
        )

    def driven_back(self) -> _Part:
        """The same ground in reverse."""
        length = float(passed_m(self.x_m, self.y_m)[-1])
        spans = tuple(
            LaneSpan(span.road, span.lane, span.forward, length - span.end_m, length - span.start_m)
            for span in reversed(self.spans)
        )
        return _Part(
            self.stations_m[::-1], self.x_m[::-1], self.y_m[::-1], self.heading_rad[::-1], spans
        )


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
    if reversal is None:
        return lay_polyline(stretches, start_m, end_m)
    if isinstance(reversal, BacksUp):
        parts = _up_and_back(reversal, stretches, start_m, end_m, who)
    elif reversal.straight_m is not None:
        outwards = _straight_out(network, motion, reversal, stretches, reversal.straight_m, who)
        parts = [outwards.last(ROLLS_M), outwards.driven_back()]
    else:
        onwards = _Part.of(lay_polyline(stretches, start_m, end_m))
        if reversal.arm is not None:
            inwards = _into_arm(network, motion, reversal.arm, reversal.setback_m, who)
        else:
            inwards = _beside(network, motion, reversal, onwards, who)
        parts = [inwards.last(ROLLS_M), inwards.driven_back(), onwards]
    return _joined(parts, stretches)


def _up_and_back(
    reversal: BacksUp, stretches: tuple[Stretch, ...], start_m: float, end_m: float, who: str
) -> list[_Part]:
    stops_m, back_m = reversal.from_m, reversal.from_m - reversal.length_m
    if not start_m + ROLLS_M <= stops_m < end_m or back_m < 0.0:
        raise MotionInfeasibleError(
            f"cannot stop at {stops_m:.1f} m and go {reversal.length_m:.1f} m back on a way that "
            f"starts at {start_m:.1f} m and ends at {end_m:.1f} m",
            where=who,
            hint=f"It has to come {ROLLS_M:g} m forwards at least, and the way back to lie on its "
            "drive.",
        )
    forth = _Part.of(lay_polyline(stretches, start_m, stops_m))
    back = _Part.of(lay_polyline(stretches, back_m, stops_m)).driven_back()
    return [forth, back, _Part.of(lay_polyline(stretches, back_m, end_m))]


def _into_arm(
    network: RoadNetwork, motion: DriveMotion, arm: int, setback_m: float, who: str
) -> _Part:
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
    update = {"exit": arm, "exit_lane": exits[0], "ring_lane": None, "lane_changes": ()}
    inwards = motion.model_copy(update={**update, "reversal": None})
    stretches, _ = walk_route(network, inwards, who)
    last = stretches[-1]
    if last.start_m + setback_m > last.end_m:
        raise MotionInfeasibleError(
            f"arm {arm} is {last.end_m - last.start_m:.1f} m long; it starts {setback_m:.1f} m "
            "along it",
            where=who,
        )
    part = _Part.of(lay_polyline(stretches, motion.start_m, last.start_m + setback_m))
    return replace(part, stations_m=np.full_like(part.stations_m, motion.start_m))


def _straight_out(
    network: RoadNetwork,
    motion: DriveMotion,
    reversal: BacksOut,
    stretches: tuple[Stretch, ...],
    straight_m: float,
    who: str,
) -> _Part:
    """Forwards on a straight line to where it stands, on its arm or square to its road."""
    if reversal.arm is not None:
        road = network.arm_road(reversal.arm)
        t = road.lane_centre_t_m(arm_lane_id(road, 1, inbound=False))
        stands = road.line.pose(road.length_m - reversal.setback_m, t).reversed()
    else:
        side = _side_of(reversal, who)
        road, sign = network.arm_road(motion.entry), side_sign(side)
        lane = lay_polyline(stretches, motion.start_m, motion.start_m + 1.0).path.start
        t = road.lane_centre_t_m(arm_lane_id(road, motion.entry_lane, inbound=True))
        aside = sign * (abs(road.edge_t_m(sign) - t) + reversal.setback_m)
        beside = lane.shifted(left_m=aside)
        stands = Pose(beside.x_m, beside.y_m, lane.heading_rad + sign * pi / 2)
    away = np.linspace(-straight_m, 0.0, max(1, ceil(straight_m / LINE_STEP_M)) + 1)
    return _Part(
        np.full_like(away, motion.start_m),
        stands.x_m + away * np.cos(stands.heading_rad),
        stands.y_m + away * np.sin(stands.heading_rad),
        np.full_like(away, stands.heading_rad),
    )


def _side_of(reversal: BacksOut, who: str) -> Side:
    if reversal.side is None:
        raise MotionInfeasibleError("backs out of nowhere", where=who)
    return reversal.side


def _beside(
    network: RoadNetwork, motion: DriveMotion, reversal: BacksOut, onwards: _Part, who: str
) -> _Part:
    """Forwards from where the drive starts, in a quarter turn and straight on, off the road."""
    side = _side_of(reversal, who)
    road = network.arm_road(motion.entry)
    sign = side_sign(side)
    lane = next(
        (s.lane for s in onwards.spans if s.road == road.id and s.start_m <= 0.0 < s.end_m), None
    )
    aside_m = 0.0
    if lane is not None:
        aside_m = abs(road.edge_t_m(sign) - road.lane_centre_t_m(lane)) + reversal.setback_m
    radius = reversal.radius_m
    if aside_m < radius:
        raise MotionInfeasibleError(
            f"backs out from {aside_m:.1f} m beside its lane on arm {motion.entry}; a quarter turn "
            f"of {radius:.1f} m needs as much room",
            where=who,
            hint="Set it back farther, and start on the entry arm.",
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
    x0, y0, h0 = onwards.x_m[0], onwards.y_m[0], onwards.heading_rad[0]
    return _Part(
        np.full_like(u, motion.start_m),
        x0 + u * np.cos(h0) - v * np.sin(h0),
        y0 + u * np.sin(h0) + v * np.cos(h0),
        h0 + sign * angle,
    )


def _joined(parts: list[_Part], stretches: tuple[Stretch, ...]) -> LaidDrive:
    """Parts one after another; each begins where the one before it ends."""
    spans: list[LaneSpan] = []
    done = 0.0
    for part in parts:
        spans += [
            LaneSpan(s.road, s.lane, s.forward, s.start_m + done, s.end_m + done)
            for s in part.spans
        ]
        done += float(passed_m(part.x_m, part.y_m)[-1])
    kept = [_kept(part, first=not number) for number, part in enumerate(parts)]
    stations, x, y, heading = (
        np.concatenate([getattr(p, name)[keep] for p, keep in zip(parts, kept, strict=True)])
        for name in ("stations_m", "x_m", "y_m", "heading_rad")
    )
    return LaidDrive(
        Path(passed_m(x, y), x, y, np.unwrap(heading), tuple(spans)), stations, stretches
    )


def _kept(part: _Part, *, first: bool) -> NDArray[np.bool_]:
    """Which vertices of a part are written: its first is the last of the part before."""
    s = passed_m(part.x_m, part.y_m)
    keep: NDArray[np.bool_] = (s > _CLOSE_M) & (s < s[-1] - _CLOSE_M)
    keep[0], keep[-1] = first, True
    return keep

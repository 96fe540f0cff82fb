"""The still part of a scene: surfaces, marks, crosswalks, signs and lights."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scegen.report.lane_shapes import road_shapes
from scegen.report.player.series import points
from scegen.road.model import LaneType, Road, RoadNetwork
from scegen.scenario.concrete import ConcreteScenario, DriveMotion
from scegen.scenario.vocabulary import Control, HazardKind

Data = dict[str, Any]
_BESIDE_M = 0.9
_SIGNS = {Control.YIELD: "yield", Control.STOP: "stop", Control.ALL_WAY_STOP: "stop"}
_LINES = {Control.YIELD: "yield_line"}
_OUTER = (
    LaneType.SIDEWALK,
    LaneType.BORDER,
    LaneType.SHOULDER,
    LaneType.PARKING,
    LaneType.DRIVING,
)
"""Carriageways lie on top where roads overlap."""


def road_data(concrete: ConcreteScenario, network: RoadNetwork) -> Data:
    """Polygons and lines in the world (m), x and y in turn."""
    shapes = road_shapes(network)
    marks = [("centre", line) for line in shapes.centre_lines]
    marks += [("lane", line) for line in shapes.lane_lines]
    arms = [network.arm_road(arm) for arm in sorted(concrete.road.controlled_arms)]
    control = concrete.road.control
    kind = _LINES.get(control, "stop_line")
    return {
        "kind": concrete.road.kind.value,
        "side": network.driving_side.value,
        "surfaces": [
            {"type": kind.value, "points": points(polygon.ravel().tolist())}
            for kind in _OUTER
            for polygon in shapes.lanes.get(kind, ())
        ],
        "marks": [{"kind": kind, "points": points(line.ravel().tolist())} for kind, line in marks]
        + [{"kind": kind, "points": points(_entry_line(road).ravel().tolist())} for road in arms],
        "stripes": [points(stripe.ravel().tolist()) for stripe in shapes.stripes],
        "signs": [{"kind": _SIGNS[control], **_beside(road)} for road in arms if control in _SIGNS],
        "lights": [
            {"states": [[0.0, state]], **_beside(road)}
            for road, state in zip(arms, _states(concrete), strict=True)
            if control is Control.SIGNALS
        ],
    }


def _states(concrete: ConcreteScenario) -> list[str]:
    """What the lights show: red to who is said to run it and to all who face the same way."""
    runners = {
        name
        for hazard in concrete.hazards
        if hazard.kind is HazardKind.RED_LIGHT_RUNNING
        for name in hazard.by
    }
    entries = {
        p.id: p.motion.entry for p in concrete.participants if isinstance(p.motion, DriveMotion)
    }
    red = {entries[name] for name in runners if name in entries}
    arms = {arm.id: arm.angle_deg for arm in concrete.road.arms}

    def along(arm: int) -> set[int]:
        """The arm, and the one that faces it most nearly."""
        facing = min(arms, key=lambda a: abs((arms[a] - arms[arm]) % 360 - 180))
        opposite = abs((arms[facing] - arms[arm]) % 360 - 180) < 45
        return {arm, facing} if opposite else {arm}

    if not red:
        green = along(entries.get(concrete.ego.id, 0))
        return ["green" if a in green else "red" for a in sorted(concrete.road.controlled_arms)]
    stops = set().union(*(along(arm) for arm in red))
    return ["red" if a in stops else "green" for a in sorted(concrete.road.controlled_arms)]


def _entry_line(road: Road) -> NDArray[np.float64]:
    """Across the lanes that lead to the junction, at the road's inner end."""
    sign = -1 if road.driving_side == "right" else 1
    at = max(road.length_m - 0.4, 0.0)
    for crosswalk in road.crosswalks:
        if road.length_m - crosswalk.s_m < 8.0:
            at = min(at, crosswalk.s_m - crosswalk.width_m / 2 - 0.8)
    ends = [road.line.pose(at, t) for t in (road.lane_offset_m, road.edge_t_m(sign))]
    return np.array([(p.x_m, p.y_m) for p in ends])


def _beside(road: Road) -> Data:
    """Where a sign stands, facing who enters; its heading is theirs."""
    sign = -1 if road.driving_side == "right" else 1
    pose = road.line.pose(road.length_m, road.edge_t_m(sign) + sign * _BESIDE_M)
    return {
        "arm": road.arm,
        "x_m": round(pose.x_m, 2),
        "y_m": round(pose.y_m, 2),
        "heading_rad": round((pose.heading_rad + pi) % (2 * pi) - pi, 4),
    }

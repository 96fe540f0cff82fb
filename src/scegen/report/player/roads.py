"""The still part of a scene: surfaces, marks, crosswalks, signs and lights."""

from collections.abc import Mapping
from math import copysign, pi

import numpy as np
from numpy.typing import NDArray

from scegen.motion.model import Path
from scegen.report.lane_shapes import bays, road_shapes
from scegen.report.lights import entry_of, lights_of, shown
from scegen.report.player.series import Data, points
from scegen.road.geometry import Pose
from scegen.road.model import LaneType, RoadNetwork
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.vocabulary import Control

_BESIDE_M = 0.9
_SIGNS = {Control.YIELD: "yield", Control.STOP: "stop", Control.ALL_WAY_STOP: "stop"}
_OUTER = (
    LaneType.SIDEWALK,
    LaneType.BORDER,
    LaneType.MEDIAN,
    LaneType.SHOULDER,
    LaneType.PARKING,
    LaneType.BIKING,
    LaneType.DRIVING,
)
"""Carriageways lie on top where roads overlap."""


def road_data(concrete: ConcreteScenario, network: RoadNetwork, paths: Mapping[str, Path]) -> Data:
    """Polygons and lines in the world (m), x and y in turn."""
    shapes = road_shapes(network, bays(concrete, paths))
    marks = [("centre", line) for line in shapes.centre_lines]
    marks += [("lane", line) for line in shapes.lane_lines]
    marks += [("edge", line) for line in shapes.edge_lines]
    entries = [(arm, *entry_of(network, arm)) for arm in sorted(concrete.road.controlled_arms)]
    control = concrete.road.control
    across = "yield_line" if control is Control.YIELD else "stop_line"
    return {
        "kind": concrete.road.kind.value,
        "side": network.driving_side.value,
        "surfaces": [
            {"type": kind.value, "points": _flat(polygon)}
            for kind in _OUTER
            for polygon in shapes.lanes.get(kind, ())
        ],
        "marks": [
            *({"kind": kind, "points": _flat(line)} for kind, line in marks),
            *({"kind": across, "points": _line(pose, reach)} for _, pose, reach in entries),
        ],
        "stripes": [_flat(stripe) for stripe in shapes.stripes],
        "signs": [
            {"kind": _SIGNS[control], **_beside(*entry)} for entry in entries if control in _SIGNS
        ],
        "lights": [
            {
                "states": [
                    [time_s, state.value]
                    for time_s, state in shown(concrete, light, concrete.latest_end_s)
                ],
                "afoot": light.afoot,
                **_beside(light.arm, light.pose, light.left_m),
            }
            for light in lights_of(concrete, network)
        ],
    }


def _flat(shape: NDArray[np.float64]) -> list[float]:
    return points(shape.ravel().tolist())


def _line(pose: Pose, reach_m: float) -> list[float]:
    """Across the lanes that lead to the junction; ``reach_m`` is how far they go to the left."""
    ends = [pose, pose.shifted(left_m=reach_m)]
    return points(value for end in ends for value in (end.x_m, end.y_m))


def _beside(arm: int, pose: Pose, reach_m: float) -> Data:
    """Where a sign stands, facing who enters; its heading is theirs."""
    place = pose.shifted(left_m=reach_m + copysign(_BESIDE_M, reach_m))
    return {
        "arm": arm,
        "x_m": round(place.x_m, 2),
        "y_m": round(place.y_m, 2),
        "heading_rad": round((pose.heading_rad + pi) % (2 * pi) - pi, 4),
    }

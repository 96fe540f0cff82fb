"""Places in the world, as OpenSCENARIO positions."""

from __future__ import annotations

from math import pi

from scegen.export.library import xosc
from scegen.motion.model import Path
from scegen.road.geometry import Pose


def vertex_position(path: Path, index: int) -> xosc.WorldPosition:
    """Where a path has a vertex."""
    return world_position(
        Pose(float(path.x_m[index]), float(path.y_m[index]), float(path.heading_rad[index]))
    )


def world_position(pose: Pose) -> xosc.WorldPosition:
    """A pose on the ground, to 0.1 mm; adding zero turns -0.0 into 0.0."""
    heading = (pose.heading_rad + pi) % (2 * pi) - pi
    return xosc.WorldPosition(
        round(pose.x_m, 4) + 0.0, round(pose.y_m, 4) + 0.0, 0.0, round(heading, 6) + 0.0
    )

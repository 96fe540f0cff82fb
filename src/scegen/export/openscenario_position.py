"""Places in the world, as OpenSCENARIO positions."""

import xml.etree.ElementTree as ET  # builds, never parses
from math import pi

from scegen.export.library import xosc
from scegen.motion.model import Path
from scegen.road.geometry import Pose


def world_position(pose: Pose) -> xosc.WorldPosition:
    """A pose on the ground."""
    x_m, y_m, heading_rad = _rounded(pose.x_m, pose.y_m, pose.heading_rad)
    return xosc.WorldPosition(x_m, y_m, 0.0, heading_rad)


class Polyline(xosc.Polyline):  # type: ignore[misc]  # the library has no types
    """The library's polyline of a path, made at once: most of a file is its vertices.

    Its times are those of a constant speed: 1.0 demands some.
    """

    def __init__(self, path: Path, speed_mps: float) -> None:
        self._path, self._speed_mps = path, speed_mps

    def get_element(self) -> ET.Element:
        """As the library makes it."""
        shape, path = ET.Element("Shape"), self._path
        line = ET.SubElement(shape, "Polyline")
        columns = (path.s_m, path.x_m, path.y_m, path.heading_rad)
        for s_m, *pose in zip(*(column.tolist() for column in columns), strict=True):
            vertex = ET.SubElement(line, "Vertex", time=str(round(s_m / self._speed_mps, 4)))
            x_m, y_m, heading_rad = map(str, _rounded(*pose))
            place = ET.SubElement(vertex, "Position")
            ET.SubElement(place, "WorldPosition", x=x_m, y=y_m, z="0.0", h=heading_rad)
        return shape


def _rounded(x_m: float, y_m: float, heading_rad: float) -> tuple[float, float, float]:
    """To 0.1 mm and a millionth of a radian; adding zero turns -0.0 into 0.0."""
    heading_rad = (heading_rad + pi) % (2 * pi) - pi
    return round(x_m, 4) + 0.0, round(y_m, 4) + 0.0, round(heading_rad, 6) + 0.0

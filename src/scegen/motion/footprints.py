"""The ground that bodies cover: their boxes from above."""

import numpy as np
import shapely

from scegen.motion.model import Array, Path
from scegen.scenario.bodies import Body


def box_corners(
    body: Body, x_m: Array | float, y_m: Array | float, heading_rad: Array | float
) -> Array:
    """Corners of a box, its front first, from its reference point's poses (...): (..., 4, 2)."""
    ahead = np.array([body.front_m, body.front_m, -body.rear_m, -body.rear_m])
    left = np.array([1, -1, -1, 1]) * body.width_m / 2
    x, y, heading = (np.asarray(values)[..., None] for values in (x_m, y_m, heading_rad))
    c, s = np.cos(heading), np.sin(heading)
    return np.stack((x + ahead * c - left * s, y + ahead * s + left * c), axis=-1)


def swept(path: Path, body: Body, s_m: Array) -> shapely.Geometry:
    """The ground that a body covers at places of its way."""
    return shapely.union_all(shapely.polygons(box_corners(body, *path.places(s_m))))

"""Boxes, bodies, frames and paths for the tests of the measures."""

import numpy as np
from shapely import affinity
from shapely.geometry import box as rectangle

from scegen.motion.batch import BatchTraces, empty_traces
from scegen.motion.batch.arrays import COS, HEADING, SIN, SPEED, S, X, Y
from scegen.motion.batch.touching import Box
from scegen.motion.model import Path


def random_boxes(rng, count, spread=6.0):
    """Boxes, a third of them long and thin so that they often form a "+"."""
    boxes = []
    for k in range(count):
        heading = rng.choice([rng.uniform(-np.pi, np.pi), rng.choice([0.0, np.pi / 2, np.pi])])
        length = rng.uniform(3.0, 6.0) if k % 3 == 0 else rng.uniform(0.2, 5.0)
        width = 0.3 if k % 3 == 0 else rng.uniform(0.2, 1.3)
        x, y = rng.uniform(-spread, spread, 2)
        boxes.append(Box(x, y, np.cos(heading), np.sin(heading), length, width))
    return boxes


def polygon(box):
    """The box as a shapely polygon."""
    shape = rectangle(-box.half_length, -box.half_width, box.half_length, box.half_width)
    return affinity.affine_transform(shape, [box.cos, -box.sin, box.sin, box.cos, box.x, box.y])


def line(x, y, heading, length, step=4.0):
    """A straight path."""
    s = np.linspace(0.0, length, int(np.ceil(length / step)) + 1)
    return Path(s, x + s * np.cos(heading), y + s * np.sin(heading), np.full_like(s, heading), ())


def through(points):
    """A path through dense points (n, 2); headings from the differences."""
    points = np.asarray(points, dtype=float)
    steps = np.diff(points, axis=0)
    heading = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
    s = np.concatenate(([0.0], np.cumsum(np.hypot(*steps.T))))
    return Path(s, points[:, 0], points[:, 1], np.append(heading, heading[-1]), ())


def arc(radius, start_rad, end_rad, count=400):
    """A circular path around the origin, counter-clockwise where end > start."""
    a = np.linspace(start_rad, end_rad, count)
    return through(np.column_stack((radius * np.cos(a), radius * np.sin(a))))


def moving(paths, positions, speeds, dt_s) -> BatchTraces:
    """Traces of one candidate with given positions and speeds, each (participant, step)."""
    batch = empty_traces(1, len(positions[0]), len(paths), 0, dt_s)
    for i, path in enumerate(paths):
        heading = np.interp(positions[i], path.s_m, path.heading_rad)
        track = batch.tracks[0, i]
        track[S], track[SPEED], track[HEADING] = positions[i], speeds[i], heading
        track[X] = np.interp(positions[i], path.s_m, path.x_m)
        track[Y] = np.interp(positions[i], path.s_m, path.y_m)
        track[COS], track[SIN] = np.cos(heading), np.sin(heading)
    return batch


def cruising(paths, starts, speeds, duration_s=20.0, dt_s=0.05) -> BatchTraces:
    """Traces of one candidate at constant speeds, to the ends of the paths."""
    t = np.arange(round(duration_s / dt_s) + 1) * dt_s
    positions = [
        np.minimum(start + speed * t, path.length_m)
        for path, start, speed in zip(paths, starts, speeds, strict=True)
    ]
    return moving(paths, positions, [np.full_like(t, speed) for speed in speeds], dt_s)

"""How far somebody has gone sideways: out of its line, along the arms of its way."""

from __future__ import annotations

import numpy as np

from scegen.claims.arms import Arm, arms_of
from scegen.claims.boxes import boxes, offset
from scegen.claims.view import View
from scegen.motion.batch.arrays import COS, SIN, Floats, X, Y
from scegen.motion.batch.kernels import inner_kernel, kernel
from scegen.scenario.logical import Drive

ALONG = 0.9
"""Cosine of the angle between an arm and the heading of who drives on it."""


def lateral_m(view: View, name: str, drive: Drive | None) -> Floats:
    """How far somebody has gone to its own left since the start, along its arms (c, t).

    In the junction the value stays as it was; on the way out it goes on from there.
    """
    return view.once(("lateral", name), lambda: _lateral(view, name, drive))


def _lateral(view: View, name: str, drive: Drive | None) -> Floats:
    if drive is None:
        box = boxes(view, name)
        x, y, cos, sin = (values[:, :1] for values in (box.x, box.y, box.cos, box.sin))
        return offset(box._replace(x=x, y=y, cos=cos, sin=sin), box)[1]
    entry, leaving = (arms_of(view)[arm] for arm in (drive.entry, drive.exit))
    straight_on = -entry.cos * leaving.cos - entry.sin * leaving.sin > 0.999
    moved = np.empty((view.count, view.steps))
    tracks = view.traces.tracks[:, view.index[name]]
    ahead_m = view.body(name).centre_ahead_m
    _write(tracks, ahead_m, _line(entry), _line(leaving), straight_on, moved)
    return moved


def _line(arm: Arm) -> tuple[float, float, float, float, float]:
    return arm.x_m, arm.y_m, arm.cos, arm.sin, arm.straight_m


@inner_kernel
def _place(
    line: tuple[float, float, float, float, float], x: float, y: float
) -> tuple[float, float]:
    """How far along a line from its beginning, and how far to its left (m)."""
    dx, dy = x - line[0], y - line[1]
    return dx * line[2] + dy * line[3], dy * line[2] - dx * line[3]


@kernel
def _write(
    tracks: Floats,
    ahead_m: float,
    entry: tuple[float, float, float, float, float],
    leaving: tuple[float, float, float, float, float],
    straight_on: bool,
    moved: Floats,
) -> None:
    """Write the way to the own left for tracks (c, row, t); an arm is x, y, cos, sin, length."""
    for c in range(moved.shape[0]):
        track = tracks[c]
        faces = 1.0 if entry[2] * track[COS, 0] + entry[3] * track[SIN, 0] >= 0.0 else -1.0
        inside, out, begin, held, from_m = True, False, 0.0, 0.0, 0.0
        for t in range(moved.shape[1]):
            cos, sin = track[COS, t], track[SIN, t]
            x, y = track[X, t] + ahead_m * cos, track[Y, t] + ahead_m * sin
            along, aside = _place(entry, x, y)
            if t == 0:
                begin = aside
            inside = inside and along <= entry[4]
            if inside or straight_on:
                held = (aside - begin) * faces
                moved[c, t] = held
                continue
            back, aside = _place(leaving, x, y)
            moved[c, t] = held
            if back <= leaving[4] and leaving[2] * cos + leaving[3] * sin < -ALONG:
                if not out:
                    out, from_m = True, aside
                moved[c, t] = held + from_m - aside

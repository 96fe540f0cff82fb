"""How far somebody has gone sideways: out of its line, along the arms of its way."""

from math import sqrt

import numpy as np

from scegen.claims.arms import Line, arms_of, place_on
from scegen.claims.boxes import boxes, offset
from scegen.claims.view import View, kept
from scegen.motion.batch.arrays import COS, SIN, Floats, X, Y
from scegen.motion.batch.kernels import kernel
from scegen.scenario.logical import Drive
from scegen.scenario.vocabulary import DrivingSide, JunctionKind

ALONG, ROUND = 0.9, (0.1, 0.5)
"""Cosine of the angle between an arm and the heading of who drives on it; of that between the
direction from the middle of a ring and the heading of who is in it, and who leaves it."""
_WIDE_M = 1.0
"""Beyond its edges, somebody counts as on an arm."""


@kept
def lateral_m(view: View, name: str, drive: Drive | None, steps: int | None = None) -> Floats:
    """How far somebody has gone to its own left since the start, along its arms (c, t).

    In a crossing the value stays as it was; in a ring it is how much nearer to its middle somebody
    has come (farther from it, where traffic keeps left). On the way out it goes on from there.
    Only of the first ``steps``, if that is given.
    """
    upto = view.steps if steps is None else min(steps, view.steps)
    if drive is None:
        box = boxes(view, name, upto)
        x, y, cos, sin = (values[:, :1] for values in (box.x, box.y, box.cos, box.sin))
        return offset(box._replace(x=x, y=y, cos=cos, sin=sin), box)[1]
    entry, leaving = (arms_of(view)[arm] for arm in (drive.entry, drive.exit))
    straight_on = -entry.cos * leaving.cos - entry.sin * leaving.sin > 0.999
    road = view.concrete.road
    ring = 0.0
    if road.kind is JunctionKind.ROUNDABOUT:
        ring, straight_on = (1.0 if road.driving_side is DrivingSide.RIGHT else -1.0), False
    moved = np.empty((view.count, upto))
    tracks = view.laid[:, view.index[name]]
    ahead_m = view.body(name).centre_ahead_m
    _write(tracks, ahead_m, entry.line, leaving.line, straight_on, ring, moved)
    return moved


@kernel
def _write(
    tracks: Floats,
    ahead_m: float,
    entry: Line,
    leaving: Line,
    straight_on: bool,
    ring: float,
    moved: Floats,
) -> None:
    """Write the way to the own left for tracks (c, row, t).

    ``ring`` is 1 where traffic goes counter-clockwise round the origin, -1 the other way, else 0.
    """
    for c in range(moved.shape[0]):
        track = tracks[c]
        faces = 1.0 if entry.cos * track[COS, 0] + entry.sin * track[SIN, 0] >= 0.0 else -1.0
        inside, round_it, out = True, False, False
        begin, since, held, from_m = 0.0, 0.0, 0.0, 0.0
        for t in range(moved.shape[1]):
            cos, sin = track[COS, t], track[SIN, t]
            x, y = track[X, t] + ahead_m * cos, track[Y, t] + ahead_m * sin
            along, aside = place_on(entry, x, y)
            if t == 0:
                begin = aside
            inside = inside and along <= entry.length
            if inside or straight_on:
                held = (aside - begin) * faces
                moved[c, t] = held
                continue
            back, aside = place_on(leaving, x, y)
            on_it = leaving.right - _WIDE_M <= aside <= leaving.left + _WIDE_M
            heads = leaving.cos * cos + leaving.sin * sin < -ALONG
            if back <= leaving.length and heads and on_it:
                if not out:
                    out, from_m = True, aside
                moved[c, t] = held + from_m - aside
                continue
            if ring != 0.0 and not out:
                radius = sqrt(x * x + y * y)
                outwards = (x * cos + y * sin) / radius
                if not round_it and abs(outwards) < ROUND[0]:
                    round_it, since = True, radius + ring * held
                if round_it and outwards < ROUND[1]:
                    held = ring * (since - radius)
            moved[c, t] = held

"""Views of hand-made movements, for the tests of the hazard predicates."""

from __future__ import annotations

import numpy as np
from criticality_scenarios import scenario

from scegen.claims.hazards.scenes import scene_of
from scegen.claims.view import view_of
from scegen.claims.ways import Sideways, Way
from scegen.motion.batch import stack_traces
from scegen.motion.model import Path, Trace
from scegen.scenario.bodies import BODIES
from scegen.scenario.concrete import LaneChange

DT_S = 0.05


def line(x0, y0, heading_deg, length_m=300.0):
    """A straight path from a point."""
    s = np.arange(0.0, length_m + 1e-9, 4.0)
    heading = np.full(len(s), np.deg2rad(heading_deg))
    return Path(s, x0 + s * np.cos(heading), y0 + s * np.sin(heading), heading, ())


def trace(name, body, path, speeds):
    """The movement along a path at these speeds, one per step."""
    speeds = np.asarray(speeds, dtype=np.float64)
    s = np.minimum(np.cumsum(speeds) * DT_S - speeds[0] * DT_S, path.length_m)
    poses = [np.interp(s, path.s_m, values) for values in (path.x_m, path.y_m, path.heading_rad)]
    return Trace(name, body, np.arange(len(s)) * DT_S, s, *poses, speeds)


def steady(speed, seconds=10.0):
    """A constant speed."""
    return np.full(round(seconds / DT_S) + 1, float(speed))


def way(participant, path, *, changes=(), turn=(150.0, 170.0), limit_mps=14.0, laid=None):
    """A way with these lane changes: (start, end, width, lane after)."""
    made = tuple(
        Sideways(a, b, w, LaneChange(position_m=a, length_m=b - a, lane_after=lane))
        for a, b, w, lane in changes
    )
    return Way(participant, path, limit_mps, *turn, path.length_m, made, laid)


def view(people, paths, speeds, hazards=(), friction=1.0, **ways):
    """What predicates see of these people on these paths at these speeds."""
    concrete = scenario(*people, hazards=hazards)
    assert {p.kind for p in people} <= set(BODIES)
    by_name = {p.id: path for p, path in zip(people, paths, strict=True)}
    traces = [
        trace(p.id, p.body, path, v) for p, path, v in zip(people, paths, speeds, strict=True)
    ]
    pairs = [(a.id, b.id) for n, a in enumerate(people) for b in people[n + 1 :]]
    all_ways = {p.id: ways.get(p.id) or way(p, by_name[p.id]) for p in people}
    scene = scene_of(concrete, by_name, pairs, friction)
    return view_of(concrete, all_ways, scene, stack_traces(traces, paths), friction)

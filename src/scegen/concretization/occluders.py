"""Things that hide: placed where they cut the line of sight until a moment before the encounter.

Nobody's movement depends on what stands beside the road. So the movements come first; then every
place is tried that lies on a line of sight shortly before the two come nearest to each other, off
the road and off everybody's way, and the one is taken from which most is hidden, late moments
counting more.
"""

from dataclasses import replace
from itertools import product

import numpy as np
import shapely

from scegen.concretization.boxes import box_at, taken_ground
from scegen.concretization.things import (
    SCREEN,
    Shape,
    caused_by_nobody,
    causing_it,
    free_name,
    made_of,
    shape_of,
)
from scegen.measures.occlusion import hidden_behind
from scegen.motion import simulate
from scegen.motion.footprints import box_corners
from scegen.motion.model import Array, Trace
from scegen.motion.paths import build_paths
from scegen.road.geometry import Pose
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import (
    Change,
    ConcreteScenario,
    CrossingMotion,
    DriveMotion,
    StandingMotion,
)
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.objects import StaticObject
from scegen.scenario.things import Thing
from scegen.scenario.vocabulary import HazardKind

_EARLIEST_S, _LATEST_S, _EVERY_S = 8.0, 0.5, 0.8
"""Before the encounter: the moments whose lines of sight are tried."""
_LOOK_S = 10.0
_STEP_S = 0.1
_FADES_S = 2.0
_LEAST_S = 0.3
_FROM_EITHER_M = (1.0, 1.6, 2.4, 3.5, 5.0, 7.0, 10.0, 14.0, 20.0)
_ALONG = (0.0, -0.45, 0.45)
"""Where the line of sight meets a box along its length: in the middle, or near an end."""
_ASIDE_M = tuple(0.2 * n for n in range(-6, 7))
"""How far to the side of that a box is moved: to the kerb, clear of somebody's way."""
_LONG_M = 12.0
"""As long as what can be as long as needed is, where it is to hide a vehicle."""
_ACROSS = 0.95
"""A thing across the road is worth a little less than one along it: few stand like that."""


def hide(
    functional: FunctionalScenario, concrete: ConcreteScenario, network: RoadNetwork
) -> ConcreteScenario:
    """The scenario with a thing for every occlusion that nobody is said to cause.

    Where no place hides anybody for long enough it is left out, and the danger has nothing that
    causes it.
    """
    parked = any(isinstance(p.motion, StandingMotion) for p in concrete.participants)
    for hazard in concrete.hazards:
        if hazard.kind is not HazardKind.OCCLUSION:
            continue
        thing = next(iter(causing_it(functional, hazard)), None)
        if thing is None and (parked or not caused_by_nobody(functional, hazard)):
            continue
        if thing is not None and any(each.id == thing.id for each in concrete.objects):
            concrete = _by_nothing(concrete, hazard)  # it lies in somebody's way
            continue
        if thing is None:
            name = free_name(functional, SCREEN.kind, {o.id for o in concrete.objects})
            thing = Thing(id=name, kind=SCREEN.kind)
        shape = shape_of(thing)
        made = _hide(concrete, network, hazard, thing, shape)
        concrete = _by_nothing(concrete, hazard) if made is concrete else made
    return concrete


def _by_nothing(concrete: ConcreteScenario, hazard: Hazard) -> ConcreteScenario:
    """With the danger left to who else causes it: the thing that was to do so is not there."""
    people = {p.id for p in concrete.participants}
    left = hazard.but(by=tuple(n for n in hazard.by if n in people))
    hazards = tuple(left if each is hazard else each for each in concrete.hazards)
    return concrete.but(hazards=hazards)


def _hide(
    concrete: ConcreteScenario, network: RoadNetwork, hazard: Hazard, thing: Thing, shape: Shape
) -> ConcreteScenario:
    observer = next(iter(hazard.to), concrete.ego.id)
    paths = build_paths(concrete, network)
    traces = simulate(concrete, paths, dt_s=_STEP_S)
    ground = taken_ground(network, concrete, paths)
    best: tuple[float, str, StaticObject] | None = None
    for group in _hidden_ones(concrete, observer, thing):
        for name in group:
            drives = isinstance(concrete.participant(name).motion, DriveMotion)
            sized = replace(shape, length_m=_LONG_M) if shape.long and drives else shape
            found = _best_place(traces[observer], traces[name], sized, ground)
            if found is not None and (best is None or found[0] > best[0]):
                best = found[0], name, made_of(thing.id, sized, thing.called, found[1])
        if best is not None:
            break
    if best is None:
        return concrete
    _, name, made = best
    change = Change(
        parameter=f"{made.id}.length_m",
        by="concretization",
        after=made.length_m,
        reason=f"hides {name} from {observer}",
    )
    by = tuple(n for n in hazard.by if n != made.id)
    caused = hazard.but(by=(*by, made.id), to=hazard.to or (observer,))
    return concrete.but(
        objects=(*concrete.objects, made),
        hazards=tuple(caused if h is hazard else h for h in concrete.hazards),
        provenance=(*concrete.provenance, change),
    )


def _hidden_ones(concrete: ConcreteScenario, observer: str, thing: Thing) -> list[list[str]]:
    """Who may be hidden: who is said to be, who crosses, who endangers, whom one meets, anybody."""
    drives = [p.id for p in concrete.participants if isinstance(p.motion, DriveMotion)]
    walks = [p.id for p in concrete.participants if isinstance(p.motion, CrossingMotion)]
    causes = [n for h in concrete.hazards if observer in h.to for n in h.by if n in drives]
    met = [
        name
        for conflict in concrete.logical.conflicts
        if observer in (conflict.first, conflict.second)
        for name in (conflict.first, conflict.second)
        if name in drives
    ]
    said = [name for name in thing.hides if name in {*drives, *walks}]
    groups = [said] if said else [walks, causes, met, drives]
    return [[n for n in dict.fromkeys(group) if n != observer] for group in groups]


def _best_place(
    observer: Trace, target: Trace, thing: Shape, ground: shapely.Geometry
) -> tuple[float, Pose] | None:
    """(worth, pose) of the best place; None if none hides the target long enough."""
    seer, seen = (box_at(t.x_m, t.y_m, t.heading_rad, t.body) for t in (observer, target))
    eye, mark = np.array(seer[:4]), np.array(seen[:4])
    nearest = int(np.hypot(*(eye - mark)[:2]).argmin())
    x, y, heading, _ = places = _places(eye[:2], mark[:2], observer, target, thing, nearest)
    shapely.prepare(ground)
    tried = shapely.polygons(box_corners(thing.body, x, y, heading))
    x, y, heading, worth = places[:, ~shapely.intersects(ground, tried)]
    if not worth.size:
        return None
    boxes = box_at(x, y, heading, thing.body)
    first = max(0, nearest - round(_LOOK_S / _STEP_S))
    eye, mark = (row[:, first:nearest].copy() for row in (eye, mark))
    half = np.array([*seen[4:], *boxes[4:]])
    hidden = hidden_behind(eye, mark, np.array(boxes[:4]), half)
    before_s = (nearest - np.arange(first, nearest)) * _STEP_S
    worth = (hidden * np.exp(-before_s / _FADES_S)).sum(axis=1) * worth
    worth[hidden.sum(axis=1) * _STEP_S < _LEAST_S] = 0.0
    n = int(worth.argmax())
    pose = Pose(float(x[n]), float(y[n]), float(heading[n]))
    return (float(worth[n]), pose) if worth[n] > 0.0 else None


def _places(
    eye: Array, mark: Array, observer: Trace, target: Trace, thing: Shape, nearest: int
) -> Array:
    """Places on lines of sight before the encounter, near either end; along the road first.

    Their x, y, heading and how much each is worth, (4, n).
    """
    rows = []
    for before_s in np.arange(_LATEST_S, _EARLIEST_S, _EVERY_S):
        t = nearest - round(before_s / _STEP_S)
        if t < 0:
            break
        a, b = eye[:, t], mark[:, t]
        away = float(np.hypot(*(b - a)))
        sight = (b - a) / max(away, 1e-6)
        across = float(np.arctan2(sight[1], sight[0])) + np.pi / 2
        headings = (
            (float(observer.heading_rad[t]), 1.0),
            (float(target.heading_rad[t]), _ACROSS),
            (across, _ACROSS**2),
        )
        for from_it in _FROM_EITHER_M:
            if from_it >= away:
                break
            for point in (b - from_it * sight, a + from_it * sight):
                rows += [(*point, heading, worth) for heading, worth in headings]
    table = np.array(rows, dtype=np.float64).reshape(-1, 1, 4)
    shifts = np.array(list(product(_ALONG, _ASIDE_M))) * np.array([thing.length_m, 1.0])
    x, y, heading, worth = np.repeat(table, len(shifts), axis=1).T
    along, aside = shifts[:, :1], shifts[:, 1:]
    c, s = np.cos(heading), np.sin(heading)
    x, y = x + along * c - aside * s, y + along * s + aside * c
    return np.array([values.T.ravel() for values in (x, y, heading, worth)])

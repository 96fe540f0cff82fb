"""Who comes near whom: distances and times to collision, common ground, lines of sight."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import ceil, isfinite, isnan

import numpy as np
import shapely

from scegen.claims.hazards.scenes import judged_pairs, occlusions
from scegen.criticality.encounter import closest_encounter
from scegen.measures.distance import distance_series
from scegen.measures.evaluation import Summary, measure
from scegen.measures.occlusion import occlusion_series
from scegen.measures.post_encroachment import post_encroachment_time, time_of_reaching
from scegen.measures.tables import Tables, build_tables
from scegen.measures.time_to_collision import time_to_collision_series
from scegen.motion.batch import BatchTraces, stack_scenario
from scegen.motion.footprints import swept
from scegen.motion.friction import friction_of
from scegen.motion.model import Path, Trace
from scegen.motion.standing import object_paths
from scegen.report.player.series import Data, compact, points
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import ConcreteScenario

EYE_M = 1.08
"""Height of a driver's eyes: AASHTO, A Policy on Geometric Design (2018), 3.2.6. What is lower
hides nobody, unless the description says that it does."""
_FARTHEST_TTC_S = 10.0
_ALONG_M = 0.5
_DETAIL_M = 0.05


@dataclass(frozen=True)
class Meetings:
    """Pairs measured against each other over time; ``pair`` is the one that matters."""

    names: tuple[str, ...]
    pair: tuple[str, ...]
    paths: Sequence[Path]
    bodies: Sequence[Body | None]
    traces: BatchTraces
    scene: Tables
    summary: Summary

    @property
    def _number(self) -> int | None:
        """Which of the pairs matters."""
        wanted = {self.names.index(name) for name in self.pair}
        found = [n for n, pair in enumerate(self.scene.pairs) if {*pair.tolist()} == wanted]
        return found[0] if found else None

    @property
    def touches(self) -> bool:
        """Whether the pair that matters touches."""
        number = self._number
        return number is not None and not isnan(self.summary.contact_s[0, number])

    @property
    def moment_s(self) -> float | None:
        """When the pair touches, or is nearest; None where nobody meets."""
        number = self._number
        if number is None:
            return None
        times = self.summary.contact_s if self.touches else self.summary.closest_s
        return float(times[0, number])

    @property
    def moment(self) -> str:
        """That moment in words."""
        both = " and ".join(self.pair)
        if self.touches:
            return f"{both} touch"
        return f"{both} are closest: {self.summary.distance_m[0, self._number or 0]:.2f} m"

    def data(self, step_s: float) -> Data:
        """Pairs, areas and lines of sight for the player, in samples of ``step_s``."""
        pairs, areas, hidden = map(list, (self._series(step_s), self._areas(), self._hidden()))
        return {"pairs": pairs, "areas": areas, "hidden": hidden}

    def _series(self, step_s: float) -> Iterator[Data]:
        """Each sample is the smallest value until the next: the least is that of the proof."""
        tracks, bodies, pairs = self.traces.tracks, self.scene.bodies, self.scene.pairs
        distance = distance_series(tracks, bodies, pairs)[0]
        ttc = time_to_collision_series(tracks, bodies, pairs)[0]
        ttc[ttc > _FARTHEST_TTC_S] = np.inf
        every = max(1, round(step_s / self.traces.dt_s))
        starts = np.arange(0, len(distance), every)
        for n, (a, b) in enumerate(pairs):
            apart, left_s = (np.minimum.reduceat(of[:, n], starts) for of in (distance, ttc))
            yield {
                "between": [self.names[a], self.names[b]],
                "distance_m": compact(apart.tolist(), 2),
                "ttc_s": compact(left_s.tolist(), 2),
                "least": {
                    name: round(float(value), 3)
                    for name in ("distance_m", "ttc_s", "pet_s")
                    if isfinite(value := getattr(self.summary, name)[0, n])
                },
            }

    def _areas(self) -> Iterator[Data]:
        """Common ground of crossing and merging ways, and when either is on it."""
        areas = self.scene.areas
        for p, pair in enumerate(self.scene.pairs.tolist()):
            for n in range(areas.first[p], areas.first[p + 1]):
                enter, leave = areas.enter_m[n], areas.leave_m[n]
                ground = shapely.intersection(
                    *(self._swept(i, enter[k], leave[k]) for k, i in enumerate(pair))
                )
                if ground.is_empty:
                    continue
                hull = shapely.simplify(shapely.convex_hull(ground), _DETAIL_M)
                if hull.geom_type != "Polygon":
                    continue
                times = [self._spell(i, enter[k], leave[k]) for k, i in enumerate(pair)]
                first, second = (self.traces.tracks[0, i] for i in pair)
                pet_s = post_encroachment_time(first, second, enter, leave, self.traces.dt_s)
                yield {
                    "between": [self.names[i] for i in pair],
                    "points": points(np.asarray(hull.exterior.coords).ravel().tolist()),
                    "occupied_s": times,
                    "pet_s": round(pet_s, 3) if isfinite(pet_s) else None,
                }

    def _swept(self, one: int, low_m: float, high_m: float) -> shapely.Geometry:
        """The ground that a body covers between two places of its way."""
        path, body = self.paths[one], self.bodies[one]
        high_m = min(high_m, path.length_m)
        low_m = min(max(low_m, 0.0), high_m)
        s = np.linspace(low_m, high_m, 2 + ceil((high_m - low_m) / _ALONG_M))
        if body is None:
            return shapely.Point(path.x_m[0], path.y_m[0])
        return swept(path, body, s)

    def _spell(self, one: int, enter_m: float, leave_m: float) -> list[float] | None:
        """From when to when somebody is on common ground; None: never."""
        track, dt_s = self.traces.tracks[0, one], self.traces.dt_s
        begins = time_of_reaching(track, enter_m, dt_s)
        ends = time_of_reaching(track, leave_m, dt_s) if isfinite(leave_m) else float("nan")
        if isnan(begins) or ends == 0.0:
            return None
        last_s = float(self.traces.time_s[-1])
        return [round(begins, 2), round(last_s if isnan(ends) else ends, 2)]

    def _hidden(self) -> Iterator[Data]:
        """Who is hidden from whom by whom, and when."""
        if not len(self.scene.occlusions):
            return
        flags = occlusion_series(self.traces.tracks, self.scene.bodies, self.scene.occlusions)[0]
        dt_s = self.traces.dt_s
        for n, triple in enumerate(self.scene.occlusions.tolist()):
            edges = np.flatnonzero(np.diff(np.concatenate(([0], flags[:, n], [0]))))
            spans = (edges.reshape(-1, 2) * dt_s).round(2).tolist()
            if spans:
                observer, target, occluder = (self.names[i] for i in triple)
                yield {"observer": observer, "target": target, "by": occluder, "spans_s": spans}


def meetings_of(
    concrete: ConcreteScenario,
    paths: Mapping[str, Path],
    traces: Mapping[str, Trace],
    pair: Sequence[str],
) -> Meetings:
    """Measure everybody against the ego, and whoever a danger names against its other.

    ``pair`` is whom it is about; whoever comes nearest to the ego, if empty.
    """
    if not pair and (nearest := closest_encounter(concrete, traces)) is not None:
        pair = (concrete.ego.id, nearest.other)
    names = tuple(entity.id for entity in concrete.entities)
    index = {name: n for n, name in enumerate(names)}
    ways = {**paths, **object_paths(concrete)}
    order = [ways[name] for name in names]
    ego = concrete.ego.id
    wanted = [tuple(pair)[:2]] * bool(pair) + [(ego, n) for n in names if n != ego]
    chosen: dict[frozenset[str], tuple[int, int]] = {}
    for a, b in wanted + judged_pairs(concrete):
        chosen.setdefault(frozenset((a, b)), (index[a], index[b]))
    sights = [*occlusions(concrete), *_sights(concrete)]
    scene = build_tables(
        order,
        [entity.body for entity in concrete.entities],
        pairs=list(chosen.values()),
        occlusions=[(index[a], index[b], index[c]) for a, b, c in dict.fromkeys(sights)],
        friction=friction_of(concrete.environment),
    )
    batch = stack_scenario(concrete, traces, paths)
    bodies = [*(p.body for p in concrete.participants), *(None for _ in concrete.objects)]
    return Meetings(names, tuple(pair), order, bodies, batch, scene, measure(batch, scene))


def _sights(concrete: ConcreteScenario) -> list[tuple[str, str, str]]:
    """What could hide a mover from the ego's driver."""
    ego = concrete.ego.id
    tall = [entity.id for entity in concrete.entities if entity.body.height_m > EYE_M]
    return [
        (ego, target.id, by)
        for target in concrete.participants
        if target.id != ego and not target.parked
        for by in tall
        if by not in {ego, target.id}
    ]

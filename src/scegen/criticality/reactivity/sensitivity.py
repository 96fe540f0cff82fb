"""Reactivity: does the danger survive an ego that starts 20 % slower or faster?

The ego starts with another speed and keeps its path and program; the others keep theirs, and
triggers that look at the ego (distance to it, distance travelled by it) are evaluated anew. A
danger that is bound to the ego's movement stays critical; one that happens at a fixed time or
place of the other's own way is missed by an ego that comes earlier or later.

A run counts as critical if the pair touches or one of these holds: distance at most 1.2 m;
post-encroachment time at most 1.5 s; time to collision at most 2.25 s and distance at most 3.0 m.
These are one and a half times the upper ends of the near-miss bands of
:mod:`scegen.criticality.target`: less than driving past each other in neighbouring lanes takes.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from math import isfinite

import numpy as np

from scegen.claims.hazards.scenes import scene_of
from scegen.criticality.encounter import closest_encounter
from scegen.measures.contact import contact_steps
from scegen.measures.evaluation import Summary, measure
from scegen.motion.batch import BatchTraces, compile_program, repeat, simulate, simulate_batch
from scegen.motion.batch.arrays import Ints
from scegen.motion.friction import friction_of
from scegen.motion.model import Path
from scegen.scenario.concrete import ConcreteScenario, DriveMotion

SLOWER, FASTER = 0.8, 1.2
CRITICAL_DISTANCE_M = 1.5 * 0.8
CRITICAL_PET_S = 1.5 * 1.0
CRITICAL_TTC_S, WITHIN_M = 1.5 * 1.5, 1.5 * 2.0
_AT_END_M, _DT_S = 1e-6, 0.01


@dataclass(frozen=True, slots=True)
class Start:
    """How critical the ego and its partner get if the ego starts at ``factor`` times its speed.

    ``distance_m``: smallest distance of the bodies. ``pet_s``, ``ttc_s``: smallest
    post-encroachment time and time to collision, None where undefined or infinite.
    ``others_touch``: two without the ego do.
    """

    factor: float
    contact: bool
    distance_m: float
    pet_s: float | None
    ttc_s: float | None
    others_touch: bool = False

    @property
    def critical(self) -> bool:
        """Whether the pair touches, or comes as close as the module says."""
        if self.contact or self.distance_m <= CRITICAL_DISTANCE_M:
            return True
        if self.pet_s is not None and self.pet_s <= CRITICAL_PET_S:
            return True
        soon = self.ttc_s is not None and self.ttc_s <= CRITICAL_TTC_S
        return soon and self.distance_m <= WITHIN_M


@dataclass(frozen=True, slots=True)
class Sensitivity:
    """The pair of the ego and ``partner`` at the scenario's own start and at the two others."""

    partner: str
    own: Start
    slower: Start
    faster: Start

    @property
    def others_touch(self) -> bool:
        """Whether an ego that starts otherwise lets two others touch who did not."""
        return not self.own.others_touch and (self.slower.others_touch or self.faster.others_touch)

    @property
    def reactive(self) -> bool:
        """Whether the event is critical however the ego starts."""
        return all(start.critical for start in (self.own, self.slower, self.faster))


def ego_start_sensitivity(
    concrete: ConcreteScenario, paths: Mapping[str, Path], *, partner: str | None = None
) -> Sensitivity | None:
    """Start the ego 20 % slower and faster; None where it meets nobody.

    Each run is looked at until the ego or its partner is at the end of its road.

    Args:
        concrete: the scenario.
        paths: its paths by participant, as :func:`scegen.motion.build_paths` makes them.
        partner: whom the event is about; None for whoever comes nearest to the ego, those who
            are parked only where nobody else is or a hazard names them.
    """
    if partner is None:
        met = closest_encounter(concrete, simulate(concrete, paths))
        if met is None:
            return None
        partner = met.other
    ways = tuple((name, path.digest) for name, path in paths.items())
    return _compared(_Asked(concrete, partner, ways, paths))


@dataclass(frozen=True, slots=True)
class _Asked:
    """One question, the same if all but the objects of the paths is."""

    concrete: ConcreteScenario
    partner: str
    ways: tuple[tuple[str, bytes], ...]
    paths: Mapping[str, Path] = field(compare=False)


@lru_cache(maxsize=8)
def _compared(asked: _Asked) -> Sensitivity:
    """Kept, because the judgement of a scenario asks what the search for it has found."""
    concrete, paths, partner = asked.concrete, asked.paths, asked.partner
    people = concrete.entities
    ego = people.index(concrete.ego)
    program, candidate = compile_program(concrete, paths)
    candidates = repeat(candidate, 3)
    factors = (1.0, SLOWER, FASTER)
    candidates.speed_mps[:, ego] *= np.array(factors)
    pair, friction = (concrete.ego.id, partner), friction_of(concrete.environment)
    everybody = scene_of(concrete, paths, [pair], friction)
    # Of all others it is only asked whether they touch, of the ego's whether this one does.
    bodies, met = everybody.bodies, everybody.pairs[0]
    others = everybody.pairs[np.all(everybody.pairs != ego, axis=1)]
    scene = everybody._replace(
        bodies=bodies[met], pairs=np.array([[0, 1]]), occlusions=everybody.occlusions[:0]
    )
    traces = simulate_batch(program, candidates, duration_s=concrete.latest_end_s, dt_s=_DT_S)
    other = [p.id for p in people].index(partner)
    starts = []
    for c, factor in enumerate(factors):
        arrives = _ends(concrete, paths, traces, c)
        end = min(arrives[ego], arrives[other])
        if c == 0:
            end = min(end, round(concrete.duration_s / _DT_S))
        # A copy: kernels are compiled for contiguous tracks.
        tracks = np.ascontiguousarray(traces.tracks[c : c + 1, met, :, : end + 1])
        found = measure(BatchTraces(_DT_S, tracks, traces.fired_step[c : c + 1]), scene)
        touch = contact_steps(traces.tracks, c, end + 1, bodies, others)
        in_time = (touch >= 0) & (touch * _DT_S < (arrives * _DT_S)[others].min(axis=1))
        starts.append(_start(found, factor, others_touch=bool(in_time.any())))
    return Sensitivity(partner, *starts)


def _ends(
    concrete: ConcreteScenario, paths: Mapping[str, Path], traces: BatchTraces, candidate: int
) -> Ints:
    """The last step of everybody's drive (i,): who waits at the end of its road counts no more."""
    last = traces.tracks.shape[3] - 1
    ends = np.full(len(concrete.entities), last)
    for i, participant in enumerate(concrete.participants):
        there = traces.s_m[candidate, :, i] >= paths[participant.id].length_m - _AT_END_M
        if isinstance(participant.motion, DriveMotion) and there.any():
            ends[i] = int(there.argmax())
    return ends


def _start(found: Summary, factor: float, *, others_touch: bool) -> Start:
    pet_s, ttc_s = (
        float(values[0, 0]) if isfinite(values[0, 0]) else None
        for values in (found.pet_s, found.ttc_s)
    )
    touch, distance_m = bool(isfinite(found.contact_s[0, 0])), float(found.distance_m[0, 0])
    return Start(factor, touch, distance_m, pet_s, ttc_s, others_touch)

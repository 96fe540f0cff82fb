"""Reactivity: does the danger survive an ego that starts 20 % slower or faster?

The ego starts with another speed and keeps its path and program; the others keep theirs, and
triggers that look at the ego (distance to it, distance travelled by it) are evaluated anew. A
danger that is bound to the ego's movement stays critical; one that happens at a fixed time or
place of the other's own way is missed by an ego that comes earlier or later.

A run counts as critical if the pair touches or one of these holds: distance at most 1.6 m;
post-encroachment time at most 2.0 s (above that, traffic is normal); time to collision at most
3.0 s and distance at most 4.0 m. These are twice the upper ends of the near-miss bands of
:mod:`scegen.criticality.target`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite

import numpy as np

from scegen.criticality.course import ego_course
from scegen.criticality.evaluation import Summary, evaluate
from scegen.criticality.scene import build_scene
from scegen.motion.batch import compile_program, repeat
from scegen.motion.model import Path
from scegen.scenario.concrete import ConcreteScenario

SLOWER, FASTER = 0.8, 1.2
CRITICAL_DISTANCE_M = 2 * 0.8
CRITICAL_PET_S = 2 * 1.0
CRITICAL_TTC_S, WITHIN_M = 2 * 1.5, 2 * 2.0


@dataclass(frozen=True, slots=True)
class Start:
    """How critical the ego and its partner get if the ego starts at ``factor`` times its speed.

    ``distance_m``: smallest distance of the bodies. ``pet_s``, ``ttc_s``: smallest
    post-encroachment time and time to collision, None where undefined or infinite.
    """

    factor: float
    contact: bool
    distance_m: float
    pet_s: float | None
    ttc_s: float | None

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
    def reactive(self) -> bool:
        """Whether the event is critical however the ego starts."""
        return all(start.critical for start in (self.own, self.slower, self.faster))


def ego_start_sensitivity(
    concrete: ConcreteScenario,
    paths: Mapping[str, Path],
    *,
    partner: str | None = None,
    dt_s: float = 0.01,
) -> Sensitivity | None:
    """Start the ego 20 % slower and faster; None where it is alone.

    Args:
        concrete: the scenario.
        paths: its paths by participant, as :func:`scegen.motion.build_paths` makes them.
        partner: whom the event is about; None for whoever comes nearest to the ego, those who
            are parked only where nobody else is or a hazard names them.
        dt_s: time step of the simulation, s.
    """
    people = concrete.participants
    ego = people.index(concrete.ego)
    if len(people) < 2:
        return None
    if partner is None:
        partner = ego_course(concrete, paths).partner
    other = [p.id for p in people].index(partner)
    program, candidate = compile_program(concrete, paths)
    candidates = repeat(candidate, 3)
    factors = (1.0, SLOWER, FASTER)
    candidates.speed_mps[:, ego] *= np.array(factors)
    scene = build_scene(
        [paths[p.id] for p in people], [p.kind for p in people], pairs=[(ego, other)]
    )
    found = evaluate(program, candidates, scene, duration_s=concrete.latest_end_s, dt_s=dt_s)
    own, slower, faster = (_start(found, c, factor) for c, factor in enumerate(factors))
    return Sensitivity(partner, own, slower, faster)


def _start(found: Summary, candidate: int, factor: float) -> Start:
    return Start(
        factor,
        bool(isfinite(found.contact_s[candidate, 0])),
        float(found.distance_m[candidate, 0]),
        _finite(found.pet_s[candidate, 0]),
        _finite(found.ttc_s[candidate, 0]),
    )


def _finite(value: float) -> float | None:
    return float(value) if isfinite(value) else None

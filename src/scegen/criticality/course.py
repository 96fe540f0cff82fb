"""The course of a scenario as the ego sees it: speeds, distances and times to collision."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from scegen.measures.bodies import body_table
from scegen.measures.distance import distance_series
from scegen.measures.injury import PROTECTED, UNPROTECTED
from scegen.measures.time_to_collision import time_to_collision_series
from scegen.motion.batch import compile_program, simulate_batch
from scegen.motion.batch.arrays import Floats
from scegen.motion.friction import friction_of
from scegen.motion.model import Path
from scegen.scenario.concrete import ConcreteParticipant, ConcreteScenario
from scegen.scenario.objects import StaticObject
from scegen.scenario.vocabulary import HazardKind


@dataclass(frozen=True)
class Course:
    """Time series, one value per step of ``time_s`` (s).

    Attributes:
        speed_mps: of every participant, forwards or backwards.
        distance_m: between the bodies of the ego and each other; 0 in contact.
        ttc_s: their two-dimensional time to collision; inf if they would never touch.
        partner: the other that comes nearest to the ego; those who are parked count only where
            nobody else is or a hazard names them, things where they are an obstacle. Empty where
            the ego is alone.
        step: the first step in which the partner is nearest: the critical moment.
    """

    time_s: Floats
    speed_mps: dict[str, Floats]
    distance_m: dict[str, Floats]
    ttc_s: dict[str, Floats]
    partner: str
    step: int


def ego_course(
    concrete: ConcreteScenario,
    paths: Mapping[str, Path],
    *,
    partner: str | None = None,
    dt_s: float = 0.05,
) -> Course:
    """Simulate a scenario and look at it from the ego.

    Args:
        concrete: the scenario.
        paths: its paths by participant, as :func:`scegen.motion.build_paths` makes them.
        partner: whom the event is about; None for whoever comes nearest, see :class:`Course`.
        dt_s: time step, s.
    """
    people = concrete.entities
    program, candidate = compile_program(concrete, paths)
    traces = simulate_batch(program, candidate, duration_s=concrete.duration_s, dt_s=dt_s)
    bodies = body_table(
        [*(p.kind for p in concrete.participants), *concrete.objects],
        friction=friction_of(concrete.environment),
        protected_curve=PROTECTED,
        unprotected_curve=UNPROTECTED,
    )
    ego = people.index(concrete.ego)
    others = [n for n in range(len(people)) if n != ego]
    pairs = np.array([(ego, n) for n in others], dtype=np.int64).reshape(-1, 2)
    apart = distance_series(traces.tracks, bodies, pairs)[0]
    ttc = time_to_collision_series(traces.tracks, bodies, pairs)[0]
    counting = [k for k, n in enumerate(others) if _counts(concrete, people[n], partner)]
    nearest = min(counting or range(len(others)), key=lambda k: apart[:, k].min(), default=None)
    return Course(
        traces.time_s,
        {p.id: np.abs(traces.speed_mps[0, :, n]) for n, p in enumerate(people)},
        {people[n].id: apart[:, k] for k, n in enumerate(others)},
        {people[n].id: ttc[:, k] for k, n in enumerate(others)},
        "" if nearest is None else people[others[nearest]].id,
        0 if nearest is None else int(apart[:, nearest].argmin()),
    )


def _counts(
    concrete: ConcreteScenario, one: ConcreteParticipant | StaticObject, partner: str | None
) -> bool:
    """Whether the event can be about this one."""
    if partner is not None:
        return one.id == partner
    if isinstance(one, StaticObject):
        return in_the_way(concrete, one)
    return not one.parked or any(one.id in (*h.by, *h.to) for h in concrete.hazards)


def in_the_way(concrete: ConcreteScenario, thing: StaticObject) -> bool:
    """Whether a thing is there as an obstacle, and does not only hide somebody."""
    obstacles = [h for h in concrete.hazards if h.kind is HazardKind.OBSTACLE]
    return any(thing.id in hazard.by for hazard in obstacles)

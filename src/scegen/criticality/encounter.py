"""The moment that a scenario is about where nothing else is said: when the ego meets another."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from scegen.measures.bodies import body_table
from scegen.measures.distance import distance_series
from scegen.motion.batch import stack_scenario
from scegen.motion.friction import friction_of
from scegen.motion.model import Trace
from scegen.scenario.concrete import ConcreteParticipant, ConcreteScenario
from scegen.scenario.objects import StaticObject
from scegen.scenario.vocabulary import HazardKind


@dataclass(frozen=True, slots=True)
class Encounter:
    """The closest approach of the ego's box to the box of ``other``, at step ``step``."""

    other: str
    step: int
    time_s: float
    distance_m: float


def closest_encounter(concrete: ConcreteScenario, traces: Mapping[str, Trace]) -> Encounter | None:
    """The closest approach to the ego, people before things; None where the ego is alone.

    Parked vehicles count only where nobody else is or a hazard names them, things only where they
    are an obstacle.
    """
    named = {name for hazard in concrete.hazards for name in (*hazard.by, *hazard.to)}
    others = [p for p in concrete.participants if p.id != concrete.ego.id]
    people = [p for p in others if not p.parked or p.id in named] or others
    met: list[ConcreteParticipant | StaticObject] = [*people]
    met += [thing for thing in concrete.objects if in_the_way(concrete, thing)]
    if not met:
        return None
    everybody = concrete.entities
    bodies = body_table(
        [entity.body for entity in everybody], friction=friction_of(concrete.environment)
    )
    ego = everybody.index(concrete.ego)
    pairs = np.array([(ego, everybody.index(one)) for one in met], dtype=np.int64)
    apart = distance_series(stack_scenario(concrete, traces).tracks, bodies, pairs)[0]
    nearest = int(apart.min(axis=0).argmin())
    step = int(apart[:, nearest].argmin())
    time_s = float(traces[concrete.ego.id].time_s[step])
    return Encounter(met[nearest].id, step, time_s, float(apart[step, nearest]))


def in_the_way(concrete: ConcreteScenario, thing: StaticObject) -> bool:
    """Whether a thing is there as an obstacle, and does not only hide somebody."""
    obstacles = [h for h in concrete.hazards if h.kind is HazardKind.OBSTACLE]
    return any(thing.id in hazard.by for hazard in obstacles)

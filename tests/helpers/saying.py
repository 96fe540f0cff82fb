"""Scenarios that are said by hand, made, and judged by their claims."""

from __future__ import annotations

from functools import cache

from scegen.claims import claims_of
from scegen.claims.hazards.scenes import judged_pairs
from scegen.criticality import Raised
from scegen.criticality.search.proving import examine
from scegen.enumeration import enumerate_scenarios
from scegen.motion.friction import friction_of
from scegen.pipeline.attempts import make_one
from scegen.pipeline.picking import pick
from scegen.pipeline.raising import chosen_target
from scegen.road import build_network
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.junction import ARM_COUNTS
from scegen.scenario.vocabulary import JunctionKind

KMH = 1 / 3.6


def person(name, kind="car", *, speed=None, **fields):
    """A participant; the one called ego is the ego; ``speed`` in km/h."""
    role = "ego" if name == "ego" else "other"
    given = {} if speed is None else {"speed_mps": speed * KMH}
    return {"id": name, "kind": kind, "role": role, **given, **fields}


def said(kind, *people, junction=None, **fields):
    """A functional scenario on a road of this kind."""
    arms = ARM_COUNTS[JunctionKind(kind)][0]
    road = {"kind": kind, "arms": arms, **(junction or {})}
    return FunctionalScenario.model_validate(
        {"description": "by hand", "junction": road, "participants": list(people), **fields}
    )


@cache
def made(functional, index=None, *, free=True):
    """Its first (or another) scenario with its danger raised, and the proof.

    Where the target is not ``free``, a near miss that cannot be had is missed.
    """
    listed = enumerate_scenarios(functional)
    scenario = pick(listed, None)[0] if index is None else listed.scenarios[index]
    target = chosen_target(None, functional)
    raising = make_one(functional, scenario, target, 0, free=free)
    return Raised(raising.concretes[0], next(iter(raising.proofs.values())))


def missed(functional, concrete, logical=None):
    """Ids of the claims that do not hold in a concrete scenario, simulated from its numbers."""
    network = build_network(concrete.road, name="x")
    ego = concrete.ego.id
    pairs = [(ego, e.id) for e in concrete.entities if e.id != ego]
    focus = list(dict.fromkeys([*judged_pairs(concrete), *pairs]))
    claims = claims_of(functional, logical or concrete.logical)
    evidence = examine(concrete, network, focus, friction_of(concrete.environment), claims=claims)
    return {claim.id for claim in evidence.claims if not claim.holds}

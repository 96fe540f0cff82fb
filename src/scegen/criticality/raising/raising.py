"""Raise the criticality of a concrete scenario: the stage between numbers and files."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from scegen.claims.hazards.scenes import Pair
from scegen.claims.ways import paths_of, ways_of
from scegen.criticality.proposals.advising import Advised, advised
from scegen.criticality.proposals.proposal import Proposer
from scegen.criticality.raising.braking_leader import braking_leaders
from scegen.criticality.raising.giving_up import blocking, give_up, out_of_reach
from scegen.criticality.raising.refusing import too_slow
from scegen.criticality.raising.stage import Stage
from scegen.criticality.search.optimize import Best, follow, search
from scegen.criticality.search.pairs import candidate_pairs
from scegen.criticality.search.problem import SEARCH_DT_S, Problem
from scegen.criticality.search.proving import PROOF_DT_S, Evidence
from scegen.criticality.search.rebuild import rebuilt
from scegen.criticality.target import AVOIDED, NEAR_MISS, Target, parse_target
from scegen.errors import InputError
from scegen.motion.trigger_steps import put_between_steps
from scegen.road import build_network
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import ConcreteScenario, door_of
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.proof import Proof

_ATTEMPTS = ((1.0, SEARCH_DT_S), (2.5, SEARCH_DT_S), (1.0, PROOF_DT_S), (2.5, PROOF_DT_S))
"""How far inside of the demands a search aims, and its steps, one after the other while the proof
in fine steps fails: one who creeps over a line passes it 0.3 s later in coarse steps."""
_AGAIN = {"rounds": 1, "restarts": 1}
"""Less effort where some of what is said cannot be met at all."""


@dataclass(frozen=True, slots=True)
class Raised:
    """The scenario found (or the one given, if none was) and its proof.

    ``others`` are different solutions of the same demands.
    """

    concrete: ConcreteScenario
    proof: Proof
    others: tuple[tuple[ConcreteScenario, Proof], ...] = ()


def raise_criticality(
    functional: FunctionalScenario | None,
    concrete: ConcreteScenario,
    *,
    target: str = NEAR_MISS,
    seed: int = 0,
    solutions: int = 1,
    proposer: Proposer | None = None,
    progress: Callable[[str], None] = lambda _: None,
) -> Raised:
    """Make every danger asked for happen at once, and bring the pair's measure into its band.

    Every claim holds meanwhile: what is possible at all comes first, then claims, then the target.
    Numbers change as little as that needs, within what is realistic; where no numbers do it and
    no danger is asked for that could, a leader brakes (see ``braking_leader``). The result is
    proved by simulating it anew from its own numbers at 0.01 s. Where the target cannot be
    reached, the claims alone are sought; the proof says what blocked it and what does not hold.

    Args:
        functional: what the description says; None if unknown.
        concrete: the scenario.
        target: ``near-miss``, ``collision`` or a band such as ``pet=0.3..1.0``.
        seed: of the search; the same seed gives the same result.
        solutions: how many different ones to look for.
        proposer: who proposes where to begin; None for a search without proposals.
        progress: told how far the search is.

    Raises:
        InputError: the target is none.
        MotionInfeasibleError, RoadInfeasibleError: the scenario itself cannot be built.
    """
    wanted = parse_target(target)
    network = build_network(concrete.road)
    stage, before = _aimed(functional, concrete, network, wanted)
    rng = np.random.Generator(np.random.PCG64(seed))
    reason = stage.blocked or too_slow(concrete, stage.pair)
    if not stage.pair and wanted.text == AVOIDED and stage.stands(before):  # nobody else is there
        return Raised(concrete, stage.proof(before, before, 1, None))
    touch = wanted.contact is True and bool(stage.pair) and stage.stands(before)
    if reason is not None and stage.pair and reason == stage.blocked and not wanted.contact:
        return _without_target(stage, stage.problem(), before, rng, reason)
    if reason is not None and not touch:
        return Raised(concrete, stage.proof(before, before, 1, reason))
    found: list[tuple[ConcreteScenario, Proof]] = []
    if stage.stands(before):
        bound = stage.finished(before)
        found.append((bound.concrete, stage.proof(before, bound, 1, None)))
        if solutions == 1:
            return Raised(*found[0])
    problem = stage.problem()
    problem.progress = progress
    advice = None
    if found:
        problem.known.append(problem.space.origin)
    else:
        give_up(stage, problem, out_of_reach(problem, before, rng))
        if proposer is not None:
            advice = advised(proposer, problem, concrete, stage.ways, before.hazards, seed=seed)
    blocked = _fill(found, solutions, stage, problem, before, rng, advice)
    if not found and problem.never:
        give_up(stage, problem, problem.never)
        _fill(found, solutions, stage, problem, before, rng, None)
    if not found and problem.apart:
        found = [
            (made, _with_advice(proof, advice, led=False))
            for made, proof in _by_braking(stage, problem, before, rng, solutions)
        ]
    if not found:
        raised = _without_target(stage, problem, before, rng, blocked)
        return Raised(raised.concrete, _with_advice(raised.proof, advice, led=False))
    return Raised(*found[0], others=tuple(found[1:]))


def _aimed(
    functional: FunctionalScenario | None,
    concrete: ConcreteScenario,
    network: RoadNetwork,
    target: Target,
) -> tuple[Stage, Evidence]:
    """Whom it is about: where nobody says who, rather those who stand already."""
    named = named_pair(functional, concrete)
    stage = Stage(functional, concrete, network, target, named)
    before = stage.examine(concrete)
    if named or concrete.hazards or stage.blocked or stage.stands(before):
        return stage, before
    for pair in stage.focus:
        if before.meets(stage.target, pair):
            other = Stage(functional, concrete, network, target, pair)
            shown = other.examine(concrete)
            if other.blocked is None and other.stands(shown):
                return other, shown
    return stage, before


def prove_as_it_is(
    functional: FunctionalScenario, concrete: ConcreteScenario, *, target: str = NEAR_MISS
) -> Proof:
    """What numbers that somebody gave show, none of them changed.

    Raises:
        InputError: the target is none, or somebody who is described does not take part.
        MotionInfeasibleError, RoadInfeasibleError: the scenario itself cannot be built.
    """
    missing = {p.id for p in functional.participants} - {p.id for p in concrete.participants}
    if missing:
        raise InputError(
            f"{', '.join(sorted(missing))} is described, but does not take part",
            where=concrete.name,
            hint="To make it without its description, copy concrete.yaml to a place of its own.",
        )
    network = build_network(concrete.road)
    between = named_pair(functional, concrete)
    stage = Stage(functional, concrete, network, parse_target(target), between)
    found = stage.examine(concrete)
    return stage.proof(found, found, 1, stage.blocked)


def named_pair(functional: FunctionalScenario | None, concrete: ConcreteScenario) -> Pair | None:
    """The pair that the description's outcome names, if both have a way of their own here."""
    between = functional.outcome.between if functional and functional.outcome else ()
    known = {entity.id for entity in concrete.entities}
    if len(between) != 2 or not {*between} <= known:
        return None
    first, second = (door_of(name) if door_of(name) in known else name for name in between)
    return first, second


def _by_braking(
    stage: Stage, problem: Problem, before: Evidence, rng: np.random.Generator, solutions: int
) -> list[tuple[ConcreteScenario, Proof]]:
    """What a leader that brakes makes of it, if anything."""
    found: list[tuple[ConcreteScenario, Proof]] = []
    pairs = candidate_pairs(stage.concrete)
    for pair, braking in braking_leaders(
        before, stage.network, stage.target, pairs, stage.friction
    ):
        other = Stage(stage.functional, braking, stage.network, stage.target, pair)
        other.given_up = stage.given_up
        if other.blocked is None:
            tried = other.problem()
            tried.evaluations, tried.progress = problem.evaluations, problem.progress
            _fill(found, solutions, other, tried, other.examine(stage.concrete), rng, None)
            problem.evaluations = tried.evaluations
        if found:
            break
    return found


def _without_target(
    stage: Stage, problem: Problem, before: Evidence, rng: np.random.Generator, reason: str | None
) -> Raised:
    """What holds every claim that can be held, where the target cannot be reached."""
    shown = before
    if not before.holds(stage.given_up):
        problem.untargeted = stage.untargeted = True
        made, _, _ = _solve(stage, problem, rng, None)
        shown = made or before
    shown = stage.ended(shown)
    return Raised(shown.concrete, stage.proof(before, shown, problem.evaluations, reason))


def _fill(
    found: list[tuple[ConcreteScenario, Proof]],
    solutions: int,
    stage: Stage,
    problem: Problem,
    before: Evidence,
    rng: np.random.Generator,
    advice: Advised | None,
) -> str | None:
    """Search until so many solutions are found; the reason why there is not one more, if so."""
    while len(found) < solutions:
        made, led, blocked = _solve(stage, problem, rng, None if found else advice)
        if made is None:
            return blocked
        evidence = stage.finished(made)
        proof = stage.proof(before, evidence, problem.evaluations, None)
        found.append((evidence.concrete, _with_advice(proof, advice, led=led)))
    return None


def _with_advice(proof: Proof, advised: Advised | None, *, led: bool) -> Proof:
    if advised is None:
        return proof
    advice = advised.advice.but(led=led)
    return proof.but(advice=advice)


def _solve(
    stage: Stage, problem: Problem, rng: np.random.Generator, advised: Advised | None
) -> tuple[Evidence | None, bool, str | None]:
    """Search until a candidate stands up to the proof; otherwise the reason why none does.

    In between, whether it was found from what was proposed. That is followed first, and forgotten
    if it leads nowhere: a scenario that is found without proposals is found with any.
    """
    if advised is not None and advised.lead is not None:
        problem.room, problem.dt_s = _ATTEMPTS[0]
        best = follow(problem, advised.lead)
        made = _evidence(stage, problem, best, advised.concrete) if best.found else None
        if made is not None and stage.stands(made):
            problem.known.append(best.x)
            return made, True, None
    reason = None
    for problem.room, problem.dt_s in _ATTEMPTS:
        best = search(problem, rng, **(_AGAIN if stage.given_up else {}))
        if not best.found:
            claims = {claim.id for claim in problem.claims}
            problem.never = frozenset(n for n, v in best.least.items() if v > 0.0 and n in claims)
            problem.apart = best.missing.get("target", 0.0) > 0.0
            return None, False, reason or blocking(problem, best)
        evidence = _evidence(stage, problem, best, stage.concrete)
        if stage.stands(evidence):
            problem.known.append(best.x)
            return evidence, False, None
        # What comes after the end of what was found must not count the next time.
        problem.duration_s = min(problem.duration_s, evidence.concrete.duration_s)
        reason = "what was found does not stand up to the proof in steps of 0.01 s"
    return None, False, reason


def _evidence(stage: Stage, problem: Problem, best: Best, concrete: ConcreteScenario) -> Evidence:
    """What the candidate found really shows; its changes are told from ``concrete`` on."""
    outcome = problem.evaluate(best.x[None, :])
    fresh = rebuilt(
        concrete,
        stage.ways,
        outcome.made,
        0,
        float(outcome.duration_s[0]),
        f"search for {stage.target.text}",
    )
    fresh = put_between_steps(fresh, paths_of(ways_of(fresh, stage.network)))
    return stage.examine(fresh)

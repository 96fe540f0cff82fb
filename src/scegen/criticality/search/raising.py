"""Raise the criticality of a concrete scenario: the stage between numbers and files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from scegen.criticality.friction import friction_of
from scegen.criticality.hazards.roles import culprits
from scegen.criticality.hazards.ways import Way, paths_of, ways_of
from scegen.criticality.proposals.advising import Advised, advised
from scegen.criticality.proposals.proposal import Proposer
from scegen.criticality.search.bounds import build_space
from scegen.criticality.search.optimize import Best, follow, search
from scegen.criticality.search.pairs import Pair, candidate_pairs, judged_pairs, scene_of
from scegen.criticality.search.problem import Problem, judged, lateral_limits, view_of
from scegen.criticality.search.proving import Evidence, examine, proof_of
from scegen.criticality.search.rebuild import rebuilt
from scegen.criticality.search.refusing import measurable, never_meet, too_fast, too_slow
from scegen.criticality.search.variables import Place, stands_at_s
from scegen.criticality.target import HEADWAY, NEAR_MISS, Target, parse_target
from scegen.motion.batch.arrays import Floats, Ints
from scegen.motion.batch.compilation import compile_program
from scegen.motion.batch.simulation import simulate_batch
from scegen.road import build_network
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import ConcreteScenario, DriveMotion
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.proof import Proof
from scegen.scenario.vocabulary import HazardKind

_FOCUS = 3
"""Pairs that are looked at for the target at first; more only where none of them will do."""
_MOST_TOUCHING = 6
_ROOMS = (1.0, 2.5, 5.0)
"""How far inside of the demands a search aims, if the proof in fine steps fails."""
_LONGER_S = 1.0


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
) -> Raised:
    """Make every danger asked for happen at once, and bring the pair's measure into its band.

    Numbers change as little as that needs, within what is realistic. The result is proved by
    simulating it anew from its own numbers at 0.01 s. Where it cannot be done, the scenario comes
    back as it was, and the proof says what blocked it.

    Args:
        functional: what the description says; None if unknown.
        concrete: the scenario.
        target: ``near-miss``, ``collision`` or a band such as ``pet=0.3..1.0``.
        seed: of the search; the same seed gives the same result.
        solutions: how many different ones to look for.
        proposer: who proposes where to begin; None for a search without proposals.

    Raises:
        InputError: the target is none.
        MotionInfeasibleError, RoadInfeasibleError: the scenario itself cannot be built.
    """
    wanted = parse_target(target)
    network = build_network(concrete.road, name=concrete.name)
    stage = _Stage(functional, concrete, network, wanted)
    reason = too_fast(functional) or stage.blocked or too_slow(concrete, stage.pair)
    before = examine(concrete, network, stage.focus, stage.friction)
    # Concretization knows no slippery roads: on those the numbers have to be brought in bounds.
    good = stage.stands(before) and stage.friction >= 1.0
    if reason is not None or good:
        proof = stage.proof(before, before, 1, reason)
        return Raised(concrete, proof)
    problem = stage.problem()
    rng = np.random.Generator(np.random.PCG64(seed))
    advice = stage.ask(proposer, problem, before, seed) if proposer is not None else None
    found: list[tuple[ConcreteScenario, Proof]] = []
    blocked = None
    for n in range(solutions):
        made, blocked = _solve(stage, problem, rng, advice if n == 0 else None)
        if made is None:
            break
        proof = stage.proof(before, made.evidence, problem.evaluations, None)
        found.append((made.evidence.concrete, _with_advice(proof, advice, led=made.led)))
    if not found:
        proof = stage.proof(before, before, problem.evaluations, blocked)
        return Raised(concrete, _with_advice(proof, advice, led=False))
    return Raised(*found[0], others=tuple(found[1:]))


@dataclass(frozen=True, slots=True)
class _Made:
    """A scenario that stands up to the proof; ``led``: found from what was proposed."""

    evidence: Evidence
    led: bool


def _with_advice(proof: Proof, advised: Advised | None, *, led: bool) -> Proof:
    if advised is None:
        return proof
    advice = advised.advice.model_copy(update={"led": led})
    return proof.model_copy(update={"advice": advice})


def _solve(
    stage: _Stage, problem: Problem, rng: np.random.Generator, advised: Advised | None
) -> tuple[_Made | None, str | None]:
    """Search until a candidate stands up to the proof; otherwise the reason why none does.

    What was proposed is followed first, and forgotten if it leads nowhere: a scenario that is found
    without proposals is found with any.
    """
    if advised is not None and advised.lead is not None:
        problem.room = _ROOMS[0]
        best = follow(problem, advised.lead)
        made = _evidence(stage, problem, best, advised.concrete) if best.found else None
        if made is not None and stage.stands(made):
            problem.known.append(best.x)
            return _Made(made, led=True), None
    reason = None
    for room in _ROOMS:
        problem.room = room
        best = search(problem, rng)
        if not best.found:
            return None, reason or _blocking(stage.concrete, best, stage.target)
        evidence = _evidence(stage, problem, best, stage.concrete)
        if stage.stands(evidence):
            problem.known.append(best.x)
            return _Made(evidence, led=False), None
        # What comes after the end of what was found must not count the next time.
        problem.duration_s = min(problem.duration_s, evidence.concrete.duration_s)
        reason = "what was found does not stand up to the proof in steps of 0.01 s"
    return None, reason


def _evidence(stage: _Stage, problem: Problem, best: Best, concrete: ConcreteScenario) -> Evidence:
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
    return examine(fresh, stage.network, stage.focus, stage.friction)


class _Stage:
    """What every part of one search shares."""

    def __init__(
        self,
        functional: FunctionalScenario | None,
        concrete: ConcreteScenario,
        network: RoadNetwork,
        target: Target,
    ) -> None:
        self.functional = functional
        self.concrete = concrete
        self.network = network
        self.friction = friction_of(concrete.environment)
        self.full = _from_outer_ends(concrete)
        self.ways: Mapping[str, Way] = ways_of(self.full, network)
        self.pair: Pair = ()  # type: ignore[assignment]
        self.blocked: str | None = None
        pairs = candidate_pairs(concrete)
        self.focus = list(dict.fromkeys([*judged_pairs(concrete), *pairs[:_FOCUS]]))
        self.scene = scene_of(concrete, paths_of(self.ways), self.focus, self.friction)
        self._choose_pair(target, pairs)
        self.target = self._with_headway(target)

    def _choose_pair(self, target: Target, pairs: list[Pair]) -> None:
        index = {p.id: i for i, p in enumerate(self.concrete.participants)}
        rest = list(pairs)
        while rest:
            known = {tuple(map(int, pair)): n for n, pair in enumerate(self.scene.pairs)}
            for pair in [p for p in rest if p in self.focus or p[::-1] in self.focus]:
                a, b = index[pair[0]], index[pair[1]]
                p = known.get((a, b), known.get((b, a)))
                rest.remove(pair)
                if p is not None and measurable(target, self.scene, p):
                    self.pair = pair
                    return
            if rest:
                self.focus += rest[:_FOCUS]
                self._rescene()
        self.blocked = never_meet(target, pairs)
        if pairs:
            self.pair = pairs[0]

    def _rescene(self) -> None:
        self.scene = scene_of(self.concrete, paths_of(self.ways), self.focus, self.friction)

    def _with_headway(self, target: Target) -> Target:
        """One who tailgates comes near enough by its headway."""
        follows_closely = any(
            hazard.kind is HazardKind.TAILGATING and set(self.pair) <= {*hazard.by, *hazard.to}
            for hazard in self.concrete.hazards
        )
        if target.text == NEAR_MISS and self.pair and follows_closely:
            return replace(target, choices=(*target.choices, HEADWAY))
        return target

    def problem(self) -> Problem:
        """The search problem."""
        program, base = compile_program(self.full, paths_of(self.ways))
        for i, participant in enumerate(self.concrete.participants):
            laid = self.ways[participant.id].laid
            if isinstance(participant.motion, DriveMotion) and laid is not None:
                base.start_m[0, i] = laid.path_s_m(participant.motion.start_m)
        duration = self.concrete.duration_s + _LONGER_S
        traces = simulate_batch(program, base, duration_s=duration)
        view = view_of(self.full, self.ways, self.scene, traces, self.friction)
        self._look_at_touching(view.summary.contact_s[0], view.scene.pairs)
        involved = {*self.pair}
        for hazard in self.concrete.hazards:
            involved |= {*culprits(self.concrete, hazard), *hazard.to}
        space = build_space(self.full, self.ways, base, involved=involved, friction=self.friction)
        for recipe in space.recipes:
            if recipe.place is Place.WAITED:
                begun = stands_at_s(base, traces, recipe.owner, recipe.phase - 1)[0]
                if np.isfinite(begun):
                    space.waits_s[recipe.phase] = recipe.trigger - float(begun)
        return Problem(
            concrete=self.full,
            ways=self.ways,
            program=program,
            space=space,
            scene=self.scene,
            target=self.target,
            pair=self.pair,
            friction=self.friction,
            duration_s=duration,
            lateral_mps2=lateral_limits(view, self.friction),
        )

    def ask(self, proposer: Proposer, problem: Problem, before: Evidence, seed: int) -> Advised:
        """Ask for proposals to begin at."""
        return advised(proposer, problem, self.concrete, self.ways, before.hazards, seed=seed)

    def stands(self, evidence: Evidence) -> bool:
        """Whether every danger happens and the target is met."""
        return evidence.all_happen and evidence.meets(self.target, self.pair)

    def _look_at_touching(self, contact_s: Floats, pairs: Ints) -> None:
        """Those who touch at first get all measures: PET leads a search out of a contact."""
        people = [p.id for p in self.concrete.participants]
        touching = [
            (people[int(a)], people[int(b)])
            for (a, b), t in zip(pairs, contact_s, strict=True)
            if not np.isnan(t)
        ]
        fresh = [p for p in touching if p not in self.focus and p[::-1] not in self.focus]
        if fresh:
            self.focus += fresh[:_MOST_TOUCHING]
            self._rescene()

    def proof(
        self, before: Evidence, after: Evidence, evaluations: int, blocked_by: str | None
    ) -> Proof:
        """The proof of the stage's search."""
        if not self.pair:
            return Proof(
                target=self.target.text,
                in_band=False,
                in_band_before=False,
                hazards=after.hazards,
                hazards_before=before.hazards,
                evaluations=evaluations,
                blocked_by=blocked_by,
            )
        return proof_of(
            self.target, self.pair, before, after, evaluations=evaluations, blocked_by=blocked_by
        )


def _from_outer_ends(concrete: ConcreteScenario) -> ConcreteScenario:
    """The scenario with every drive's way from the outer end of its arm."""
    people = tuple(
        p.model_copy(update={"motion": p.motion.model_copy(update={"start_m": 0.0})})
        if isinstance(p.motion, DriveMotion)
        else p
        for p in concrete.participants
    )
    return concrete.model_copy(update={"participants": people})


def _blocking(concrete: ConcreteScenario, best: Best, target: Target) -> str:
    """Which demands the best candidate misses, and whether any candidate met them at all."""
    hazards = judged(concrete)
    words = []
    for name, missed in sorted(best.missing.items(), key=lambda item: -item[1]):
        if missed <= 0.0:
            continue
        shown = target.text if name == "target" else name
        if name.startswith("hazard "):
            hazard = hazards[int(name.split()[1])]
            shown = f"{hazard.kind} by {', '.join(culprits(concrete, hazard)) or 'nobody'}"
        never = best.least.get(name, 0.0) > 0.0
        words.append(f"{shown} ({'never reached' if never else 'not together with the rest'})")
    return "blocked by " + ", ".join(words)

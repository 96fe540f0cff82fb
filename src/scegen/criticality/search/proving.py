"""The proof: what a scenario really shows, simulated anew in fine steps from its own numbers."""

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from scegen.claims.claim import Claim
from scegen.claims.hazards.judging import judge, number
from scegen.claims.hazards.scenes import Pair, scene_of
from scegen.claims.near_miss import Band
from scegen.claims.proving import prove
from scegen.claims.statements.dangers import claim_id
from scegen.claims.view import View, view_of
from scegen.claims.ways import paths_of, ways_of
from scegen.criticality.search.problem import PROVED, choice_missing, follows_from, target_missing
from scegen.criticality.target import AVOIDED, Target
from scegen.motion.batch.compilation import compile_program
from scegen.motion.batch.simulation import simulate_batch
from scegen.motion.trigger_steps import STEP_S
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.proof import ClaimProof, HazardProof, MeasureProof, Proof

PROOF_DT_S = 0.01
_AS_SAID = "what the text says of it decides, not the threshold"


@dataclass(frozen=True)
class Evidence:
    """What one scenario shows in fine steps, and in coarse ones once that is asked for."""

    concrete: ConcreteScenario
    view: View
    seen_in: Callable[[float], View]
    claimed: Sequence[Claim] = ()

    @cached_property
    def hazards(self) -> tuple[HazardProof, ...]:
        """How every danger happens, by its threshold."""
        return tuple(judge(self.view, hazard) for hazard in self.concrete.hazards)

    @cached_property
    def _coarse(self) -> View:
        """Players take longer steps, in which triggers fire later: what is said holds in both."""
        return self.seen_in(STEP_S)

    @cached_property
    def claims(self) -> tuple[ClaimProof, ...]:
        """How every claim holds: in the one and in the other."""
        return prove(self.claimed, self.view, self._coarse) if self.claimed else ()

    @cached_property
    def dangers(self) -> tuple[HazardProof, ...]:
        """Whether every danger happens: its statement decides, where there is one."""
        held = {claim.id: claim.holds for claim in self.claims} if self.hazards else {}
        found = []
        for place, hazard in enumerate(self.hazards):
            happens = held.get(claim_id(place, hazard.kind), hazard.happened)
            note = hazard.note if happens == hazard.happened else _AS_SAID
            found.append(hazard.but(happened=happens, note=note))
        return tuple(found)

    def holds(self, but: Collection[str] = ()) -> bool:
        """Whether every statement holds, but for those with these ids."""
        asked = [claim for claim in self.claimed if claim.id not in but]
        return all(claim.judge(self.view).margin[0] >= 0.0 for claim in asked) and all(
            claim.judge(self._coarse).margin[0] >= 0.0 for claim in asked
        )

    def unwanted(self, target: Target, pair: Pair) -> tuple[Pair, ...]:
        """Pairs that touch although they should not."""
        view = self.view
        wanted = view.pair(*pair) if pair and target.contact is not False else None
        return tuple(
            view.names_of(p)
            for p in view.touching()
            if (wanted is None or p != wanted[0]) and not follows_from(view, target, pair, p)[0]
        )

    def meets(self, target: Target, pair: Pair) -> bool:
        """Whether the target is met, with no unwanted contact."""
        missing = target_missing(self.view, target, pair, room=0.0)
        return bool(missing[0] <= 0.0) and not self.unwanted(target, pair)


def examine(
    concrete: ConcreteScenario,
    network: RoadNetwork,
    focus: Sequence[Pair],
    friction: float,
    *,
    claims: Sequence[Claim] = (),
) -> Evidence:
    """Simulate a scenario from nothing but its own numbers, and judge it and what is claimed of it.

    Raises:
        MotionInfeasibleError: somebody cannot move as its numbers say.
    """
    ways = ways_of(concrete, network)
    program, own = compile_program(concrete, paths_of(ways))
    scene = scene_of(concrete, paths_of(ways), focus, friction)

    def seen_in(step_s: float) -> View:
        traces = simulate_batch(program, own, duration_s=concrete.duration_s, dt_s=step_s)
        return view_of(concrete, ways, scene, traces, friction)

    return Evidence(concrete, seen_in(PROOF_DT_S), seen_in, claims)


def proof_of(
    target: Target,
    pair: Pair,
    before: Evidence,
    after: Evidence,
    *,
    evaluations: int,
    blocked_by: str | None,
) -> Proof:
    """The proof of one search, for files; without a pair that of dangers and claims alone."""
    settled = bool(pair) or target.text == AVOIDED  # one who is alone touches nobody
    deciding = None if target.contact or not pair else _deciding(after.view, target, pair)
    measure = "contact_time" if target.contact else "distance"
    if deciding is not None:
        measure = deciding.measure
    return Proof(
        target=target.text,
        in_band=settled and after.meets(target, pair),
        in_band_before=settled and before.meets(target, pair),
        measure=measure if pair else None,
        band=None if deciding is None else (deciding.low, deciding.high),
        pair=pair,
        measures=tuple(
            MeasureProof(
                name=proved.name,
                unit=proved.unit,
                before=number(before.view.of_pair(proved.field, *pair)[0]),
                after=number(after.view.of_pair(proved.field, *pair)[0]),
            )
            for proved in PROVED
            if pair
        ),
        hazards=after.dangers,
        hazards_before=before.dangers,
        claims=after.claims,
        unwanted_contacts=after.unwanted(target, pair) if pair else (),
        evaluations=evaluations,
        dt_s=PROOF_DT_S,
        changed=after.concrete != before.concrete,
        blocked_by=blocked_by,
    )


def _deciding(view: View, target: Target, pair: Pair) -> Band | None:
    """The first band of the choice that is met, or missed by the least; None if none is asked."""
    missing = [float(choice_missing(view, choice, pair, 0.0)[0]) for choice in target.choices]
    return target.choices[int(np.argmin(missing))][0] if missing else None

"""What every part of one search shares: whom it is about, what it runs on, what counts."""

from collections.abc import Mapping
from dataclasses import replace

from scegen.claims import claims_of, described_by
from scegen.claims.hazards.judging import number
from scegen.claims.hazards.scenes import Pair, judged_pairs, scene_of
from scegen.claims.near_miss import HEADWAY
from scegen.claims.view import View, view_of
from scegen.claims.ways import Way, paths_of, ways_of
from scegen.criticality.raising.aftermath import halted
from scegen.criticality.raising.refusing import measurable, never_meet
from scegen.criticality.reactivity.binding import bind_to_ego
from scegen.criticality.search.bounds import build_space
from scegen.criticality.search.lead_in import tailgates
from scegen.criticality.search.pairs import candidate_pairs
from scegen.criticality.search.problem import Problem, lateral_limits
from scegen.criticality.search.proving import Evidence, examine, proof_of
from scegen.criticality.search.stated import Stated
from scegen.criticality.target import AVOIDED, NEAR_MISS, Target, asks_for_measure
from scegen.errors import MotionInfeasibleError
from scegen.motion.batch.compilation import compile_program
from scegen.motion.batch.simulation import simulate_batch
from scegen.motion.friction import friction_of
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import ConcreteScenario, DriveMotion
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.proof import Proof
from scegen.scenario.reversing import BacksOut

_FOCUS = 3
"""Pairs that are looked at for the target at first; more only where none of them will do."""
_MOST_TOUCHING = 6
_LONGER_S = 1.0


class Stage:
    """What every part of one search shares; ``pair`` is whom it is about, None to choose."""

    def __init__(
        self,
        functional: FunctionalScenario | None,
        concrete: ConcreteScenario,
        network: RoadNetwork,
        target: Target,
        pair: Pair | None = None,
    ) -> None:
        self.functional = functional
        self.concrete = concrete
        self.network = network
        self.friction = friction_of(concrete.environment)
        self.full = _from_outer_ends(concrete)
        self.ways: Mapping[str, Way] = ways_of(self.full, network)
        self.pair: Pair = ()  # type: ignore[assignment]
        self.blocked: str | None = None
        pairs = candidate_pairs(concrete) if pair is None else [pair]
        if not pairs and target.text == AVOIDED:  # past what is parked, too, nobody is touched
            pairs = [(concrete.ego.id, p.id) for p in concrete.participants if p.parked]
        self.focus = list(dict.fromkeys([*judged_pairs(concrete), *pairs[:_FOCUS]]))
        self.scene = scene_of(concrete, paths_of(self.ways), self.focus, self.friction)
        self._choose_pair(target, pairs)
        self.target = self._with_headway(target)
        said = functional or described_by(concrete)
        touching = self.pair if target.contact is not False else ()
        asked = self.pair if asks_for_measure(target) else ()
        self.claims = claims_of(said, concrete.logical, touching=touching, brought_together=asked)
        self.given_up: frozenset[str] = frozenset()
        self.untargeted = False

    def _choose_pair(self, target: Target, pairs: list[Pair]) -> None:
        index = {entity.id: i for i, entity in enumerate(self.concrete.entities)}
        rest = list(pairs)
        while rest:
            known = {tuple(map(int, pair)): n for n, pair in enumerate(self.scene.pairs)}
            for pair in [p for p in rest if p in self.focus or p[::-1] in self.focus]:
                a, b = index[pair[0]], index[pair[1]]
                p = known.get((a, b), known.get((b, a)))
                rest.remove(pair)
                if p is None:
                    continue
                still = max(a, b) >= len(self.concrete.participants)
                if measurable(target, self.scene, p, still=still):
                    self.pair = pair
                    return
            if rest:
                self.focus += rest[:_FOCUS]
                self._rescene()
        self.blocked = never_meet(target, pairs, self.concrete)
        if pairs:
            self.pair = pairs[0]

    def _rescene(self) -> None:
        self.scene = scene_of(self.concrete, paths_of(self.ways), self.focus, self.friction)

    def _with_headway(self, target: Target) -> Target:
        """One who tailgates comes near enough by its headway."""
        if target.text == NEAR_MISS and self.pair and tailgates(self.concrete, self.pair):
            return replace(target, choices=(*target.choices, HEADWAY))
        return target

    def problem(self) -> Problem:
        """The search problem."""
        program, base = compile_program(self.full, paths_of(self.ways))
        # Triggers look at places counted from where everybody really starts.
        own, _ = compile_program(self.concrete, paths_of(ways_of(self.concrete, self.network)))
        program = program._replace(phases=own.phases)
        for i, participant in enumerate(self.concrete.participants):
            laid = self.ways[participant.id].laid
            if isinstance(participant.motion, DriveMotion) and laid is not None:
                base.start_m[0, i] = laid.path_s_m(participant.motion.start_m)
        duration = self.concrete.duration_s + _LONGER_S
        traces = simulate_batch(program, base, duration_s=duration)
        view = view_of(self.full, self.ways, self.scene, traces, self.friction)
        self._look_at_touching(view)
        involved = {*self.pair}
        for hazard in self.concrete.hazards:
            involved |= {*hazard.by, *hazard.to}
        space = build_space(
            self.full,
            self.ways,
            base,
            involved=involved,
            friction=self.friction,
            stated=Stated.of(self.functional),
        )
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
            claims=self.claims,
            given_up=self.given_up,
        )

    def examine(self, concrete: ConcreteScenario) -> Evidence:
        """What a scenario shows, and which of the claims hold."""
        return examine(concrete, self.network, self.focus, self.friction, claims=self.claims)

    def stands(self, evidence: Evidence) -> bool:
        """Whether every claim holds that is not given up, and the target is met."""
        met = self.untargeted or evidence.meets(self.target, self.pair)
        return met and evidence.holds(self.given_up)

    def _look_at_touching(self, view: View) -> None:
        """Those who touch at first get all measures: PET leads a search out of a contact."""
        touching = (view.names_of(p) for p in view.touching())
        fresh = [p for p in touching if p not in self.focus and p[::-1] not in self.focus]
        if fresh:
            self.focus += fresh[:_MOST_TOUCHING]
            self._rescene()

    def finished(self, found: Evidence) -> Evidence:
        """What was found, with those in danger bound to the ego, and collisions that halt.

        Either where that is possible, with all that holds without it.
        """
        shown = [found]

        def proved(tried: ConcreteScenario) -> bool:
            shown.append(self.examine(tried))
            return self.stands(shown[-1])

        made = bind_to_ego(found.concrete, self.network, self.meetings_s(found), proved)
        bound = next(evidence for evidence in shown if evidence.concrete is made)
        return self.ended(bound)

    def ended(self, found: Evidence) -> Evidence:
        """With collisions that halt, where all that holds then still does."""
        held = {claim.id for claim in found.claims if claim.holds}
        for scraping in (True, False):
            over = halted(found.concrete, found.view, scraping=scraping)
            if over is found.concrete:
                return found
            try:
                after = self.examine(over)
            except MotionInfeasibleError:
                continue  # the lane in which it would stay ends
            met = after.meets(self.target, self.pair) or not found.meets(self.target, self.pair)
            if met and held <= {c.id for c in after.claims if c.holds}:
                return after
        return found

    def meetings_s(self, found: Evidence) -> dict[str, list[float]]:
        """Whose danger with the ego it is, the target's partner first, and when it happens.

        Things do not wait for anybody, nor does who is said to drive at some speed or distance:
        who waits drives otherwise. Whom the ego passes does not gain speed then.
        """
        stated = Stated.of(self.functional)
        ego = self.concrete.ego.id
        passed = self.functional.overtaken(ego) if self.functional is not None else ()
        fixed = {*stated.speeds, *stated.placed, *passed} - {ego}
        people = {p.id for p in self.concrete.participants} - fixed
        pairs = [p for p in (self.pair, *judged_pairs(self.concrete)) if people >= {*p}]
        met = {frozenset(pair): pair for pair in pairs if ego in pair}
        meetings: dict[str, list[float]] = {}
        for both, pair in met.items():
            (name,) = both - {ego}
            times = [h.time_s for h in found.hazards if both <= {*h.by, *h.to}]
            times.append(number(found.view.of_pair("closest_s", *pair)[0]))
            meetings[name] = list(dict.fromkeys(time for time in times if time))
        return meetings

    def proof(
        self, before: Evidence, after: Evidence, evaluations: int, blocked_by: str | None
    ) -> Proof:
        """The proof of the stage's search."""
        return proof_of(
            self.target, self.pair, before, after, evaluations=evaluations, blocked_by=blocked_by
        )


def _from_outer_ends(concrete: ConcreteScenario) -> ConcreteScenario:
    """The scenario with every drive's way from the outer end of its arm.

    One that backs out has its own place to start.
    """
    people = (
        p.but(motion=p.motion.but(start_m=0.0))
        if isinstance(p.motion, DriveMotion) and not isinstance(p.motion.reversal, BacksOut)
        else p
        for p in concrete.participants
    )
    return concrete.changed(people)

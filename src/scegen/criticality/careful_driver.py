"""Verdict: could a careful and competent driver have avoided it?

The ego is driven by the reference driver of UN Regulation No. 157 (automated lane keeping systems,
Annex 3, first model; Appendix 3 to Annex 4 of its first version): it evaluates a perceivable risk
for 0.4 s, needs 0.75 s more until the brakes act, and then brakes with up to 0.774 g, reached
within 0.6 s. The figures were checked against two public implementations that cite the
regulation, the JRC's (ec-jrc/JRC-FSM, ``CC_human_driver``) and esmini's (``ControllerALKS_R157SM``,
``ReferenceDriver``): 0.4 s, 0.75 s, 0.774 x 9.81 m/s², 12.65 m/s³, lateral wandering 0.375 m,
critical time to collision 2.0 s; the regulation's own text could not be consulted. For cut-ins both
turn the 0.4 s into a lateral way of 0.72 m beyond the wandering.

The regulation defines this driver for cut-in, cut-out and deceleration on motorways. **Using it at
crossings, and for pedestrians, cyclists and oncoming traffic, is an extension of our own**: what is
perceivable is decided by the rule in :mod:`scegen.criticality.perception`, and the horizon is the
2 s of the regulation or, if longer, the time that this driver needs to stop. Published validation
(arXiv:2406.09493) found this model rather late against real near-crashes.

Simplifications: the driver keeps the scenario's path and speed program until the brakes act, never
steers, brakes to a standstill and stays; it does not lift the foot while it reacts (both
implementations slow by 0.4 m/s² meanwhile, and say that they are not sure). The others
keep their paths and programs; triggers that look at the ego are evaluated anew. Who never was a
perceivable danger and touches the ego only because it braked (a follower that does not react) is
named, but does not decide.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property

import numpy as np

from scegen.criticality.perception import perceivable_dangers
from scegen.measures.bodies import body_table
from scegen.measures.distance import distance_series
from scegen.motion.batch import compile_program, simulate_batch
from scegen.motion.batch.arrays import SPEED, BatchTraces, Bools, Floats
from scegen.motion.friction import GRAVITY_MPS2, friction_of
from scegen.motion.model import Path
from scegen.motion.standing import object_paths
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import AtTime, ConcreteScenario, SpeedPhase

RISK_EVALUATION_S = 0.4
DELAY_S = 0.75
DECELERATION_G = 0.774
JERK_MPS3 = DECELERATION_G * GRAVITY_MPS2 / 0.6
CRITICAL_TTC_S = 2.0
"""UN R157, Annex 3; see above."""
STEP_S = 0.01
_LOOK_EVERY = 5
_STAGES = 6
"""The rise of the deceleration is driven in so many stages of constant deceleration."""
_SPARE_STEP_S = 0.1
_MOST_SPARE_S = 3.0


class Outcome(StrEnum):
    """Whether the careful driver touches nobody that decides."""

    AVOIDABLE = "avoidable"
    UNAVOIDABLE = "unavoidable"


@dataclass(frozen=True, slots=True)
class Verdict:
    """What becomes of the scenario with a careful and competent driver as the ego.

    Times are on the scenario's clock (s), None if it does not come to that.

    Attributes:
        outcome: avoidable if nobody who decides is touched.
        contact_as_driven: whom the ego touches as the scenario drives it.
        danger: the participant that made the driver brake.
        perceived_s: since when it was perceivable without a break.
        brakes_s: when the brakes act, 1.15 s later.
        contact: whom the careful driver touches all the same.
        secondary: who touches it only because it braked.
        distance_m: smallest distance to those who decide, 0 in contact.
        contact_speed_mps: the ego's speed at the first such contact.
        spare_s: how much later the brakes could have acted and still avoided it; negative: how
            much earlier they would have had to; None if nothing within 3 s changes the outcome,
            or nothing called for braking. To 0.1 s.
    """

    outcome: Outcome
    contact_as_driven: tuple[str, ...]
    danger: str | None
    perceived_s: float | None
    brakes_s: float | None
    contact: tuple[str, ...]
    secondary: tuple[str, ...]
    distance_m: float
    contact_speed_mps: float | None
    spare_s: float | None


def hardest_mps2(body: Body, friction: float) -> float:
    """What the driver brakes with: no more than vehicle and road allow."""
    return min(DECELERATION_G * GRAVITY_MPS2, body.max_deceleration_mps2, friction * GRAVITY_MPS2)


def horizon_s(speed_mps: Floats, braking_mps2: float) -> Floats:
    """How far ahead the driver looks, for speeds of its own."""
    rise_s = braking_mps2 / JERK_MPS3
    stop_s = RISK_EVALUATION_S + DELAY_S + rise_s / 2 + speed_mps / braking_mps2
    return np.maximum(CRITICAL_TTC_S, stop_s)


def careful_driver_verdict(
    concrete: ConcreteScenario, paths: Mapping[str, Path], *, friction: float | None = None
) -> Verdict:
    """Let the careful and competent driver drive the ego, and see.

    ``paths`` are by participant, as :func:`scegen.motion.build_paths` makes them; ``friction`` is
    the coefficient between tyre and road, None for that of the environment.
    """
    grip = friction_of(concrete.environment) if friction is None else friction
    own = concrete.ego.but(on_contact=None)  # its own crash is no braking
    ways = {**paths, **object_paths(concrete)}
    return _Trial(concrete.with_participant(own), ways, grip).verdict()


@dataclass(frozen=True, slots=True)
class _Run:
    """One simulated run: movements, distances of the others from the ego (t, other)."""

    traces: BatchTraces
    distance_m: Floats


@dataclass(frozen=True)
class _Trial:
    concrete: ConcreteScenario
    paths: dict[str, Path]
    friction: float

    @cached_property
    def names(self) -> list[str]:
        return [entity.id for entity in self.concrete.entities]

    @cached_property
    def ego(self) -> int:
        return self.names.index(self.concrete.ego.id)

    @cached_property
    def others(self) -> list[str]:
        return [name for name in self.names if name != self.concrete.ego.id]

    @cached_property
    def bodies(self) -> Floats:
        return body_table([each.body for each in self.concrete.entities], friction=self.friction)

    @cached_property
    def deceleration_mps2(self) -> float:
        return hardest_mps2(self.concrete.ego.body, self.friction)

    @cached_property
    def as_driven(self) -> _Run:
        return self.run(self.concrete)

    def verdict(self) -> Verdict:
        driven = self.touched(self.as_driven)
        danger, perceived_s = self.first_danger()
        if danger is None or perceived_s is None:
            return self.told(self.as_driven, driven, None, set(self.others))
        brakes_s = perceived_s + RISK_EVALUATION_S + DELAY_S
        run = self.run(self.braking(brakes_s))
        deciding = {*driven, danger, *self.seen(run)}
        found = self.told(run, driven, (danger, perceived_s, brakes_s), deciding)
        if found.contact and not driven:
            # Braking into a contact that there was not: the driver may as well not have braked.
            found = self.told(self.as_driven, driven, (danger, perceived_s, None), deciding)
        return found

    def told(
        self,
        run: _Run,
        driven: set[str],
        reaction: tuple[str, float, float | None] | None,
        deciding: set[str],
    ) -> Verdict:
        touched = self.touched(run)
        contact = touched & deciding
        danger, perceived_s, brakes_s = reaction or (None, None, None)
        near = run.distance_m[:, [name in deciding for name in self.others]]
        spare = speed = None
        if brakes_s is not None and driven:
            spare = self.spare_s(brakes_s, deciding, avoided=not contact)
        if contact:
            step = int((near <= 0.0).any(axis=1).argmax())
            speed = float(run.traces.tracks[0, self.ego, SPEED, step])
        return Verdict(
            outcome=Outcome.UNAVOIDABLE if contact else Outcome.AVOIDABLE,
            contact_as_driven=self.sorted(driven),
            danger=danger,
            perceived_s=None if perceived_s is None else round(perceived_s, 2),
            brakes_s=None if brakes_s is None else round(brakes_s, 2),
            contact=self.sorted(contact),
            secondary=self.sorted(touched - deciding),
            distance_m=float(near.min()) if near.size else float("inf"),
            contact_speed_mps=speed,
            spare_s=spare,
        )

    def sorted(self, names: set[str]) -> tuple[str, ...]:
        return tuple(name for name in self.others if name in names)

    def run(self, concrete: ConcreteScenario) -> _Run:
        program, own = compile_program(concrete, self.paths)
        traces = simulate_batch(program, own, duration_s=self.concrete.duration_s, dt_s=STEP_S)
        pairs = [(self.ego, n) for n in range(len(self.names)) if n != self.ego]
        table = np.array(pairs, dtype=np.int64).reshape(-1, 2)
        return _Run(traces, distance_series(traces.tracks, self.bodies, table)[0])

    def touched(self, run: _Run) -> set[str]:
        nearest = run.distance_m.min(axis=0).tolist()
        return {name for name, least in zip(self.others, nearest, strict=True) if least <= 0.0}

    def dangers(self, run: _Run) -> Bools:
        tracks = np.ascontiguousarray(run.traces.tracks[0, :, :, ::_LOOK_EVERY])
        ahead_s = horizon_s(tracks[self.ego, SPEED], self.deceleration_mps2)
        ways = [self.paths[name] for name in self.names]
        return perceivable_dangers(tracks, self.bodies, ways, self.ego, ahead_s)

    def first_danger(self) -> tuple[str | None, float | None]:
        """Who first stays a perceivable danger for the whole evaluation, and from when (s)."""
        flags = self.until_contact(self.as_driven)
        step_s = STEP_S * _LOOK_EVERY
        needed = round(RISK_EVALUATION_S / step_s) + 1
        if flags.shape[1] < needed:
            return None, None
        windows = np.lib.stride_tricks.sliding_window_view(flags, needed, axis=1)
        lasting: Bools = np.all(windows, axis=2)
        first = np.where(lasting.any(axis=1), lasting.argmax(axis=1), lasting.shape[1])
        who = int(first.argmin())
        return (self.names[who], int(first[who]) * step_s) if lasting[who].any() else (None, None)

    def seen(self, run: _Run) -> set[str]:
        """Those who ever are a perceivable danger in a run, before they touch the ego."""
        return {self.names[n] for n in np.flatnonzero(self.until_contact(run).any(axis=1))}

    def until_contact(self, run: _Run) -> Bools:
        """The dangers of a run, of each participant until it touches the ego: (i, t)."""
        flags = self.dangers(run)
        for number, name in enumerate(self.others):
            hits = np.flatnonzero(run.distance_m[:, number] <= 0.0)
            if hits.size:
                flags[self.names.index(name), hits[0] // _LOOK_EVERY :] = False
        return flags

    def braking(self, brakes_s: float) -> ConcreteScenario:
        """The scenario with an ego that brakes to a standstill from a time on."""
        ego, people = self.concrete.ego, self.concrete.participants
        before = sum(len(p.speed_program) for p in people[: self.ego])
        fired = self.as_driven.traces.fired_step[0, before : before + len(ego.speed_program)]
        kept = int(((fired >= 0) & (fired * STEP_S < brakes_s)).sum())
        rise_s = self.deceleration_mps2 / JERK_MPS3
        stages = [(n / _STAGES, (n + 0.5) / _STAGES) for n in range(_STAGES)] + [(1.0, 1.0)]
        speed = self.as_driven.traces.tracks[0, self.ego, SPEED]
        step = min(int(brakes_s / STEP_S), len(speed) - 1)
        # Who brakes already does not brake less while the pedal goes down.
        already = float(speed[step - 1] - speed[step]) / STEP_S if step else 0.0
        phases = tuple(
            SpeedPhase(
                trigger=AtTime(time_s=brakes_s + share * rise_s),
                target_speed_mps=0.0,
                rate_mps2=max(level * self.deceleration_mps2, already),
            )
            for share, level in stages
        )
        driver = ego.but(speed_program=ego.speed_program[:kept] + phases)
        return self.concrete.with_participant(driver)

    def spare_s(self, brakes_s: float, deciding: set[str], *, avoided: bool) -> float | None:
        """The shift of the braking at which the outcome changes, see :class:`Verdict`."""
        sign = 1 if avoided else -1
        for number in range(1, round(_MOST_SPARE_S / _SPARE_STEP_S) + 1):
            shift = sign * number * _SPARE_STEP_S
            if brakes_s + shift < 0.0:
                return None
            now = not self.touched(self.run(self.braking(brakes_s + shift))) & deciding
            if now != avoided:
                return round(shift - _SPARE_STEP_S if avoided else shift, 1)
        return None

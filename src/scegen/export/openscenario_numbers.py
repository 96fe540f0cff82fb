"""The numbers of a storyboard: those of a concrete scenario, or what parameters make of them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from scegen.export.expressions import Expression, Number
from scegen.motion import simulate
from scegen.motion.model import STANDING_MPS, Path
from scegen.scenario.concrete import LATEST, ConcreteScenario

_BEFORE_END_S = 1.0
_SHORT_OF_REST_M = 0.1
"""Players come to rest some millimetres off, and must not wait for them."""


@dataclass(frozen=True, slots=True)
class PhaseNumbers:
    """When a phase of a speed program fires (s or m, by its trigger), and what it changes to."""

    trigger: Number
    target_speed_mps: Number
    rate_mps2: Number


@dataclass(frozen=True, slots=True)
class Start:
    """Where along a longer path, from ``along_m`` on the same as its own, somebody starts."""

    path: Path
    along_m: Expression


@dataclass(frozen=True, slots=True)
class Numbers:
    """What can differ between two files of one scenario, by participant.

    ``speeds_mps`` are those at the start; ``ego_goes_m`` is how far the ego has come shortly
    before the scenario is over. Who is not in ``starts`` starts where its path does.
    """

    speeds_mps: Mapping[str, Number]
    phases: Mapping[str, Sequence[PhaseNumbers]]
    duration_s: Number
    ego_goes_m: Number
    starts: Mapping[str, Start] = field(default_factory=dict)

    @property
    def latest_end_s(self) -> Number:
        """When it is over even if the ego has not come so far."""
        return LATEST * self.duration_s


def numbers_of(concrete: ConcreteScenario, paths: Mapping[str, Path]) -> Numbers:
    """Those of a concrete scenario."""
    return Numbers(
        speeds_mps={p.id: p.speed_mps for p in concrete.participants},
        phases={
            p.id: tuple(
                PhaseNumbers(
                    getattr(phase.trigger, phase.trigger.measured),
                    phase.target_speed_mps,
                    phase.rate_mps2,
                )
                for phase in p.speed_program
            )
            for p in concrete.participants
        },
        duration_s=concrete.duration_s,
        ego_goes_m=round(_ego_goes_m(concrete, paths), 3),
    )


def _ego_goes_m(concrete: ConcreteScenario, paths: Mapping[str, Path]) -> float:
    """How far the ego has come shortly before the end; a little less if it has stopped by then."""
    trace = simulate(concrete, paths)[concrete.ego.id]
    before = max(0.0, concrete.duration_s - _BEFORE_END_S)
    far = float(np.interp(before, trace.time_s, trace.s_m))
    stopped = np.interp(before, trace.time_s, trace.speed_mps) < STANDING_MPS
    return max(0.0, far - _SHORT_OF_REST_M) if stopped else far

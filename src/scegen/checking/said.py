"""What was said, judged on what is played: the claims of the description on a recording."""

from collections.abc import Callable
from pathlib import Path

import numpy as np

from scegen.checking.esmini.playing import Played
from scegen.checking.esmini.recording import Movement, RecordingError, read_recording
from scegen.checking.recording import record, trace_of
from scegen.checking.results import CheckResult, Finding, Severity, error, not_run, verdict
from scegen.checking.subject import Subject
from scegen.claims import View, claims_of, prove, view_of
from scegen.claims.hazards.scenes import judged_pairs, scene_of
from scegen.claims.ways import paths_of, ways_of
from scegen.errors import ScegenError
from scegen.motion.batch import BatchTraces, stack_traces
from scegen.motion.friction import friction_of
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.wording import counted

CHECKER = "said"
_BACK_M = 1e-4
"""Less movement against the heading in a step is rounding."""


def check_said(
    subject: Subject,
    scenario: Path,
    driven_from_outside: frozenset[str],
    once: Callable[[], Played],
) -> CheckResult:
    """Play a scenario, in esmini or else in our own simulation, and judge every statement.

    Nothing is judged where somebody is driven from outside, who does as it likes. ``once`` plays it
    in esmini, for others too.
    """
    concrete, functional = subject.concrete, subject.functional
    if concrete is None or functional is None:
        lacking = "concrete.yaml" if concrete is None else "functional.yaml"
        return not_run(CHECKER, f"there is no {lacking} that tells what was said")
    if driven_from_outside:
        return not_run(CHECKER, f"{min(driven_from_outside)} is driven from outside")
    missing = {p.id for p in functional.participants} - {p.id for p in concrete.participants}
    if missing:
        message = "is described but does not take part in concrete.yaml"
        return verdict(CHECKER, [error("said.participant", name, message) for name in missing])
    try:
        recorded = record(scenario, concrete, once)
        view = recorded_view(concrete, read_recording(recorded.csv))
    except (ScegenError, RecordingError) as problem:
        return not_run(CHECKER, str(problem))
    claims = claims_of(
        functional,
        concrete.logical,
        touching=subject.touching,
        brought_together=subject.brought_together,
    )
    proofs = prove(claims, view)
    findings = []
    for claim in proofs:
        if not claim.holds:
            words = f" ({claim.words!r})" if claim.words else ""
            message = f"{claim.statement}{words}: {claim.found}"
            findings.append(Finding(f"said.{claim.kind}", Severity.ERROR, claim.field, message))
    hold = len(proofs) - len(findings)
    detail = f"{hold} of {counted(len(proofs), 'statement')} hold in {recorded.player}"
    if functional.unjudged:
        detail += f"; {functional.unjudged}"
    return verdict(CHECKER, findings, detail)


def recorded_view(concrete: ConcreteScenario, recording: list[Movement]) -> View:
    """A recording as claims look at it.

    Raises:
        RecordingError: somebody is not in it.
        RoadInfeasibleError, MotionInfeasibleError: the numbers cannot be built.
    """
    ways = ways_of(concrete, build_network(concrete.road))
    ego = concrete.ego.id
    everybody = [(ego, entity.id) for entity in concrete.entities if entity.id != ego]
    focus = list(dict.fromkeys([*judged_pairs(concrete), *everybody]))
    friction = friction_of(concrete.environment)
    scene = scene_of(concrete, paths_of(ways), focus, friction)
    return view_of(concrete, ways, scene, _traces(concrete, recording), friction)


def _traces(concrete: ConcreteScenario, recording: list[Movement]) -> BatchTraces:
    """One candidate: the way gone counts as the place, the movement tells who reverses."""
    played = {movement.entity: movement for movement in recording}
    if lacking := [e.id for e in concrete.entities if e.id not in played]:
        raise RecordingError(f"{lacking[0]} does not take part in what is played")
    times = recording[0].time_s
    if len(times) < 2:
        raise RecordingError("it is over at once")
    batch = stack_traces([trace_of(played[e.id], e.body) for e in concrete.entities])
    for number, entity in enumerate(concrete.entities):
        movement = played[entity.id]
        along = (np.diff(movement.point) * np.exp(-1j * batch.heading_rad[0, 1:, number])).real
        speed = np.abs(movement.speed_mps)
        back = np.concatenate(([False], along < -_BACK_M))
        batch.speed_mps[0, :, number] = np.where(back, -speed, speed)
    return batch._replace(dt_s=float(np.median(np.diff(times))))

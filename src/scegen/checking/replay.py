"""Agreement with the reference player: does esmini show what our simulator predicts?

The file is played in steps of 0.05 s and compared with our own simulation at the same
step: every participant's position and heading over its whole trace, the time at which every phase
of a speed program fires, and which bodies touch, and when.

In the step that would go beyond the end of its path, an entity in esmini either does not move at
all (off the road) or takes the whole step (on a road), and then it stops: up to speed times step
short of the end or beyond it, where our simulator moves to the very end. From the step of our
arrival on, any place on that one step straight ahead counts as the predicted one.
"""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import combinations
from pathlib import Path as FilePath

import numpy as np

from scegen.checking.esmini.playing import NotPlayedError, Played, play
from scegen.checking.esmini.recording import Movement, RecordingError, read_recording
from scegen.checking.results import CheckResult, Finding, error, not_run, verdict
from scegen.errors import ScegenError
from scegen.measures import build_tables
from scegen.measures.distance import distance_series
from scegen.motion import build_paths
from scegen.motion.batch import compile_program, simulate_batch
from scegen.motion.batch.simulation import traces_of
from scegen.motion.model import Array, Trace
from scegen.motion.standing import object_paths
from scegen.motion.trigger_steps import STEP_S
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario

CHECKER = "replay"
P95_M = 0.05
MAX_M = 0.25
MAX_RAD = 0.1
EVENT_STEPS = 2
GRAZE_M = 0.02
"""Bodies that pass so closely may touch in one program and not in the other."""

_FIRED = re.compile(r"^\[([\d.]+)\] \[info\] (\S+_phase_\d+) standbyState -> ")
_CONTACT = re.compile(r"^\[([\d.]+)\] .*Collision between (\S+) and (\S+)")


@dataclass(frozen=True, slots=True)
class Prediction:
    """Our side: traces by participant, when phases fire, and when pairs first touch (s).

    ``distance_m`` is the smallest distance of every pair, 0 where they touch; ``overlaps`` are
    the pairs that touch in more than one step, which are no mere grazes; ``still`` says where
    things stand, x + iy.
    """

    traces: dict[str, Trace]
    fired_s: dict[str, float]
    contact_s: dict[frozenset[str], float]
    distance_m: dict[frozenset[str], float]
    overlaps: frozenset[frozenset[str]]
    still: dict[str, complex] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Agreement:
    """How well the play agrees with the prediction; all is well without findings.

    ``p95_m`` and ``max_m`` are over all participants and steps together.
    """

    p95_m: float
    max_m: float
    events: int
    contacts: int
    findings: tuple[Finding, ...]


def check_replay(
    scenario: FilePath, concrete: ConcreteScenario, once: Callable[[], Played] | None = None
) -> CheckResult:
    """Play a scenario file and compare it with the prediction from its concrete scenario.

    ``once`` plays it, for others too.
    """
    try:
        predicted = predict(concrete)
        played = once() if once is not None else play(scenario)
        recording = read_recording(played.recording)
    except NotPlayedError as reason:
        return not_run(CHECKER, str(reason))
    except (ScegenError, RecordingError) as problem:
        return verdict(CHECKER, [error("replay.played", scenario.name, str(problem))])
    found = compare(predicted, recording, played.log)
    detail = (
        f"positions p95 {100 * found.p95_m:.2f} cm, max {100 * found.max_m:.2f} cm; "
        f"{found.events} events, {found.contacts} contacts"
    )
    return verdict(CHECKER, found.findings, detail)


def predict(concrete: ConcreteScenario) -> Prediction:
    """Simulate a scenario at the player's step.

    Raises:
        InfeasibleError: the concrete scenario cannot be built.
    """
    paths = build_paths(concrete, build_network(concrete.road))
    program, candidate = compile_program(concrete, paths)
    batch = simulate_batch(program, candidate, duration_s=concrete.duration_s, dt_s=STEP_S)
    names = [
        f"{p.id}_phase_{number}"
        for p in concrete.participants
        for number in range(1, len(p.speed_program) + 1)
    ]
    steps = batch.fired_step[0].tolist()
    still = object_paths(concrete)
    scene = build_tables(
        [*(paths[p.id] for p in concrete.participants), *still.values()],
        [entity.body for entity in concrete.entities],
    )
    apart = distance_series(batch.tracks, scene.bodies, scene.pairs)[0]
    touching = apart == 0.0
    pairs = [frozenset((a.id, b.id)) for a, b in combinations(concrete.entities, 2)]
    return Prediction(
        traces_of(concrete, batch),
        {name: step * STEP_S for name, step in zip(names, steps, strict=True) if step >= 0},
        {
            pair: float(touching[:, n].argmax()) * STEP_S
            for n, pair in enumerate(pairs)
            if touching[:, n].any()
        },
        {pair: float(apart[:, n].min()) for n, pair in enumerate(pairs)},
        frozenset(pair for n, pair in enumerate(pairs) if touching[:, n].sum() > 1),
        {name: complex(path.start.x_m, path.start.y_m) for name, path in still.items()},
    )


def compare(predicted: Prediction, recording: list[Movement], log: str) -> Agreement:
    """Compare a play with a prediction."""
    played = {movement.entity: movement for movement in recording}
    findings: list[Finding] = []
    errors: list[Array] = []
    for name, trace in predicted.traces.items():
        if name not in played:
            findings.append(error("replay.missing", name, "does not take part in the play"))
            continue
        off = position_errors(trace, played[name].point)
        errors.append(off)
        findings += _positions(trace, off)
        findings += _headings(trace, played[name])
    for name, place in predicted.still.items():
        if name not in played:
            findings.append(error("replay.missing", name, "is not there in the play"))
        elif np.abs(played[name].point - place).max() > P95_M:
            findings.append(error("replay.position", name, "is not where it should stand"))
    phases = {event: time_s for (event,), time_s in _told(log, _FIRED).items()}
    contacts = {frozenset(pair): time_s for pair, time_s in _told(log, _CONTACT).items()}
    ends_s = max((len(t.x_m) - 1) * STEP_S for t in predicted.traces.values())
    findings += _events(predicted.fired_s, phases, ends_s)
    findings += _touching(predicted, contacts)
    every = np.concatenate(errors) if errors else np.zeros(1)
    p95 = float(np.percentile(every, 95))
    if p95 > P95_M:
        message = f"95 % of all positions are within {100 * p95:.1f} cm, not {100 * P95_M:g} cm"
        findings.append(error("replay.p95", "all participants", message))
    return Agreement(p95, float(every.max()), len(phases), len(contacts), tuple(findings))


def position_errors(trace: Trace, points: np.ndarray[tuple[int], np.dtype[np.complex128]]) -> Array:
    """Distance between predicted and played reference point by step, m.

    ``points`` are x + iy, and may be one step shorter than the prediction.
    """
    steps = min(len(points), len(trace.x_m))
    wanted = trace.x_m[:steps] + 1j * trace.y_m[:steps]
    off: Array = np.abs(points[:steps] - wanted)
    arrived = _arrival(trace)
    if arrived is not None and arrived < steps:
        before = complex(trace.x_m[arrived - 1], trace.y_m[arrived - 1])
        last = complex(trace.x_m[arrived], trace.y_m[arrived]) - before
        ahead = last / max(abs(last), 1e-12)
        rest = points[arrived:steps] - before
        step_m = float(trace.speed_mps[arrived - 1] * np.diff(trace.time_s[:2])[0])
        along = np.clip((rest * ahead.conjugate()).real, 0.0, step_m)
        off[arrived:] = np.abs(rest - along * ahead)
    return off


def _arrival(trace: Trace) -> int | None:
    """The step in which it is halted at the end of its path, None if it never is."""
    halted = np.flatnonzero((trace.speed_mps[1:] == 0.0) & (np.diff(trace.s_m) > 0.0))
    return int(halted[0]) + 1 if halted.size else None


def _positions(trace: Trace, off: Array) -> Iterator[Finding]:
    """``replay.position``, ``replay.end``: everywhere near, and to the end."""
    if len(off) < len(trace.x_m) - 1:
        message = f"is played for {len(off)} steps of {len(trace.x_m)}"
        yield error("replay.end", trace.participant, message)
    step = int(off.argmax())
    if off[step] > MAX_M:
        place = f"{trace.participant} t = {step * STEP_S:.2f} s"
        yield error("replay.position", place, f"is {off[step]:.2f} m from where it should be")


def _headings(trace: Trace, played: Movement) -> Iterator[Finding]:
    """``replay.heading``: the body points the same way, which tells reversing from driving."""
    steps = min(len(played.heading_rad), len(trace.heading_rad))
    off = np.abs(np.angle(np.exp(1j * (played.heading_rad[:steps] - trace.heading_rad[:steps]))))
    step = int(off.argmax())
    if off[step] > MAX_RAD:
        place = f"{trace.participant} t = {step * STEP_S:.2f} s"
        message = f"heads {np.degrees(off[step]):.1f} degrees away from where it should"
        yield error("replay.heading", place, message)


def _events(
    predicted: dict[str, float], played: dict[str, float], ends_s: float
) -> Iterator[Finding]:
    """``replay.event``: the same phases fire, within ``EVENT_STEPS`` steps.

    One that fires in the last of them may in the other have been due just after the end.
    """
    for name in sorted(predicted.keys() | played.keys()):
        ours, theirs = predicted.get(name), played.get(name)
        if ours is None or theirs is None:
            who = "esmini" if ours is None else "our simulator"
            when = theirs if ours is None else ours
            if when is not None and _steps_apart(when, ends_s) <= EVENT_STEPS:
                continue
            yield error("replay.event", name, f"fires at {when:.2f} s in {who} only")
        elif _steps_apart(ours, theirs) > EVENT_STEPS:
            yield error("replay.event", name, f"fires at {theirs:.2f} s, predicted {ours:.2f} s")


def _touching(predicted: Prediction, played: dict[frozenset[str], float]) -> Iterator[Finding]:
    """``replay.contact``: the same pairs touch, for the first time within ``EVENT_STEPS`` steps."""
    for pair in sorted(predicted.contact_s.keys() | played.keys(), key=sorted):
        ours, theirs = predicted.contact_s.get(pair), played.get(pair)
        place = " and ".join(sorted(pair))
        if ours is None:
            apart = predicted.distance_m.get(pair, np.inf)
            if apart > GRAZE_M:
                message = f"touch in esmini at {theirs:.2f} s; predicted {apart:.2f} m apart"
                yield error("replay.contact", place, message)
        elif theirs is None:
            if pair in predicted.overlaps:
                message = f"do not touch in esmini; predicted at {ours:.2f} s"
                yield error("replay.contact", place, message)
        elif _steps_apart(ours, theirs) > EVENT_STEPS:
            yield error("replay.contact", place, f"touch at {theirs:.2f} s, predicted {ours:.2f} s")


def _steps_apart(one_s: float, two_s: float) -> int:
    return abs(round(one_s / STEP_S) - round(two_s / STEP_S))


def _told(log: str, line: re.Pattern[str]) -> dict[tuple[str, ...], float]:
    """When esmini first says something of some, by their names, s."""
    times: dict[tuple[str, ...], float] = {}
    for found in filter(None, map(line.match, log.splitlines())):
        time, *names = found.groups()
        times.setdefault(tuple(sorted(names)), float(time))
    return times

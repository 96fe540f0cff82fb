"""Keep triggers clear of ties: no player's rounding shall decide in which step a phase fires.

Players add up how far somebody has come from rounded positions, across the corners of its
polyline; after a bend that is some millimetres short. A trigger that a step only just reaches
then fires a step later in one of two simulators, and a step at 5 m/s is a quarter of a metre.
"""

from collections.abc import Mapping

import numpy as np

from scegen.motion.batch import simulate
from scegen.motion.model import NEGLIGIBLE, STANDING_MPS, Array, Path, Trace
from scegen.road.geometry import Pose
from scegen.scenario.concrete import (
    ArrivalBelow,
    AtTime,
    Change,
    ConcreteParticipant,
    ConcreteScenario,
    SpeedPhase,
    StoodStill,
    Travelled,
    Trigger,
)

STEP_S = 0.05
"""The step that files are played with."""
_JUST_S = 0.006
_CLEAR = 0.02
"""Nearer than this (m or s) to what a step reaches is a tie."""
_DECIMALS = 3
_ROUNDING = 1e-9
_REASON = "clear of a tie between two steps"


def just_before_step_s(moment_s: float) -> float:
    """When a trigger is to fire for the step next to a moment: then it does in finer steps, too."""
    return max(round(moment_s / STEP_S) * STEP_S - _JUST_S, 0.0)


def put_between_steps(concrete: ConcreteScenario, paths: Mapping[str, Path]) -> ConcreteScenario:
    """The scenario with triggers moved to between two steps of 0.05 s where they tie with one.

    Every phase fires in the same step as before.

    Args:
        concrete: the scenario.
        paths: its paths by participant.
    """
    traces = simulate(concrete, paths, dt_s=STEP_S)
    changes: list[Change] = []
    people = [_clear(p, traces, paths, changes) for p in concrete.participants]
    return concrete.changed(people, changes) if changes else concrete


def _clear(
    participant: ConcreteParticipant,
    traces: Mapping[str, Trace],
    paths: Mapping[str, Path],
    changes: list[Change],
) -> ConcreteParticipant:
    program: list[SpeedPhase] = []
    after = -1
    for n, phase in enumerate(participant.speed_program):
        trigger = phase.trigger
        limit = float(getattr(trigger, trigger.measured))
        values = _values(trigger, participant.id, traces, paths)
        rises = isinstance(trigger, AtTime | Travelled | StoodStill)
        step = _fires(values, limit, after, rises=rises)
        if step is None:
            program += participant.speed_program[n:]
            break
        here = values[max(0, step - 1) : step + 1]
        movable = step > after + 1 and not isinstance(trigger, AtTime | StoodStill)
        middle = round(float(here.mean()), _DECIMALS) if movable and _ties(here, limit) else limit
        # A time of arrival rises again as one slows down: the middle may be reached sooner.
        if middle != limit and _fires(values, middle, after, rises=rises) == step:
            name = f"{participant.id}.speed_program.{n}.trigger.{trigger.measured}"
            changes.append(
                Change(parameter=name, by="rounding", before=limit, after=middle, reason=_REASON)
            )
            trigger = trigger.but(**{trigger.measured: middle})
        program.append(phase.but(trigger=trigger))
        after = step
    return participant.but(speed_program=tuple(program))


def _fires(values: Array, limit: float, after: int, *, rises: bool) -> int | None:
    """The first step after another in which a trigger holds, if there is one."""
    holds = values >= limit - _ROUNDING if rises else values < limit
    holds[: after + 1] = False
    return int(holds.argmax()) if holds.any() else None


def _ties(here: Array, limit: float) -> bool:
    """Whether a limit is next to one of two steps that are far enough apart to do better."""
    near = bool(np.abs(here - limit).min() < _CLEAR)
    return near and bool(np.isfinite(here).all()) and bool(abs(np.diff(here)).max() > 2 * _CLEAR)


def _values(
    trigger: Trigger, owner: str, traces: Mapping[str, Trace], paths: Mapping[str, Path]
) -> Array:
    """What the trigger looks at, by step (steps,)."""
    if isinstance(trigger, AtTime):
        return traces[owner].time_s
    subject = traces[trigger.participant]
    if isinstance(trigger, Travelled):
        return subject.s_m
    if isinstance(trigger, ArrivalBelow):
        place = paths[trigger.participant].pose(trigger.place_m)
        return arrivals_s(subject, subject.speed_mps, place)
    if isinstance(trigger, StoodStill):
        return _stands_s(subject)
    return np.hypot(traces[owner].x_m - subject.x_m, traces[owner].y_m - subject.y_m)


def _stands_s(trace: Trace) -> Array:
    """How long somebody has stood, -1 while it moves (steps,)."""
    moves = trace.speed_mps >= STANDING_MPS
    steps = np.arange(len(moves))
    last = np.maximum.accumulate(np.where(moves, steps, -1))
    return np.where(moves, -1.0, (steps - last - 1) * STEP_S)


def arrivals_s(who: Pose | Trace, speed_mps: Array | float, place: Pose) -> Array:
    """When one who is there is at a place if it goes straight to it at its speed; inf: never."""
    dx, dy = place.x_m - who.x_m, place.y_m - who.y_m
    away = np.hypot(dx, dy)
    ahead = dx * np.cos(who.heading_rad) + dy * np.sin(who.heading_rad) > 0.0
    defined = ahead & (away >= NEGLIGIBLE) & (np.asarray(speed_mps) >= NEGLIGIBLE)
    return np.where(defined, away / np.maximum(speed_mps, NEGLIGIBLE), np.inf)

"""From drafts to the concrete scenario, with its duration."""

from collections.abc import Mapping
from itertools import combinations

import numpy as np

from scegen.claims.ways import Way, paths_of, ways_of
from scegen.concretization.boxes import overlap
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.limits import LONGEST_DURATION_S, MAX_DURATION_S
from scegen.concretization.profile import SpeedChange
from scegen.concretization.reversing import as_it_comes
from scegen.concretization.setup import NeedsLongerArms, Setup
from scegen.concretization.walkers import leaves_s, partner_of
from scegen.concretization.written import as_they_come, written, written_phase, written_scenario
from scegen.errors import MotionInfeasibleError
from scegen.motion import simulate
from scegen.motion.model import STANDING_MPS, Path, Trace
from scegen.motion.trigger_steps import put_between_steps
from scegen.scenario.concrete import (
    ConcreteParticipant,
    ConcreteScenario,
    StoodStill,
    Travelled,
    Trigger,
)
from scegen.scenario.vocabulary import HazardKind

_INTO_EXIT_M, _SHORT_M = 20.0, 1e-3
_AFTER_S, _AFTER_REST_S = 1.0, 2.5
_NEAR_M, _CLOSING_MPS = 40.0, 0.5
_SOONER_S = 0.1
"""By so much sooner may one be at the end of its road in a player that takes other steps."""
_TURNS_MPS = 0.6
"""One that is to stand where it changes direction comes to rest some centimetres short of it."""


def assemble(scene: Setup, seed: int) -> ConcreteScenario:
    """The concrete scenario of a finished scene.

    Raises:
        MotionInfeasibleError: bodies overlap at the start, or somebody never leaves.
        NeedsLongerArms: somebody reaches the end of its road before the scenario ends.
    """
    people = [_participant(scene, each.id) for each in scene.functional.participants]
    concrete = written_scenario(
        scene, scene.road, people, scene.objects, scene.hazards,
        seed=seed, duration_s=MAX_DURATION_S, signals=scene.signals,
    )  # fmt: skip
    ways = ways_of(concrete, scene.network)
    paths = paths_of(ways)
    require_apart(concrete, paths)
    for lasts_s in (MAX_DURATION_S, LONGEST_DURATION_S):
        traces = simulate(concrete.but(duration_s=lasts_s), paths)
        _check_turns(traces, paths)
        duration = _duration_s(scene, traces, ways)
        if duration is not None:
            return put_between_steps(concrete.but(duration_s=duration), paths)
    raise MotionInfeasibleError(
        f"somebody has not left after {LONGEST_DURATION_S:.0f} s",
        hint="Raise the speeds or take a smaller junction.",
    )


def _participant(scene: Setup, name: str) -> ConcreteParticipant:
    if name in scene.drives:
        draft = scene.drives[name]
        course, start_s = draft.course, draft.start_s
        program = tuple(
            written_phase(scene, change, _trigger(scene, draft, change))
            for change in course.from_then(start_s)
        )
        motion = draft.motion(draft.laid.station_m(draft.start_m))
        speed = course.speed_then(start_s)
        return written(scene, name, motion, speed_mps=speed, program=program)
    if name in scene.stands:
        return written(scene, name, scene.stands[name].motion, parked=True)
    if name in scene.walks:
        # It steps off when the driver has come so far that both arrive together.
        walk = scene.walks[name]
        found, sets_off_s = partner_of(scene, walk), leaves_s(scene, walk.id)
        met = () if found is None else found[:1]
        for draft in met:
            scene.note(f"{name}.sets_off_s", sets_off_s, f"arrives when {draft.id} does")
        program = walk.program_by(met, sets_off_s, walk.path.length_m)
        return written(scene, name, walk.motion_at(walk.from_junction_m), program=program)
    raise MotionInfeasibleError("the logical scenario assigns it no way", where=name)


def _trigger(scene: Setup, draft: DriveDraft, phase: SpeedChange) -> Trigger:
    """What sets a change of speed off: whose coming, how long it stood, its place.

    Who stands from the start sets off, or goes back, as another comes, who waits when one has
    passed or it is green.
    """
    moment_s = draft.offset_s + phase.begins_s
    if draft.waits is not None and phase is draft.course.going_on:
        passing = [scene.drives[draft.waits.lets_by]] if draft.waits.lets_by is not None else []
        why = (
            f"{passing[0].id} has passed, who has right of way" if passing else "its light is green"
        )
        scene.note(f"{draft.id}.goes_s", moment_s, why)
        return as_they_come(passing, moment_s)
    backs = phase.hazard is HazardKind.REVERSING and draft.backs_to is None
    if backs or (scene.sets_off(draft.id) and phase.act == scene.speed_acts(draft.id)[0].id):
        others = [each for each in scene.concerned(draft.id) if each is not draft]
        if backs and others:
            return as_it_comes(draft, others[0], moment_s)
        return as_they_come(others[: not phase.timed], moment_s)
    if phase.then_s is not None:
        return StoodStill(participant=draft.id, duration_s=phase.then_s)
    return Travelled(participant=draft.id, distance_m=max(0.0, phase.s_m - draft.start_m))


def require_apart(concrete: ConcreteScenario, paths: Mapping[str, Path]) -> None:
    """Refuse a scenario in which two stand in each other at the start.

    Raises:
        MotionInfeasibleError: bodies overlap.
    """
    for first, second in combinations(concrete.participants, 2):
        if overlap(paths[first.id].start, first.body, paths[second.id].start, second.body):
            raise MotionInfeasibleError(
                f"{first.id} and {second.id} overlap at the start",
                hint="Fewer dangers at once, or another logical scenario.",
            )


def _check_turns(traces: Mapping[str, Trace], paths: Mapping[str, Path]) -> None:
    """Nobody goes from forwards to backwards, or on again, at speed."""
    for name, trace in traces.items():
        for place in (place for part in paths[name].backwards for place in part):
            passed = np.flatnonzero((trace.s_m[1:] > place) & (trace.s_m[:-1] <= place))
            if place > 0.0 and passed.size and trace.speed_mps[passed[0]] > _TURNS_MPS:
                raise MotionInfeasibleError(
                    f"does not stand where it changes direction, {place:.1f} m from its start, "
                    f"but goes {trace.speed_mps[passed[0]]:.1f} m/s",
                    where=name,
                    hint="Fewer dangers at once, or another logical scenario.",
                )


def _duration_s(scene: Setup, traces: Mapping[str, Trace], ways: Mapping[str, Way]) -> float | None:
    """Until everybody has left the junction and everything has happened; None if never."""
    ends: dict[str, float] = {}
    for name, trace in traces.items():
        way, rests = ways[name], trace.speed_mps < STANDING_MPS
        goal = way.goal_m
        if scene.network.plain and name in scene.drives:
            goal = max(goal, min(way.turn_end_m + _INTO_EXIT_M, way.path.length_m - _SHORT_M))
        stays = way.halts or bool(rests.all())
        if stays:
            # Who is to stand in the end has done all it does once it moves no more.
            done = np.flatnonzero(np.logical_and.accumulate(rests[::-1])[::-1])
        else:
            done = np.flatnonzero(trace.s_m >= goal)
        if not done.size:
            return None
        # One who comes to rest in the end is often nearest to another just then.
        ends[name] = float(trace.time_s[done[0]]) + (_AFTER_REST_S - _AFTER_S if stays else 0.0)
    duration = _until_past(scene, traces, max(ends.values()) + _AFTER_S)
    for name in scene.drives:
        trace = traces[name]
        stopped = trace.s_m >= ways[name].path.length_m - 1e-6
        if stopped.any():
            early = duration + _SOONER_S - float(trace.time_s[stopped.argmax()])
            if early > 0:
                # One who waits at the end of the road would be run over by the next.
                speed = float(trace.speed_mps[max(0, int(stopped.argmax()) - 1)])
                raise NeedsLongerArms(early * max(speed, 5.0) + 5.0, name)
    return round(duration * 20) / 20


def _until_past(scene: Setup, traces: Mapping[str, Trace], duration_s: float) -> float:
    """Until whoever is near the ego by then, and still comes nearer, has come past it."""
    own, lasts = traces[scene.functional.ego.id], [duration_s]
    for other in traces.values():
        apart = np.hypot(own.x_m - other.x_m, own.y_m - other.y_m)
        steps = np.flatnonzero(own.time_s >= duration_s)[:-1]
        closing = (apart[steps] - apart[steps + 1]) / np.diff(own.time_s)[steps]
        if steps.size and apart[steps[0]] < _NEAR_M and closing[0] > _CLOSING_MPS:
            past = steps[closing <= 0.0]
            lasts += [float(own.time_s[step]) + _AFTER_REST_S for step in past[:1]]
    return max(lasts)

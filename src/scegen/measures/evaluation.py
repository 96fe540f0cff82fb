"""All measures of many candidates at once: the worst value over time for each pair.

Every candidate is simulated into the same small scratch memory and measured while it lies in the
processor's cache; whole movements of thousands of candidates would not fit.
"""

from math import nan
from typing import NamedTuple

import numpy as np

from scegen.measures.bodies import body_of
from scegen.measures.distance import closest_approach
from scegen.measures.drac import highest_drac
from scegen.measures.following import write_gaps
from scegen.measures.headway import least_headway
from scegen.measures.impact import delta_v, relative_speed
from scegen.measures.injury import injury_probability
from scegen.measures.occlusion import occlusion_times
from scegen.measures.post_encroachment import post_encroachment_time
from scegen.measures.registry import MEASURES, Subject
from scegen.measures.required_braking import highest_before_area, highest_behind_leader
from scegen.measures.tables import Tables
from scegen.measures.time_to_collision import least_time_to_collision
from scegen.motion.batch.arrays import BatchTraces, Candidates, Floats, Program, empty_traces
from scegen.motion.batch.kernels import kernel
from scegen.motion.batch.stepping import run_candidate


class Summary(NamedTuple):
    """The worst over time, by candidate and pair: (c, p), those of one of the pair (c, p, 2).

    The meanings are those of the files in ``measures``; ``measures.registry`` lists units and
    directions. After the first contact of a pair nothing more is measured for it (but PET, which
    looks at the whole run). ``closest_s`` is the first time of the smallest distance,
    ``contact_s`` that of the first contact. Occlusions: (c, q).
    """

    distance_m: Floats
    closest_s: Floats
    contact_s: Floats
    ttc_s: Floats
    pet_s: Floats
    headway_s: Floats
    drac_mps2: Floats
    required_mps2: Floats
    brake_threat: Floats
    impact_mps: Floats
    delta_v_mps: Floats
    injury: Floats
    occluded_s: Floats
    sight_s: Floats


def evaluate(
    program: Program,
    candidates: Candidates,
    scene: Tables,
    *,
    duration_s: float,
    dt_s: float = 0.05,
) -> Summary:
    """Simulate candidates and measure them, without keeping the movements.

    Args:
        program: paths and structure of the speed programs.
        candidates: the numbers that differ.
        scene: made from the same paths.
        duration_s: simulated time, s; the steps are 0 to round(duration / dt).
        dt_s: time step, s; 0.05 to search, at most 0.01 to prove.
    """
    steps = round(duration_s / dt_s) + 1
    count, participants = candidates.speed_mps.shape
    scratch = empty_traces(1, steps, participants, candidates.trigger.shape[1], dt_s)
    summary = _room(count, scene)
    _evaluate(program, candidates, scene, scratch, summary)
    return summary


def measure(traces: BatchTraces, scene: Tables) -> Summary:
    """Measure movements that exist already.

    Args:
        traces: movements along the scene's paths, from the batch simulator or ``stack_traces``.
        scene: bodies, pairs, shared lanes and conflict areas.
    """
    summary = _room(traces.tracks.shape[0], scene)
    _measure(traces, scene, summary)
    return summary


def _room(candidates: int, scene: Tables) -> Summary:
    """A summary in which everything is undefined."""
    shapes = {
        Subject.PAIR: (candidates, len(scene.pairs)),
        Subject.EACH: (candidates, len(scene.pairs), 2),
        Subject.OCCLUSION: (candidates, len(scene.occlusions)),
    }
    subjects = {known.field: known.subject for known in MEASURES}
    fields = (subjects.get(field, Subject.PAIR) for field in Summary._fields)
    return Summary(*(np.full(shapes[subject], nan) for subject in fields))


@kernel
def _evaluate(
    program: Program, candidates: Candidates, scene: Tables, scratch: BatchTraces, out: Summary
) -> None:
    tracks = scratch.tracks[0]
    room = np.empty(tracks.shape[2])
    for c in range(candidates.speed_mps.shape[0]):
        run_candidate(program, candidates, c, scratch.dt_s, tracks, scratch.fired_step[0], -1)
        _measure_one(tracks, scratch.dt_s, scene, room, out, c)


@kernel
def _measure(traces: BatchTraces, scene: Tables, out: Summary) -> None:
    room = np.empty(traces.tracks.shape[3])
    for c in range(traces.tracks.shape[0]):
        _measure_one(traces.tracks[c], traces.dt_s, scene, room, out, c)


@kernel
def _measure_one(
    tracks: Floats, dt_s: float, scene: Tables, room: Floats, out: Summary, c: int
) -> None:
    """Measure one candidate, whose tracks these are, into row ``c`` of the summary.

    ``room`` (steps,) is room to work in.
    """
    for p in range(scene.pairs.shape[0]):
        a, b = tracks[scene.pairs[p, 0]], tracks[scene.pairs[p, 1]]
        body_a = body_of(scene.bodies, scene.pairs[p, 0])
        body_b = body_of(scene.bodies, scene.pairs[p, 1])
        distance, step, contact = closest_approach(a, b, body_a, body_b, room)
        last = step if contact else a.shape[1] - 1
        out.distance_m[c, p] = distance
        out.closest_s[c, p] = step * dt_s
        out.ttc_s[c, p] = least_time_to_collision(a, b, body_a, body_b, last, room)
        if contact:
            speed = relative_speed(a, b, step)
            out.contact_s[c, p] = step * dt_s
            out.impact_mps[c, p] = speed
            change = delta_v(speed, body_a.mass_kg, body_b.mass_kg)
            out.delta_v_mps[c, p, 0] = change
            out.injury[c, p, 0] = injury_probability(body_a, speed, change)
            change = delta_v(speed, body_b.mass_kg, body_a.mass_kg)
            out.delta_v_mps[c, p, 1] = change
            out.injury[c, p, 1] = injury_probability(body_b, speed, change)
        following = scene.following
        headway_a, drac_a, braking_a = _behind(
            a, b, body_a.front_m, dt_s, following.rear_m, following.first[p, 0], last, room
        )
        headway_b, drac_b, braking_b = _behind(
            b, a, body_b.front_m, dt_s, following.rear_m, following.first[p, 1], last, room
        )
        out.headway_s[c, p] = np.fmin(headway_a, headway_b)
        out.drac_mps2[c, p] = np.fmax(drac_a, drac_b)
        pet = nan
        for n in range(scene.areas.first[p], scene.areas.first[p + 1]):
            enter, leave = scene.areas.enter_m[n], scene.areas.leave_m[n]
            pet = np.fmin(pet, post_encroachment_time(a, b, enter, leave, dt_s))
            braking_a = max(braking_a, highest_before_area(a, b, enter, leave, 0, last))
            braking_b = max(braking_b, highest_before_area(b, a, enter, leave, 1, last))
        out.pet_s[c, p] = pet
        out.required_mps2[c, p, 0], out.required_mps2[c, p, 1] = braking_a, braking_b
        out.brake_threat[c, p, 0] = braking_a / body_a.available_mps2
        out.brake_threat[c, p, 1] = braking_b / body_b.available_mps2
    for q in range(scene.occlusions.shape[0]):
        out.occluded_s[c, q], out.sight_s[c, q] = occlusion_times(
            tracks, scene.bodies, scene.occlusions[q], dt_s
        )


@kernel
def _behind(
    own: Floats,
    other: Floats,
    front_m: float,
    dt_s: float,
    rear_m: Floats,
    first: int,
    last: int,
    gaps: Floats,
) -> tuple[float, float, float]:
    """Least headway, highest DRAC and required braking of one behind the other."""
    if not write_gaps(own, other, front_m, rear_m, first, gaps[: last + 1]):
        return nan, nan, 0.0
    return (
        least_headway(own, gaps, last),
        highest_drac(own, other, gaps, last),
        highest_behind_leader(own, other, gaps, dt_s, last),
    )

"""What the player plays: one concrete scenario with its movement, as JSON-able data.

The format is part of the contract with pages; docs/reference/json.md has it. Positions are those of
the reference point in the world, 20 a second; whatever no longer changes is cut off, so that a
series holds its last value to the end.
"""

from collections.abc import Mapping

import numpy as np

from scegen.criticality.search.proving import PROOF_DT_S
from scegen.motion import build_paths, simulate
from scegen.motion.model import Array, Path, Trace
from scegen.report.player.meetings import Meetings, meetings_of
from scegen.report.player.moments import claim_data, moments
from scegen.report.player.roads import road_data
from scegen.report.player.series import Data, compact, points
from scegen.road import build_network
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import ConcreteParticipant, ConcreteScenario
from scegen.scenario.objects import StaticObject
from scegen.scenario.proof import Proof

STEP_S = 0.05
_LEAD_S, _REST_S = 4.0, 2.5
"""What is shown before and after the moment that matters."""


def player_scene(
    concrete: ConcreteScenario,
    network: RoadNetwork,
    traces: Mapping[str, Trace],
    proof: Proof | None = None,
    *,
    paths: Mapping[str, Path] | None = None,
    title: str = "",
) -> Data:
    """A scene for the player; the same input gives the same data.

    ``traces`` are at the same evenly spaced times from 0 on; the finer, the nearer are the plotted
    extremes to those of the proof, which says what to show and whom it is about. ``paths`` are
    built here if not given; ``title`` is what it is called where two are compared.

    Raises:
        MotionInfeasibleError: the numbers cannot be built.
    """
    paths = build_paths(concrete, network) if paths is None else paths
    meetings = meetings_of(concrete, paths, traces, proof.pair if proof else ())
    others = [entity.id for entity in concrete.entities if entity.id != concrete.ego.id]
    colour = {concrete.ego.id: 0} | {name: n for n, name in enumerate(others, start=1)}
    return {
        "format": 1,
        "name": concrete.name,
        "title": title,
        "duration_s": round(_end_s(traces), 3),
        "step_s": STEP_S,
        "ego": concrete.ego.id,
        "pair": list(meetings.pair),
        "moment_s": None if meetings.moment_s is None else round(meetings.moment_s, 2),
        "critical_s": _critical_s(meetings, _end_s(traces)),
        "road": road_data(concrete, network, paths),
        "participants": [
            _participant(p, traces[p.id], paths[p.id], colour[p.id]) for p in concrete.participants
        ],
        "objects": [_object(thing, colour[thing.id]) for thing in concrete.objects],
        **meetings.data(STEP_S),
        "claims": [claim_data(claim, concrete, traces) for claim in proof.claims] if proof else [],
        "moments": moments(concrete, traces, proof, meetings),
    }


def scene_of(
    concrete: ConcreteScenario, proof: Proof | None = None, *, first: bool = False
) -> Data:
    """A scenario simulated as finely as in its proof, for the player.

    Of a ``first`` timing the proof says only whom it is about.

    Raises:
        RoadInfeasibleError, MotionInfeasibleError: the numbers cannot be built.
    """
    network = build_network(concrete.road)
    paths = build_paths(concrete, network)
    traces = simulate(concrete, paths, dt_s=PROOF_DT_S)
    if first and proof is not None:
        proof = proof.but(claims=(), hazards=())
    return player_scene(concrete, network, traces, proof, paths=paths)


def _end_s(traces: Mapping[str, Trace]) -> float:
    return float(next(iter(traces.values())).time_s[-1])


def _critical_s(meetings: Meetings, end_s: float) -> list[float]:
    """The seconds that are worth to be looked at again and again."""
    if meetings.moment_s is None:
        return [0.0, round(end_s, 3)]
    low = max(0.0, meetings.moment_s - _LEAD_S)
    return [round(low, 2), round(min(end_s, meetings.moment_s + _REST_S), 2)]


def _participant(one: ConcreteParticipant, trace: Trace, path: Path, colour: int) -> Data:
    body = one.body
    times = np.arange(round(float(trace.time_s[-1]) / STEP_S) + 1) * STEP_S

    def sampled(series: Array, digits: int) -> list[float | None]:
        return compact(np.interp(times, trace.time_s, series).tolist(), digits)

    heading = np.interp(trace.s_m, path.s_m, path.heading_rad) if len(path.s_m) > 1 else None
    backwards = [
        [round(float(trace.time_s[inside[0]]), 2), round(float(trace.time_s[inside[-1]]), 2)]
        for low, high in path.backwards
        if heading is not None
        and len(inside := np.flatnonzero((trace.s_m > low) & (trace.s_m < high)))
    ]
    return {
        "id": one.id,
        "kind": one.kind.value,
        "role": one.role.value,
        "parked": one.parked,
        "colour": colour,
        "length_m": body.length_m,
        "width_m": body.width_m,
        "height_m": body.height_m,
        "ahead_m": body.centre_ahead_m,
        "x_m": sampled(trace.x_m, 2),
        "y_m": sampled(trace.y_m, 2),
        "heading_rad": sampled(trace.heading_rad, 4),
        "speed_mps": sampled(np.abs(trace.speed_mps), 3),
        "backwards_s": backwards,
        "way": _way(path),
    }


def _way(path: Path) -> list[float]:
    """The planned way, x and y in turn, without the vertices that a straight line needs not."""
    if len(path.s_m) < 2:
        return []
    turns = np.abs(np.diff(path.heading_rad)) > 1e-6
    keep = np.concatenate(([True], turns[1:] | turns[:-1], [True]))
    return points(np.column_stack((path.x_m[keep], path.y_m[keep])).ravel().tolist())


def _object(thing: StaticObject, colour: int) -> Data:
    return {
        "id": thing.id,
        "what": thing.what,
        "category": thing.category.value,
        "colour": colour,
        "length_m": thing.length_m,
        "width_m": thing.width_m,
        "height_m": thing.height_m,
        "x_m": round(thing.x_m, 2),
        "y_m": round(thing.y_m, 2),
        "heading_rad": round(float(np.deg2rad(thing.heading_deg)), 4),
    }

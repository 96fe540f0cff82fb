"""What a proposer is shown, made from a search problem."""

from collections.abc import Sequence
from math import inf

import numpy as np

from scegen.claims.hazards.judging import number
from scegen.claims.view import View
from scegen.criticality.proposals.parameters import parameters_of
from scegen.criticality.proposals.proposal import Encounter, Passage, Situation
from scegen.criticality.proposals.reaching import explored
from scegen.criticality.search.problem import PROVED, Problem
from scegen.measures.following import SPACING_M
from scegen.motion.batch.arrays import Floats
from scegen.scenario.proof import HazardProof


def situation_of(problem: Problem, hazards: tuple[HazardProof, ...]) -> Situation:
    """The situation before the search; ``hazards`` as they are now."""
    space = problem.space
    view = problem.view(space.candidates(space.origin[None, :]))
    parameters = parameters_of(problem.concrete, space)
    encounters = tuple(_encounters(view))
    return Situation(
        concrete=problem.concrete,
        target=problem.target,
        pair=problem.pair,
        parameters=parameters,
        hazards=hazards,
        measures=tuple(
            (measure.name, number(view.of_pair(measure.field, *problem.pair)[0]), measure.unit)
            for measure in PROVED
        ),
        encounters=encounters,
        contacts=tuple(view.names_of(p) for p in view.touching()),
        explore=lambda: explored(problem, parameters, _places_m(encounters)),
    )


def _places_m(encounters: Sequence[Encounter]) -> dict[str, float]:
    """Where everybody comes to its first encounter."""
    places: dict[str, float] = {}
    for met in encounters:
        for name, passage in zip((met.first, met.second), met.passages, strict=True):
            places.setdefault(name, passage.enters_m)
    return places


def _encounters(view: View) -> list[Encounter]:
    """The closest meeting of every pair that has a conflict area, in the order of time."""
    found, movers = [], len(view.concrete.participants)
    for p, pair in enumerate(view.scene.pairs):
        if pair.max() >= movers:
            continue  # a thing comes at no time
        met = []
        for area in view.areas(*view.names_of(p)):
            names, edges = [*view.names_of(p)], (area[:2], area[2:])
            passages = [
                Passage(_time_s(view, name, comes_m), _time_s(view, name, goes_m), comes_m)
                for name, (comes_m, goes_m) in zip(names, edges, strict=True)
            ]
            if passages[1].enters_s < passages[0].enters_s:
                passages.reverse()
                names.reverse()
            first, second = passages
            gap = second.enters_s - first.leaves_s
            # else somebody starts beyond it
            if np.isfinite(gap) and min(first.leaves_s, second.leaves_s) > 0.0:
                behind = _least_behind_s(view, leader=names[0], follower=names[1])
                both = names[0], names[1]
                met.append(Encounter(*both, gap, min(gap, behind), (first, second)))
        if met:
            found.append(min(met, key=lambda e: e.gap_s))
    return sorted(found, key=lambda e: (e.passages[1].enters_s, e.first, e.second))


def _least_behind_s(view: View, *, leader: str, follower: str) -> float:
    """The least time after which a follower's front is where the leader's rear was; inf: nowhere.

    Over the places that the leader comes by in the lane that both share.
    """
    first = view.rows_behind(follower, leader)
    if first < 0:
        return inf
    begin, end = view.place_m(leader)[0, [0, -1]] / SPACING_M
    n = np.arange(int(np.ceil(begin)), int(end) + 1)
    rear: Floats = view.scene.following.rear_m[first + n]
    front = view.scene.bodies[view.index[follower], 4]
    behind = _times_s(view, follower, rear - front)
    ahead = _times_s(view, leader, np.asarray(n * SPACING_M, dtype=np.float64))
    gaps = np.subtract(behind, ahead)
    return float(np.min(gaps[np.isfinite(gaps)], initial=inf))


def _time_s(view: View, name: str, place_m: float) -> float:
    """When somebody reaches a place on its path; 0 if it starts beyond it, inf if it never does."""
    return float(np.nan_to_num(_times_s(view, name, np.array([place_m])), posinf=inf)[0])


def _times_s(view: View, name: str, at_m: Floats) -> Floats:
    """When somebody reaches places on its path; inf where it never does, nan behind its start."""
    places = view.place_m(name)[0]
    times = np.arange(len(places)) * view.dt_s
    reached = np.interp(at_m, places, times)
    reached = np.where(at_m > places[-1], inf, reached)
    return np.where(at_m < places[0], np.nan, reached)

"""What a proposer is shown, made from a search problem."""

from __future__ import annotations

import numpy as np

from scegen.criticality.hazards.judging import number
from scegen.criticality.hazards.view import View
from scegen.criticality.proposals.parameters import parameters_of
from scegen.criticality.proposals.proposal import Encounter, Situation
from scegen.criticality.search.problem import MEASURE_FIELDS, Problem, view_of
from scegen.motion.batch.simulation import simulate_batch
from scegen.scenario.proof import HazardProof


def situation_of(problem: Problem, hazards: tuple[HazardProof, ...]) -> Situation:
    """The situation before the search; ``hazards`` as they are now."""
    space = problem.space
    made = space.candidates(space.origin[None, :])
    traces = simulate_batch(problem.program, made, duration_s=problem.duration_s)
    view = view_of(problem.concrete, problem.ways, problem.scene, traces, problem.friction)
    people = [p.id for p in problem.concrete.participants]
    touching = ~np.isnan(view.summary.contact_s[0])
    return Situation(
        concrete=problem.concrete,
        target=problem.target,
        pair=problem.pair,
        parameters=parameters_of(problem.concrete, space),
        hazards=hazards,
        measures=tuple(
            (name, number(view.of_pair(field, *problem.pair)[0]), unit)
            for name, (field, unit) in MEASURE_FIELDS.items()
        ),
        encounters=tuple(_encounters(view, people)),
        contacts=tuple((people[int(a)], people[int(b)]) for a, b in problem.scene.pairs[touching]),
    )


def _encounters(view: View, people: list[str]) -> list[Encounter]:
    """The closest meeting of every pair that has a conflict area, in the order of time."""
    areas, found = view.scene.areas, []
    for p, (a, b) in enumerate(view.scene.pairs):
        met = []
        for n in range(areas.first[p], areas.first[p + 1]):
            entered = [_time_s(view, people[i], areas.enter_m[n, k]) for k, i in enumerate((a, b))]
            left = [_time_s(view, people[i], areas.leave_m[n, k]) for k, i in enumerate((a, b))]
            first = int(entered[1] < entered[0])
            gap = entered[1 - first] - left[first]
            if np.isfinite(gap):
                names = people[a], people[b]
                met.append(Encounter(names[first], names[1 - first], gap, entered[1 - first]))
        if met:
            found.append(min(met, key=lambda e: e.gap_s))
    return sorted(found, key=lambda e: (e.at_s, e.first, e.second))


def _time_s(view: View, name: str, place_m: float) -> float:
    """When somebody reaches a place on its path; inf if it never does."""
    places = view.place_m(name)[0]
    if not places[-1] >= place_m:
        return float("inf")
    times = np.arange(len(places)) * view.dt_s
    return float(np.interp(place_m, places, times))

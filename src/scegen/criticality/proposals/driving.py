"""Whether values can be driven: nobody stands in somebody, bends hold, everybody gets through."""

from itertools import combinations

from scegen.claims.view import View
from scegen.concretization.boxes import overlap
from scegen.criticality.search.problem import Problem, finishing
from scegen.motion.batch.arrays import Bools, Candidates, Floats


def hindrances(problem: Problem, x: Floats) -> frozenset[str]:
    """Why values of all variables (n,) cannot be driven; nothing: they can."""
    made = problem.space.candidates(x[None, :])
    (found,) = hindrances_in(problem, made, problem.view(made))
    return found


def hindrances_in(problem: Problem, made: Candidates, view: View) -> list[frozenset[str]]:
    """The same of many, whose movements are known."""
    standing: dict[bytes, list[str]] = {}
    for starts in made.start_m:
        if starts.tobytes() not in standing:
            standing[starts.tobytes()] = _overlaps(problem, starts)
    found = [set(standing[starts.tobytes()]) for starts in made.start_m]
    for name, limit in problem.lateral_mps2.items():
        slides = view.lateral_mps2(name).max(axis=1) > limit
        why = f"{name} takes a bend with more than {limit:.1f} m/s2 sideways, which it may not"
        _add(found, slides, why)
    missing, _ = finishing(view, problem.pair)
    for participant in problem.concrete.participants:
        way = problem.ways[participant.id]
        under_way = view.place_m(participant.id)[:, -1] < way.goal_m
        if not way.halts:
            why = f"{participant.id} is still under way after {problem.duration_s:.0f} s, the end"
            _add(found, under_way & (missing > 0.0), why)
            missing = missing * ~under_way
    _add(
        found, missing > 0.0, "somebody does not stand, or waits at the end of its road, in the end"
    )
    return [frozenset(one) for one in found]


def _add(found: list[set[str]], where: Bools, why: str) -> None:
    for one, holds in zip(found, where, strict=True):
        if holds:
            one.add(why)


def _overlaps(problem: Problem, start_m: Floats) -> list[str]:
    """Pairs whose bodies overlap where they start; ``start_m`` (participants,)."""
    people = problem.concrete.participants  # things, which come after them, stay
    poses = [problem.ways[p.id].path.pose(float(s)) for p, s in zip(people, start_m, strict=False)]
    return [
        f"{first.id} and {second.id} overlap at the start"
        for (first, one), (second, other) in combinations(zip(people, poses, strict=True), 2)
        if overlap(one, first.body, other, second.body)
    ]

"""Evaluations to success: the search against plain random search, and parts of it alone.

    python benchmarks/search.py [--json] [--each N] [--seeds N] [--cap N]

The problems are the source paper's eleven sentences and N random scenarios of every junction kind,
each with a near-miss, a collision and a narrow range of PET as target, where the first guess is
no success already. All methods get the same problem object: bounds, measures, test of success and
cap. "random" draws uniformly within the bounds; "quasi-random" is the search without CMA-ES,
started over until the cap; "CMA-ES" starts from the first guess with nothing before it; "TPE" is
Optuna's, where that is installed, told the same loss. A run that
fails counts as longer than the cap in medians. The proof in finer steps is left out: it is the
same for all.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import fields
from itertools import islice
from time import perf_counter

import numpy as np
from drawing import draw

try:
    import optuna
except ModuleNotFoundError:  # make bench installs it
    optuna = None

from scegen.concretization import concretize
from scegen.criticality.raising.stage import Stage
from scegen.criticality.search import optimize
from scegen.criticality.search.optimize import Best, _evolve, halton, search
from scegen.criticality.search.problem import Outcome, Problem
from scegen.criticality.target import COLLISION, NEAR_MISS, parse_target
from scegen.enumeration import enumerate_scenarios
from scegen.errors import InfeasibleError
from scegen.motion.batch.arrays import Floats
from scegen.pipeline.picking import pick
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.vocabulary import JunctionKind
from scegen.understanding import paper_cases, read

CAP = 2_000
NARROW = "pet=0.45..0.5"
BATCH = 48


class _OverError(Exception):
    """Success, or the cap."""


class Watched(Problem):
    """A problem that notes the first success and ends the search there or at the cap."""

    successes_at: int | None = None
    cap: int = CAP

    def evaluate(self, x: Floats) -> Outcome:
        before = self.evaluations
        outcome = super().evaluate(x)
        if outcome.found.any():
            self.successes_at = before + int(outcome.found.argmax()) + 1
        if self.successes_at is not None or self.evaluations >= self.cap:
            raise _OverError
        return outcome


Method = Callable[[Problem, np.random.Generator], None]


def ours(problem: Problem, rng: np.random.Generator) -> None:
    """The search as it is, started over until the cap."""
    while True:
        search(problem, rng)


def by_chance(problem: Problem, rng: np.random.Generator) -> None:
    space = problem.space
    problem.evaluate(space.origin[None, :])
    while True:
        problem.evaluate(space.at(rng.random((BATCH, len(space.variables)))))


def quasi_random(problem: Problem, rng: np.random.Generator) -> None:
    restarts, optimize.RESTARTS = optimize.RESTARTS, 0
    try:
        ours(problem, rng)
    finally:
        optimize.RESTARTS = restarts


def evolution(problem: Problem, rng: np.random.Generator) -> None:
    origin = problem.space.origin
    outcome = problem.evaluate(origin[None, :])
    best = Best(origin)
    best.take(origin[None, :], outcome)
    start = problem.space.unit(origin)
    while True:
        _evolve(problem, best, start, rng)
        start = halton(1, rng.random(len(start)))[0]


def parzen(problem: Problem, rng: np.random.Generator) -> None:
    """Optuna's tree-structured Parzen estimator, from the same first guess."""
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    sampler = optuna.samplers.TPESampler(seed=int(rng.integers(2**31)))
    study = optuna.create_study(sampler=sampler)
    ends = zip(problem.space.low.tolist(), problem.space.high.tolist(), strict=True)
    within = {str(n): optuna.distributions.FloatDistribution(*pair) for n, pair in enumerate(ends)}
    study.enqueue_trial({str(n): x for n, x in enumerate(problem.space.origin.tolist())})
    while True:
        trial = study.ask(within)
        x = np.array([trial.params[name] for name in within])
        study.tell(trial, float(problem.evaluate(x[None, :]).loss[0]))


METHODS: dict[str, Method] = {
    "search": ours,
    "random": by_chance,
    "quasi-random": quasi_random,
    "CMA-ES": evolution,
}
if optuna is not None:
    METHODS["TPE"] = parzen


def paper() -> Iterator[tuple[FunctionalScenario, ConcreteScenario]]:
    for case in paper_cases():
        functional = read(case.text)
        logical = pick(enumerate_scenarios(functional), None)[0]
        yield functional, concretize(functional, logical, seed=0)


def drawn(each: int) -> Iterator[tuple[FunctionalScenario, ConcreteScenario]]:
    for kind in JunctionKind:
        rng = np.random.Generator(np.random.PCG64(11))
        for number, (functional, logical) in enumerate(islice(draw(kind, rng), each)):
            try:
                yield functional, concretize(functional, logical, seed=number)
            except InfeasibleError:
                continue


def problem_of(
    functional: FunctionalScenario, concrete: ConcreteScenario, target: str, cap: int = CAP
) -> Watched | None:
    """The search problem; None where there is nothing to search for."""
    network = build_network(concrete.road, name=concrete.name)
    stage = Stage(functional, concrete, network, parse_target(target))
    if stage.blocked:
        return None
    made = stage.problem()
    watched = Watched(**{field.name: getattr(made, field.name) for field in fields(Problem)})
    watched.cap = cap
    try:
        watched.evaluate(watched.space.origin[None, :])
    except _OverError:
        return None
    return watched


def tried(problem: Watched, method: Method, seed: int) -> tuple[float, float]:
    """Evaluations to the first success (inf: none) and seconds, of one run."""
    problem.evaluations, problem.successes_at = 0, None
    begin = perf_counter()
    with suppress(_OverError):
        method(problem, np.random.Generator(np.random.PCG64(seed)))
    found = problem.successes_at
    return (np.inf if found is None else float(found)), perf_counter() - begin


def compared(problems: list[Watched], seeds: int) -> list[dict[str, object]]:
    rows: list[dict[str, object]] = []
    for name, method in METHODS.items():
        runs = [tried(p, method, seed) for p in problems for seed in range(seeds)]
        counts = np.array([count for count, _ in runs]).reshape(len(problems), seeds)
        medians = np.median(counts, axis=1)
        rows.append(
            {
                "method": name,
                "runs": counts.size,
                "successes": int(np.isfinite(counts).sum()),
                "problems_solved": int(np.isfinite(counts).any(axis=1).sum()),
                "median": _or_none(float(np.median(counts))),
                "hardest_quarter_median": _or_none(
                    float(np.quantile(medians, 0.75, method="lower"))
                ),
                "p90": _or_none(float(np.quantile(counts, 0.9, method="lower"))),
                "mean_s": float(np.mean([seconds for _, seconds in runs])),
            }
        )
    return rows


def _or_none(value: float) -> float | None:
    return value if np.isfinite(value) else None


def main() -> int:
    """Print the tables; exit code 1 if random search finds more, or as much with less."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--each", type=int, default=6, metavar="N", help="per junction kind")
    parser.add_argument("--seeds", type=int, default=5, metavar="N")
    parser.add_argument("--cap", type=int, default=CAP, metavar="N", help="evaluations a run")
    asked = parser.parse_args()
    sets = {"paper": list(paper()), "random": list(drawn(asked.each))}
    report: dict[str, object] = {"cap": asked.cap, "seeds": asked.seeds, "sets": {}}
    worse = False
    for name, scenarios in sets.items():
        for target in (NEAR_MISS, COLLISION, NARROW):
            made = [problem_of(*scenario, target, asked.cap) for scenario in scenarios]
            problems = [p for p in made if p is not None]
            rows = compared(problems, asked.seeds) if problems else []
            sizes = [len(p.space.variables) for p in problems]
            report["sets"][f"{name}, {target}"] = {  # type: ignore[index]
                "scenarios": len(scenarios),
                "problems": len(problems),
                "variables": [min(sizes), max(sizes)] if sizes else [],
                "methods": rows,
            }
            worse |= bool(rows) and rows[0]["successes"] < rows[1]["successes"]  # type: ignore[operator]
    if asked.json:
        print(json.dumps(report, indent=2))
    else:
        show(report)
    return int(worse)


def show(report: dict[str, object]) -> None:
    print(f"at most {report['cap']} evaluations a run, {report['seeds']} seeds a problem")
    for name, part in report["sets"].items():  # type: ignore[attr-defined]
        spread = "-".join(str(n) for n in part["variables"])
        print(f"\n{name}: {part['problems']} of {part['scenarios']} to search, {spread} variables")
        print(
            f"{'':14}{'successes':>12}{'solved':>8}{'median':>8}{'p75*':>8}{'p90':>8}{'s/run':>8}"
        )
        for row in part["methods"]:
            counts = "".join(
                f"{'> cap' if row[key] is None else format(row[key], '.0f'):>8}"
                for key in ("median", "hardest_quarter_median", "p90")
            )
            successes = f"{row['successes']}/{row['runs']}"
            print(
                f"{row['method']:14}{successes:>12}{row['problems_solved']:>8}{counts}"
                f"{row['mean_s']:>8.2f}"
            )
    print("\nsolved: problems with a success in any run; p75*: of the problems' medians")


if __name__ == "__main__":
    sys.exit(main())

"""Share of random scenarios in which the danger can be made to happen, and why not in the rest.

    python benchmarks/solved.py [--json] [--each N] [--seed N] [--doubt]

N scenarios of every junction kind with at least two cars in conflict (see drawing.py), each from
the logical scenario to numbers and on to a near-miss and to a collision. "reasons" are what the
program says of those that fail, names and numbers left out. "at once": those solved by cars that
are nearest in the very first second, as they start. --doubt gives every search that
found nothing forty times the effort, by plain random search and CMA-ES from random places, and lays
out the ground that bodies sweep where paths are said never to meet: a reason that this refutes is
untrue, and makes the exit code 1.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections import Counter
from itertools import combinations, islice
from time import perf_counter
from typing import Any

import numpy as np
import shapely
from drawing import draw
from shapely.affinity import rotate, translate
from shapely.geometry.base import BaseGeometry

from scegen.concretization import concretize
from scegen.criticality import raise_criticality
from scegen.criticality.raising.raising import Raised
from scegen.criticality.raising.stage import Stage
from scegen.criticality.search.optimize import Best, _evolve
from scegen.criticality.search.proving import examine
from scegen.criticality.target import COLLISION, NEAR_MISS, parse_target
from scegen.errors import InfeasibleError
from scegen.motion import build_paths
from scegen.motion.friction import friction_of
from scegen.motion.model import Path as Way
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteParticipant, ConcreteScenario
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.vocabulary import JunctionKind

TARGETS = (NEAR_MISS, COLLISION)
GOAL = 0.9
RANDOM_BATCHES, BATCH, EVOLUTIONS = 80, 500, 40
_FIRST_S = 1.0
_VARIES = re.compile(r"\b(ego|car_\d+)\b|\d[\d,.]*")


def kind_of(reason: str) -> str:
    """A reason without names and numbers, lists of pairs as one pair."""
    plain = _VARIES.sub("#", reason.splitlines()[0])
    plain = re.sub(r"# and #(, # and #)*( and # more pairs)?", "# and #", plain)
    return re.sub(r" in # candidates.*", "", plain)


def starts_close(raised: Raised) -> bool:
    """Whether the pair is nearest in the first second."""
    concrete = raised.concrete
    network = build_network(concrete.road, name=concrete.name)
    evidence = examine(
        concrete, network, [raised.proof.pair], friction_of(concrete.environment), dt_s=0.05
    )
    return bool(evidence.view.of_pair("closest_s", *raised.proof.pair)[0] < _FIRST_S)


def swept(participant: ConcreteParticipant, way: Way) -> BaseGeometry:
    """The ground that a body covers on its way, by shapely: nothing of the package's own."""
    body = participant.body
    box = shapely.box(-body.rear_m, -body.width_m / 2, body.front_m, body.width_m / 2)
    s = np.arange(0.0, way.length_m, 0.25)
    poses = zip(
        *(np.interp(s, way.s_m, v) for v in (way.x_m, way.y_m, way.heading_rad)), strict=True
    )
    parts = [translate(rotate(box, h, (0, 0), use_radians=True), x, y) for x, y, h in poses]
    return shapely.union_all(parts)


def refuted(functional: FunctionalScenario, concrete: ConcreteScenario, target: str) -> bool:
    """Whether much more effort finds what the search did not, or ways that never meet do meet."""
    network = build_network(concrete.road, name=concrete.name)
    stage = Stage(functional, concrete, network, parse_target(target))
    if stage.blocked:
        ways = build_paths(concrete, network)
        grounds = [swept(p, ways[p.id]) for p in concrete.participants]
        return any(a.intersects(b) for a, b in combinations(grounds, 2))
    problem = stage.problem()
    rng = np.random.Generator(np.random.PCG64(1))
    space = problem.space
    best = Best(space.origin)
    for _ in range(RANDOM_BATCHES):
        x = space.at(rng.random((BATCH, len(space.variables))))
        best.take(x, problem.evaluate(x))
    for n in range(EVOLUTIONS):
        if best.found:
            break
        start = rng.random(len(best.x)) if n else space.unit(best.x)
        _evolve(problem, best, start, rng)
    return best.found


def row(kind: JunctionKind, each: int, seed: int, *, doubt: bool) -> dict[str, Any]:
    """One junction kind."""
    rng = np.random.Generator(np.random.PCG64(seed))
    solved: Counter[str] = Counter()
    at_once: Counter[str] = Counter()
    reasons: Counter[str] = Counter()
    failures: list[dict[str, Any]] = []
    evaluations, seconds = [], []
    for number, (functional, logical) in enumerate(islice(draw(kind, rng), each)):
        try:
            concrete = concretize(functional, logical, seed=number)
        except InfeasibleError as error:
            reasons[f"numbers: {kind_of(str(error))}"] += 1
            failures.append({"number": number, "scenario": logical.slug, "reason": str(error)})
            continue
        for target in TARGETS:
            begin = perf_counter()
            raised = raise_criticality(functional, concrete, target=target, seed=seed)
            seconds.append(perf_counter() - begin)
            evaluations.append(raised.proof.evaluations)
            if raised.proof.reached:
                solved[target] += 1
                at_once[target] += starts_close(raised)
                continue
            reason = raised.proof.blocked_by or "no reason"
            reasons[f"{target}: {kind_of(reason)}"] += 1
            failure = {"number": number, "scenario": logical.slug, "target": target}
            failure["reason"] = reason
            if doubt:
                failure["refuted"] = refuted(functional, concrete, target)
            failures.append(failure)
    return {
        "kind": str(kind),
        "drawn": each,
        **{f"{t.replace('-', '_')}_solved": solved[t] for t in TARGETS},
        **{f"{t.replace('-', '_')}_at_once": at_once[t] for t in TARGETS},
        "median_evaluations": float(np.median(evaluations)),
        "median_s": float(np.median(seconds)),
        "slowest_s": max(seconds),
        "reasons": dict(reasons.most_common()),
        "failures": failures,
    }


def main() -> int:
    """Print the table; exit code 1 if a kind is below 90 % or a reason is refuted."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--each", type=int, default=100, metavar="N")
    parser.add_argument("--seed", type=int, default=4)
    parser.add_argument("--doubt", action="store_true")
    asked = parser.parse_args()
    rows = [row(kind, asked.each, asked.seed, doubt=asked.doubt) for kind in JunctionKind]
    if asked.json:
        print(json.dumps({"rows": rows}, indent=2))
    else:
        show(rows)
    short = any(
        r[f"{t}_solved"] < GOAL * asked.each for r in rows for t in ("near_miss", COLLISION)
    )
    return int(short or any(f.get("refuted") for r in rows for f in r["failures"]))


def show(rows: list[dict[str, Any]]) -> None:
    print(
        f"{'':12}{'drawn':>6}{'near-miss':>11}{'at once':>9}{'collision':>11}{'at once':>9}", end=""
    )
    print(f"{'evaluations':>13}{'median s':>10}{'slowest s':>11}")
    for r in rows:
        print(
            f"{r['kind']:12}{r['drawn']:6}{r['near_miss_solved']:11}{r['near_miss_at_once']:9}"
            f"{r['collision_solved']:11}{r['collision_at_once']:9}"
            f"{r['median_evaluations']:13.0f}{r['median_s']:10.2f}{r['slowest_s']:11.2f}"
        )
    for r in rows:
        for reason, count in r["reasons"].items():
            print(f"{r['kind']:12}{count:4}  {reason}")
    doubted = [(r["kind"], f) for r in rows for f in r["failures"] if "refuted" in f]
    for kind, failure in doubted:
        if failure["refuted"]:
            print(f"UNTRUE: {kind} {failure['number']} {failure['target']}: {failure['reason']}")
    if doubted:
        untrue = sum(f["refuted"] for _, f in doubted)
        print(f"doubted: {len(doubted)} failures of the search, {untrue} with an untrue reason")


if __name__ == "__main__":
    sys.exit(main())

"""Candidates per second and core: simulation and all measures, for 2, 4 and 10 participants.

    python benchmarks/batch.py [--json]

A four-way crossing with one lane each way: straight on, left and right turns from all arms, from
the fifth participant on second and third vehicles in the same lanes. Every participant has two
phases. 10 s in steps of 0.05 s (201 states). One occlusion is measured from 4 participants on.
Processor time of one thread, best of three runs after the kernels have been loaded.
"""

from __future__ import annotations

import argparse
import json
import sys
from time import process_time

import numpy as np

from scegen.measures import Tables, build_tables, evaluate
from scegen.motion.batch import (
    Candidates,
    Phase,
    Program,
    TriggerKind,
    build_program,
    repeat,
    simulate_batch,
)
from scegen.motion.model import Path
from scegen.scenario.bodies import BODIES
from scegen.scenario.vocabulary import ParticipantKind

GOALS = {2: 80_000, 4: 30_000, 10: 5_000}
DURATION_S, DT_S = 10.0, 0.05
WAYS = ("straight", "left", "straight", "right", "left", "straight")
RUNS = 3
SECONDS_PER_RUN = 0.5


def path(arm: int, way: str, start_m: float) -> Path:
    """From 100 m before the centre on arm 0 to 3 (counter-clockwise), right-hand traffic."""
    lane, stop = 1.75, 12.0
    s = [np.arange(start_m, 100.0 - stop, 4.0)]
    bends = {"straight": (2 * stop, 0.0), "left": (0.0, stop + lane), "right": (0.0, lane - stop)}
    length, radius = bends[way]
    x, y, heading = [s[0] - 100.0], [np.full_like(s[0], -lane)], [np.zeros_like(s[0])]
    if radius:
        turn = np.linspace(0.0, np.pi / 2 * np.sign(radius), int(abs(radius) * np.pi / 2 / 0.25))
        x.append(-stop + abs(radius) * np.abs(np.sin(turn)))
        y.append(-lane + radius * (1.0 - np.cos(turn)))
        heading.append(turn)
    else:
        x.append(np.arange(-stop, stop, 4.0))
        y.append(np.full_like(x[1], -lane))
        heading.append(np.zeros_like(x[1]))
        del length
    out = np.arange(4.0, 84.0, 4.0)
    if radius == 0.0:
        out = np.concatenate(([0.0], out))
        x.append(stop + out)
        y.append(np.full_like(out, -lane))
        heading.append(np.zeros_like(out))
    else:
        x.append(np.full_like(out, x[1][-1]))
        y.append(y[1][-1] + out * np.sign(radius))
        heading.append(np.full_like(out, heading[1][-1]))
    xs, ys, hs = (np.concatenate(parts) for parts in (x, y, heading))
    angle = arm * np.pi / 2
    c, sn = np.cos(angle), np.sin(angle)
    xs, ys = c * xs - sn * ys, sn * xs + c * ys
    along = np.concatenate(([0.0], np.cumsum(np.hypot(np.diff(xs), np.diff(ys)))))
    return Path(along, xs, ys, hs + angle, ())


def crossing(participants: int) -> tuple[Program, Candidates, Tables]:
    """Program, one candidate and scene of so many vehicles."""
    paths = [path(i % 4, WAYS[i % 6], 40.0 - 20.0 * (i // 4)) for i in range(participants)]
    phases = [
        [
            Phase(TriggerKind.DISTANCE_BELOW, (i + 1) % participants, 45.0, 6.0, 3.0),
            Phase(TriggerKind.ARRIVAL_BELOW, (i + 1) % participants, 1.5, 12.0, 2.5, 85.0),
        ]
        for i in range(participants)
    ]
    program, candidate = build_program(paths, [10.0 + i % 3 for i in range(participants)], phases)
    bodies = [BODIES[ParticipantKind.CAR]] * participants
    occlusions = [(0, 1, 2)] if participants > 2 else []
    return program, candidate, build_tables(paths, bodies, occlusions=occlusions)


def varied(candidate: Candidates, count: int, seed: int = 4) -> Candidates:
    """Candidates whose starts, speeds and trigger values are spread around the first's."""
    rng = np.random.default_rng(seed)
    many = repeat(candidate, count)
    many.start_m[:] = rng.uniform(0.0, 10.0, many.start_m.shape)
    many.speed_mps[:] *= rng.uniform(0.6, 1.4, many.speed_mps.shape)
    many.trigger[:] *= rng.uniform(0.5, 1.5, many.trigger.shape)
    return many


def rate(participants: int) -> dict[str, float]:
    """Candidates per second with and without measures, and what became of them."""
    program, candidate, scene = crossing(participants)
    count = max(200, int(GOALS[participants] * SECONDS_PER_RUN))
    many = varied(candidate, count)
    few = varied(candidate, 10)
    evaluate(program, few, scene, duration_s=DURATION_S, dt_s=DT_S)
    simulate_batch(program, few, duration_s=DURATION_S, dt_s=DT_S)
    full, bare = [], []
    for _ in range(RUNS):
        begin = process_time()
        summary = evaluate(program, many, scene, duration_s=DURATION_S, dt_s=DT_S)
        full.append(process_time() - begin)
        part = Candidates(*(array[:500] for array in many))
        begin = process_time()
        simulate_batch(program, part, duration_s=DURATION_S, dt_s=DT_S)
        bare.append((process_time() - begin) / 500)
    return {
        "participants": participants,
        "pairs": len(scene.pairs),
        "per_s": count / min(full),
        "goal_per_s": GOALS[participants],
        "simulation_only_per_s": 1.0 / min(bare),
        "with_contact": float(np.isfinite(summary.contact_s).any(axis=1).mean()),
        "pairs_with_pet": float(np.isfinite(summary.pet_s).mean()),
        "pairs_with_headway": float(np.isfinite(summary.headway_s).mean()),
    }


def main() -> int:
    """Print the table; exit code 1 if a goal is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    rows = [rate(n) for n in GOALS] if (args := parser.parse_args()) else []
    if args.json:
        print(json.dumps({"rows": rows}, indent=2))
    else:
        print("participants  pairs  candidates/s/core     goal  simulation only  contact    PET")
        for r in rows:
            print(
                f"{r['participants']:12.0f} {r['pairs']:6.0f} {r['per_s']:18,.0f} "
                f"{r['goal_per_s']:8,.0f} {r['simulation_only_per_s']:16,.0f} "
                f"{r['with_contact']:8.0%} {r['pairs_with_pet']:6.0%}"
            )
    return int(any(r["per_s"] < r["goal_per_s"] for r in rows))


if __name__ == "__main__":
    sys.exit(main())

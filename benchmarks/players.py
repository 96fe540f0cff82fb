"""The batch simulator beside esmini's library and commonroad-crime, on the same scenarios.

    python benchmarks/players.py [--json]

Random scenarios of two and of four cars, with a small PET or a collision found first, and the
source paper's ten cars are written as files and played by esmini through its library (libesminiLib,
found beside the esmini on PATH), in steps of 0.05 s; our own rate is that of the simulation with
all measures of all pairs, over the same time and steps. Traces are compared step by step. Pairs of
the two-car scenarios go to commonroad-crime (``make bench`` installs it in an environment of its
own) with the same boxes and states, in steps of 0.1 s, and so do two cars that follow each other.
What is not installed is said, and left out. One thread each; wall clock.
"""

from __future__ import annotations

import argparse
import ctypes
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
from drawing import draw

from scegen.checking.environment import ESMINI_HINT, esmini, own_python
from scegen.concretization import concretize
from scegen.criticality import raise_criticality
from scegen.criticality.search.pairs import has_areas
from scegen.enumeration import enumerate_scenarios
from scegen.errors import InfeasibleError
from scegen.measures import Tables, build_tables, evaluate, measure
from scegen.motion import build_paths
from scegen.motion.batch import compile_program, repeat, simulate_batch
from scegen.motion.batch.arrays import HEADING, SPEED, Candidates, Program, X, Y
from scegen.motion.model import Path as Way
from scegen.pipeline.export import export_scenario
from scegen.pipeline.picking import pick
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario, DriveMotion
from scegen.scenario.vocabulary import JunctionKind
from scegen.understanding import read

GOAL = 1_000.0
STEP_S, CRIME_STEP_S = 0.05, 0.1
CANDIDATES = 2_000
EACH = {2: 3, 4: 1}
TEN = "Ten cars arriving at a T intersection."
FOLLOWING = (
    "A car tailgates another car on a straight road and the car ahead brakes hard.",
    "A car follows another car that brakes suddenly on a straight road.",
    "A speeding car approaches a slow car ahead on a straight road.",
)
CRIME_VARIABLE = "SCEGEN_CRIME_PYTHON"
CRIME_HINT = "run: make bench"


@dataclass(frozen=True)
class Case:
    """A scenario ready for our own simulator."""

    concrete: ConcreteScenario
    ways: dict[str, Way]
    program: Program
    candidate: Candidates
    scene: Tables

    @property
    def count(self) -> int:
        return len(self.concrete.participants)


def case_of(concrete: ConcreteScenario) -> Case:
    ways = build_paths(concrete, build_network(concrete.road, name=concrete.name))
    program, candidate = compile_program(concrete, ways)
    ordered = [ways[p.id] for p in concrete.participants]
    scene = build_tables(ordered, [p.body for p in concrete.participants])
    return Case(concrete, ways, program, candidate, scene)


def crossings() -> Iterator[Case]:
    """Random ones with so many cars; a PET of 0.3 to 1 s and a collision in turn."""
    for kind in JunctionKind:
        if kind is JunctionKind.STRAIGHT:
            continue
        rng = np.random.Generator(np.random.PCG64(8))
        wanted = dict(EACH)
        for number, (functional, logical) in enumerate(islice(draw(kind, rng), 200)):
            size = len(functional.participants)
            if not wanted.get(size):
                continue
            try:
                concrete = concretize(functional, logical, seed=number)
            except InfeasibleError:
                continue
            target = "pet=0.3..1.0" if wanted[size] % 2 else "collision"
            raised = raise_criticality(functional, concrete, target=target)
            if raised.proof.reached:
                wanted[size] -= 1
                yield case_of(raised.concrete)


def told(text: str) -> Case:
    functional = read(text)
    concrete = concretize(functional, pick(enumerate_scenarios(functional), None)[0], seed=0)
    return case_of(raise_criticality(functional, concrete).concrete)


def own_rate(case: Case) -> float:
    """Candidates per second with all measures of all pairs."""
    many = repeat(case.candidate, CANDIDATES)
    duration_s = case.concrete.duration_s
    best = np.inf
    for _ in range(3):
        begin = perf_counter()
        evaluate(case.program, many, case.scene, duration_s=duration_s, dt_s=STEP_S)
        best = min(best, perf_counter() - begin)
    return CANDIDATES / best


class _State(ctypes.Structure):
    """The first members of SE_ScenarioObjectState (esmini 3.6), and room for the rest."""

    _fields_ = (
        ("ids", ctypes.c_int * 3),
        ("timestamp", ctypes.c_double),
        ("x", ctypes.c_double),
        ("y", ctypes.c_double),
        ("rest", ctypes.c_char * 512),
    )


def library() -> ctypes.CDLL | None:
    """esmini's library: in the folder of the player, or in the lib beside it."""
    player = esmini()
    if player is None:
        return None
    for folder in {player.parent, player.resolve().parent}:
        for place in (folder, folder.parent / "lib"):
            for name in ("libesminiLib.so", "libesminiLib.dylib", "esminiLib.dll"):
                if (place / name).is_file():
                    found = ctypes.CDLL(str(place / name))
                    found.SE_StepDT.argtypes = [ctypes.c_double]
                    found.SE_GetSimulationTime.restype = ctypes.c_double
                    found.SE_GetObjectName.restype = ctypes.c_char_p
                    found.SE_SetOptionPersistent(b"disable_stdout")
                    found.SE_SetOptionPersistent(b"disable_log")
                    return found
    return None


def played(player: ctypes.CDLL, file: Path, seconds: float) -> dict[str, np.ndarray]:
    """Play a file; x and y of every entity by step."""
    arguments = ["esmini", "--osc", str(file), "--headless", "--disable_stdout", "--disable_log"]
    given = (ctypes.c_char_p * len(arguments))(*(a.encode() for a in arguments))
    if player.SE_InitWithArgs(len(arguments), given) != 0:
        raise RuntimeError(f"esmini cannot play {file}")
    names = {}
    rows: dict[str, list[tuple[float, float]]] = {}
    for index in range(player.SE_GetNumberOfObjects()):
        number = player.SE_GetId(index)
        names[number] = player.SE_GetObjectName(number).decode()
        rows[names[number]] = []
    state = _State()
    for step in range(round(seconds / STEP_S) + 1):
        if step and player.SE_StepDT(STEP_S) != 0:
            break
        for number, name in names.items():
            player.SE_GetObjectState(number, ctypes.byref(state))
            rows[name].append((state.x, state.y))
    player.SE_Close()
    return {name: np.array(row) for name, row in rows.items()}


def beside_esmini(groups: dict[int, list[Case]]) -> list[dict[str, Any]]:
    player = library()
    rows = []
    with tempfile.TemporaryDirectory(prefix="scegen-players-") as folder:
        for size, cases in groups.items():
            row: dict[str, Any] = {"cars": size, "scenarios": len(cases)}
            row["ours_per_s"] = float(np.median([own_rate(case) for case in cases]))
            row["simulated_s"] = float(np.mean([case.concrete.duration_s for case in cases]))
            if player is not None:
                spent, apart = [], []
                for number, case in enumerate(cases):
                    place = Path(folder, f"{size}-{number}")
                    place.mkdir()
                    for name, content in export_scenario(case.concrete).items():
                        (place / name).write_bytes(content)
                    begin = perf_counter()
                    shown = played(player, place / "scenario.xosc", case.concrete.duration_s)
                    spent.append(perf_counter() - begin)
                    apart.append(_apart(case, shown))
                row["esmini_per_s"] = float(1.0 / np.median(spent))
                row["times"] = row["ours_per_s"] / row["esmini_per_s"]
                row["apart_p95_m"] = float(np.quantile(np.concatenate(apart), 0.95))
                row["apart_most_m"] = float(np.concatenate(apart).max())
            rows.append(row)
    return rows


def _apart(case: Case, shown: dict[str, np.ndarray]) -> np.ndarray:
    """Distances between our positions and esmini's, over all cars and steps."""
    traces = simulate_batch(
        case.program, case.candidate, duration_s=case.concrete.duration_s, dt_s=STEP_S
    )
    parts = []
    for n, participant in enumerate(case.concrete.participants):
        other = shown[participant.id]
        steps = min(len(other), traces.tracks.shape[3])
        ours = traces.tracks[0, n][[X, Y], :steps].T
        parts.append(np.hypot(*(ours - other[:steps]).T))
    return np.concatenate(parts)


def crime_python() -> Path | None:
    named = os.environ.get(CRIME_VARIABLE)
    python = Path(named) if named else own_python("crime")
    return python if python.is_file() else None


def pair_data(case: Case, kind: str) -> tuple[dict[str, Any], dict[str, float]]:
    """The first two participants as plain data for the other side, and our own values."""
    traces = simulate_batch(
        case.program, case.candidate, duration_s=case.concrete.duration_s, dt_s=CRIME_STEP_S
    )
    summary = measure(traces, case.scene)
    tracks = traces.tracks[0]
    people = list(case.concrete.participants[:2])
    order = [0, 1]
    if kind == "following":  # who is behind comes first: it is the other side's ego
        order = sorted(order, key=lambda n: _ahead(case, n))
    vehicles = [_vehicle(case, people[n].id, tracks[n]) for n in order]
    contact = float(summary.contact_s[0, 0])
    data = {
        "kind": kind,
        "lane_m": 3.5,
        "vehicles": vehicles,
        "contact_step": None if np.isnan(contact) else round(contact / CRIME_STEP_S),
    }
    ours = {
        "pet": float(summary.pet_s[0, 0]),
        "distance": float(summary.distance_m[0, 0]),
        "delta_v": float(summary.delta_v_mps[0, 0, 0]),
        "headway": float(summary.headway_s[0, 0]),
        "ttc": float(summary.ttc_s[0, 0]),
        "required": -float(summary.drac_mps2[0, 0]),
    }
    return data, ours


def _ahead(case: Case, n: int) -> float:
    motion = case.concrete.participants[n].motion
    return motion.start_m if isinstance(motion, DriveMotion) else 0.0


def _vehicle(case: Case, name: str, track: np.ndarray) -> dict[str, Any]:
    participant = case.concrete.participant(name)
    body, way = participant.body, case.ways[name]
    centre = body.centre_ahead_m
    ahead = [track[X] + centre * np.cos(track[HEADING]), track[Y] + centre * np.sin(track[HEADING])]
    # Lanes begin behind the car and go on ahead of it, so that its whole box lies on them.
    at = np.arange(-15.0, way.length_m + 15.0, 1.0)
    inside = np.clip(at, 0.0, way.length_m)
    heading = np.interp(inside, way.s_m, way.heading_rad)
    x = np.interp(inside, way.s_m, way.x_m) + (at - inside) * np.cos(heading)
    y = np.interp(inside, way.s_m, way.y_m) + (at - inside) * np.sin(heading)
    motion = participant.motion
    assert isinstance(motion, DriveMotion)
    bends = [motion.turning_starts_m - motion.start_m, motion.turning_ends_m - motion.start_m]
    enters, leaves = (int(np.searchsorted(at, bend)) for bend in bends)
    return {
        "length": body.length_m,
        "width": body.width_m,
        "x": ahead[0].tolist(),
        "y": ahead[1].tolist(),
        "heading": track[HEADING].tolist(),
        "speed": track[SPEED].tolist(),
        "way": {
            "x": x.tolist(),
            "y": y.tolist(),
            "heading": heading.tolist(),
            "inside": [enters, min(max(leaves, enters + 2), len(at) - 2)],
        },
    }


def beside_crime(crossing: list[Case], behind: list[Case]) -> list[dict[str, Any]] | None:
    python = crime_python()
    if python is None:
        return None
    chosen = [(case, "crossing") for case in crossing if has_areas(case.scene, 0)]
    chosen += [(case, "following") for case in behind]
    prepared = [(*pair_data(case, kind), case, kind) for case, kind in chosen]
    asked = json.dumps({"dt": CRIME_STEP_S, "pairs": [data for data, *_ in prepared]})
    done = subprocess.run(
        [str(python), str(Path(__file__).with_name("crime.py"))],
        input=asked,
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode:
        raise RuntimeError(f"commonroad-crime failed:\n{done.stderr[-2000:]}")
    rows = []
    for (_, ours, case, kind), found in zip(prepared, json.loads(done.stdout), strict=True):
        values = {name: float(value) for name, value in found["values"].items()}
        names = sorted({name.split("_lanes")[0] for name in values})
        rows.append(
            {
                "scenario": case.concrete.name,
                "kind": kind,
                "failure": found.get("failure"),
                "ours": {name: ours[name] for name in names},
                "theirs": values,
                "theirs_per_s": 1.0 / found["seconds"] if "seconds" in found else None,
                "ours_per_s": own_rate(case),
            }
        )
    return rows


def main() -> int:
    """Print the tables; exit code 1 if two or four cars miss the goal beside esmini."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--json", action="store_true")
    asked = parser.parse_args()
    cases = list(crossings())
    groups = {n: [case for case in cases if case.count == n] for n in EACH}
    groups[10] = [told(TEN)]
    report: dict[str, Any] = {"goal": GOAL, "esmini": beside_esmini(groups)}
    report["crime"] = beside_crime(groups[2], [told(text) for text in FOLLOWING])
    if asked.json:
        print(json.dumps(report, indent=2))
    else:
        show(report)
    if library() is None:
        print(
            f"NOT MEASURED: no library of esmini beside esmini on PATH; {ESMINI_HINT}",
            file=sys.stderr,
        )
    if report["crime"] is None:
        print(f"NOT MEASURED: commonroad-crime is not installed; {CRIME_HINT}", file=sys.stderr)
    judged = [row for row in report["esmini"] if row["cars"] in EACH]
    return int(any(row.get("times", GOAL) < GOAL for row in judged))


def show(report: dict[str, Any]) -> None:
    print(f"{'cars':>4}{'scenarios':>11}{'seconds each':>14}{'ours/s':>10}{'esmini/s':>10}", end="")
    print(f"{'times':>8}{'apart p95, most':>20}")
    for row in report["esmini"]:
        line = f"{row['cars']:4}{row['scenarios']:11}{row['simulated_s']:14.1f}"
        line += f"{row['ours_per_s']:10,.0f}"
        if "times" in row:
            apart = f"{100 * row['apart_p95_m']:.2f}, {100 * row['apart_most_m']:.2f} cm"
            line += f"{row['esmini_per_s']:10.1f}{row['times']:8,.0f}{apart:>20}"
        print(line)
    if report["crime"] is None:
        return
    print("\ncommonroad-crime: value of ours / theirs (on lanes as wide as the cars; PET also on")
    print("lanes of 3.5 m); evaluations per second of ours (all measures) and theirs (those shown)")
    for row in report["crime"]:
        if row["failure"]:
            print(f"{row['scenario'][:30]:31} {row['kind']}: {row['failure']}")
            continue
        shown = [
            f"{name} {value:.2f}/{row['theirs'][name]:.2f}" for name, value in row["ours"].items()
        ]
        if "pet_lanes" in row["theirs"]:
            shown.append(f"pet on lanes {row['theirs']['pet_lanes']:.2f}")
        rates = f"{row['ours_per_s']:,.0f}/s, {row['theirs_per_s']:.1f}/s"
        print(f"{row['scenario'][:24]:25} {', '.join(shown)}; {rates}")


if __name__ == "__main__":
    sys.exit(main())

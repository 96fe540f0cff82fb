"""Run the benchmarks one after another, and write what they measure as one page.

    python benchmarks/table.py [--only NAME …] [--output FILE.md] [--from FOLDER] [--keep FOLDER]

Every benchmark runs as a process of its own, so on a quiet machine the figures are its own. What it
prints as JSON is kept with ``--keep`` and read again with ``--from``; what ends in an error, misses
a tool or its goal is said on the page. Less than a quarter of an hour on two quiet cores.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from time import perf_counter
from typing import Any

from scegen.checking.environment import esmini
from scegen.understanding import paper_cases

HERE = Path(__file__).parent
PAGE = HERE.parent / "docs" / "reference" / "benchmarks.md"
PACKAGES = ("ml-scegen", "numpy", "numba", "clingo", "cmaes", "optuna", "duckdb", "ray")
Row = Mapping[str, Any]


def table(rows: Iterable[Row], columns: Mapping[str, Callable[[Row], object]]) -> str:
    """Rows as a table; a number gets the digits that matter."""
    lines = ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    lines += ["| " + " | ".join(_shown(c(row)) for c in columns.values()) + " |" for row in rows]
    return "\n".join(lines)


def _shown(value: object) -> str:
    match value:
        case None:
            return "–"
        case bool():
            return "yes" if value else "no"
        case int():
            return f"{value:,}" if value < 1e12 else f"{value:.2e}"
        case float():
            small = f"{value:.2f}" if abs(value) >= 0.1 else f"{value:.3g}"
            return f"{value:,.0f}" if abs(value) >= 100 else small
        case _:
            return str(value)


def key(name: str) -> Callable[[Row], object]:
    """The value of this name."""
    return lambda row: row.get(name)


def paper(data: Any) -> str:
    rows = [*data["rows"]]
    after = table(
        rows,
        {
            "case": lambda row: row["case"].removeprefix("paper-"),
            "understood": key("understood"),
            "participants": key("participants"),
            "scenarios": key("scenarios"),
            "every check passed": key("green"),
            "dangers": lambda r: f"{len(r['hazards_happened'])} of {len(r['hazards_asked'])}",
            "measure": lambda r: f"{r['measure']}, {r['unit']}",
            "before": key("before"),
            "after": key("after"),
            "evaluations": key("evaluations"),
        },
    )
    theirs, cases = data["paper"], data["cases"]
    return (
        f"{after}\n\nValid files: {data['green']} of {cases}; the paper reports "
        f"{theirs['successes']} of {theirs['cases']}. The right danger: {data['dangers_happen']} "
        f"of {cases}; the paper reports 8."
    )


def enumeration(data: Any) -> str:
    rows = table(
        data["listings"],
        {
            "cars, arms": lambda row: f"{row['cars']}, {row['arms']}",
            "reduction": key("reduction"),
            "scenarios": key("scenarios"),
            "the paper's encoding, s": key("paper_s"),
            "raw clingo, s": key("raw_s"),
            "ours, s": key("whole_s"),
            "ours ÷ raw": key("whole_per_raw"),
            "paper's ÷ ours": key("paper_per_whole"),
        },
    )
    flow = data["stream"]
    rates = ", ".join(_shown(rate) for rate in flow["per_s"])
    return (
        f"{rows}\n\nTwenty cars at six arms: counted in {flow['count_ms']:.1f} ms, the first "
        f"scenario after {flow['first_ms']:.0f} ms, then {rates} a second; memory grows by "
        f"{flow['growth_kb']:.0f} kB over 10,000 scenarios."
    )


def growth(data: Any) -> str:
    counted = table(
        data["counted"],
        {
            name: key(field)
            for name, field in {
                "cars": "cars",
                "arms": "arms",
                "assignments": "assignments",
                "scenarios": "scenarios",
                "counted in ms": "ms",
            }.items()
        },
    )
    listed = table(
        data["listed"],
        {"scenarios listed": key("scenarios"), "s": key("s"), "peak, MB": key("peak_mb")},
    )
    made = table(
        data["made"],
        {
            "cars": key("cars"),
            "numbers, search, files: s": key("s"),
            "in the band": key("in_band"),
            "peak, MB": key("peak_mb"),
        },
    )
    base = f"A process that has only imported the program holds {data['base_mb']:.0f} MB."
    return f"{counted}\n\n{listed}\n\n{made}\n\n{base}"


def plain(data: Any) -> str:
    """Its rows as they are."""
    return table(_rows(data), {name: key(name) for name in _rows(data)[0]})


def _rows(data: Any) -> list[Row]:
    """The rows of a report that is a list, or has one."""
    if isinstance(data, dict):
        return next((v for v in data.values() if isinstance(v, list)), [data])
    return list(data)


def scaling(data: Any) -> str:
    by_participants = table(
        data["by_participants"],
        {
            "participants": key("participants"),
            "pairs": key("pairs"),
            "µs a candidate": key("us"),
            "µs a pair": lambda row: row["us"] / row["pairs"],
        },
    )
    by_candidates = table(
        data["by_candidates"],
        {
            "candidates in a call": key("candidates"),
            **{f"µs a candidate, {n} cars": key(f"us_{n}") for n in (2, 4, 10)},
        },
    )
    return f"{by_participants}\n\n{by_candidates}"


def players(data: Any) -> str:
    theirs = table(
        data["esmini"],
        {
            "cars": key("cars"),
            "scenarios": key("scenarios"),
            "simulated, s": key("simulated_s"),
            "ours, a second": key("ours_per_s"),
            "esmini, a second": key("esmini_per_s"),
            "times": key("times"),
            "apart at most, cm": lambda r: 100 * r["apart_most_m"] if "apart_most_m" in r else None,
        },
    )
    if data["crime"] is None:
        return f"{theirs}\n\ncommonroad-crime is not installed: not measured."
    crime = table(
        [row for row in data["crime"] if not row["failure"]],
        {
            "scenario": key("scenario"),
            "kind": key("kind"),
            "ours / commonroad-crime": lambda row: ", ".join(
                f"{name} {value:.2f} / {row['theirs'][name]:.2f}"
                for name, value in row["ours"].items()
            ),
            "ours, a second": key("ours_per_s"),
            "theirs, a second": key("theirs_per_s"),
        },
    )
    return f"{theirs}\n\n{crime}"


def search(data: Any) -> str:
    rows = [
        {"problems": f"{name} ({part['problems']})", **method}
        for name, part in data["sets"].items()
        for method in part["methods"]
    ]
    return table(
        rows,
        {
            "problems": key("problems"),
            "method": key("method"),
            "successes": lambda row: f"{row['successes']} of {row['runs']}",
            "median evaluations": lambda row: "> cap" if row["median"] is None else row["median"],
            "s a run": key("mean_s"),
        },
    )


def end_to_end(data: Any) -> str:
    seconds = sum(row["seconds"] for row in data["rows"])
    return (
        f"{data['right']} of {data['descriptions']} made as said, in {seconds:.1f} s: "
        f"{data['descriptions'] / seconds:.2f} a second, each with its search, its report and "
        "every quick check, esmini's play included."
    )


def facts(data: Any, before: str = "") -> str:
    """Names and values, whatever they lie in."""
    if not isinstance(data, dict):
        return f"{before.strip()} {_shown(data)}"
    return ", ".join(facts(value, f"{before} {name}") for name, value in data.items())


@dataclass(frozen=True)
class Step:
    """A benchmark: how it is called, how it is shown, and by what protocol it measures.

    ``texts``: it is given the paper's sentences as a file.
    """

    name: str
    title: str
    protocol: str
    show: Callable[[Any], str]
    arguments: tuple[str, ...] = ()
    module: bool = False
    texts: bool = False


STEPS = (
    Step("paper", "The source paper's eleven sentences",
         "From the text to files; every checker; the danger searched for.", paper,
         ("benchmark", "paper"), module=True),
    Step("enumeration", "Enumeration beside the paper's encoding and raw clingo",
         "Ten cars at five arms; processor time, median of nine runs, the paper's encoding once.",
         enumeration),
    Step("growth", "Growth with cars, arms and scenarios",
         "All arms alike, cars spread over them; a process for each row.", growth),
    Step("batch", "Candidates a second and core",
         "Simulation of 10 s in steps of 0.05 s with all measures; best of three.", plain),
    Step("scaling", "Cost of a candidate", "The same crossing.", scaling),
    Step("players", "The simulator beside esmini and commonroad-crime",
         "The same scenarios in each; esmini through its library.", players),
    Step("search", "The search beside random search and TPE",
         "Evaluations until the target is met, at most 400 a run, one run a problem.", search,
         ("--each", "1", "--seeds", "1", "--cap", "400")),
    Step("claims", "What claims cost",
         "Beside an evaluation without them; the paper's eleven and four with numbers.", plain),
    Step("end_to_end", "From text to checked files", "The paper's eleven, one process.",
         end_to_end, texts=True),
    Step("startup", "One `scegen generate` as a process",
         "Quick checks; the least of five, the first not counted.", facts),
    Step("reader", "The offline reader",
         "The paper's sentences; the best of many rounds, processor time.", facts),
    Step("campaign", "A campaign's throughput",
         "Search, claims, own checks and storing, no pictures; processor time.", plain),
    Step("campaign_at_size", "A campaign with one worker and with two",
         "The paper's eleven, four logical scenarios of each, eight times; wall clock.", facts,
         ("--compare", "--count", "4", "--each", "8"), texts=True),
)  # fmt: skip


def run(step: Step, folder: Path) -> tuple[Any, str, float]:
    """What it printed, what it complained of, and the seconds that it took."""
    arguments = [sys.executable, str(HERE / f"{step.name}.py"), *step.arguments, "--json"]
    if step.module:
        arguments = [sys.executable, "-m", "scegen", *step.arguments, "--json"]
    if step.texts:
        cases = [json.dumps({"id": case.id, "text": case.text}) for case in paper_cases()]
        (folder / "cases.jsonl").write_text("\n".join(cases), encoding="utf-8")
        arguments.insert(2, str(folder / "cases.jsonl"))
    begin = perf_counter()
    done = subprocess.run(arguments, capture_output=True, text=True, check=False, env=os.environ)
    seconds = perf_counter() - begin
    try:
        data = json.loads(done.stdout)
    except ValueError:
        return None, done.stderr[-500:] or "it printed nothing", seconds
    return data, "" if done.returncode == 0 else "It misses its goal.", seconds


def machine() -> str:
    """Processor, load and versions, of this run."""
    model = platform.processor() or platform.machine()
    told = Path("/proc/cpuinfo")
    if told.exists():
        names = [x for x in told.read_text().splitlines() if x.startswith("model name")]
        model = names[0].partition(": ")[2] if names else model
    load = ", ".join(f"{part:.1f}" for part in os.getloadavg())
    versions = [f"Python {platform.python_version()}"]
    for package in PACKAGES:
        try:
            versions.append(f"{package} {version(package)}")
        except PackageNotFoundError:
            versions.append(f"no {package}")
    player = esmini()
    if player is not None:
        said = subprocess.run([player, "--version"], capture_output=True, text=True, check=False)
        tags = [x for x in said.stdout.splitlines() if "REV" in x]
        versions.append(f"esmini {tags[0].split()[-1] if tags else ''}".strip())
    return (
        f"{os.cpu_count()} processors ({model}), load {load} at the start; {platform.system()}; "
        f"{', '.join(versions)}."
    )


def main() -> int:
    """Write the page; exit code 1 if a benchmark printed nothing."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    names = [step.name for step in STEPS]
    parser.add_argument("--only", nargs="*", choices=names, default=names)
    parser.add_argument("--output", type=Path, default=PAGE)
    parser.add_argument("--from", dest="source", type=Path, help="folder of kept results")
    parser.add_argument("--keep", type=Path, help="folder to keep results in")
    asked = parser.parse_args()
    parts = [
        "# Benchmarks",
        "Written by `make bench`, every figure by the command beside it; `--json` gives all of it. "
        "What each one measures stands in [measuring](measuring.md).",
        machine(),
    ]
    broken = 0
    with tempfile.TemporaryDirectory(prefix="scegen-bench-") as place:
        for step in (step for step in STEPS if step.name in asked.only):
            if asked.source is not None:
                kept = json.loads((asked.source / f"{step.name}.json").read_text("utf-8"))
                data, complaint, seconds = kept["data"], kept["complaint"], kept["seconds"]
            else:
                data, complaint, seconds = run(step, Path(place))
            print(f"{step.name}: {seconds:.0f} s {complaint}", file=sys.stderr, flush=True)
            if asked.keep is not None:
                asked.keep.mkdir(parents=True, exist_ok=True)
                kept = {"data": data, "complaint": complaint, "seconds": seconds}
                (asked.keep / f"{step.name}.json").write_text(json.dumps(kept), encoding="utf-8")
            command = f"benchmarks/{step.name}.py"
            if step.module:
                command = f"scegen {' '.join(step.arguments)}"
            parts += [f"## {step.title}", f"{step.protocol} `{command}`, {seconds:.0f} s."]
            if data is None:
                broken += 1
                parts.append(f"Not measured: {complaint.strip().splitlines()[-1]}")
            else:
                parts += [step.show(data), *([complaint] if complaint else [])]
    asked.output.write_text("\n\n".join(parts) + "\n", encoding="utf-8")
    print(asked.output)
    return int(broken > 0)


if __name__ == "__main__":
    sys.exit(main())

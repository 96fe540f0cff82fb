"""scegen benchmark paper: the source paper's eleven sentences."""

from __future__ import annotations

from typing import TYPE_CHECKING

import typer
from rich.console import Console
from rich.table import Table

from scegen.cli.console import result_json, working
from scegen.cli.options import JsonFlag, SeedOption

if TYPE_CHECKING:
    from scegen.benchmark.paper import Row
    from scegen.scenario.proof import HazardProof


def paper(json: JsonFlag = False, seed: SeedOption = 0) -> None:
    """The source paper's eleven sentences: understood, made, and passed by every checker."""
    from scegen.benchmark.paper import PAPER_CASES, PAPER_SUCCESSES, PAPER_TRUE, run

    with working() as progress:
        rows = list(run(progress, seed=seed))
    green = sum(row.green for row in rows)
    in_band = sum(bool(row.proof and row.proof.in_band) for row in rows)
    dangers = sum(bool(row.proof and all(h.happened for h in row.proof.hazards)) for row in rows)
    if json:
        result_json(
            {
                "green": green,
                "dangers_happen": dangers,
                "in_band": in_band,
                "cases": len(rows),
                "paper": {"successes": PAPER_SUCCESSES, "cases": PAPER_CASES},
                "rows": [row.to_data() for row in rows],
            }
        )
    else:
        _print_table(rows, f"ours {green}/{len(rows)}, the paper {PAPER_SUCCESSES}/{PAPER_CASES}")
        _print_danger(
            rows,
            f"all dangers happen in {dangers}/{len(rows)} cases (the paper {PAPER_TRUE}/"
            f"{PAPER_CASES}), the target is reached in {in_band}/{len(rows)}",
        )
    if any(not row.understood or row.problem or "failed" in row.checks.values() for row in rows):
        raise typer.Exit(1)


def _print_table(rows: list[Row], caption: str) -> None:
    checkers = list(dict.fromkeys(name for row in rows for name in row.checks))
    table = Table(caption=f"cases with every check passed: {caption}", caption_justify="left")
    table.add_column("case", no_wrap=True)
    for name in ("under-stood", "partici-pants", "scenarios", "files", *checkers):
        table.add_column(
            name.replace("-", "-\n").replace("openscen", "open-\nscen"), justify="center"
        )
    marks = {"passed": "yes", "failed": "NO", "not_run": "not run", "": "-"}
    for row in rows:
        table.add_row(
            row.case,
            "yes" if row.understood else f"NO: {', '.join(row.wrong_fields)}",
            str(row.participants),
            str(row.scenarios),
            str(row.files) if row.problem is None else f"none: {row.problem}",
            *(marks[row.checks.get(name, "")] for name in checkers),
        )
    Console().print(table)


def _print_danger(rows: list[Row], caption: str) -> None:
    table = Table(caption=caption, caption_justify="left")
    for name in ("case", "dangers, by which margin", "criticality"):
        table.add_column(name, overflow="fold")
    for name in ("in\nband", "avoid-\nable", "other\negos", "esmini\nagrees"):
        table.add_column(name, justify="center", overflow="fold")
    table.add_column("search", justify="right", overflow="fold")
    for row in rows:
        proof = row.proof
        if proof is None:
            table.add_row(row.case, "-")
            continue
        measure = proof.of(proof.measure)
        table.add_row(
            row.case.removeprefix("paper-"),
            "\n".join(_danger(hazard) for hazard in proof.hazards) or "none asked for",
            "-" if measure is None else f"{measure.name} {measure.in_words}",
            "yes" if proof.in_band else "NO",
            {"avoidable": "yes", "unavoidable": "no"}.get(row.verdict or "", "-"),
            {True: "yes", False: "no", None: "-"}[row.reactive],
            {True: "yes", False: "NO", None: "not run"}[row.esmini_agrees],
            f"{proof.evaluations}" + ("" if row.search_s is None else f"\n{row.search_s:.2f} s"),
        )
    Console().print(table)


def _danger(hazard: HazardProof) -> str:
    name = str(hazard.kind).replace("_", " ")
    if not hazard.happened:
        return f"{name}: NO"
    return name if hazard.margin is None else f"{name}: {hazard.margin:.2f} {hazard.unit}"

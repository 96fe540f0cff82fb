"""scegen simulate: our own prediction of a concrete scenario, as a table of movements."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from scegen.cli.options import OutputFile
from scegen.cli.writing import write_text
from scegen.errors import InputError

CONCRETE_FILE = "concrete.yaml"


def simulate(
    place: Annotated[
        Path, typer.Argument(metavar="DIR|FILE", help="A scenario folder or a concrete.yaml.")
    ],
    csv: Annotated[
        bool, typer.Option("--csv", help="As CSV (the one format, and so the default).")
    ] = True,
    output: OutputFile = None,
    dt: Annotated[
        float, typer.Option(min=0.001, max=1.0, help="Time step in s; esmini is played at 0.05.")
    ] = 0.05,
) -> None:
    """Simulate a scenario: time, id, x, y, heading and speed of everybody, in SI units."""
    del csv
    from scegen.motion import build_paths
    from scegen.motion import simulate as run
    from scegen.motion.traces import traces_csv
    from scegen.road import build_network
    from scegen.scenario.concrete import ConcreteScenario
    from scegen.scenario.files import load

    concrete = load(_concrete_file(place), ConcreteScenario)
    paths = build_paths(concrete, build_network(concrete.road))
    table = traces_csv(run(concrete, paths, dt_s=dt))
    write_text(table, output)


def _concrete_file(place: Path) -> Path:
    if not place.is_dir():
        return place
    if (place / CONCRETE_FILE).is_file():
        return place / CONCRETE_FILE
    inside = sorted(place.glob(f"scenarios/*/{CONCRETE_FILE}"))
    if len(inside) == 1:
        return inside[0]
    problem = f"holds {len(inside)} scenarios" if inside else f"holds no {CONCRETE_FILE}"
    raise InputError(
        problem, where=str(place), hint="name one scenario folder made by scegen generate"
    )

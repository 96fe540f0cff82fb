"""scegen concretize: one logical scenario to a concrete one."""

from pathlib import Path
from typing import Annotated

import typer

from scegen.cli.console import write_bytes
from scegen.cli.options import JsonFlag, OutputFile, SeedOption


def concretize(
    source: Annotated[Path, typer.Argument(metavar="LOGICAL", help="logical.json")],
    index: Annotated[int, typer.Option("--index", "-i", min=0, help="Which logical scenario.")],
    seed: SeedOption = 0,
    json: JsonFlag = False,
    output: OutputFile = None,
) -> None:
    """Choose all numbers of one logical scenario."""
    from scegen.concretization import concretize as choose_numbers
    from scegen.pipeline.picking import pick
    from scegen.scenario.files import load, to_json, to_yaml
    from scegen.scenario.logical import LogicalSet

    logical = load(source, LogicalSet)
    scenario = pick(logical, str(index), option="--index")[0]
    concrete = choose_numbers(logical.functional, scenario, seed=seed)
    text = to_json(concrete) if json else to_yaml(concrete)
    write_bytes(text.encode(), output)

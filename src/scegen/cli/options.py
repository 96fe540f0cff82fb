"""Options that mean the same in several commands."""

from pathlib import Path
from typing import Annotated

import typer

from scegen.scenario.rule_file import RuleFile
from scegen.scenario.vocabulary import ArmsMode, Reduction

CAMPAIGN = ("campaign", "a campaign", "duckdb", "joblib", "pyarrow")
"""The extra that campaigns need, and its libraries."""

ReductionOption = Annotated[
    Reduction, typer.Option(help="Which assignments count as one scenario.")
]
ArmsOption = Annotated[ArmsMode, typer.Option(help="Whether all arms count alike.")]
WhereOption = Annotated[
    str | None, typer.Option(help="Only scenarios for which this holds, such as yields(ego).")
]
RulesOption = Annotated[
    Path | None, typer.Option(help="Only scenarios that keep the ASP rules in this file.")
]
JsonFlag = Annotated[bool, typer.Option("--json", help="Print JSON.")]
OutputFile = Annotated[
    Path | None, typer.Option("--output", "-o", help="Write to this file instead of stdout.")
]
SeedOption = Annotated[int, typer.Option(min=0, help="Seed of everything random.")]
ScenarioOption = Annotated[
    str | None, typer.Option(help="Which scenario of the folder, by name or its number.")
]


def rules_of(path: Path | None) -> RuleFile | None:
    """The rules in a file, if one is named.

    Raises:
        InputError: it cannot be read.
    """
    from scegen.scenario.files import read_text

    return None if path is None else RuleFile(read_text(path), str(path))

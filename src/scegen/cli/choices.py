"""Options by which a list of scenarios is narrowed, the same wherever one is made."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

WhereOption = Annotated[
    str | None, typer.Option(help="Only scenarios for which this holds, such as yields(ego).")
]
RulesOption = Annotated[
    Path | None, typer.Option(help="Only scenarios that keep the ASP rules in this file.")
]

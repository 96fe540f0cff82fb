"""scegen schema: the published JSON Schema of a level."""

from typing import Annotated, Literal

import typer

from scegen.cli.console import result_json


def schema(
    level: Annotated[
        Literal["functional", "logical", "concrete", "campaign"],
        typer.Argument(metavar="LEVEL", help="functional, logical, concrete or campaign."),
    ],
) -> None:
    """Print the JSON Schema of a level."""
    from scegen.scenario.files import json_schema

    if level == "campaign":
        from scegen.campaign.order import Campaign

        result_json(Campaign.model_json_schema())
        return
    result_json(json_schema(level))

"""scegen campaign: many descriptions, many scenarios. ``run`` is what it does if not said."""

from typing import Any

import typer
from typer.core import TyperGroup

from scegen.cli.campaign.report import report
from scegen.cli.campaign.run import run
from scegen.cli.campaign.select import select


class _RunUnlessSaid(TyperGroup):
    """``scegen campaign RUN.yaml`` stands for ``scegen campaign run RUN.yaml``."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:  # noqa: ANN401 - typer's own
        if args and args[0] not in {"--help", *self.commands}:
            args = ["run", *args]
        return super().parse_args(ctx, args)


app = typer.Typer(
    cls=_RunUnlessSaid,
    help="Make thousands of scenarios from many descriptions (RUN.yaml, .jsonl or .txt, -o DIR), "
    "and look through them.",
    no_args_is_help=True,
    rich_markup_mode=None,
)


app.command("run")(run)
app.command("report")(report)
app.command("select")(select)

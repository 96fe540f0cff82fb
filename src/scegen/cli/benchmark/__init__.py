"""scegen benchmark: measured claims, one file each."""

import typer

from scegen.cli.benchmark.paper import paper
from scegen.cli.benchmark.said import said
from scegen.cli.benchmark.understand import understand

app = typer.Typer(help="Repeat measured claims.", no_args_is_help=True, rich_markup_mode=None)


app.command("paper")(paper)
app.command("said")(said)
app.command("understand")(understand)

"""The application: its commands, and one place where errors become messages and exit codes."""

import atexit
import gc
import os
import re
import sys
from io import TextIOWrapper
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from scegen import __version__
from scegen.cli import (
    benchmark,
    campaign,
    check,
    concretize,
    doctor,
    enumerate,  # noqa: A004 - named after its command
    gallery,
    generate,
    parameterise,
    play,
    render,
    schema,
    serve,
    trace,
    understand,
)
from scegen.cli.console import INTERRUPTED, stderr
from scegen.errors import ScegenError

_OBJECTS_BEFORE_COLLECTING = 200_000
_PLAINLY = {
    r"Input should be a valid (integer|int).*": "it must be a whole number",
    r"Input should be a valid (number|float).*": "it must be a number",
    r"Input should be greater than or equal to": "it must be at least",
    r"Input should be less than or equal to": "it must be at most",
    r"Value error, ": "",
}
"""What is said of an option's value in the words of a library, and in ours."""


class _Commands(TyperGroup):
    """Says so when a command is interrupted, and speaks of wrong options in plain words."""

    def invoke(self, ctx: Any) -> object:  # noqa: ANN401 - typer keeps the type to itself
        try:
            return super().invoke(ctx)
        except typer.BadParameter as error:
            for theirs, ours in _PLAINLY.items():
                error.message = re.sub(theirs, ours, error.message)
            raise
        except KeyboardInterrupt:
            stderr.print("interrupted")
            raise typer.Exit(INTERRUPTED) from None


app = typer.Typer(
    name="scegen",
    cls=_Commands,
    help="From an English description of traffic to every scenario it can mean, "
    "as OpenDRIVE and OpenSCENARIO files.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"scegen {__version__}")
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Say the version.")
    ] = False,
) -> None:
    pass


app.command("generate")(generate.generate)
app.command("understand")(understand.understand)
app.command("enumerate")(enumerate.enumerate_)
app.command("gallery")(gallery.gallery)
app.command("concretize")(concretize.concretize)
app.command("parameterise")(parameterise.parameterise)
app.command("check")(check.check)
app.command("trace")(trace.trace)
app.command("play")(play.play)
app.command("render")(render.render)
app.command("serve")(serve.serve)
app.command("schema")(schema.schema)
app.command("doctor")(doctor.doctor)
app.add_typer(campaign.app, name="campaign")
app.add_typer(benchmark.app, name="benchmark")


def _leave_garbage() -> None:
    """Look through no objects when the process ends, which would be a sixth of a short run."""
    if "duckdb" not in sys.modules:  # it complains of each of its own that is left
        gc.freeze()


def main() -> None:
    """Run the command line; every expected error is one message and an exit code."""
    # Loading makes hundreds of thousands of objects that live to the end: looking through them
    # for garbage again and again costs a tenth of a short run.
    gc.set_threshold(_OBJECTS_BEFORE_COLLECTING)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):  # results are UTF-8 in every locale, as files are
            stream.reconfigure(encoding="utf-8")
    atexit.register(_leave_garbage)
    try:
        app()
    except ScegenError as error:
        stderr.print("error:", style="bold red", end=" ")
        stderr.print(error.render(), markup=False)
        sys.exit(error.exit_code)
    except BrokenPipeError:
        # the reader of stdout is gone (| head); Python would complain again at exit
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)

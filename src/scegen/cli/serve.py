"""scegen serve: the page."""

import socket
from pathlib import Path
from typing import Annotated

import typer

from scegen.cli.console import result, say
from scegen.cli.llm import Asked, BudgetOption, ModelOption, TimeoutOption, UrlOption
from scegen.errors import InputError, of_extra


def serve(
    project: Annotated[
        Path, typer.Argument(metavar="FOLDER", help="Project folder; made when first needed.")
    ] = Path("scegen-project"),
    host: Annotated[
        str, typer.Option(help="Address to listen on; others than the loopback want a token.")
    ] = "127.0.0.1",
    port: Annotated[int, typer.Option(min=0, max=65535, help="Port; 0 takes a free one.")] = 8750,
    show: Annotated[bool, typer.Option("--open", help="Open it in a browser.")] = False,
    llm: ModelOption = None,
    llm_url: UrlOption = None,
    llm_budget: BudgetOption = None,
    llm_timeout: TimeoutOption = None,
) -> None:
    """Open the page: describe, choose, make dangerous, watch, take away."""
    models = Asked(llm, llm_url, llm_budget, llm_timeout).settings()
    if project.exists() and not project.is_dir():
        raise InputError("is a file, not a folder", where=str(project))
    with of_extra("web", "the page", "nicegui", "uvicorn", "fastapi"):
        from scegen.web.server import address
        from scegen.web.server import serve as run
    place = address(host, _free(host, port))

    def ready() -> None:
        say(f"project folder {project.resolve()}; Ctrl-C ends it")
        result(place.url)

    run(place, project, models, ready=ready, show=show)


def _free(host: str, port: int) -> int:
    """The port, if it is free; any free one for 0.

    Raises:
        InputError: something listens there already, or there is no such address.
    """
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    try:
        with socket.socket(family, socket.SOCK_STREAM) as trial:
            trial.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            trial.bind((host, port))
            found: int = trial.getsockname()[1]
            return found
    except OSError as error:
        raise InputError(
            f"cannot listen on {host}:{port}: {error.strerror}",
            where="--port",
            hint="choose another with --port, or 0 for a free one",
        ) from error

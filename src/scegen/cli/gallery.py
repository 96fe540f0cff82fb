"""scegen gallery: logical scenarios as one picture, SVG or PNG."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from scegen.cli.console import result, write_bytes
from scegen.errors import InputError

if TYPE_CHECKING:
    from scegen.scenario.logical import LogicalSet


def gallery(
    source: Annotated[
        Path, typer.Argument(metavar="FOLDER|LOGICAL", help="A generated folder or logical.json.")
    ],
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", help="Picture, .svg or .png; beside its source if not said."
        ),
    ] = None,
    page: Annotated[int, typer.Option(min=1, help="Which page, where there are several.")] = 1,
    moves: Annotated[
        str | None, typer.Option(help="Show all with these moves, such as 1,2,2.")
    ] = None,
) -> None:
    """Draw the logical scenarios of a folder as gallery.png, or where --output says.

    Many are folded by their moves, and paged.
    """
    from scegen.pipeline.folder import record
    from scegen.pipeline.source import recounted
    from scegen.scenario.files import load
    from scegen.scenario.logical import LogicalSet

    path = source / "logical.json" if source.is_dir() else source
    picture = output or path.with_name("gallery.png")
    require_picture(picture, "--output")
    if source.is_dir() and not path.exists():
        raise InputError(
            "holds no logical.json",
            where=str(source),
            hint="What was made from a concrete.yaml has no list of logical scenarios.",
        )
    logical = recounted(load(path, LogicalSet))
    write_picture(logical, picture, page, None if moves is None else _moves(moves))
    record(picture)
    result(str(picture))


def _moves(text: str) -> tuple[int, ...]:
    try:
        return tuple(int(move) for move in text.replace(",", " ").split())
    except ValueError as error:
        raise InputError(f"{text!r} is no list of numbers", where="--moves") from error


def require_picture(path: Path, option: str) -> None:
    """Refuse what is no picture before anything is worked out.

    Raises:
        InputError: the name ends neither in .svg nor in .png.
    """
    if path.suffix.lower() not in {".svg", ".png"}:
        raise InputError(
            f"{path} is neither .svg nor .png", where=option, hint="Name the picture gallery.png."
        )


def write_picture(
    logical: LogicalSet, path: Path, page: int = 1, moves: tuple[int, ...] | None = None
) -> None:
    """Draw to this file; its name says how."""
    from scegen.report.gallery import gallery_svg

    svg = gallery_svg(logical, page=page, moves=moves)
    if path.suffix.lower() == ".svg":
        write_bytes(svg.encode(), path)
        return
    from scegen.report.raster import png_of

    write_bytes(png_of(svg), path)

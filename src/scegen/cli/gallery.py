"""scegen gallery: logical scenarios as one picture, SVG or PNG."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from scegen.cli.console import result
from scegen.cli.writing import write_bytes
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
) -> None:
    """Draw the logical scenarios of a folder as gallery.png, or where --output says."""
    from scegen.pipeline.source import recounted
    from scegen.scenario.files import load
    from scegen.scenario.logical import LogicalSet

    path = source / "logical.json" if source.is_dir() else source
    picture = output or path.with_name("gallery.png")
    require_picture(picture, "--output")
    logical = recounted(load(path, LogicalSet))
    write_picture(logical, picture)
    result(str(picture))


def require_picture(path: Path, option: str) -> None:
    """Refuse what is no picture before anything is worked out.

    Raises:
        InputError: the name ends neither in .svg nor in .png.
    """
    if path.suffix.lower() not in {".svg", ".png"}:
        raise InputError(
            f"{path} is neither .svg nor .png", where=option, hint="Name the picture gallery.png."
        )


def write_picture(logical: LogicalSet, path: Path) -> None:
    """Draw to this file; its name says how."""
    from scegen.report.gallery import gallery_svg

    svg = gallery_svg(logical)
    if path.suffix.lower() == ".svg":
        write_bytes(svg.encode(), path)
        return
    from scegen.report.raster import png_of

    write_bytes(png_of(svg), path)

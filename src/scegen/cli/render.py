"""scegen render: a scenario as moving pictures for slides and READMEs."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from scegen.cli.console import counting, result
from scegen.cli.simulate import CONCRETE_FILE
from scegen.cli.writing import write_bytes
from scegen.errors import InputError
from scegen.pipeline.place import scenario_file

if TYPE_CHECKING:
    from scegen.report.film import Film

_NAME = "animation"


class ThemeName(StrEnum):
    """Variants of the colours."""

    LIGHT = "light"
    DARK = "dark"


def render(
    place: Annotated[
        Path,
        typer.Argument(metavar="DIR|FILE", help="A generated folder, a scenario, concrete.yaml."),
    ],
    gif: Annotated[bool, typer.Option("--gif", help="An animated GIF (the default).")] = False,
    mp4: Annotated[bool, typer.Option("--mp4", help="A video; needs ml-scegen[video].")] = False,
    png: Annotated[bool, typer.Option("--png", help="One still picture, see --at.")] = False,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="File; beside concrete.yaml if not said."),
    ] = None,
    scenario: Annotated[
        str | None, typer.Option(help="Which scenario of the folder, by name or its number.")
    ] = None,
    begin: Annotated[
        float | None,
        typer.Option("--from", min=0.0, help="Begin, s; 6 s before the closest approach."),
    ] = None,
    end: Annotated[
        float | None, typer.Option("--to", min=0.0, help="End, s; 3 s after the closest approach.")
    ] = None,
    at: Annotated[
        float | None,
        typer.Option("--at", min=0.0, help="Moment of --png, s; the closest approach."),
    ] = None,
    fps: Annotated[
        float | None,
        typer.Option(min=1.0, max=50.0, help="Pictures a second; 10, of video 25."),
    ] = None,
    speed: Annotated[
        float, typer.Option(min=0.05, max=8.0, help="1 is real time, 0.25 slow motion.")
    ] = 1.0,
    width: Annotated[int, typer.Option(min=240, max=1920, help="Width in pixels.")] = 720,
    theme: Annotated[ThemeName, typer.Option(help="Colours.")] = ThemeName.LIGHT,
) -> None:
    """Render a scenario as animated GIF, video or a still picture."""
    from scegen.motion import build_paths
    from scegen.pipeline.folder import record
    from scegen.report.film import Cut, make_film
    from scegen.report.theme import THEMES
    from scegen.road import build_network
    from scegen.scenario.concrete import ConcreteScenario
    from scegen.scenario.files import load

    ending = _ending(output, gif=gif, mp4=mp4, png=png)
    if begin is not None and end is not None and end <= begin:
        raise InputError(f"ends at {end:g} s, not after --from {begin:g} s", where="--to")
    source = scenario_file(place, CONCRETE_FILE, scenario)
    target = output or source.with_name(f"{_NAME}.{ending}")
    concrete = load(source, ConcreteScenario)
    network = build_network(concrete.road, concrete.name)
    if at is not None:
        begin, end = at, max(end or at, at)
    rate = fps or (25.0 if ending == "mp4" else 10.0)
    cut = Cut(begin, end, rate, speed, 2 * (width // 2))
    film = make_film(concrete, network, build_paths(concrete, network), cut, THEMES[theme])
    _write(film, target, ending, rate)
    record(target)
    result(str(target))


def _ending(output: Path | None, *, gif: bool, mp4: bool, png: bool) -> str:
    """What to make: what is asked for, else what the name of the file says, else a GIF."""
    asked = [name for name, wanted in (("gif", gif), ("mp4", mp4), ("png", png)) if wanted]
    if len(asked) > 1:
        raise InputError("one of --gif, --mp4 and --png at a time", where="scegen render")
    named = output.suffix.lower().lstrip(".") if output is not None else ""
    ending = asked[0] if asked else named or "gif"
    if ending not in {"gif", "mp4", "png"} or (named and named != ending):
        raise InputError(
            f"{output} is no .{asked[0] if asked else 'gif, .mp4 or .png'}", where="--output"
        )
    return ending


def _write(film: Film, target: Path, ending: str, rate: float) -> None:
    from scegen.report.cinema import gif_of, write_mp4
    from scegen.report.raster import png_of

    if ending == "png":
        write_bytes(png_of(film.picture(film.critical)), target)
        return
    with counting(len(film)) as watch:
        if ending == "gif":
            write_bytes(gif_of(film, watch), target)
        else:
            write_mp4(film, target, rate, watch)

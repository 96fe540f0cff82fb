"""scegen render: a scenario as moving pictures for slides and READMEs."""

from pathlib import Path
from typing import Annotated, Literal

import typer

from scegen.cli.console import counting, result, write_bytes
from scegen.cli.options import ScenarioOption
from scegen.errors import InputError
from scegen.pipeline.place import scenario_file

_NAME = "animation"


def render(
    place: Annotated[
        Path,
        typer.Argument(metavar="DIR|FILE", help="A generated folder, a scenario, concrete.yaml."),
    ],
    gif: Annotated[bool, typer.Option("--gif", help="An animated GIF (the default).")] = False,
    mp4: Annotated[bool, typer.Option("--mp4", help="A video; needs ml-scegen[video].")] = False,
    png: Annotated[bool, typer.Option("--png", help="One still picture, see --at.")] = False,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="File; beside concrete.yaml if not said.")
    ] = None,
    scenario: ScenarioOption = None,
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
        float | None, typer.Option(min=1.0, max=50.0, help="Pictures a second; 10, of video 25.")
    ] = None,
    speed: Annotated[
        float, typer.Option(min=0.05, max=8.0, help="1 is real time, 0.25 slow motion.")
    ] = 1.0,
    width: Annotated[int, typer.Option(min=240, max=1920, help="Width in pixels.")] = 720,
    theme: Annotated[Literal["light", "dark"], typer.Option(help="Colours.")] = "light",
) -> None:
    """Render a scenario as animated GIF, video or a still picture."""
    from scegen.checking.subject import CONCRETE_FILE
    from scegen.pipeline.folder import record
    from scegen.pipeline.rendering import PNG, RATES, rendered
    from scegen.report.film import Cut
    from scegen.report.theme import THEMES
    from scegen.scenario.concrete import ConcreteScenario
    from scegen.scenario.files import load

    ending = _ending(output, gif=gif, mp4=mp4, png=png)
    if end is not None and end <= (begin or 0.0):
        raise InputError(f"ends at {end:g} s, not after --from {begin or 0.0:g} s", where="--to")
    if at is not None and ending != PNG:
        raise InputError(f"is the moment of a .png, not of a .{ending}", where="--at")
    source = scenario_file(place, CONCRETE_FILE, scenario)
    target = output or source.with_name(f"{_NAME}.{ending}")
    concrete = load(source, ConcreteScenario)
    for option, moment_s in (("--from", begin), ("--at", at)):
        if moment_s is not None and moment_s > concrete.duration_s:
            raise InputError(f"lies beyond the end, {concrete.duration_s:g} s", where=option)
    if at is not None:
        begin, end = at, max(end or at, at)
    cut = Cut(begin, end, fps or RATES[ending], speed, 2 * (width // 2))
    with counting() as watch:
        write_bytes(rendered(concrete, ending, cut, THEMES[theme], watch), target)
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

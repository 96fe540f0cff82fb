"""scegen play and doctor: what this machine has, and playing in it."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path
from typing import Annotated

import typer

from scegen.cli.console import result, result_json, say
from scegen.cli.llm import ModelOption, TimeoutOption, UrlOption
from scegen.errors import InputError, MissingToolError


def play(
    folder: Annotated[Path, typer.Argument(help="A scenario folder, or one made by generate.")],
    scenario: Annotated[
        str | None, typer.Option(help="Which scenario of the folder, by name or its number.")
    ] = None,
    headless: Annotated[bool, typer.Option("--headless", help="Play without a window.")] = False,
) -> None:
    """Play a scenario in esmini."""
    from scegen.checking.environment import ESMINI_HINT, esmini

    file = _scenario_file(folder, scenario)
    program = esmini()
    if program is None:
        raise MissingToolError("esmini is not on PATH", hint=ESMINI_HINT)
    if not headless and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        say("no screen here: playing without a window")
        headless = True
    view = "--headless --fixed_timestep 0.05" if headless else "--window 60 60 1200 700"
    arguments = [str(program), "--osc", file.name, *view.split(), "--logfile_path", os.devnull]
    code = subprocess.run(arguments, cwd=file.parent, check=False).returncode
    if code:
        say(f"esmini ended with exit code {code}")
        raise typer.Exit(1)


def _scenario_file(folder: Path, scenario: str | None) -> Path:
    if folder.is_file():
        return folder
    found = [folder / "scenario.xosc"] if (folder / "scenario.xosc").is_file() else []
    found = found or sorted(folder.glob("scenarios/*/scenario.xosc"))
    if not found:
        raise InputError(
            "holds no scenario.xosc",
            where=str(folder),
            hint="name a folder made by scegen generate, or one of its scenarios",
        )
    if scenario is None:
        return found[0]
    for file in found:
        if scenario == file.parent.name or (
            scenario.isdigit() and file.parent.name.startswith(f"{int(scenario):03d}-")
        ):
            return file
    names = ", ".join(file.parent.name for file in found)
    raise InputError(
        f"there is no scenario {scenario!r}", where=str(folder), hint=f"there are: {names}"
    )


def doctor(
    json: Annotated[bool, typer.Option("--json", help="Print JSON.")] = False,
    llm: ModelOption = None,
    llm_url: UrlOption = None,
    llm_timeout: TimeoutOption = None,
) -> None:
    """Say what is installed, what is missing and how to get it; --llm tests a connection."""
    if llm is not None:
        _test_connection(llm, llm_url, llm_timeout, as_json=json)
        return
    from scegen.checking.environment import Tool, installed_tools
    from scegen.llm import INSTALL_LLM, require_llm

    try:
        require_llm()
        libraries = "installed"
    except MissingToolError:
        libraries = None
    tools = (*installed_tools(), Tool("language models", libraries, f"run: {INSTALL_LLM}"))
    if json:
        result_json([{"tool": t.name, "found": t.found, "hint": t.hint} for t in tools])
        return
    for tool in tools:
        mark = "found  " if tool.found else "missing"
        result(f"{mark}  {tool.name:<22} {tool.found or tool.hint}")


def _test_connection(llm: str, url: str | None, timeout: float | None, *, as_json: bool) -> None:
    from scegen.llm import parse_models, require_llm
    from scegen.llm.naming import require_url

    require_llm()
    from scegen.llm.probe import PATIENCE, probe

    address = require_url(url) if url is not None else None
    limits = PATIENCE if timeout is None else PATIENCE.patient(timeout)
    names = parse_models(llm, url=address)
    probes = [probe(name, os.environ, url=address, limits=limits) for name in names]
    if as_json:
        result_json(
            [
                {
                    "model": p.model,
                    "address": p.address,
                    "serves": p.fault is None,
                    "fault": p.fault and p.fault.model_dump(mode="json"),
                    "seconds": round(p.seconds, 3),
                    **p.usage.to_data(),
                }
                for p in probes
            ]
        )
    else:
        for p in probes:
            if p.fault is None:
                result(
                    f"serves   {p.model} at {p.address}: {p.seconds:.1f} s, {p.usage.in_words()}"
                )
            else:
                hint = f"; {p.fault.hint}" if p.fault.hint else ""
                result(f"no use   {p.model} at {p.address}: {p.fault.message}{hint}")
    if any(p.fault for p in probes):
        raise typer.Exit(1)

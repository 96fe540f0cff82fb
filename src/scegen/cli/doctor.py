"""scegen doctor: what this machine has, what is missing and how to get it."""

import os

import typer

from scegen.cli.console import result, result_json
from scegen.cli.llm import ModelOption, TimeoutOption, UrlOption
from scegen.cli.options import JsonFlag
from scegen.errors import MissingToolError


def doctor(
    json: JsonFlag = False,
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
            known, told = "serves   ", f"{p.seconds:.1f} s, {p.usage.in_words()}"
            if p.fault is not None:
                hint = f"; {p.fault.hint}" if p.fault.hint else ""
                known, told = "no use   ", f"{p.fault.message}{hint}"
            result(f"{known}{p.model} at {p.address}: {told}")
    if any(p.fault for p in probes):
        raise typer.Exit(1)

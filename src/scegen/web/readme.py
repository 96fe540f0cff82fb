"""The README of what is taken away."""

from __future__ import annotations

from scegen import __version__
from scegen.web.made import Made
from scegen.web.steps.take_away import MODEL_SPOKE, again
from scegen.web.work import Work

_OUTCOMES = {
    "held": "every check passed, all that was said holds, the target is reached",
    "open": "no check failed and all that was said holds, but something was not reached or not run",
    "failed": "a check failed, or something that was said does not hold; see the report",
}


def readme(work: Work) -> str:
    """What lies in the folder, what was said, and how to make it again."""
    if work.made is None:
        return ""
    made = work.made
    description = made.functional.description if made.functional is not None else ""
    quoted = "\n".join(f"> {line}" for line in description.splitlines())
    rows = "\n".join(f"- `scenarios/{s.name}/`: {_OUTCOMES[s.state]}" for s in made.scenarios)
    return (
        f"# {made.folder.name}\n\n{quoted}\n\n"
        f"Made by ML-SceGen {__version__}. Open `report.html`; it needs no network.\n\n"
        f"{rows}\n\n"
        "Each scenario folder holds `road.xodr` (OpenDRIVE) and `scenario.xosc` (OpenSCENARIO), "
        "`concrete.yaml` with every number, and `proof.json` with every statement of the "
        "description and whether it holds. `functional.yaml` is what was understood, "
        "`logical.json` every way in which it can happen.\n\n"
        f"{_how(made)}"
        "Check and play them:\n\n    scegen check .\n    scegen play .\n"
    )


def _how(made: Made) -> str:
    """The command that makes the files again, where the folder tells it."""
    command = again(made)
    if command is None:
        return ""
    spoken = f"{MODEL_SPOKE}\n\n" if "llm" in made.summary else ""
    return f"The same files again, byte for byte:\n\n    {command}\n\n{spoken}"

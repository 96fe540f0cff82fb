"""The scenario that a folder stands for: its own, or one of those that generate made in it."""

from pathlib import Path

from scegen.errors import InputError

_ENDINGS = {".xosc": {".xosc"}, ".yaml": {".yaml", ".yml", ".json"}}
"""How a file may be called instead."""


def scenario_file(place: Path, name: str, scenario: str | None = None) -> Path:
    """The file ``name`` of a scenario; ``place`` itself where it is a file.

    Without ``scenario``, a name or a number, the first one in the folder.

    Raises:
        InputError: there is none.
    """
    if place.is_file():
        if place.suffix.lower() not in _ENDINGS[Path(name).suffix]:
            raise InputError(
                "is no file of a scenario folder",
                where=str(place),
                hint=f"name a folder made by scegen generate, or a {name} in it",
            )
        return place
    found = [place / name] if (place / name).is_file() else []
    found = found or sorted(place.glob(f"scenarios/*/{name}"))
    if not found:
        raise InputError(
            f"holds no {name}",
            where=str(place),
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
        f"there is no scenario {scenario!r}", where=str(place), hint=f"there are: {names}"
    )

"""The scenario whose numbers become parameters: a logical one, or one that was made."""

from __future__ import annotations

from pathlib import Path

from scegen.checking.subject import CONCRETE_FILE
from scegen.concretization import concretize
from scegen.errors import InputError
from scegen.pipeline.picking import pick
from scegen.pipeline.place import scenario_file
from scegen.pipeline.source import origin_of
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import load, load_any
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalSet


def parameter_source(
    place: Path, index: int | None, seed: int, scenario: str | None = None
) -> tuple[FunctionalScenario | None, ConcreteScenario]:
    """What a logical.json with an index, a scenario folder or a concrete.yaml stands for.

    Of a folder with several, ``scenario`` names one; the first is taken without.

    Raises:
        InputError: none of these, or no index where one is needed.
        InfeasibleError: the logical scenario cannot be made concrete.
    """
    found = load_any(place) if place.is_file() else None
    if isinstance(found, LogicalSet):
        if index is None:
            raise InputError(
                f"holds {len(found.scenarios)} scenarios", where=str(place), hint="choose --index"
            )
        if scenario is not None:
            raise InputError("chooses in a folder; of a file, --index does", where="--scenario")
        logical = pick(found, str(index), option="--index")[0]
        return found.functional, concretize(found.functional, logical, seed=seed)
    if found is not None and not isinstance(found, ConcreteScenario):
        raise InputError(
            f"is a {found.level} scenario",
            where=str(place),
            hint="name a logical.json (scegen enumerate --json), or a scenario folder",
        )
    if index is not None:
        raise InputError("names one scenario: there is nothing to choose", where="--index")
    file = scenario_file(place, CONCRETE_FILE, scenario)
    return origin_of(str(file)).functional, load(file, ConcreteScenario)

"""A scenario with parameters: which one is meant, its files, and sets of values to play it with."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from scegen.checking.subject import CONCRETE_FILE, ROAD_FILE, SCENARIO_FILE
from scegen.concretization import concretize
from scegen.criticality.search.rebuild import DECIMALS
from scegen.errors import InfeasibleError, InputError
from scegen.export.openscenario import write_distribution, write_openscenario, write_parameterised
from scegen.export.openscenario_parameters import Declared
from scegen.motion.batch.arrays import Floats
from scegen.pipeline.export import road_file
from scegen.pipeline.parameterising import (
    ParameterSpace,
    UnusableError,
    frozen,
    parameter_space,
    parameterised,
)
from scegen.pipeline.picking import pick
from scegen.pipeline.place import scenario_file
from scegen.pipeline.source import origin_of
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import load, load_any, to_yaml
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalSet

PARAMETERISED_FILE = "parameterised.xosc"
VALUES_FILE = "values.xosc"
SETS_FOLDER = "sets"
_TRIES = 40
"""So many draws are made for every set that is asked for, at most."""


@dataclass(frozen=True, slots=True)
class ParameterSet:
    """One set of values and the concrete scenario that has them."""

    values: dict[str, float]
    concrete: ConcreteScenario


@dataclass(frozen=True, slots=True)
class ParameterFiles:
    """What was made: files by name, parameters, sets, and what could not be had.

    ``frozen`` are numbers that no parameter decides; ``passed_over`` says how many draws were not
    taken, by reason.
    """

    files: dict[str, bytes]
    declared: Sequence[Declared]
    sets: Sequence[ParameterSet]
    frozen: Sequence[str]
    passed_over: Counter[str] = field(default_factory=Counter)


def write_parameter_files(
    functional: FunctionalScenario | None,
    concrete: ConcreteScenario,
    *,
    count: int,
    seed: int,
    alone: bool = False,
) -> ParameterFiles:
    """The scenario with parameters, its road, and ``count`` random sets of values.

    With ``alone``, every set is also written as the files of a concrete scenario of its own.

    Raises:
        InputError: fewer than one set is asked for.
        InfeasibleError: the scenario cannot be built, has no parameters, or no such sets.
    """
    if count < 1:
        raise InputError(f"must be at least 1, not {count}", where="--sets")
    space = parameter_space(functional, concrete)
    if not space.names:
        raise InfeasibleError("has no number that could be a parameter", where=concrete.name)
    try:
        made = parameterised(space)
    except UnusableError as reason:
        raise InfeasibleError(f"cannot be parameterised: {reason}", where=concrete.name) from reason
    passed_over: Counter[str] = Counter()
    sets = [
        ParameterSet(space.values(x, one), one)
        for x, one in _drawn(space, count, seed, passed_over)
    ]
    road = road_file(space.concrete.road, space.concrete.signals)
    files = {
        ROAD_FILE: road,
        PARAMETERISED_FILE: write_parameterised(
            space.concrete, space.paths(space.concrete), made, road_file=ROAD_FILE
        ),
        VALUES_FILE: write_distribution(concrete, PARAMETERISED_FILE, [s.values for s in sets]),
    }
    for number, one in enumerate(sets, start=1) if alone else ():
        folder = _set_folder(number)
        paths = space.paths(one.concrete)
        files[f"{folder}/{ROAD_FILE}"] = road
        files[f"{folder}/{SCENARIO_FILE}"] = write_openscenario(one.concrete, paths)
        files[f"{folder}/{CONCRETE_FILE}"] = to_yaml(one.concrete).encode()
    return ParameterFiles(files, made.declared, sets, frozen(space, made.numbers), passed_over)


def set_files(folder: Path, count: int) -> dict[str, Path]:
    """The scenario files of sets of their own, by name, where they were written."""
    names = [_set_folder(number) for number in range(1, count + 1)]
    return {name: folder / name / SCENARIO_FILE for name in names}


def _set_folder(number: int) -> str:
    return f"{SETS_FOLDER}/{number:03d}"


def _drawn(
    space: ParameterSpace, count: int, seed: int, passed_over: Counter[str]
) -> list[tuple[Floats, ConcreteScenario]]:
    """Values drawn evenly within the bounds, with their scenarios; those that give none counted."""
    rng = np.random.Generator(np.random.PCG64(seed))
    low, high = space.bounds
    found: list[tuple[Floats, ConcreteScenario]] = []
    for _ in range(_TRIES * count):
        x = np.clip(np.round(rng.uniform(low, high), DECIMALS), low, high)
        try:
            found.append((x, space.at(x)))
        except UnusableError as reason:
            passed_over[str(reason)] += 1
        if len(found) == count:
            return found
    worst = "; ".join(f"{n} times {reason}" for reason, n in passed_over.most_common(3))
    raise InfeasibleError(
        f"only {len(found)} of {count} sets were found in {_TRIES * count} draws: {worst}",
        where=space.concrete.name,
        hint="Ask for fewer --sets.",
    )


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

"""Parameters of a scenario by name: swept through values, or spread over their ranges."""

from collections.abc import Iterator, Mapping
from itertools import product
from typing import Any

import numpy as np

from scegen.campaign.order import Sweep
from scegen.errors import InputError
from scegen.scenario.evidence import Evidence, EvidenceSource
from scegen.scenario.files import from_data
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.model import Interval
from scegen.units import SPEED_UNITS_MPS

_UNITS = {"_kph": ("_mps", SPEED_UNITS_MPS["km/h"]), "_mph": ("_mps", SPEED_UNITS_MPS["mph"])}
_EGO = "ego."


def points(sweep: Mapping[str, Sweep]) -> Iterator[dict[str, float]]:
    """Every combination of the values, by the names as they are written; one without a sweep."""
    names = sorted(sweep)
    for values in product(*(sweep[name].points for name in names)):
        yield dict(zip(names, values, strict=True))


def at_point(functional: FunctionalScenario, point: Mapping[str, float]) -> FunctionalScenario:
    """The description with these numbers in place of what it says of them.

    Raises:
        InputError: it has no such parameter, or the number cannot stand there.
    """
    for name, value in point.items():
        plain, factor = name, 1.0
        for suffix, (si, times) in _UNITS.items():
            if name.endswith(suffix):
                plain, factor = name.removesuffix(suffix) + si, times
        said = Interval(low=value * factor, high=value * factor)
        functional = _said(functional, plain, said, "a point of the sweep", name)
    return functional


def spread(
    functional: FunctionalScenario, logical: LogicalScenario, number: int, count: int, seed: int
) -> tuple[FunctionalScenario, LogicalScenario]:
    """The scenario with every parameter's range cut down to one of ``count`` equal parts.

    Each of the ``count`` concretizations gets every part of every range once (Latin hypercube:
    McKay, Beckman, Conover, Technometrics 21, 1979), in an order of its own by parameter; traffic
    that comes on one arm has one speed. Within its part, the search is free.
    """
    if count == 1:
        return functional, logical
    rng = np.random.Generator(np.random.PCG64(seed))
    arms = {f"{drive.participant}.speed_mps": drive.entry for drive in logical.drives}
    parts: dict[tuple[int | str, float, float], int] = {}
    kept = []
    for parameter in logical.parameters:
        drawn = int(rng.permutation(count)[number])
        arm = None if parameter.reason == "stated" else arms.get(parameter.name)
        alike = parameter.name if arm is None else arm, parameter.low, parameter.high
        part = parts.setdefault(alike, drawn)
        width = (parameter.high - parameter.low) / count
        low = parameter.low + part * width
        cut = parameter.but(low=low, high=low + width, default=low + width / 2)
        kept.append(cut if width > 0.0 else parameter)
        if width > 0.0 and parameter.reason == "stated":
            said = Interval(low=low, high=low + width)
            functional = _said(functional, parameter.name, said, "a part of it", parameter.name)
    return functional, logical.but(parameters=tuple(kept))


def _said(
    functional: FunctionalScenario, name: str, value: Interval, reason: str, told: str
) -> FunctionalScenario:
    """The functional scenario as if its text gave this value."""
    data = functional.model_dump(mode="python")
    if name.startswith(_EGO):
        name = f"{functional.ego.id}.{name.removeprefix(_EGO)}"
    field = _set(data, name, value)
    if field is None:
        raise InputError(
            f"there is no parameter {told!r}",
            where="sweep",
            hint=", ".join((*_told(data), "or the speed of anybody, such as ego.speed_kph")),
        )
    others = tuple(item for item in functional.evidence if item.field != field)
    own = Evidence(field=field, source=EvidenceSource.DEFAULT, reason=reason)
    data["evidence"] = (*others, own)
    return from_data(FunctionalScenario, data, where=f"sweep: {told}")


def _told(data: dict[str, Any]) -> Iterator[str]:
    """The parameters of which the description gives a number."""
    for group in ("participants", "objects", "acts"):
        for one in data[group]:
            yield from _numbers(one, f"{one['id']}.")
    for number, spacing in enumerate(data["spacings"]):
        yield from _numbers(spacing, f"spacing_{number}.")
    yield from _numbers(data["outcome"] or {}, "outcome.")


def _numbers(said: dict[str, Any], before: str) -> Iterator[str]:
    for name, value in said.items():
        if not isinstance(value, dict):
            continue
        if "low" in value:
            yield before + (str(said["measure"]) if name == "value" else name)
        else:
            yield from _numbers(value, f"{before}{name}.")


def _set(data: dict[str, Any], name: str, value: Interval) -> str | None:
    """Put the value where the parameter of this name stands; its path, None if there is none."""
    who, _, quantity = name.partition(".")
    for group in ("participants", "objects", "acts"):
        for number, one in enumerate(data[group]):
            changed = _quantity(one, quantity, value) if one["id"] == who else None
            if changed is not None:
                data[group] = _with(data[group], number, changed)
                return f"{group}.{who}.{quantity.partition('.')[0]}"
    for number, spacing in enumerate(data["spacings"]):
        if who == f"spacing_{number}" and str(spacing["measure"]) == quantity:
            data["spacings"] = _with(data["spacings"], number, {"value": value})
            return f"spacings.{number}.value"
    outcome = data["outcome"] if who == "outcome" else None
    if outcome and (changed := _quantity(outcome, quantity, value)) is not None:
        data["outcome"] = changed
        return f"outcome.{quantity}"
    return None


def _quantity(said: dict[str, Any], name: str, value: Interval) -> dict[str, Any] | None:
    """The fields with this one changed, where it is a quantity; that of a measure is its value."""
    part, _, inner = name.partition(".")
    if inner:
        changed = _quantity(said.get(part) or {}, inner, value)
        return None if changed is None else {**said, part: changed}
    if str(said.get("measure", "")) == name:
        return {**said, "value": value}
    unit = name.rpartition("_")[2]
    known = name in said and unit in {"mps", "mps2", "s", "m", "percent"}
    return {**said, name: value} if known else None


def _with(items: tuple[Any, ...], number: int, changes: dict[str, Any]) -> tuple[Any, ...]:
    return tuple(
        {**item, **changes} if place == number else item for place, item in enumerate(items)
    )

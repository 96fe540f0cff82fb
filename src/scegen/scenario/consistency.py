"""Whether what a file of logical scenarios names is there: participants, arms, parameters."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from typing import get_args

from scegen.errors import VocabularyError
from scegen.scenario.acts import Act, WhenMeasure
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Drive, LogicalScenario, LogicalSet
from scegen.scenario.model import FrozenModel, Interval
from scegen.scenario.outcome import Outcome

OF_PARTICIPANTS = ("speed_mps", "arrival_offset_s")
"""The parameters that every participant may have."""


def require_consistent(logical: LogicalSet, *, where: str) -> None:
    """Refuse a file that could not have been listed.

    Raises:
        VocabularyError: names the scenario and what in it is unknown.
    """
    if not logical.scenarios:
        raise VocabularyError("holds no logical scenario", where=where, hint="run scegen enumerate")
    functional = logical.functional
    takes_part = {p.id for p in functional.participants}
    known = takes_part | {thing.id for thing in functional.objects}
    parameters = set(_parameters(functional))
    twice = Counter(s.index for s in logical.scenarios).most_common(1)[0]
    if twice[1] > 1:
        raise VocabularyError(f"two scenarios have the index {twice[0]}", where=where)
    for scenario in logical.scenarios:
        for complaint in _complaints(scenario, functional.junction.arms, takes_part, known):
            raise VocabularyError(f"scenario {scenario.index}: {complaint}", where=where)
        for name in (p.name for p in scenario.parameters if p.name not in parameters):
            raise VocabularyError(
                f"scenario {scenario.index}: there is no parameter {name!r}",
                where=where,
                hint=f"there may be: {', '.join(sorted(parameters))}",
            )


def _complaints(
    scenario: LogicalScenario, arms: int, takes_part: set[str], known: set[str]
) -> Iterator[str]:
    assigned = Counter(a.participant for a in scenario.assignments)
    for name in takes_part:
        if assigned[name] != 1:
            times = "no assignment" if not assigned[name] else f"{assigned[name]} assignments"
            yield f"participant {name!r} has {times}, not one"
    for name in _named(scenario):
        if name not in known:
            yield f"there is no participant {name!r}; there are {', '.join(sorted(known))}"
    for item in scenario.assignments:
        for arm in (item.entry, item.exit) if isinstance(item, Drive) else (item.arm,):
            if arm >= arms:
                yield f"{item.participant} uses arm {arm}, outside 0..{arms - 1}"


def _named(scenario: LogicalScenario) -> Iterator[str]:
    for item in scenario.assignments:
        yield item.participant
        beside: str | None = getattr(item, "beside", None)
        if beside is not None:
            yield beside
    for hazard in scenario.hazards:
        yield from (*hazard.by, *hazard.to)
    for act in scenario.acts:
        yield from (act.participant, *((act.into,) if act.into else ()))
    for conflict in scenario.conflicts:
        yield from (conflict.first, conflict.second)
        if conflict.yields is not None:
            yield conflict.yields
    yield from scenario.deadlock


def _parameters(functional: FunctionalScenario) -> Iterator[str]:
    """The names that parameters may have, as :class:`ParameterRange` tells them."""
    for participant in functional.participants:
        yield from (f"{participant.id}.{quantity}" for quantity in OF_PARTICIPANTS)
    for act in functional.acts:
        yield from (f"{act.id}.{quantity}" for quantity in _ranges(Act))
        if isinstance(act.when, WhenMeasure):
            yield f"{act.id}.when.{act.when.measure}"
        elif act.when is not None:
            yield from (f"{act.id}.when.{quantity}" for quantity in _ranges(type(act.when)))
    for number, spacing in enumerate(functional.spacings):
        yield f"spacing_{number}.{spacing.measure}"
    yield from (f"outcome.{quantity}" for quantity in _ranges(Outcome))


def _ranges(model: type[FrozenModel]) -> Iterable[str]:
    """The fields that hold a range."""
    for name, field in model.model_fields.items():
        if field.annotation is Interval or Interval in get_args(field.annotation):
            yield name

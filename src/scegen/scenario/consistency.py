"""Whether what a file of logical scenarios names is there: participants, arms, parameters."""

from collections import Counter
from collections.abc import Iterable, Iterator

from scegen.errors import VocabularyError
from scegen.scenario.acts import Act, WhenMeasure
from scegen.scenario.arms import arm_angles_deg, exit_arm, turn_name
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.locating import members_of
from scegen.scenario.logical import (
    Assignment,
    Conflict,
    Crossing,
    Drive,
    LogicalScenario,
    LogicalSet,
    Standing,
    Walking,
)
from scegen.scenario.model import FrozenModel, Interval
from scegen.scenario.outcome import Outcome
from scegen.scenario.vocabulary import Maneuver

OF_PARTICIPANTS = ("speed_mps", "arrival_offset_s")
"""The parameters that every participant may have."""
_BESIDE_TURNING = frozenset({Maneuver.LANE_CHANGE, Maneuver.OVERTAKE, Maneuver.STAY})


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
        for complaint in _complaints(scenario, functional, takes_part, known):
            raise VocabularyError(f"scenario {scenario.index}: {complaint}", where=where)
        for name, times in Counter(p.name for p in scenario.parameters).items():
            if name in parameters and times == 1:
                continue
            wrong = f"there is no parameter {name!r}"
            if name in parameters:
                wrong = f"the parameter {name!r} is given {times} times"
            raise VocabularyError(
                f"scenario {scenario.index}: {wrong}",
                where=where,
                hint=f"there may be, each once: {', '.join(sorted(parameters))}",
            )


def _complaints(
    scenario: LogicalScenario, functional: FunctionalScenario, takes_part: set[str], known: set[str]
) -> Iterator[str]:
    arms = functional.junction.arms
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
    yield from _misfits(scenario, functional)
    for conflict in scenario.conflicts:
        yield from _no_pair(conflict)


def _misfits(scenario: LogicalScenario, functional: FunctionalScenario) -> Iterator[str]:
    """Assignments that their participant, or the junction, cannot have."""
    angles = arm_angles_deg(functional.junction)
    drivers = {v.id for v in functional.vehicles}
    parked = {p.id for p in functional.participants if p.parked}
    for item in scenario.assignments:
        name = item.participant
        fitting: tuple[type[Assignment], ...] = (Crossing, Standing, Walking)
        if name in drivers or name in parked:
            fitting = (Drive,) if name in drivers else (Standing,)
        if not isinstance(item, fitting):
            words = " or ".join(str(kind.model_fields["type"].default) for kind in fitting)
            yield f"{name} has the type {item.type}, and can only have {words}"
        elif isinstance(item, Drive):
            leaves = exit_arm(item.entry, item.move, len(angles))
            turn = turn_name(angles, item.entry, item.move)
            if item.exit != leaves:
                said = f"{name} enters at arm {item.entry} with move {item.move}"
                yield f"{said}: its exit is {leaves}"
            if item.turn is not turn:
                yield f"{name} goes from arm {item.entry} to {leaves}: its turn is {turn}"
            if item.maneuver not in {turn, *_BESIDE_TURNING}:
                words = ", ".join(sorted({turn, *_BESIDE_TURNING}))
                yield f"{name} turns {turn}: its maneuver is one of {words}"
    moves = sorted(drive.move for drive in scenario.drives)
    if list(scenario.pattern) != moves:
        yield f"the pattern of its moves is {moves}"


def _no_pair(conflict: Conflict) -> Iterator[str]:
    pair = {conflict.first, conflict.second}
    if len(pair) == 1:
        yield f"{conflict.first} has a conflict with itself"
    if conflict.yields is not None and conflict.yields not in pair:
        yield f"{conflict.yields} yields in a conflict of {' and '.join(sorted(pair))}"


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
        if Interval in members_of(field.annotation):
            yield name

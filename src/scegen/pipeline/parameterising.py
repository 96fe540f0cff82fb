"""A scenario as a space of parameters: what is one, what is none, and what any values give.

The parameters are those that the search for danger varies, and the numbers of a file follow from
them by the very functions by which the search makes its candidates. For a file these functions are
called with symbols; for a set of values, with the values.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from math import ceil, floor

import numpy as np

from scegen.claims.view import view_of
from scegen.claims.ways import paths_of, ways_of
from scegen.concretization.assemble import require_apart
from scegen.criticality.raising.raising import named_pair
from scegen.criticality.raising.stage import Stage
from scegen.criticality.search.problem import Problem, finishing
from scegen.criticality.search.rebuild import DECIMALS, rebuilt
from scegen.criticality.target import NEAR_MISS, parse_target
from scegen.errors import MotionInfeasibleError
from scegen.export.expressions import Expression, Number
from scegen.export.openscenario_numbers import Numbers, PhaseNumbers, Start, numbers_of
from scegen.export.openscenario_parameters import Declared, Parameterisation
from scegen.motion.batch import compile_program, simulate_batch
from scegen.motion.batch.arrays import Candidates, Floats
from scegen.motion.model import Path
from scegen.motion.trigger_steps import STEP_S, put_between_steps
from scegen.road import build_network
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.functional import FunctionalScenario

_LONGER = (1.0, 1.25, 1.6, 2.0)
"""Slower ones take longer than the scenario as it is; no longer than needed is looked at, or those
who wait at the end of their road would meet there."""
_AS_WRITTEN = 1.6e-3
_AS_PLAYED_M = 0.01
_DURATION, _EGO_GOES = "duration_s", "ego_has_come_m"


class UnusableError(Exception):
    """No scenario has these values: the reason. Never leaves the package."""


@dataclass(frozen=True)
class ParameterSpace:
    """The parameters of a scenario: ``names`` in the order of the search's variables.

    ``concrete`` is the scenario from which they depart, ``ways`` of the problem those from the
    outer ends of the arms.
    """

    concrete: ConcreteScenario
    network: RoadNetwork
    problem: Problem
    pair: tuple[str, str] | tuple[()]
    names: tuple[str, ...]

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """Between which values the parameters lie, to the decimals that files have (n,)."""
        unit = 10**DECIMALS
        space = self.problem.space
        low = np.array([ceil(v * unit - 1e-6) / unit for v in space.low])
        high = np.array([floor(v * unit + 1e-6) / unit for v in space.high])
        return low, np.maximum(low, high)

    @property
    def origin(self) -> Floats:
        """The scenario as it is (n,)."""
        return np.clip(np.round(self.problem.space.origin, DECIMALS), *self.bounds)

    def paths(self, concrete: ConcreteScenario) -> dict[str, Path]:
        """The paths of a scenario on this road, from where everybody starts."""
        return paths_of(ways_of(concrete, self.network))

    def at(self, x: Floats) -> ConcreteScenario:
        """The concrete scenario with these values (n,).

        Raises:
            UnusableError: bodies overlap at the start, somebody never leaves, or the rounding of
                its numbers would decide in which step something happens.
        """
        made = self.problem.space.candidates(x[None, :])
        concrete = rebuilt(
            self.concrete,
            self.problem.ways,
            made,
            0,
            self._duration_s(made),
            "set of parameters",
            by="parameters",
        )
        try:
            paths = self.paths(concrete)
            require_apart(concrete, paths)
        except MotionInfeasibleError as reason:
            raise UnusableError(reason.message) from reason
        self._require_as_told(concrete, paths, made)
        return concrete

    def values(self, x: Floats, concrete: ConcreteScenario) -> dict[str, float]:
        """By name, with those that follow from a simulation."""
        numbers = numbers_of(concrete, self.paths(concrete))
        own = {name: float(value) for name, value in zip(self.names, x, strict=True)}
        return own | {
            _DURATION: float(numbers.duration_s),  # type: ignore[arg-type]
            _EGO_GOES: float(numbers.ego_goes_m),  # type: ignore[arg-type]
        }

    def _duration_s(self, made: Candidates) -> float:
        """Until everybody has left."""
        problem = self.problem
        for longer in _LONGER:
            end_s = longer * problem.duration_s
            traces = simulate_batch(problem.program, made, duration_s=end_s)
            view = view_of(problem.concrete, problem.ways, problem.scene, traces, problem.friction)
            missing, duration = finishing(view, self.pair)
            if missing[0] <= 0.0:
                return float(duration[0])
        raise UnusableError("somebody does not leave in time")

    def _require_as_told(
        self, concrete: ConcreteScenario, paths: Mapping[str, Path], made: Candidates
    ) -> None:
        """The rounded numbers of the scenario must do what the values do, in every player."""
        program, own = compile_program(concrete, paths)
        rounded = zip(own[1:], made[1:], strict=True)
        if any(np.abs(a - b).max(initial=0.0) > _AS_WRITTEN for a, b in rounded):
            raise UnusableError("a number of it is moved off the steps of time")
        if put_between_steps(concrete, paths) is not concrete:
            raise UnusableError("a trigger ties with a step of time")
        end_s = concrete.duration_s
        ours = simulate_batch(program, own, duration_s=end_s, dt_s=STEP_S)
        theirs = simulate_batch(self.problem.program, made, duration_s=end_s, dt_s=STEP_S)
        off = np.hypot(ours.x_m - theirs.x_m, ours.y_m - theirs.y_m)
        if float(off.max()) > _AS_PLAYED_M:
            raise UnusableError("rounding decides in which step something happens")


def parameter_space(
    functional: FunctionalScenario | None, concrete: ConcreteScenario
) -> ParameterSpace:
    """The parameters of a scenario, within what is realistic and what the description says.

    Raises:
        MotionInfeasibleError, RoadInfeasibleError: the scenario itself cannot be built.
    """
    network = build_network(concrete.road, name=concrete.name)
    between = named_pair(functional, concrete)
    stage = Stage(functional, concrete, network, parse_target(NEAR_MISS), between)
    problem = stage.problem()
    return ParameterSpace(concrete, network, problem, stage.pair, _names(problem))


def _names(problem: Problem) -> tuple[str, ...]:
    """Of the variables, as files have them: letters, digits and ``_``, each once, a unit last.

    What is added to a trigger is a shift, and says so.
    """
    shifts = {recipe.shift.column for recipe in problem.space.recipes}
    names: list[str] = []
    for column, variable in enumerate(problem.space.variables):
        name, _, unit = variable.name.replace(".", "_").replace("-", "_").rpartition("_")
        name = f"{name}_shift" if column in shifts else name
        same = sum(known.startswith(name) and known.endswith(unit) for known in names)
        names.append(f"{name}_{same + 1}_{unit}" if f"{name}_{unit}" in names else f"{name}_{unit}")
    return tuple(names)


def parameterised(space: ParameterSpace) -> Parameterisation:
    """How the numbers of a file follow from the parameters, which have the scenario's values.

    Raises:
        UnusableError: the scenario itself is none of those that the parameters give.
    """
    x = space.origin
    concrete = space.at(x)
    given = space.values(x, concrete)
    low, high = space.bounds
    declared = [
        Declared(name, given[name], float(a), float(b))
        for name, a, b in zip(space.names, low, high, strict=True)
    ]
    ego = space.problem.ways[space.concrete.ego.id]
    declared += [
        Declared(_DURATION, given[_DURATION], 0.0, _LONGER[-1] * space.problem.duration_s),
        Declared(_EGO_GOES, given[_EGO_GOES], 0.0, ceil(ego.path.length_m)),
    ]
    symbols = {item.name: Expression.parameter(item.name, item.low, item.high) for item in declared}
    numbers = _numbers(space, symbols)
    fastest = rebuilt(
        concrete,
        space.problem.ways,
        space.problem.space.candidates(space.problem.space.high[None, :]),
        0,
        concrete.duration_s,
        "the highest of everything",
    )
    return Parameterisation(declared, numbers, fastest, " ".join(_note(space, numbers)))


def _numbers(space: ParameterSpace, symbols: Mapping[str, Expression]) -> Numbers:
    """The numbers of the file: the search's own functions, called with symbols."""
    values = space.problem.space.values([symbols[name] for name in space.names])
    speeds: dict[str, Number] = {}
    phases: dict[str, tuple[PhaseNumbers, ...]] = {}
    starts: dict[str, Start] = {}
    first = 0
    for i, participant in enumerate(space.concrete.participants):
        name, count = participant.id, len(participant.speed_program)
        speeds[name] = values.speed_mps[i]
        if isinstance(values.start_m[i], Expression):
            starts[name] = Start(space.problem.ways[name].path, values.start_m[i])
        made = [values.phases[k] for k in range(first, first + count)]
        phases[name] = tuple(PhaseNumbers(p.trigger, p.target_speed_mps, p.rate_mps2) for p in made)
        first += count
    return Numbers(speeds, phases, symbols[_DURATION], symbols[_EGO_GOES], starts)


def _note(space: ParameterSpace, numbers: Numbers) -> list[str]:
    """What is no parameter, in sentences."""
    fixed = frozen(space, numbers)
    return [
        "Its parameters keep to the bounds of their constraints.",
        f"{_DURATION} and {_EGO_GOES} follow from a simulation: each set of values brings its own.",
        "Fixed: the road, ways with their lane changes, who crosses or stands where, things, "
        "places to which somebody's arrival is awaited, weather"
        + ("; " + "; ".join(fixed) if fixed else "")
        + ".",
    ]


def frozen(space: ParameterSpace, numbers: Numbers) -> list[str]:
    """Numbers that no parameter decides: of whom, and parameters of the logical scenario."""
    told = []
    for participant in space.concrete.participants:
        name = participant.id
        if participant.parked:
            continue
        items = [] if name in numbers.starts else ["where it starts"]
        if not isinstance(numbers.speeds_mps[name], Expression):
            items.append("its speed at the start")
        for n, phase in enumerate(numbers.phases[name], start=1):
            parts = {
                "trigger": phase.trigger,
                "target speed": phase.target_speed_mps,
                "rate": phase.rate_mps2,
            }
            fixed = [what for what, value in parts.items() if not isinstance(value, Expression)]
            if fixed:
                items.append(f"of its phase {n} {' and '.join(fixed)}")
        if items:
            told.append(f"of {name}: {', '.join(items)}")
    known = {variable.name for variable in space.problem.space.variables}
    lost = [p.name for p in space.concrete.logical.parameters if p.name not in known]
    if lost:
        told.append(
            f"{', '.join(lost)} of the logical scenario, from which places and moments are laid out"
        )
    return told

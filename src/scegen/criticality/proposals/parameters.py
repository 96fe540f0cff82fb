"""The parameters that may be changed: the variables of the search, as somebody would read them."""

import re
from collections import Counter
from dataclasses import dataclass

from scegen.criticality.search.variables import Space, Variable
from scegen.scenario.concrete import ConcreteScenario, DistanceBelow
from scegen.units import parted

_STEP = re.compile(r"(?P<who>[^.]+)\.(?P<what>.+)_(?P<step>\d+)\.(?P<quantity>\w+)")
_WHOLE = {
    "start_m": "where {who} starts, along its way from the outer end of its arm: more is nearer "
    "to the junction and earlier there",
    "speed_mps": "the speed of {who}",
    "bend_mps": "the speed to which {who} slows down on its way",
    "to_mps": "the speed to which {who} changes in its danger",
}
_OF_STEP = {
    "rate_mps2": "how hard {who} {does} ({what})",
    "distance_m": "shift of the {distance} at which {who} {does} ({what}): 0 is as it is, more is "
    "{more}",
    "place_m": "shift of the place at which {who} {does} ({what}): 0 is as it is, more is later; "
    "the place stays where it is if the start changes",
    "time_s": "shift of the time before another's arrival at which {who} {does} ({what}): 0 is as "
    "it is, more is earlier",
    "duration_s": "shift of how long {who} stands before it drives on ({what}): 0 is as it is",
}


@dataclass(frozen=True, slots=True)
class Parameter:
    """A number of the scenario: ``value`` now, and the closed range that it may take.

    ``column`` is its place among the variables of the search.
    """

    name: str
    value: float
    unit: str
    low: float
    high: float
    meaning: str
    column: int

    def inside(self, value: float) -> float:
        """A value as files show it, within the bounds."""
        return min(max(round(value, 3), self.low), self.high)


def parameters_of(concrete: ConcreteScenario, space: Space) -> tuple[Parameter, ...]:
    """All parameters of a scenario; a name that would come twice gets a number."""
    seen: Counter[str] = Counter()
    found = []
    for column, (variable, value) in enumerate(zip(space.variables, space.origin, strict=True)):
        seen[variable.name] += 1
        number = seen[variable.name]
        found.append(
            Parameter(
                name=variable.name if number == 1 else f"{variable.name}_{number}",
                value=float(value),
                unit=(parted(variable.name)[1] or "1").replace("²", "2"),
                low=variable.low,
                high=variable.high,
                meaning=_meaning(concrete, variable),
                column=column,
            )
        )
    return tuple(found)


def _meaning(concrete: ConcreteScenario, variable: Variable) -> str:
    step = _STEP.fullmatch(variable.name)
    if step is None:
        who, quantity = variable.name.split(".", 1)
        return _WHOLE.get(quantity, "{who}: " + quantity).format(who=who)
    who = step["who"]
    participant = concrete.participant(who)
    phase = participant.speed_program[int(step["step"])]
    slows = phase.target_speed_mps < participant.speed_mps
    does = f"{'brakes' if slows else 'changes speed'} to {phase.target_speed_mps:g} m/s"
    near = isinstance(phase.trigger, DistanceBelow)
    more = "earlier" if near else "later"
    distance = "straight distance between the reference points" if near else "distance"
    what = f"step {int(step['step']) + 1}, {step['what'].replace('_', ' ')}"
    text = _OF_STEP.get(step["quantity"], "{who}: " + step["quantity"])
    return text.format(who=who, does=does, what=what, more=more, distance=distance)

"""The agent's instructions and its question, generated from what the code knows."""

from functools import lru_cache
from math import ceil, floor

from scegen.criticality.proposals.parameters import Parameter
from scegen.criticality.proposals.proposal import Situation
from scegen.criticality.proposals.reaching import Reach, Said
from scegen.criticality.target import BANDS, Target
from scegen.llm.prompting import as_data, data_rule, prompt_file, version_of
from scegen.measures.registry import measure_named
from scegen.scenario.concrete import ConcreteParticipant, DriveMotion
from scegen.scenario.proof import HazardProof

AGENT = "parameters"
_NO_TIME_S = 0.0005


@lru_cache(maxsize=1)
def instructions() -> str:
    """What the agent is told before any question."""
    measures = ", ".join(f"`{name}` ({measure_named(name).unit})" for name in BANDS)
    return prompt_file(__package__, AGENT).substitute(data_rule=data_rule(), measures=measures)


@lru_cache(maxsize=1)
def instructions_version() -> str:
    """Changes whenever the instructions do."""
    return version_of({AGENT: instructions()})


def question(situation: Situation) -> str:
    """Everything about one situation."""
    first, second = situation.pair
    found = situation.explore()
    lines = (_parameter(p, found.reaches[p.name]) for p in situation.parameters)
    people = (_who(p) for p in situation.concrete.participants)
    things = (f"{o.id}: {o.what}, does not move" for o in situation.concrete.objects)
    now = [f"{n} {value:.3g} {unit}" for n, value, unit in situation.measures if value is not None]
    return "\n".join(
        [
            as_data(situation.concrete.description),
            "",
            f"Target, between {first} and {second}: {_target(situation.target)}",
            f"As it is now: {', '.join(now) or 'the two do not meet'}",
            _listing("The dangers", [_danger(h) for h in situation.hazards]),
            _listing("What is said and must hold", [_statement(s) for s in found.said]),
            _listing("Who meets whom (all others never do)", _meetings(situation)),
            _listing("Who touches whom", [f"{a} and {b}" for a, b in situation.contacts]),
            _listing("The participants", [*people, *things]),
            _listing("The parameters that may change", list(filter(None, lines))),
        ]
    )


def _listing(title: str, lines: list[str]) -> str:
    return "\n".join([f"{title}:", *(f"- {line}" for line in lines or ["none"])])


def _target(target: Target) -> str:
    if target.contact:
        return f"{target.text}, the two touch"
    choices = [
        " and ".join(f"{b.measure} {b.low:g} to {b.high:g} {_unit(b.measure)}" for b in choice)
        for choice in target.choices
    ]
    apart = "without touching, " if target.contact is False else ""
    return f"{target.text}, {apart}{', or '.join(choices)}"


def _unit(measure: str) -> str:
    return measure_named(measure).unit


def _meetings(situation: Situation) -> list[str]:
    """When both are on their common ground, and how near in time."""
    lines = []
    for e in situation.encounters:
        first, second = e.passages
        gap = f"gap {e.gap_s:.2f} s" + (", both there at once" if e.gap_s < 0 else "")
        later = (
            f", later {e.least_s:.2f} s in the lane that they share" if e.least_s < e.gap_s else ""
        )
        lines.append(
            f"{e.first} is on their common ground from {first.enters_s:.2f} to "
            f"{first.leaves_s:.2f} s, {e.second} from {second.enters_s:.2f} to "
            f"{second.leaves_s:.2f} s: {gap}{later}"
        )
    return lines


def _statement(said: Said) -> str:
    if said.margin >= 0.0:
        return f"{said.statement}: holds"
    return f"{said.statement}: does not hold, by {-said.margin:.2f} {said.unit}"


def _parameter(parameter: Parameter, reach: Reach) -> str | None:
    """Its range, rounded inwards, so that a value at a bound is inside; None where none is left."""
    low, high = ceil(reach.low * 1000) / 1000, floor(reach.high * 1000) / 1000
    if low >= high:
        return None
    stops = f" (beyond: {'; '.join(reach.stops)})" if reach.stops else ""
    sooner = ""
    if reach.sooner_s is not None and abs(reach.sooner_s) >= _NO_TIME_S:
        comes = "sooner" if reach.sooner_s > 0 else "later"
        sooner = f"; 1 {parameter.unit} more comes {abs(reach.sooner_s):.3f} s {comes}"
    return (
        f"`{parameter.name}` = {parameter.value:.3f} {parameter.unit}, {low:.3f} to {high:.3f}"
        f"{stops}{sooner}: {parameter.meaning}"
    )


def _danger(hazard: HazardProof) -> str:
    who = f"{hazard.kind} by {' and '.join(hazard.by) or 'somebody'}"
    who += f" to {' and '.join(hazard.to)}" if hazard.to else ""
    told, side = ("happens", "beyond") if hazard.happened else ("does not happen yet", "short of")
    if hazard.margin is not None:
        told += f" ({abs(hazard.margin):.2f} {hazard.unit} {side} its threshold)"
    return f"{who}: {told}"


def _who(participant: ConcreteParticipant) -> str:
    motion = participant.motion
    if isinstance(motion, DriveMotion):
        way = f"drives from arm {motion.entry} to arm {motion.exit}"
    else:
        way = f"{motion.type} at arm {motion.arm}"
    kind = f"{participant.kind}, {participant.role}"
    return f"{participant.id}: {kind}, {participant.speed_mps:.1f} m/s, {way}"

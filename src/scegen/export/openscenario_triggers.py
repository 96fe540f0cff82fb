"""When a phase of a speed program fires, as OpenSCENARIO start triggers.

A phase can only fire once its predecessor has: the state of the predecessor's event is asked
beside the phase's own condition.
"""

from collections.abc import Mapping

import numpy as np

from scegen.export.expressions import Number, written
from scegen.export.library import xosc
from scegen.export.openscenario_numbers import Numbers
from scegen.export.openscenario_position import world_position
from scegen.motion.model import Path
from scegen.scenario.concrete import (
    ArrivalBelow,
    AtTime,
    ConcreteParticipant,
    SpeedPhase,
    StoodStill,
    Travelled,
)

_SLACK_S = 1e-5
"""1.0 knows only "greater than": this much earlier, a time on the step's grid counts as reached."""
_SLACK_M = 1e-5
"""Likewise, a distance that a step reaches exactly counts as reached."""


def phase_event_name(participant: ConcreteParticipant, index: int) -> str:
    """The name of the event of a phase, unique in the file: players look it up by name alone."""
    return f"{participant.id}_phase_{index + 1}"


def phase_trigger(
    participant: ConcreteParticipant,
    index: int,
    value: Number,
    paths: Mapping[str, Path],
    *,
    duration_s: float,
    minor: int,
) -> xosc.Trigger:
    """The start trigger of phase ``index`` of a participant's speed program, at this ``value``.

    "Has fired" is "running or complete". Version 1.0 asks for the start instead of the running
    state, which scenario_runner does not know; it remembers a start, and so does esmini until
    the condition is looked at, which is why this condition stands behind the phase's own.
    """
    phase = participant.speed_program[index]
    event = phase_event_name(participant, index)
    fired = ("startTransition" if minor == 0 else "runningState", "completeState")
    trigger = xosc.Trigger()
    for number, state in enumerate(fired if index else ("",), start=1):
        group = xosc.ConditionGroup()
        # Names must differ between groups: scenario_runner keeps what came true by name.
        name = f"{event}_when_{number}"
        condition = _condition(name, participant, phase, value, paths, duration_s, minor)
        group.add_condition(condition)
        if state:
            before = phase_event_name(participant, index - 1)
            group.add_condition(_state_condition(f"{event}_after_{number}", "event", before, state))
        trigger.add_conditiongroup(group)
    return trigger


def when_complete(name: str, action: str) -> xosc.ValueTrigger:
    """True once the action of this name is over."""
    return _state_condition(name, "action", action, "completeState")


def when_touching(entity: str, other: str) -> xosc.EntityTrigger:
    """True once the boxes of two touch."""
    return _entity(f"{entity}_touches_{other}", xosc.CollisionCondition(other), entity)


def at_once(name: str, duration_s: float) -> xosc.ValueTrigger:
    """True from the first instant: "later than 0" would lose a step."""
    return _value(name, xosc.SimulationTimeCondition(duration_s, xosc.Rule.lessThan))


def at_time(name: str, time_s: float, minor: int) -> xosc.ValueTrigger:
    """True from a time on."""
    return _value(name, _reached(time_s, minor))


def at_end(name: str, ego: str, numbers: Numbers, minor: int) -> xosc.Trigger:
    """True when the scenario is over, as a stop trigger: an ego that is late is waited for."""
    trigger = xosc.Trigger("stop")
    in_time = xosc.ConditionGroup("stop")
    in_time.add_condition(_value(f"{name}_in_time", _reached(numbers.duration_s, minor)))
    gone = xosc.TraveledDistanceCondition(written(numbers.ego_goes_m))
    in_time.add_condition(_entity(f"{name}_ego_has_passed", gone, ego))
    trigger.add_conditiongroup(in_time)
    trigger.add_conditiongroup(_at_last(name, numbers, minor))
    return trigger


def at_the_latest(name: str, numbers: Numbers, minor: int) -> xosc.Trigger:
    """True when even an ego that is late is waited for no longer.

    One condition alone: scenario_runner ends an act when any condition of a group holds.
    """
    trigger = xosc.Trigger("stop")
    trigger.add_conditiongroup(_at_last(name, numbers, minor))
    return trigger


def _at_last(name: str, numbers: Numbers, minor: int) -> xosc.ConditionGroup:
    group = xosc.ConditionGroup("stop")
    latest = _reached(numbers.latest_end_s, minor)
    group.add_condition(_value(f"{name}_at_last", latest))
    return group


def _reached(time_s: Number, minor: int) -> xosc.SimulationTimeCondition:
    if minor == 0:
        return xosc.SimulationTimeCondition(_rounded(time_s - _SLACK_S), xosc.Rule.greaterThan)
    return xosc.SimulationTimeCondition(written(time_s), xosc.Rule.greaterOrEqual)


def _rounded(value: Number) -> float | str:
    """As it is written, a number to 0.001 mm or ms."""
    return round(value, 6) if isinstance(value, float) else written(value)


def _condition(
    name: str,
    owner: ConcreteParticipant,
    phase: SpeedPhase,
    value: Number,
    paths: Mapping[str, Path],
    duration_s: float,
    minor: int,
) -> xosc.ValueTrigger | xosc.EntityTrigger:
    trigger = phase.trigger
    if isinstance(trigger, AtTime):
        if isinstance(value, float) and value <= _SLACK_S:
            return at_once(name, duration_s)
        return _value(name, _reached(value, minor))
    if isinstance(trigger, Travelled):
        # Players add up rounded steps: a distance that a step reaches exactly may be missed by one.
        distance = np.maximum(value - _SLACK_M, 0.0)
        return _entity(
            name, xosc.TraveledDistanceCondition(_rounded(distance)), trigger.participant
        )
    if isinstance(trigger, StoodStill):
        # Players ask for longer than the duration.
        stood = np.maximum(value - _SLACK_S, 0.0)
        return _entity(name, xosc.StandStillCondition(_rounded(stood)), trigger.participant)
    if isinstance(trigger, ArrivalBelow):
        return _entity(name, _arrival(trigger, value, paths), trigger.participant)
    kind = xosc.RelativeDistanceType
    condition = xosc.RelativeDistanceCondition(
        written(value),
        xosc.Rule.lessThan,
        kind.cartesianDistance if minor == 0 else kind.euclidianDistance,
        trigger.participant,
        freespace=False,
    )
    return _entity(name, condition, owner.id)


def _arrival(
    trigger: ArrivalBelow, time_s: Number, paths: Mapping[str, Path]
) -> xosc.TimeToCollisionCondition:
    """Time to a place, in a straight line; the 1.0 reading of "not along the route" is the same."""
    return xosc.TimeToCollisionCondition(
        written(time_s),
        xosc.Rule.lessThan,
        alongroute=False,
        freespace=False,
        position=world_position(paths[trigger.participant].pose(trigger.place_m)),
        distance_type=xosc.RelativeDistanceType.euclidianDistance,
        coordinate_system=xosc.CoordinateSystem.entity,
    )


def _value(name: str, condition: object) -> xosc.ValueTrigger:
    return xosc.ValueTrigger(name, 0, xosc.ConditionEdge.none, condition)


def _entity(name: str, condition: object, entity: str) -> xosc.EntityTrigger:
    return xosc.EntityTrigger(name, 0, xosc.ConditionEdge.none, condition, entity)


def _state_condition(name: str, element: str, reference: str, state: str) -> xosc.ValueTrigger:
    return _value(
        name,
        xosc.StoryboardElementStateCondition(
            getattr(xosc.StoryboardElementType, element),
            reference,
            getattr(xosc.StoryboardElementState, state),
        ),
    )

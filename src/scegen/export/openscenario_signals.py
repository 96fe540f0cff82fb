"""Traffic lights in OpenSCENARIO: what they show over time, as the standard and as esmini says it.

The standard's controllers go into every file. esmini 3.6 reads none of them, but changes lamps by
TrafficSignalStateAction with one word a lamp, which scenario_runner refuses: so these go into a
file of their own.
"""

from itertools import pairwise

from scegen.export.library import xosc
from scegen.export.openscenario_numbers import Numbers
from scegen.export.openscenario_triggers import at_once, at_the_latest, at_time
from scegen.export.signs import signals_of
from scegen.road.cross_section import arm_road_id
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.signals import SignalGroup, SignalPlan, SignalState

LAMPS: dict[SignalState, str] = {
    SignalState.RED: "on;off;off",
    SignalState.AMBER: "off;on;off",
    SignalState.GREEN: "off;off;on",
    SignalState.OFF: "off;off;off",
}
"""The three lamps of OpenDRIVE's signal 1000001, from top to bottom."""
LAMPS_AFOOT: dict[SignalState, str] = {
    SignalState.RED: "on;off",
    SignalState.GREEN: "off;on",
    SignalState.OFF: "off;off",
}
"""The two of 1000002, for people on foot."""


def controllers(plan: SignalPlan) -> list[xosc.TrafficSignalController]:
    """One for every controller of the road file: its phases from time 0 on, over one cycle."""
    made = []
    for group in plan.groups:
        controller = xosc.TrafficSignalController(str(group.id))
        changes = [*plan.changes(group, plan.cycle_s), (plan.cycle_s, None)]
        for number, ((begins, state), (ends, _)) in enumerate(pairwise(changes)):
            if state is None or ends - begins < 1e-6:
                continue
            phase = xosc.Phase(f"{state.value}_{number}", round(ends - begins, 3))
            for signal, lamps in _lamps(group, state):
                phase.add_signal_state(signal, lamps)
            controller.add_phase(phase)
        made.append(controller)
    return made


def first_lamps(plan: SignalPlan) -> list[xosc.TrafficSignalStateAction]:
    """What every light shows at the start."""
    return [
        xosc.TrafficSignalStateAction(signal, lamps)
        for group in plan.groups
        for signal, lamps in _lamps(group, next(plan.changes(group, 0.0))[1])
    ]


def lamp_act(
    concrete: ConcreteScenario, plan: SignalPlan, numbers: Numbers, minor: int
) -> xosc.Act:
    """Every change of a light after the start."""
    act = xosc.Act(
        "lights_act",
        at_once("lights_act_starts", concrete.duration_s),
        at_the_latest("lights_act_over", numbers, minor),
    )
    group = xosc.ManeuverGroup("lights")
    for controlled in plan.groups:
        group.add_maneuver(_maneuver(concrete, plan, controlled, minor))
    act.add_maneuver_group(group)
    return act


def _maneuver(
    concrete: ConcreteScenario, plan: SignalPlan, group: SignalGroup, minor: int
) -> xosc.Maneuver:
    maneuver = xosc.Maneuver(f"lights_{group.id}")
    changes = list(plan.changes(group, max(concrete.latest_end_s, plan.cycle_s)))
    for number, (time_s, state) in enumerate(changes[1:]):
        name = f"lights_{group.id}_{state.value}_{number}"
        event = xosc.Event(name, xosc.Priority.parallel)
        for signal, lamps in _lamps(group, state):
            event.add_action(f"{name}_{signal}", xosc.TrafficSignalStateAction(signal, lamps))
        event.add_trigger(at_time(f"{name}_when", time_s, minor))
        maneuver.add_event(event)
    return maneuver


def _lamps(group: SignalGroup, state: SignalState) -> list[tuple[str, str]]:
    """The signals of a group, and what their lamps do in a state."""
    lamps = (LAMPS_AFOOT if group.afoot else LAMPS)[state]
    roads = [arm_road_id(arm) for arm in sorted(group.arms)]
    return [(name, lamps) for road in roads for name in signals_of(road, afoot=group.afoot)]

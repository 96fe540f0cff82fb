"""What the lights show: the same in still and moving pictures."""

from typing import NamedTuple

from scegen.road.geometry import Pose
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.control import LIGHTS
from scegen.scenario.signals import SignalState


class Light(NamedTuple):
    """A light: its arm, where on that it stands (looking in), and whether people on foot obey it.

    ``left_m`` is how far to the left of the pose the kerb lies beside which it stands.
    """

    arm: int
    pose: Pose
    left_m: float
    afoot: bool = False


def lights_of(concrete: ConcreteScenario, network: RoadNetwork) -> list[Light]:
    """All that stand at a junction: beside the stop lines, and on both sides of crosswalks."""
    if concrete.road.control not in LIGHTS:
        return []
    found = [Light(a, *entry_of(network, a)) for a in sorted(concrete.road.controlled_arms)]
    groups = concrete.signals.groups if concrete.signals is not None else ()
    for arm in sorted(arm for group in groups if group.afoot for arm in group.arms):
        road = network.arm_road(arm)
        pose = road.line.pose(road.crosswalk_end_m)
        found += [Light(arm, pose, road.edge_t_m(side), afoot=True) for side in (1, -1)]
    return found


def entry_of(network: RoadNetwork, arm: int) -> tuple[Pose, float]:
    """The stop line of an arm, looking in, and how far its entering lanes reach to the left."""
    road = network.arm_road(arm)
    sign = -1 if network.driving_side == "right" else 1
    return road.line.pose(road.length_m - road.stop_line_m), road.edge_t_m(sign)


def shown(
    concrete: ConcreteScenario, light: Light, until_s: float
) -> list[tuple[float, SignalState]]:
    """What a light shows from 0 on: (since when, state); nothing where it is dark."""
    plan = concrete.signals
    group = plan and plan.group_of(light.arm, afoot=light.afoot)
    return list(plan.changes(group, until_s)) if plan and group else []


def state_at(concrete: ConcreteScenario, light: Light, time_s: float) -> SignalState | None:
    """What a light shows at a time; None where it is dark."""
    states = [state for since_s, state in shown(concrete, light, time_s) if since_s <= time_s]
    return states[-1] if states else None

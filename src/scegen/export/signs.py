"""Signs and lights at the entries of a junction, as OpenDRIVE signals."""

import xml.etree.ElementTree as ET  # builds, never parses
from math import pi

from scegen.export.library import xodr
from scegen.road.model import LaneType, Road, RoadNetwork
from scegen.scenario.control import LIGHTS
from scegen.scenario.signals import SignalGroup, SignalPlan
from scegen.scenario.vocabulary import Control

_STVO: dict[Control, tuple[str, str]] = {
    Control.YIELD: ("205", "yield"),
    Control.STOP: ("206", "stop"),
    Control.ALL_WAY_STOP: ("206", "stop"),
    **dict.fromkeys(LIGHTS, ("1000001", "traffic_light")),
}
"""Type and name by control: signs of the German catalogue (StVO), the three lamps of OpenDRIVE."""
_AFOOT = "1000002"
_AFOOT_FROM = 1000
"""Signals of people on foot are numbered from here on: no arm's road has such a number."""
_BESIDE_M = 0.5
_HEIGHT_M = 2.3


def entry_sign(road: Road, control: Control) -> xodr.Signal | None:
    """What stands beside the inner end of an arm road, for traffic towards the junction."""
    if control not in _STVO:
        return None
    kind, name = _STVO[control]
    sign = -1 if road.driving_side == "right" else 1
    inward = [lane for lane in road.lanes if lane.id * sign > 0]
    kerb = sum(lane.width_m for lane in inward if lane.type is not LaneType.SIDEWALK)
    lights = control in LIGHTS
    signal = xodr.Signal(
        s=round(road.length_m - road.stop_line_m, 9),
        t=round(sign * (kerb + _BESIDE_M), 9),
        country="DE",
        Type=kind,
        id=str(road.id),
        name=f"{name}_{road.id}",
        dynamic=xodr.Dynamic.yes if lights else xodr.Dynamic.no,
        zOffset=_HEIGHT_M,
        orientation=xodr.Orientation.positive,
        width=0.6,
        height=0.6,
    )
    driving = [lane.id for lane in inward if lane.type is LaneType.DRIVING]
    signal.add_validity(min(driving), max(driving))
    return signal


def signals_of(road_id: int, *, afoot: bool) -> list[str]:
    """The ids of the lights at an arm: of who enters by it, or on both sides, of who crosses it."""
    first = _AFOOT_FROM + 2 * road_id
    return [str(first), str(first + 1)] if afoot else [str(road_id)]


def lights_afoot(road: Road) -> list[xodr.Signal]:
    """On either side of an arm, for people who cross it from there."""
    s_m = road.crosswalk_end_m
    return [
        xodr.Signal(
            s=round(s_m, 9),
            t=round(road.edge_t_m(sign, s_m) + sign * _BESIDE_M, 9),
            country="DE",
            Type=_AFOOT,
            id=name,
            name=f"light_afoot_{name}",
            dynamic=xodr.Dynamic.yes,
            zOffset=_HEIGHT_M,
            orientation=xodr.Orientation.none,
            hOffset=round(-sign * pi / 2, 9),
            width=0.3,
            height=0.6,
        )
        for sign, name in zip((1, -1), signals_of(road.id, afoot=True), strict=True)
    ]


def _signals(network: RoadNetwork, group: SignalGroup) -> list[str]:
    roads = [network.arm_roads[arm] for arm in sorted(group.arms)]
    return [name for road in roads for name in signals_of(road, afoot=group.afoot)]


def name_catalogue(root: ET.Element) -> None:
    """Lights are OpenDRIVE's own, which scenariogeneration would write in capitals."""
    for signal in root.iter("signal"):
        if signal.get("type") in {_STVO[Control.SIGNALS][0], _AFOOT}:
            signal.set("country", "OpenDRIVE")


def add_controllers(root: ET.Element, network: RoadNetwork, plan: SignalPlan) -> None:
    """One controller for every group of lights that show the same, known to its junctions.

    scenariogeneration has no class for them; their place is between roads and junctions.
    """
    place = list(root).index(next(root.iter("junction")))
    for number, group in enumerate(plan.groups):
        named = {"id": str(group.id), "name": f"lights_{group.id}"}
        controller = ET.Element("controller", named | {"sequence": str(number)})
        for name in _signals(network, group):
            ET.SubElement(controller, "control", {"signalId": name})
        root.insert(place + number, controller)
    for junction in root.iter("junction"):
        incoming = {c.get("incomingRoad") for c in junction.iter("connection")}
        for number, group in enumerate(plan.groups):
            if incoming & {str(network.arm_roads[arm]) for arm in group.arms}:
                ET.SubElement(
                    junction, "controller", {"id": str(group.id), "sequence": str(number)}
                )

"""Everything that the scenario names exists."""

from collections import Counter
from collections.abc import Iterator

from scegen.checking.opendrive.network import lane_place, road_place
from scegen.checking.openscenario.situation import Situation
from scegen.checking.results import Finding, error, unchecked


def check_entities(situation: Situation) -> Iterator[Finding]:
    """``xosc.entity``: names are unique, and every reference names one of them."""
    counted = Counter(entity.name for entity in situation.storyboard.entities)
    for name, times in counted.items():
        if times > 1:
            yield error("xosc.entity", name, f"is the name of {times} entities")
    for place, name in situation.storyboard.references:
        if name.startswith("$"):
            message = f"names the entity by {name!r}, which is not worked out"
            yield unchecked("xosc.entity", place, message)
        elif name not in counted:
            yield error("xosc.entity", place, f"names the unknown entity {name!r}")


def check_ego(situation: Situation) -> Iterator[Finding]:
    """``xosc.ego``: exactly one entity carries the property type = ego_vehicle."""
    egos = [entity.name for entity in situation.storyboard.entities if entity.is_ego]
    if len(egos) != 1:
        message = f"exactly one entity must have the property type=ego_vehicle, found {egos}"
        yield error("xosc.ego", situation.storyboard.name, message)
    elif situation.concrete is not None and egos[0] != situation.concrete.ego.id:
        message = f"is marked as the ego instead of {situation.concrete.ego.id}"
        yield error("xosc.ego", egos[0], message)


def check_participants(situation: Situation) -> Iterator[Finding]:
    """``xosc.participants``: the entities are those of the concrete scenario, objects included."""
    if situation.concrete is None:
        return
    found = {entity.name for entity in situation.storyboard.entities}
    wanted = {entity.id for entity in situation.concrete.entities}
    for name in sorted(wanted - found):
        yield error("xosc.participants", name, "is in concrete.yaml but not among the entities")
    for name in sorted(found - wanted):
        yield error("xosc.participants", name, "is an entity but not in concrete.yaml")


def check_lane_positions(situation: Situation) -> Iterator[Finding]:
    """``xosc.lane_position``: the road and the lane exist and are long enough."""
    if situation.network is None:
        return
    for place, point in situation.storyboard.lane_points:
        road = situation.network.roads.get(point.road)
        if road is None:
            message = f"names {road_place(point.road)}, which does not exist"
            yield error("xosc.lane_position", place, message)
        elif not 0 <= point.s <= road.length:
            message = f"s = {point.s:g} m lies outside {road_place(road.id)} ({road.length:.2f} m)"
            yield error("xosc.lane_position", place, message)
        elif point.lane == 0 or not any(point.lane in s.lanes for s in road.sections):
            message = f"names {lane_place(road.id, point.lane)}, which does not exist"
            yield error("xosc.lane_position", place, message)

"""Everybody is as large as the concrete scenario says; objects are what it says, and where.

One that is an obstacle lies on a lane; any other stands beside the road.
"""

from collections.abc import Iterator
from math import degrees, radians

from scegen.checking.opendrive.tolerances import heading_step
from scegen.checking.openscenario.situation import Situation
from scegen.checking.openscenario.storyboard import Entity, WorldPoint
from scegen.checking.results import Finding, error
from scegen.scenario.bodies import Body
from scegen.scenario.objects import StaticObject
from scegen.scenario.vocabulary import HazardKind
from scegen.scenario.wording import with_article

RULE = "xosc.object"
PLACE_M = 0.01
HEADING_DEG = 0.5
SIZE_M = 0.001


def check_objects(situation: Situation) -> Iterator[Finding]:
    """``xosc.size``: the boxes of all. ``xosc.object``: what a thing is and where it lies.

    Obstacles lie on a lane, other things beside the road.
    """
    concrete = situation.concrete
    if concrete is None:
        return
    entities = {entity.name: entity for entity in situation.storyboard.entities}
    obstacles = {name for h in concrete.hazards if h.kind is HazardKind.OBSTACLE for name in h.by}
    for one in concrete.entities:
        if one.id in entities:  # xosc.participants tells the others
            yield from _as_large(one.id, one.body, entities[one.id])
    for thing in concrete.objects:
        if thing.id in entities:
            yield from _as_said(thing, entities[thing.id])
            yield from _placed(situation, thing, blocks=thing.id in obstacles)


def _as_said(thing: StaticObject, entity: Entity) -> Iterator[Finding]:
    if (entity.kind, entity.category) != ("MiscObject", thing.category.value):
        said = f"{entity.kind} {entity.category}".strip()
        yield error(RULE, thing.id, f"is {with_article(said)}, not a MiscObject {thing.category}")


def _as_large(name: str, body: Body, entity: Entity) -> Iterator[Finding]:
    wanted = (body.length_m, body.width_m, body.height_m)
    size = entity.size_m
    if size is None or max(abs(a - b) for a, b in zip(size, wanted, strict=True)) > SIZE_M:
        yield error("xosc.size", name, f"has a box of {size}, not {wanted} m")


def _placed(situation: Situation, thing: StaticObject, *, blocks: bool) -> Iterator[Finding]:
    start = situation.storyboard.starts.get(thing.id)
    if not isinstance(start, WorldPoint):
        yield error(RULE, thing.id, "has no place in the world")
        return
    away = abs(start.point - complex(thing.x_m, thing.y_m))
    turned = abs(heading_step(start.heading, radians(thing.heading_deg)))
    if away > PLACE_M or degrees(turned) > HEADING_DEG:
        message = f"stands {away:.2f} m and {degrees(turned):.1f}° from where it should"
        yield error(RULE, thing.id, message)
    if situation.network is None:
        return
    driven_on = {"driving"} | ({"biking"} if blocks else set())
    on_lane = any(lane.type in driven_on for lane in situation.lanes_at([start.point])[0])
    if blocks != on_lane:
        where = "beside the road, not on a lane" if blocks else "on a driving lane, not beside it"
        yield error(RULE, thing.id, f"stands {where}")

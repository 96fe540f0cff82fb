"""From the things of a description to objects with a place."""

from __future__ import annotations

from collections.abc import Collection
from math import degrees

from scegen.concretization.things import SHAPES, Shape
from scegen.road.geometry import Pose
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.model import middles
from scegen.scenario.objects import StaticObject
from scegen.scenario.things import Thing, ThingKind
from scegen.scenario.vocabulary import HazardKind, Maneuver


def shape_of(thing: Thing) -> Shape:
    """The box of a thing: as large as is said, else as its kind usually is."""
    return SHAPES[thing.kind].sized(*middles(thing.length_m, thing.width_m))


def causes_it(functional: FunctionalScenario, hazard: Hazard) -> Thing | None:
    """The thing that causes a danger: the one that is named, else one that does such a thing."""
    named = [thing for thing in functional.objects if thing.id in hazard.by]
    if named or hazard.by:
        return next(iter(named), None)
    for thing in functional.objects:
        hides = hazard.kind is HazardKind.OCCLUSION and bool(thing.hides)
        blocks = hazard.kind is HazardKind.OBSTACLE and thing.in_way_of is not None
        if hides or blocks:
            return thing
    return None


def caused_by_nobody(functional: FunctionalScenario, hazard: Hazard) -> bool:
    """Whether no participant causes a danger: a thing does."""
    people = {p.id for p in functional.participants}
    return not people & {*hazard.by}


def lying_in_the_way(
    functional: FunctionalScenario, logical: LogicalScenario, drivers: Collection[str]
) -> list[tuple[Hazard, Thing]]:
    """The things that dangers need which nobody causes, each in the way of one of the drivers."""
    found: list[tuple[Hazard, Thing]] = []
    for hazard in functional.hazards:
        if hazard.kind is not HazardKind.OBSTACLE:
            continue
        thing = causes_it(functional, hazard)
        if thing is None and not caused_by_nobody(functional, hazard):
            continue
        lying = [each for _, each in found]
        if thing is None and (found or logical.standings):
            continue
        if thing is not None and any(each.id == thing.id for each in lying):
            continue
        who = next(
            (n for n in hazard.to if n in drivers), _who_reacts(functional, logical, drivers)
        )
        taken = {each.id for each in lying} | {*drivers}
        name = free_name(functional, ThingKind.OBSTACLE, taken)
        thing = thing or Thing(id=name, kind=ThingKind.OBSTACLE)
        said = thing.in_way_of in drivers
        blocked = thing if said else thing.model_copy(update={"in_way_of": who})
        found.append((hazard, blocked))
    return found


def _who_reacts(
    functional: FunctionalScenario, logical: LogicalScenario, drivers: Collection[str]
) -> str:
    """The driver who does something that one does because of a thing in its way; else the ego."""
    acting = [h.by[0] for h in functional.hazards if h.by and HAZARDS[h.kind].acts]
    sideways = {Maneuver.LANE_CHANGE, Maneuver.OVERTAKE}
    aside = [d.participant for d in logical.drives if d.maneuver in sideways]
    return next((name for name in (*acting, *aside) if name in drivers), functional.ego.id)


def made_of(name: str, shape: Shape, called: str | None, pose: Pose) -> StaticObject:
    """The object of a shape with its middle at a pose."""
    return StaticObject(
        id=name,
        category=shape.category,
        what=called or shape.kind.value.replace("_", " "),
        x_m=round(pose.x_m, 3),
        y_m=round(pose.y_m, 3),
        heading_deg=round((degrees(pose.heading_rad) + 180) % 360 - 180, 3),
        length_m=round(shape.length_m, 3),
        width_m=round(shape.width_m, 3),
        height_m=shape.height_m,
        mass_kg=shape.mass_kg,
        blueprint=shape.blueprint,
    )


def free_name(functional: FunctionalScenario, kind: ThingKind, taken: set[str]) -> str:
    """A name for a thing that the text implies and does not name."""
    known = taken | {p.id for p in functional.participants} | {o.id for o in functional.objects}
    number = next(n for n in range(1, len(known) + 2) if f"{kind}_{n}" not in known)
    return f"{kind}_{number}"

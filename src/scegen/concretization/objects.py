"""From the things of a description to objects with a place."""

from __future__ import annotations

from math import degrees

from scegen.concretization.things import SHAPES, Shape
from scegen.road.geometry import Pose
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.objects import StaticObject
from scegen.scenario.things import Thing, ThingKind
from scegen.scenario.vocabulary import HazardKind


def shape_of(kind: ThingKind) -> Shape:
    """The box of a kind of thing."""
    return SHAPES[kind]


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

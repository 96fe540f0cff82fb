"""From the words behind a danger to the thing that causes it."""

from __future__ import annotations

import re
from math import degrees

from scegen.concretization.drafts import Scene
from scegen.concretization.things import Thing
from scegen.road.geometry import Pose
from scegen.scenario.functional import Hazard
from scegen.scenario.objects import StaticObject


def words_of(scene: Scene, hazard: Hazard) -> list[str]:
    """The words that a danger rests on, then those that nothing else could hold.

    Where somebody is parked, who may be what is meant, the danger's own words alone.
    """
    functional, field = scene.functional, f"hazards.{hazard.kind}"
    evidence = [e.text for e in functional.evidence if e.field == field and e.text]
    return [*evidence, *(left.text for left in functional.unsupported if not scene.stands)]


def made_of(scene: Scene, thing: Thing, pose: Pose) -> StaticObject:
    """The object of a kind with its middle at a pose."""
    return StaticObject(
        id=_free_id(scene, thing.what),
        category=thing.category,
        what=thing.what,
        x_m=round(pose.x_m, 3),
        y_m=round(pose.y_m, 3),
        heading_deg=round((degrees(pose.heading_rad) + 180) % 360 - 180, 3),
        length_m=round(thing.length_m, 3),
        width_m=round(thing.width_m, 3),
        height_m=thing.height_m,
        mass_kg=thing.mass_kg,
        blueprint=thing.blueprint,
    )


def _free_id(scene: Scene, what: str) -> str:
    """A name for a thing that nobody has yet."""
    stem = re.sub(r"[^a-z0-9]+", "_", what.lower()).strip("_")[:30]
    taken = {p.id for p in scene.functional.participants} | {o.id for o in scene.objects}
    number = next(n for n in range(1, len(taken) + 2) if f"{stem}_{n}" not in taken)
    return f"{stem}_{number}"

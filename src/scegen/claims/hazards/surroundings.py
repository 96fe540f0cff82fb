"""Dangers made by what stands beside or on the road: occlusion and obstacles."""

import numpy as np

from scegen.claims.boxes import box_at, free_width_m, offset
from scegen.claims.hazards import thresholds as limits
from scegen.claims.hazards.predicate import NEVER, Part, Predicate, at_least, at_most
from scegen.claims.hidden import hidden
from scegen.claims.view import View


def occlusion(view: View, by: str, to: str) -> list[Part]:
    """Somebody is hidden from the sufferer until shortly before the two come nearest.

    All occluders count together; of several who are hidden, the one with whom it is clearest.
    """
    people = [entity.id for entity in view.concrete.entities]
    rows = [[people[int(i)] for i in row] for row in view.scene.occlusions]
    best: list[Part] = []
    for target in sorted({t for observer, t, hider in rows if (observer, hider) == (to, by)}):
        hiders = [hider for observer, t, hider in rows if (observer, t) == (to, target)]
        found = hidden(view, to, target, *hiders)
        parts = [
            at_least("hidden", found.total_s, limits.OCCLUDED, found.last_s),
            at_most("in sight before", found.seen_s, limits.IN_SIGHT, found.last_s),
        ]
        if not best or _clearest(parts) > _clearest(best):
            best = parts
    never = np.full(view.count, np.nan)
    return best or [at_least("hidden", never, limits.OCCLUDED, never)]


def _clearest(parts: list[Part]) -> float:
    """How clearly parts hold together in the best candidate."""
    least = np.min([part.relative for part in parts], axis=0)
    return float(least.max(initial=NEVER))


def obstacle(view: View, by: str, to: str) -> list[Part]:
    """The sufferer has to pass close by what stands there, or comes to rest before it."""
    frame, box = (box_at(view, name, view.steps - 1) for name in (to, by))
    before = (free_width_m(frame, box) <= 0.0) & (offset(frame, box)[0] > 0.0)
    held_up = before & (view.speed_mps(to)[:, -1] < limits.STANDS_MPS)
    apart = np.where(held_up, 0.0, view.of_pair("distance_m", by, to))
    return [at_most("distance", apart, limits.OBSTACLE, view.of_pair("closest_s", by, to))]


OCCLUSION = Predicate(occlusion, conflict=False)
OBSTACLE = Predicate(obstacle)

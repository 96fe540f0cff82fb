"""From which side they come who walk as another drove before it turned."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, CrossedArm, Maneuver
from scegen.understanding.draft import Basis, Draft, Entity

_SIDES = {Maneuver.LEFT: Approach.LEFT, Maneuver.RIGHT: Approach.RIGHT}
_OTHER = {Approach.LEFT: Approach.RIGHT, Approach.RIGHT: Approach.LEFT}


def settle_arms(draft: Draft, ego: Entity) -> None:
    """From which side they come who walk as the ego drove before it turned, or against it.

    That leads over the road into which it turns. What is said of the side itself comes first.
    """
    for entity in draft.entities:
        if entity.course is None or len(ego.maneuvers & set(_SIDES)) != 1:
            continue
        along, basis = entity.course
        if entity.crosses is None:
            reason = "across the ego's turn only this road is walked that way"
            entity.crosses = (CrossedArm.EXIT, Basis(basis.i, basis.j, reason))
        side = _SIDES[next(iter(ego.maneuvers & set(_SIDES)))]
        side = side if along else _OTHER[side]
        said = [p.approaches & set(_OTHER) for p in draft.placements if p.entity is entity]
        if entity.crosses[0] is CrossedArm.EXIT and all(side in sides for sides in said if sides):
            draft.place(entity, ego, {side}, basis)

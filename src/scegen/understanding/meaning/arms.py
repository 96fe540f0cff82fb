"""By which arms: who is on the road that has the sign, and over which road people walk."""

from __future__ import annotations

from scegen.scenario.control import controlled_arms
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import Approach, Control, CrossedArm, JunctionKind, Maneuver
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Entity

_SIDES = {Maneuver.LEFT: Approach.LEFT, Maneuver.RIGHT: Approach.RIGHT}
_OTHER = {Approach.LEFT: Approach.RIGHT, Approach.RIGHT: Approach.LEFT}
_ALL_ALIKE = frozenset({Control.SIGNALS, Control.ALL_WAY_STOP})


def settle_arms(draft: Draft, ego: Entity) -> None:
    """From which side they come who walk as the ego drove before it turned, or against it.

    That leads over the road into which it turns. What is said of the side itself comes first.
    """
    for entity in draft.entities:
        alone = len(ego.maneuvers & set(_SIDES)) == 1
        if entity.course is None or entity.crosses is None or not alone:
            continue
        along, basis = entity.course
        side = _SIDES[next(iter(ego.maneuvers & set(_SIDES)))]
        side = side if along else _OTHER[side]
        said = [p.approaches & set(_OTHER) for p in draft.placements if p.entity is entity]
        if entity.crosses[0] is CrossedArm.EXIT and all(side in sides for sides in said if sides):
            draft.place(entity, ego, {side}, basis)


def settle_roads(draft: Draft, junction: Junction) -> None:
    """Lets who has the sign enter where it stands, and who has priority elsewhere.

    A T without signs has a side road, too.
    """
    signed = junction.control in {Control.YIELD, Control.STOP}
    stem = junction.kind is JunctionKind.T and junction.control not in _ALL_ALIKE
    if not (signed or stem):
        return
    minor = controlled_arms(
        junction if signed else junction.model_copy(update={"control": Control.YIELD})
    )
    for entity in draft.entities:
        if entity.on_minor is None or entity.entries or not entity.moving_vehicle:
            continue
        if Maneuver.CROSS in entity.maneuvers:
            continue  # a cyclist who crosses a road has none of its arms to come in by
        on_minor, basis = entity.on_minor
        arms = minor if on_minor else frozenset(range(junction.arms)) - minor
        entity.entries, entity.entry_basis = set(arms), basis

"""Between whom a distance or a time lies, where the words leave one of them out."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.draft import Entity
from scegen.understanding.frames import Measured
from scegen.understanding.happenings import amount_of
from scegen.understanding.semantics.context import Context


def ego_of(context: Context) -> Entity | None:
    """The ego, if the text names one."""
    return next((e for e in context.draft.entities if e.ego), None)


def counterpart(entity: Entity, context: Context, near: list[Entity]) -> Entity | None:
    """The other of two: for everybody the ego; for the ego who is ahead, or the only other.

    Args:
        entity: one of them.
        context: the scenario in the making.
        near: who is spoken of around, the nearest last.
    """
    ego = ego_of(context)
    if entity is not ego and ego is not None:
        return ego
    others = [e for e in context.draft.entities if e is not entity]
    named = [e for e in reversed(near) if e in others]
    ahead = [e for e in others if context.placed(e, Approach.AHEAD) or "ahead" in e.dirs | e.loci]
    moving = [e for e in ahead if e.stands is None and not e.parked]
    for choice in (
        [e for e in named if e in moving],
        [e for e in named if e in ahead],
        named,
        moving,
        ahead,
        [e for e in others if not e.parked],
    ):
        if choice:
            return choice[0]
    return others[0] if len(others) == 1 else None


def in_file(one: Entity, other: Entity, context: Context) -> tuple[Entity, Entity]:
    """Two as follower and leader: a headway is that of the one behind."""
    for placement in context.draft.placements:
        reference = placement.reference or ego_of(context)
        if {placement.entity, reference} != {one, other} or reference is None:
            continue
        if placement.approaches == {Approach.AHEAD}:
            return reference, placement.entity
        if placement.approaches == {Approach.BEHIND}:
            return placement.entity, reference
    return (one, other) if one.ego or not other.ego else (other, one)


def behind_or_ahead(number: Measured, one: Entity, other: Entity, context: Context) -> None:
    """``15 m behind``: who is said to be there, if no place of the two is said.

    Args:
        number: the distance.
        one: who is there.
        other: from whom.
        context: the scenario in the making.
    """
    draft, after = context.draft, number.around.after
    way = {" behind ": Approach.BEHIND, " ahead ": Approach.AHEAD, " in front ": Approach.AHEAD}
    said = next((a for w, a in way.items() if after.startswith(w)), None)
    known = any(
        {p.entity, p.reference or ego_of(context)} == {one, other} for p in draft.placements
    )
    vehicles = one.is_vehicle and other.is_vehicle and not (one.parked or other.parked)
    sideways = {Maneuver.CROSS, Maneuver.LANE_CHANGE} & (one.maneuvers | other.maneuvers)
    if said is not None and not known and vehicles and not sideways:
        draft.place(one, other, {said}, amount_of(number).basis)

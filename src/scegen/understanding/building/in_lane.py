"""Where in the road somebody is: ahead in the lane, in which of several lanes, in the ring."""

from __future__ import annotations

from scegen.scenario.acts import ActKind
from scegen.scenario.functional import Junction
from scegen.scenario.vocabulary import (
    ON_FOOT,
    Approach,
    DrivingSide,
    HazardKind,
    JunctionKind,
    Maneuver,
)
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.happenings import Happenings
from scegen.understanding.semantics.numbered_lanes import EITHER

_FEWEST_WITH_A_MIDDLE = 3
_ASIDE = frozenset({ActKind.CHANGE_LANE, ActKind.OVERTAKE})
BRAKING = frozenset({HazardKind.HARD_BRAKING, HazardKind.DELAYED_BRAKING, HazardKind.STOPPING})
_UNSETTLED = "from which side lanes are counted is not said, so the number names none"


def settle_along(draft: Draft, ego: Entity, happenings: Happenings) -> None:
    """On a straight road, who stands or walks in the lane is ahead; lanes of one name are one.

    So is whoever drives there, where the ego brakes.
    """
    brakes = any(d.kind in BRAKING and ego in d.by for d in draft.dangers)
    aside = any(a.entity is ego and a.kind in _ASIDE and a.side for a in happenings.acts)
    passed = {
        e.index
        for d in draft.dangers
        if aside and d.kind is HazardKind.OVERTAKING and ego in d.by
        for e in d.to
    }
    for entity in draft.entities:
        if entity is ego:
            continue
        _in_the_same_lane(entity, ego, passed=entity.index in passed)
        alone = not entity.approaches and entity.heading is None and not entity.parked
        if entity.stands is not None and alone:
            basis = entity.stands
            entity.approaches = {Approach.AHEAD}
            entity.approach_basis = Basis(basis.i, basis.j, "who stands in the lane is ahead")
        if entity.in_egos_lane is not None and alone and entity.moving_vehicle:
            entity.approaches = {Approach.AHEAD}
            entity.approaches |= set() if entity.stands or brakes else {Approach.BEHIND}
            entity.approach_basis = entity.in_egos_lane
        along = {Approach.AHEAD, Approach.OPPOSITE}
        walks = entity.kind in ON_FOOT
        sides = entity.approaches & {Approach.LEFT, Approach.RIGHT}
        if walks and Maneuver.CROSS in entity.maneuvers and sides:
            entity.approaches = sides  # "behind it, from the right": from where it comes
        along |= {Approach.BEHIND} if entity.maneuvers == {Maneuver.STAY} else set()
        keeps = entity.maneuvers in ({Maneuver.STRAIGHT}, {Maneuver.STAY})
        if walks and keeps and entity.approaches & along:
            entity.approaches &= along
        afoot = entity.kind in ON_FOOT
        if afoot and alone and entity.maneuvers == {Maneuver.STRAIGHT}:
            basis = entity.maneuver_basis or entity.basis
            entity.approaches = {Approach.AHEAD, Approach.OPPOSITE}
            reason = "along the road; which way is not said"
            entity.approach_basis = Basis(basis.i, basis.j, reason)


def _in_the_same_lane(entity: Entity, ego: Entity, *, passed: bool) -> None:
    """``the ego in the right lane … a truck in the right lane``: not beside it.

    Nor is who stands in the right lane, where nobody says in which one the ego drives, or whom it
    changes lanes to pass.
    """
    if entity.start_lane is None or entity.approaches != {Approach.ADJACENT}:
        return
    same = ego.start_lane is not None and entity.start_lane[0] == ego.start_lane[0]
    barred = ego.start_lane is None and (passed or entity.stands is not None)
    if same or barred:
        entity.beside = None
        basis = entity.start_lane[1]
        entity.approaches = {Approach.AHEAD}
        reason = "who stands in the lane is ahead"
        if same or passed:
            reason = "in the lane of the ego" if same else "the ego goes over to pass it"
        entity.approach_basis = Basis(basis.i, basis.j, reason)


def beside_of(entity: Entity) -> Approach | None:
    """On which side of the ego the lane of somebody beside it lies."""
    if entity.approaches != {Approach.ADJACENT} or entity.beside is None:
        return None
    return Approach(entity.beside[0])


def lanes_of(entity: Entity, junction: Junction) -> frozenset[int]:
    """The lane that the text names, counted from 1 at the centre line outwards."""
    count = min(junction.lanes, default=1)
    if entity.start_lane is None or count < 2:
        return frozenset()
    name = entity.start_lane[0]
    if name == "middle":
        return frozenset({count // 2 + 1}) if count >= _FEWEST_WITH_A_MIDDLE else frozenset()
    if name in {"fast", "slow"}:
        return frozenset({1 if name == "fast" else count})
    if name.isdigit():
        return frozenset({int(name)}) if int(name) <= count else frozenset()
    inner = "right" if junction.driving_side is DrivingSide.LEFT else "left"
    number, _, side = name.partition(" from ")
    if side:
        inwards, outwards = int(number), count + 1 - int(number)
        found = {inner: {inwards}, EITHER: {inwards, outwards}}.get(side, {outwards})
        return frozenset(found) if int(number) <= count else frozenset()
    return frozenset({1 if name == inner else count})


def settle_numbers(draft: Draft, ego: Entity, junction: Junction) -> None:
    """Lanes by number, where nothing says from which side they are counted.

    The middle one is the same from either. Either is open of one lane alone, in which somebody is,
    or the ego with others in file. Of several, or where these would be all lanes, the numbers only
    tell who is beside the ego; else they are reported.
    """
    told = [e for e in draft.entities if e.start_lane and e.start_lane[0].endswith(EITHER)]
    unsettled = [e for e in told if len(lanes_of(e, junction)) != 1]
    count = min(junction.lanes, default=1)
    in_file = {Approach.AHEAD, Approach.BEHIND}
    alone = [
        e for e in unsettled if e is ego or not 0 < len(e.approaches) <= len(e.approaches & in_file)
    ]
    alike = len({e.lane for e in unsettled}) == 1 and (len(unsettled) == 1 or alone == [ego])
    if alike and 0 < len(lanes_of(unsettled[0], junction)) < count:
        return
    beside = [e for e in told if e is not ego and e.approaches == {Approach.ADJACENT}]
    for entity in unsettled:
        _, basis = entity.start_lane or ("", entity.basis)
        entity.start_lane = None
        expressed = entity in beside or (entity is ego and beside)
        if not expressed:
            draft.note_at(basis, _UNSETTLED)


def circulates(entity: Entity, junction: Junction) -> bool:
    """Whether somebody is said to be in the roundabout already."""
    return junction.kind is JunctionKind.ROUNDABOUT and entity.circulates is not None


Placed = tuple[Entity, Entity, set[Approach], Basis]


def past_people(relations: list[Placed]) -> list[Placed]:
    """``a man stands ahead and, behind him, a bus``: farther on, as one sees it who comes there.

    Args:
        relations: who is where, seen from whom.
    """
    return [
        (entity, reference, {Approach.AHEAD}, basis)
        if approaches == {Approach.BEHIND}
        and not reference.is_vehicle
        and reference.approaches == {Approach.AHEAD} == entity.approaches
        else (entity, reference, approaches, basis)
        for entity, reference, approaches, basis in relations
    ]

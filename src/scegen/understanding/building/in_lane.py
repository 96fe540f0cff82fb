"""Where in the road somebody is: ahead in the lane, in which of several lanes, in the ring."""

from __future__ import annotations

from scegen.scenario.acts import ActKind
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import Approach, DrivingSide, HazardKind, Maneuver, ParticipantKind
from scegen.understanding.building.viewpoint import Placed
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Entity
from scegen.understanding.happenings import Happenings
from scegen.understanding.semantics.lanes import EITHER

_FEWEST_WITH_A_MIDDLE = 3
_ASIDE = frozenset({ActKind.CHANGE_LANE, ActKind.OVERTAKE})
_BRAKING = frozenset({HazardKind.HARD_BRAKING, HazardKind.DELAYED_BRAKING, HazardKind.STOPPING})
_TWO_WHEELED = frozenset({ParticipantKind.BICYCLE, ParticipantKind.MOTORCYCLE})
_ABREAST = "nobody rides beside another in one lane; one is behind the other instead"
_UNSETTLED = "from which side lanes are counted is not said, so the number names none"


def settle_along(draft: Draft, ego: Entity, happenings: Happenings) -> None:
    """On a straight road, who stands or walks in the lane is ahead; lanes of one name are one.

    So is whoever drives there, where the ego brakes.
    """
    brakes = ego in draft.causing(*_BRAKING)
    aside = any(a.entity is ego and a.kind in _ASIDE and a.side for a in happenings.acts)
    overtaken = [d.to for d in draft.dangers if d.kind is HazardKind.OVERTAKING and ego in d.by]
    for entity in draft.entities:
        if entity is ego:
            continue
        passed = aside and any(entity in to for to in overtaken)
        _in_the_same_lane(entity, ego, passed=passed)
        alone = not entity.approaches and entity.heading is None and not entity.parked
        if entity.stands is not None and alone:
            basis = entity.stands.because("who stands in the lane is ahead")
            entity.comes_from({Approach.AHEAD}, basis)
        if entity.in_egos_lane is not None and alone and entity.moving_vehicle:
            either = set() if entity.stands or brakes else {Approach.BEHIND}
            entity.comes_from({Approach.AHEAD, *either}, entity.in_egos_lane)
        if not entity.is_vehicle:
            _afoot(entity, alone=alone)


def _afoot(entity: Entity, *, alone: bool) -> None:
    """Who crosses comes from a side; who walks along the road, or stands, is before one."""
    along = {Approach.AHEAD, Approach.OPPOSITE}
    sides = entity.approaches & {Approach.LEFT, Approach.RIGHT}
    if Maneuver.CROSS in entity.maneuvers and sides:
        entity.approaches = sides  # "behind it, from the right": from where it comes
    elif entity.maneuvers == {Maneuver.STAY}:
        entity.approaches = entity.approaches & (along | {Approach.BEHIND}) or entity.approaches
    elif entity.maneuvers == {Maneuver.STRAIGHT} and alone:
        basis = entity.maneuver_basis or entity.basis
        entity.comes_from(along, basis.because("along the road; which way is not said"))
    elif entity.maneuvers == {Maneuver.STRAIGHT}:
        entity.approaches = entity.approaches & along or entity.approaches


def _in_the_same_lane(entity: Entity, ego: Entity, *, passed: bool) -> None:
    """``the ego in the right lane … a truck in the right lane``: not beside it.

    Nor is who stands in the right lane, where nobody says in which one the ego drives, or whom it
    changes lanes to pass.
    """
    if entity.start_lane is None or entity.approaches != {Approach.ADJACENT}:
        return
    same = ego.start_lane is not None and entity.start_lane[0] == ego.start_lane[0]
    if same or (ego.start_lane is None and (passed or entity.stands is not None)):
        reason = "the ego goes over to pass it" if passed else "who stands in the lane is ahead"
        reason = "in the lane of the ego" if same else reason
        entity.beside = None
        entity.comes_from({Approach.AHEAD}, entity.start_lane[1].because(reason))


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


def past_people(relations: list[Placed]) -> list[Placed]:
    """``a man stands ahead and, behind him, a bus``: farther on, as one sees it who comes there."""
    return [
        (entity, reference, {Approach.AHEAD}, basis)
        if approaches == {Approach.BEHIND}
        and not reference.is_vehicle
        and reference.approaches == {Approach.AHEAD} == entity.approaches
        else (entity, reference, approaches, basis)
        for entity, reference, approaches, basis in relations
    ]


def side_by_side(relations: list[Placed], draft: Draft) -> list[Placed]:
    """``two cars drive abreast ahead of the ego``: only one of them can be in its lane.

    Two-wheelers share a lane, which is noted.
    """
    kept: list[Placed] = []
    for entity, reference, approaches, basis in relations:
        alike = entity.approaches == reference.approaches
        in_lane = alike and entity.approaches in ({Approach.AHEAD}, {Approach.BEHIND})
        if approaches == {Approach.ADJACENT} and in_lane:
            if {entity.kind, reference.kind} <= _TWO_WHEELED:
                draft.note_at(basis, _ABREAST)
                continue
            entity.approaches = set()
        kept.append((entity, reference, approaches, basis))
    return kept

"""How many lanes the road has, and in which somebody is: ahead in the lane, in one of several."""

from itertools import pairwise

from scegen.errors import InfeasibleError
from scegen.scenario.acts import ActKind
from scegen.scenario.junction import MAX_LANES, Junction
from scegen.scenario.vocabulary import (
    Approach,
    DrivingSide,
    HazardKind,
    JunctionKind,
    Maneuver,
    ParticipantKind,
    Side,
)
from scegen.understanding.building.viewpoint import Placed
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import Doing, Happenings
from scegen.understanding.lexicon import word_list
from scegen.understanding.road.lengthwise import Lengthwise
from scegen.understanding.road.surroundings import Surroundings
from scegen.understanding.semantics.lanes import EITHER

JOINING = "joining"
"""The lane beside the others into which a ramp leads."""
_FEWEST_WITH_A_MIDDLE = 3
_ASIDE = frozenset({ActKind.CHANGE_LANE, ActKind.OVERTAKE})
_BRAKING = frozenset({HazardKind.HARD_BRAKING, HazardKind.DELAYED_BRAKING, HazardKind.STOPPING})
TWO_WHEELED = frozenset({ParticipantKind.BICYCLE, ParticipantKind.MOTORCYCLE})
_ABREAST = "nobody rides beside another in one lane; one is behind the other instead"
_UNSETTLED = "from which side lanes are counted is not said, so the number names none"


def settle_along(draft: Draft, ego: Entity, happenings: Happenings) -> None:
    """On a straight road, who stands or walks in the lane is ahead; lanes of one name are one.

    So is whoever drives there, where the ego brakes or is faster.
    """
    brakes = ego in draft.causing(*_BRAKING)
    aside = any(a.entity is ego and a.kind in _ASIDE and a.side for a in happenings.acts)
    overtaken = [d.to for d in draft.dangers if d.kind is HazardKind.OVERTAKING and ego in d.by]
    changes = (a for a in happenings.acts if a.entity is ego and a.kind is ActKind.CHANGE_LANE)
    first = next(changes, None)
    leaves = first.side.opposite if first is not None and first.side is not None else None
    _stood_before(ego, draft, happenings)
    for entity in draft.entities:
        if entity is ego:
            continue
        passed = aside and any(entity in to for to in overtaken)
        comes_up = any(
            p.reference is entity and p.approaches == {Approach.BEHIND}
            for p in draft.placements_of(ego)
        )
        _in_the_same_lane(entity, ego, leaves, passed=passed, met=comes_up)
        _into_the_lane(entity, ego, happenings)
        alone = not entity.approaches and entity.heading is None and not entity.parked
        if entity.stands is not None and alone:
            basis = entity.stands.because("who stands in the lane is ahead")
            entity.comes_from({Approach.AHEAD}, basis)
        if entity.in_egos_lane is not None and alone and entity.moving_vehicle:
            slower = entity.speed and ego.speed and entity.speed.high < ego.speed.low
            either = set() if entity.stands or brakes or slower else {Approach.BEHIND}
            entity.comes_from({Approach.AHEAD, *either}, entity.in_egos_lane)
        if not entity.is_vehicle:
            _afoot(entity, alone=alone)


def _stood_before(ego: Entity, draft: Draft, happenings: Happenings) -> None:
    """``stops 2 m behind a van``: of which nothing else is told, so it stands there."""
    told = {*draft.causing(), *(act.entity for act in happenings.acts)}
    for apart in happenings.spacings:
        pair, stops = (apart.entity, apart.reference), apart.at
        at_rest = apart.since == "end" and isinstance(stops, Doing) and stops.ends_at_rest
        others = [e for e in pair if isinstance(e, Entity) and e not in told and e.speed is None]
        for other in others if at_rest and ego in pair and ego in told else ():
            free = other.moving_vehicle and not (other.maneuvers or other.heading)
            if (
                free
                and not {"moves", "followed"} & other.told.keys()
                and other.approaches <= {Approach.AHEAD}
            ):
                basis = apart.amount.basis.because("nothing says that it drives: it stands there")
                other.stands = other.stands or basis


def _afoot(entity: Entity, *, alone: bool) -> None:
    """Who crosses comes from a side; who walks along the road, or stands, is before one."""
    along = {Approach.AHEAD, Approach.OPPOSITE}
    sides = entity.approaches & {Approach.LEFT, Approach.RIGHT}
    if Maneuver.CROSS in entity.maneuvers and sides:
        entity.approaches = sides  # "behind it, from the right": from where it comes
    elif entity.maneuvers == {Maneuver.STRAIGHT} and alone:
        basis = entity.maneuver_basis or entity.basis
        entity.comes_from(along, basis.because("along the road; which way is not said"))
    elif entity.maneuvers == {Maneuver.STRAIGHT}:
        entity.approaches = entity.approaches & along or entity.approaches


def _in_the_same_lane(
    entity: Entity, ego: Entity, leaves: Side | None, *, passed: bool, met: bool
) -> None:
    """``the ego in the right lane … a truck in the right lane``: not beside it.

    So it is where the ego changes to the left lane: it ``leaves`` the right one. Nor is who stands
    in the right lane, where nobody says in which one the ego drives, or whom it comes up to or is
    behind of there, or changes lanes to pass.
    """
    if entity.start_lane is None or entity.approaches != {Approach.ADJACENT}:
        return
    along, words = entity.in_next_lane or (set(), entity.basis)
    met = along == {Approach.AHEAD} and (met or words.reason is not None)
    own = ego.start_lane[0] if ego.start_lane is not None else leaves
    same = own is not None and entity.start_lane[0] == own
    if same or (ego.start_lane is None and (passed or met or entity.stands is not None)):
        reason = "the ego goes over to pass it" if passed else "who is met in the lane is ahead"
        reason = "in the lane of the ego" if same else reason
        behind = {Approach.BEHIND} if same and along == {Approach.BEHIND} else None
        told = words if met and not same else entity.start_lane[1].because(reason)
        entity.comes_from(behind or {Approach.AHEAD}, told)


def _into_the_lane(entity: Entity, ego: Entity, happenings: Happenings) -> None:
    """``the car ahead cuts in``, ``ahead in the middle lane … changes into the lane of the ego``.

    Until then it is beside that lane.
    """
    along = entity.approaches
    if along not in ({Approach.AHEAD}, {Approach.BEHIND}):
        return
    first = next((a for a in happenings.acts if a.entity is entity and a.kind in _ASIDE), None)
    if first is not None and first.into is ego and first.kind is ActKind.CHANGE_LANE:
        side = {Approach(first.side.opposite.value)} if first.side is not None else set()
        words = entity.approach_basis or entity.basis
        entity.in_next_lane = entity.in_next_lane or (along, words)
        because = words.because("who comes into the ego's lane is beside it")
        entity.comes_from({Approach.ADJACENT, *side}, because)


def lanes_of(entity: Entity, junction: Junction) -> frozenset[int]:
    """The lane that the text names, counted from 1 at the centre line outwards."""
    count = min(junction.lanes, default=1)
    name = entity.start_lane[0] if entity.start_lane is not None else ""
    if name == JOINING:
        return frozenset({junction.through_lanes + 1})
    if not name or count < 2:
        return frozenset()
    if name == "middle":
        return frozenset({count // 2 + 1}) if count >= _FEWEST_WITH_A_MIDDLE else frozenset()
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
            if {entity.kind, reference.kind} <= TWO_WHEELED:
                draft.note_at(basis, _ABREAST)
                continue
            entity.approaches = set()
        kept.append((entity, reference, approaches, basis))
    return kept


_MOST_LANES = 3
_RING_LANES = 2
_RING_OF_TWO = "a roundabout's ring has 2 lanes at most, and has 2 here"
_FEWER_LANES = "at junctions at most 3 lanes a direction are built; as many as it takes"
_FEWEST_TO_NAME = 2
"""There is a left and a right lane only where there are two."""


def lanes_of_road(
    draft: Draft, around: Surroundings, along: Lengthwise, kind: JunctionKind, arms: int
) -> tuple[tuple[int, ...], int | None, Basis | None]:
    """Lanes per arm and direction, those of a ring, and why; none: as many as it takes.

    The positions of the draft are settled by then.

    Raises:
        InfeasibleError: it names a lane beyond those that are built.
    """
    ring, plain = kind is JunctionKind.ROUNDABOUT, kind is JunctionKind.STRAIGHT
    implied = draft.implied.get("lanes")
    beside = [e for e in draft.entities if Approach.ADJACENT in e.approaches]
    if implied is None and beside:
        basis = beside[0].approach_basis or beside[0].basis
        implied = basis.because("vehicles side by side need a second lane")
    most = MAX_LANES if plain else _MOST_LANES
    if around.lanes == 1 and around.lanes_in_all is not None and implied is not None:
        count = min(around.lanes_in_all, most)  # "on a two-lane road, a car in the next lane"
        reason = f"{count} lanes in one direction: {implied.reason or 'a second one is meant'}"
        counted = around.lanes_basis or implied
        return (count,) * arms, None, counted.because(reason)
    if around.lanes_basis is not None and (around.lanes or 0) > (_RING_LANES if ring else most):
        draft.note_at(around.lanes_basis, _RING_OF_TWO if ring else _FEWER_LANES)
    if around.lanes is not None and around.lanes <= most:
        doubled = _RING_LANES if ring and around.lanes > 1 else None
        return (around.lanes,) * arms, doubled, around.lanes_basis
    parted = along.carriageway is not None and not along.presumed  # the words do so for sure
    passing = draft.implied.get("passing")
    if implied is None and passing is not None:
        facing = any(Approach.OPPOSITE in e.approaches for e in draft.entities)
        facing = facing or (around.two_lane is not None and around.highway is None)
        if facing and not (ring or parted):
            reason = "who overtakes uses the oncoming lane"
            return (1,) * arms, None, passing.because(reason)
        implied = passing.because("overtaking needs a second lane")
    if implied is None and plain and around.two_lane is not None and not parted:
        counted = around.two_lane
        return (1,) * arms, None, counted.because("two lanes, one each way")
    if implied is None and around.highway is not None:
        reason = "highways have two lanes per direction unless said otherwise"
        implied = around.highway.because(reason)
    lanes = [e.start_lane for e in draft.entities if e.start_lane is not None]
    named = [name for name, _ in lanes]
    if implied is None or not (ring or named or around.highway is not None):
        return (), None, None  # as many as it takes
    sides = {e.beside[0] for e in beside if e.beside is not None}
    middle = "middle" in named or len(sides) > 1 or _middle_lane(draft)
    count = _MOST_LANES if middle else _FEWEST_TO_NAME
    count = max(count, *(int(name.split()[0]) for name in named if name[0].isdigit()), 0)
    if count > most:
        msg = f"lane {count} is named; at most {most} lanes a direction are built here"
        raise InfeasibleError(msg, where="junction.lanes", hint="Name a lower number.")
    return (count,) * arms, (2 if ring else None), implied


def _middle_lane(draft: Draft) -> bool:
    """``changes from the left to the middle lane``."""
    words = [token.low for token in draft.tokens]
    pairs = pairwise(words)
    return any(one in word_list("middle") and other == "lane" for one, other in pairs)

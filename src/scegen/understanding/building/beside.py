"""Who and what is on and beside the lanes: in the way, abreast, on strips, on a ramp."""

from typing import TypeAlias

from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.roadway import (
    BESIDE_AN_AUXILIARY_LANE,
    NOT_BESIDE_A_SHOULDER,
    PLAIN_ROAD_STRIPS,
    AuxiliaryLane,
    Carriageway,
    Strip,
)
from scegen.scenario.vocabulary import Approach, HazardKind, JunctionKind, Maneuver, ParticipantKind
from scegen.understanding.building.in_lane import JOINING, TWO_WHEELED
from scegen.understanding.building.leftovers import ONE_RAMP
from scegen.understanding.building.viewpoint import unplaced_dangers
from scegen.understanding.building.writing import Proofs
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import Happenings, Item
from scegen.understanding.road.lengthwise import Lengthwise
from scegen.understanding.semantics.lanes import INVERSE

AT_JUNCTIONS = "built only along a road without a junction; here the plain road is"
_INNER_SHOULDER = "no shoulder is built along the median; here it is on the outer one"
_NOBODY_DRIVES = "there is one, but only who stands from the start is put on it"
_BESIDE_A_SHOULDER = "built only where there is no hard shoulder; here it is left out"
_BESIDE_A_RAMP = "built only where no ramp joins or leaves; here it is left out"


def strips_beside(
    draft: Draft,
    along: Lengthwise,
    proofs: Proofs,
    kind: JunctionKind,
    carriageway: Carriageway,
    auxiliary: AuxiliaryLane | None,
) -> frozenset[Strip]:
    """The strips of the road; a motorway's hard shoulder only where it is one.

    Only a hard shoulder lies beside an auxiliary lane. Who is on a strip that is not built is taken
    off it.
    """
    found: set[Strip] = set()
    back = any(Maneuver.U_TURN in e.maneuvers for e in draft.entities)
    plain = kind is JunctionKind.STRAIGHT and not back
    for strip, basis in along.strips.items():
        of_road = basis == along.carriageway_basis
        if strip in along.without:
            proofs.add("junction.strips", along.without[strip])
        elif not plain:
            draft.note_at(None if of_road else basis, AT_JUNCTIONS)
        elif auxiliary is not None and strip not in BESIDE_AN_AUXILIARY_LANE:
            draft.note_at(None if of_road else basis, _BESIDE_A_RAMP)
        elif not of_road or carriageway is Carriageway.DIVIDED:
            told = (e.parked or e.was_parked or e.strip for e in draft.entities)
            if strip is Strip.HARD_SHOULDER and not of_road and not any(told):
                draft.note_at(basis, _NOBODY_DRIVES)
            proofs.add("junction.strips", basis)
            found.add(strip)
    _where_somebody_is(draft, proofs, found, plain=plain, ramp=auxiliary is not None)
    return frozenset(found)


def _where_somebody_is(
    draft: Draft, proofs: Proofs, found: set[Strip], *, plain: bool, ramp: bool
) -> None:
    """Adds the strips on which somebody is at first; who crosses starts behind them all.

    Who waits at a bus stop on foot does so behind it, on the pavement.
    """
    kerb, sides = Approach(draft.kerb), {Approach.LEFT, Approach.RIGHT}
    for entity in draft.entities:
        strip, basis = entity.strip or (None, None)
        if strip is Strip.BUS_STOP and basis is not None and not entity.is_vehicle and not ramp:
            found |= {strip} if plain else set()
            strip, entity.strip = Strip.PAVEMENT, (Strip.PAVEMENT, basis)
        others = [e for e in draft.entities if e is not entity and not e.parked]
        crossed = {e.moving_vehicle and Maneuver.CROSS not in e.maneuvers for e in others} != {True}
        backs_up = crossed and entity in draft.causing(HazardKind.REVERSING)  # before nobody
        if strip is None or basis is None or backs_up or Maneuver.CROSS in entity.maneuvers:
            entity.strip = None
            continue
        built = plain or (entity.parked and strip not in PLAIN_ROAD_STRIPS)
        beside = Strip.HARD_SHOULDER in found and strip in NOT_BESIDE_A_SHOULDER
        if strip is Strip.HARD_SHOULDER and entity.approaches & sides == sides - {kerb}:
            draft.note_at(basis, _INNER_SHOULDER)
            entity.approaches = {kerb}
        if ramp and strip not in BESIDE_AN_AUXILIARY_LANE:
            entity.strip = None
            draft.note_at(basis, _BESIDE_A_RAMP)
        elif built and not beside:
            proofs.add("junction.strips", basis)
            found.add(strip)
        elif strip not in found:
            entity.strip = None
            draft.note_at(basis, _BESIDE_A_SHOULDER if beside else AT_JUNCTIONS)


Used: TypeAlias = tuple[AuxiliaryLane, Basis] | None
"""The auxiliary lane that somebody uses, with the words for that."""


def auxiliary_lane(draft: Draft, *, drops: bool) -> Used:
    """The auxiliary lane that somebody uses, with the words for it; of two, who joins counts.

    It ``drops`` where the text names a lane that ends, and no ramp.
    """
    driven = [e for e in draft.entities if e.moving_vehicle]
    for words in (e.by_ramp for e in driven if e.by_ramp is not None):
        return AuxiliaryLane.LANE_DROP if drops else AuxiliaryLane.ON_RAMP, words
    exits = (basis for e in driven if (basis := e.told.get("exits")) is not None)
    return next(((AuxiliaryLane.OFF_RAMP, basis) for basis in exits), None)


def settle_ramp(
    draft: Draft, ego: Entity, auxiliary: AuxiliaryLane, along: Lengthwise, *, beside_ego: bool
) -> None:
    """Who uses the auxiliary lane merges or exits, from or to the side of the kerb."""
    kerb = Approach(draft.kerb)
    leaves = auxiliary is AuxiliaryLane.OFF_RAMP
    for entity in draft.entities:
        exits = entity.told.get("exits")
        basis = exits if leaves else entity.by_ramp
        draft.note_at(None if leaves else exits, ONE_RAMP)
        if basis is None or not entity.moving_vehicle:
            continue
        entity.maneuvers = {Maneuver.EXIT if leaves else Maneuver.MERGE}
        entity.maneuver_basis = basis
        if leaves:
            continue
        entity.start_lane = (JOINING, basis) if along.alongside else None
        if not entity.ego and ego.by_ramp is None:
            beside = {Approach.ADJACENT, kerb} if beside_ego else set[Approach]()
            entity.comes_from(beside, entity.approach_basis or basis)
    if ego.by_ramp is None or leaves:
        return
    for entity in draft.entities:
        # All others are on the road that the ego joins, which lies to the other side.
        there = entity.beside is not None and entity.beside[0] == kerb.value
        # "In front of a truck" is where it gets to: until then the truck drives beside the ramp.
        there = there or entity.approaches in ({Approach.AHEAD}, {Approach.BEHIND})
        if entity.by_ramp is None and there:
            entity.approaches = {Approach.ADJACENT}
            entity.beside = INVERSE[kerb].value, entity.approach_basis or ego.by_ramp
            if entity.in_next_lane is not None and entity.in_next_lane[0] == {Approach.BEHIND}:
                entity.in_next_lane = None


_IN_THE_WAY = frozenset({HazardKind.STOPPING, HazardKind.SLOW_DRIVING, HazardKind.HARD_BRAKING,
                         HazardKind.OBSTACLE})  # fmt: skip
_OVER_THERE = frozenset({Maneuver.U_TURN, Maneuver.OVERTAKE, Maneuver.LEFT, Maneuver.RIGHT})
"""Ways on which one gets into the lane of those who come the other way."""
_OVER = _OVER_THERE | {Maneuver.LANE_CHANGE, Maneuver.MERGE, Maneuver.CROSS}
_SIDEWAYS = (HazardKind.CUT_IN, HazardKind.SWERVING, HazardKind.MERGING_CONFLICT,
             HazardKind.LOSS_OF_CONTROL, HazardKind.ONCOMING_LANE)  # fmt: skip


def in_the_way(draft: Draft, ego: Entity) -> None:
    """On a straight road, who endangers the ego by going slowly or stopping is ahead of it."""
    placed = [e for p in draft.placements for e in (p.entity, p.reference)]
    for entity, basis in unplaced_dangers(draft, ego, _IN_THE_WAY):
        if entity not in placed and entity.heading is None and entity.is_vehicle:
            reason = "on a straight road, who is in the way is ahead"
            entity.comes_from({Approach.AHEAD}, basis.because(reason))


def at_the_edge(draft: Draft, happenings: Happenings) -> None:
    """Who stands or walks at the edge of the road, and concerns nobody, is beside the lanes."""
    told: list[Entity | Item | None] = [*draft.causing(), *draft.suffering()]
    told += [e for s in happenings.spacings for e in (s.entity, s.reference)]
    ending = happenings.ending
    told += ending.between if ending is not None and ending.kind is not OutcomeKind.AVOIDED else []
    for entity in draft.entities:
        stays = bool(entity.maneuvers) and entity.maneuvers <= {Maneuver.STAY, Maneuver.STRAIGHT}
        words = entity.told.get("roadside")
        if stays and words is not None and not entity.is_vehicle and entity not in told:
            entity.strip = entity.strip or (Strip.PAVEMENT, words)


def in_one_lane(draft: Draft, happenings: Happenings) -> None:
    """On a straight road, of two who touch, or nearly do, one comes over to the other.

    Head-on, that is the one that comes the other way; side by side, the one that hits.
    """
    ending = happenings.ending
    pair = ending.between if ending is not None and ending.kind is not OutcomeKind.AVOIDED else []
    told = {*draft.causing(), *draft.suffering()}
    aside = {*draft.causing(*_SIDEWAYS), *draft.suffering(*_SIDEWAYS)}
    over = any(e.maneuvers & _OVER for e in pair) or not aside.isdisjoint(pair)
    for entity in [e for e in pair if e.moving_vehicle]:
        basis = (entity.approach_basis or entity.basis).because("two who touch are in one lane")
        to = [e for e in pair if e.ego and not e.maneuvers & _OVER_THERE]
        oncoming = entity.approaches == {Approach.OPPOSITE} and entity.stands is None
        if oncoming and to and told.isdisjoint(pair):
            draft.hazard(HazardKind.ONCOMING_LANE, basis, [entity], to)
        if Approach.ADJACENT in entity.approaches and not over:
            along, words = entity.in_next_lane or (set(), basis)
            if along == {Approach.AHEAD if pair[0].ego else Approach.BEHIND}:
                entity.comes_from(along, words)  # who is behind in the left lane hits it
            else:
                draft.hazard(HazardKind.SWERVING, basis, pair[:1], pair[1:])


def from_the_strip(draft: Draft, ego: Entity) -> None:
    """On a straight road, who was parked and sets off is parked at first and pulls out."""
    for entity in draft.entities:
        crosses = entity.kind is ParticipantKind.BICYCLE and Maneuver.CROSS in entity.maneuvers
        if entity is ego or entity.was_parked is None or not entity.is_vehicle or crosses:
            continue
        entity.parked, entity.parked_basis = True, entity.was_parked
        entity.maneuvers -= {Maneuver.STAY, Maneuver.CROSS, Maneuver.OVERTAKE}
        if not entity.maneuvers:
            entity.maneuver_basis = entity.was_parked.because("it pulls out and drives on")
            entity.maneuvers = {Maneuver.STRAIGHT}


def abreast(draft: Draft, ego: Entity) -> None:
    """On a straight road, a vehicle on the left is not one that comes out of a road there."""
    along = draft.implied.keys().isdisjoint({"access", "from_kerb"})
    along &= ego.strip is None or ego not in draft.causing(HazardKind.REVERSING)  # out of a bay
    for entity in draft.entities if along else []:
        seen = entity.approaches
        alongside = entity.moving_vehicle and Maneuver.CROSS not in entity.maneuvers
        sided = len(seen) == 1 and seen <= {Approach.LEFT, Approach.RIGHT}
        if entity is ego or not sided or not alongside or entity.pulls_out:
            continue
        basis = entity.approach_basis or entity.basis
        if entity.kind is ParticipantKind.BICYCLE and off_the_road(entity, draft):
            if from_a_side(entity, draft) and not (entity.maneuvers or entity.strip):
                entity.maneuvers, entity.maneuver_basis = {Maneuver.CROSS}, basis
                draft.hazard(HazardKind.CROSSING_CYCLIST, basis, [entity])
            continue
        passed = any(entity in d.to for d in draft.dangers if ego in d.by)
        if entity.kind is ParticipantKind.BICYCLE and seen == {Approach(draft.kerb)} and passed:
            reason = "a cyclist who is overtaken rides ahead, at the kerb"
            entity.comes_from({Approach.AHEAD}, basis.because(reason))
            continue
        basis = basis.because("on a straight road, who is at one's side drives in the next lane")
        entity.beside = entity.beside or (next(iter(seen)).value, basis)
        entity.comes_from({Approach.ADJACENT}, basis)


def both_change_lanes(draft: Draft, ego: Entity) -> None:
    """Who changes lanes as the ego does comes from another lane."""
    both = Maneuver.LANE_CHANGE in ego.maneuvers
    for entity in draft.entities if both else []:
        free = not entity.approaches and not draft.placements_of(entity)
        if entity is not ego and free and Maneuver.LANE_CHANGE in entity.maneuvers:
            basis = entity.maneuver_basis or entity.basis
            reason = "who changes lanes beside the ego comes from another lane"
            entity.comes_from({Approach.ADJACENT}, basis.because(reason))


_TURNS = {Approach.RIGHT: Maneuver.RIGHT, Approach.LEFT: Maneuver.LEFT}


def alongside(draft: Draft, ego: Entity) -> None:
    """A rider on the side to which the ego turns, and who goes on, is beside it.

    One who comes *from* that side comes out of the road there.
    """
    crossing = draft.causing(HazardKind.CROSSING_CYCLIST)
    for entity in draft.entities:
        basis = entity.approach_basis
        if entity is ego or entity.kind not in TWO_WHEELED or basis is None or basis.i is None:
            continue
        seen = entity.approaches - {Approach.BEHIND}  # "from behind on its right"
        side = next(iter(seen)) if len(seen) == 1 else None
        turned_to = side is not None and side in _TURNS and ego.maneuvers == {_TURNS[side]}
        goes_on = entity.maneuvers <= {Maneuver.STRAIGHT} and entity not in crossing
        if turned_to and goes_on and not off_the_road(entity, draft):
            reason = f"beside the ego, on the {side}: it turns across its way"
            entity.comes_from({Approach.ADJACENT, *entity.approaches}, basis.because(reason))


def off_the_road(entity: Entity, draft: Draft) -> bool:
    """``from the right``, ``on the right front``: out of the road or off the pavement there."""
    return from_a_side(entity, draft) or "front" in _words_of_place(entity, draft)


def from_a_side(entity: Entity, draft: Draft) -> bool:
    """``from the right``; not ``1 m from the ego's right side``, ``from behind on the right``."""
    words = _words_of_place(entity, draft)
    return words[:1] == ["from"] and "'s" not in words and Approach.BEHIND not in entity.approaches


def _words_of_place(entity: Entity, draft: Draft) -> list[str]:
    basis = entity.approach_basis or entity.basis
    return [t.low for t in draft.tokens[basis.i : basis.j]] if basis.i is not None else []

"""What a noun of place puts those at it on, or beside: a strip, a lane, a side."""

from scegen.scenario.roadway import BAYS, Strip
from scegen.scenario.vocabulary import Approach, CrossedArm, HazardKind, Maneuver, ParticipantKind
from scegen.understanding.chunks import Mention, Place
from scegen.understanding.draft import Danger
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.semantics.context import Context
from scegen.understanding.semantics.lanes import EITHER, FROM_SIDE, SIDES, counted_from, lane_number
from scegen.understanding.semantics.seen import SEEN, SEVERAL, Put, Site

_OVER_THE_ROAD = frozenset({HazardKind.CROSSING_PEDESTRIAN, HazardKind.CROSSING_CYCLIST})


def _on_strip(entity: Entity, site: Site) -> None:
    """One who stands beside the lanes stands in nobody's way, and nobody overtakes it."""
    stands = entity.still or entity.was_parked is not None
    if entity.ego and not (stands or site.clause.event.name == "reverse"):
        return  # "a taxi overtakes the ego on the hard shoulder"
    if entity.strip is not None or site.noun.head is None:
        return
    strip = Strip(site.noun.head.data["stands_on"])
    entity.strip = strip, site.basis
    if not entity.is_vehicle or entity.ego:
        return
    if entity.pulls_out or (strip in BAYS and entity.sets_off >= 0):
        entity.was_parked = entity.was_parked or site.basis
    elif entity.still or strip in BAYS:
        if site.noun.dirs and not _standing(entity, site.context):  # "at a stop on the left"
            _at_sides(entity, site)
        basis = entity.parked_basis or entity.stands or site.basis
        entity.parked, entity.parked_basis, entity.stands = True, basis, None
        dangers = site.context.draft.dangers
        dangers[:] = [d for d in dangers if not _none_of(d, entity)]


def _none_of(danger: Danger, entity: Entity) -> bool:
    stops = danger.kind is HazardKind.STOPPING and danger.by == [entity]
    return stops or (danger.kind is HazardKind.OVERTAKING and danger.to == [entity])


def _in_numbered(entity: Entity, site: Site) -> None:
    """The lane in which it drives at first, as far as none is known of it yet."""
    number = lane_number(site.noun, site.context.tokens)
    if number is None or entity.start_lane is not None or entity.parked or site.noun.head is None:
        return
    side = counted_from(site.noun.j, site.context.tokens)
    basis = Basis(site.basis.i, site.noun.j + (0 if side == EITHER else FROM_SIDE))
    entity.start_lane = f"{number} from {side}", basis
    site.context.draft.implied.setdefault("lanes", basis.because(SEVERAL))


def _used_as(arm: CrossedArm) -> Put:
    """``turns into a side road``: for who comes by "the side road" later on."""

    def put(_: Entity, site: Site) -> None:
        site.context.draft.used.setdefault(site.place.kind, arm)

    return put


def _crosses(entity: Entity, site: Site) -> None:
    """Which road of a junction it goes over, by where another comes from or goes to."""
    road = site.place
    used = site.context.draft.used
    arm = road.arm or {"exit": CrossedArm.EXIT, **used}.get(road.kind)
    if arm is None and road.head is not None and "mouth" in road.head.data:
        arm = next(iter(used.values()), None)  # of the side road that is told of
    if arm is None:
        return
    entity.crosses = entity.crosses or (arm, site.basis)
    _meets(entity, road, site.context)
    if entity.kind is ParticipantKind.BICYCLE:
        site.context.draft.maneuver(entity, {Maneuver.CROSS}, site.basis)


def _meets(entity: Entity, road: Place, context: Context) -> None:
    """``the road that the truck turns into``: who crosses it meets the truck."""
    if road.user is None or road.user.is_ego:
        return
    kinds = [h.value for h in road.user.heads]
    users = [e for e in context.draft.entities if e.kind.value in kinds and e.moving_vehicle]
    for danger in context.draft.dangers if len(users) == 1 else []:
        if danger.kind in _OVER_THE_ROAD and danger.by == [entity] and not danger.to:
            danger.to = users


def _on_its_side(entity: Entity, site: Site) -> None:
    """Who is hidden by something, or comes out from behind it, is on its side of the road."""
    sides, end = {SIDES[d] for d in site.noun.dirs if d in SIDES}, site.noun.j
    whole = site.noun.owner if isinstance(site.noun, Place) else site.noun
    if isinstance(whole, Mention):  # "from the front of the bus"
        found = {a for e in whole.entities for a in _standing(e, site.context)}
        if found == {Approach.OPPOSITE} and not site.context.meeting:
            found = {Approach(site.context.across)}
        found &= set(SIDES.values())
        sides = found if len(found) == 1 else set()
    elif sides:
        end = max([end, *(m.j for m in site.noun.mods)])
    on_foot = not entity.is_vehicle or ((entity.kind is ParticipantKind.BICYCLE) and not entity.ego)
    if on_foot and not _standing(entity, site.context) & set(SIDES.values()):
        site.context.draft.place(entity, None, sides, Basis(site.basis.i, end))


def _standing(entity: Entity, context: Context) -> set[Approach]:
    """Where one is seen, as far as said, or as their lanes have it."""
    told = context.draft.placements_of(entity)
    seen = {a for p in told if p.reference is None or p.reference.ego for a in p.approaches}
    lanes = [e.start_lane[0] for e in (entity, context.draft.ego) if e and e.start_lane]
    return seen | {SIDES[lane] for lane in lanes[:1] if {*lanes} == {*SIDES}}


def _at_sides(entity: Entity, site: Site) -> None:
    sides = {SIDES[d] for d in site.noun.dirs if d in SIDES}
    site.context.draft.place(entity, None, sides, site.basis)


def _at_kerb(entity: Entity, site: Site) -> None:
    kerb = {Approach(site.context.draft.kerb)} if not site.noun.dirs else set()
    site.context.draft.place(entity, None, kerb, site.basis)


PUTS: dict[str, Put] = {
    **SEEN,
    "strip": _on_strip,
    "sides": _at_sides,
    "kerb": _at_kerb,
    "lane": _in_numbered,
    "leads_to": _used_as(CrossedArm.EXIT),
    "comes_by": _used_as(CrossedArm.ENTRY),
    "crosses": _crosses,
    "its_side": _on_its_side,
}
"""Name -> what it notes of somebody who is there."""

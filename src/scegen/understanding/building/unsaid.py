"""What participants do of whom the text names no maneuver, or of whom no matter which do it."""

from collections import Counter

from scegen.scenario.functional import Group
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import (
    ANIMALS,
    ON_FOOT,
    Approach,
    HazardKind,
    JunctionKind,
    Maneuver,
)
from scegen.understanding.building.writing import Proofs
from scegen.understanding.draft import TURNS, Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import STILL, Happenings

_OVER_A_JUNCTION = frozenset({Maneuver.LEFT, Maneuver.RIGHT, Maneuver.STRAIGHT})
_OUT_OF_THE_ACCESS = frozenset({HazardKind.FAILURE_TO_YIELD, HazardKind.REVERSING,
                                HazardKind.CROSSING_CYCLIST})  # fmt: skip


def maneuvers_of(entity: Entity, junction: Junction, draft: Draft) -> set[Maneuver]:
    """The maneuvers that the text says, or what follows from what it says besides.

    The basis of its maneuvers is set.

    Returns:
        The maneuvers; empty where the text leaves them open.
    """
    if entity.stays and not entity.ego and not entity.parked:
        entity.maneuver_basis = entity.stands
        return {Maneuver.STAY}
    bides = entity.told.get("bides")
    # somebody comes up behind who stands there, or hits it: the ego, or another behind the ego
    seen = [e.approaches for e in draft.entities] if entity.ego else [entity.approaches]
    stands = {Approach.BEHIND if entity.ego else Approach.AHEAD} in seen
    stands = stands or "is_hit" in entity.told or entity in draft.causing(HazardKind.OCCLUSION)
    if bides is not None and entity.sets_off < 0 and stands:
        entity.maneuver_basis = bides.because("it waits, and nothing says that it turns")
        if entity.ego:
            entity.speed, entity.speed_basis = STILL, bides
        return {Maneuver.STAY}
    if entity.maneuvers and (entity.was_parked is not None or not entity.parked):
        turns = entity.maneuvers & TURNS
        passes = turns and entity in draft.causing(HazardKind.OVERTAKING)
        return turns if passes else entity.maneuvers  # "overtakes, then turns right"
    found = _followed(entity, junction, draft)
    if found is None:
        left = _ways_left(entity) if junction.kind is not JunctionKind.ROUNDABOUT else set()
        if left and entity.excluded_basis is not None:
            entity.maneuver_basis = entity.excluded_basis.because("the other ways are ruled out")
        return left
    maneuver, words, reason = found
    entity.maneuver_basis = words.because(reason)
    return {maneuver}


def _followed(
    entity: Entity, junction: Junction, draft: Draft
) -> tuple[Maneuver, Basis, str] | None:
    if entity.parked:
        return Maneuver.STAY, entity.basis, "a parked vehicle stays"
    if entity.kind in ANIMALS and entity not in draft.causing(HazardKind.CROSSING_ANIMAL):
        return Maneuver.STAY, entity.basis, "an animal of which no more is said stands there"
    if entity.kind in ON_FOOT:
        reason = "nothing else is said: somebody on foot crosses"
        return Maneuver.CROSS, entity.basis, reason
    if junction.kind is JunctionKind.STRAIGHT:
        reason = "on a straight road, or one without a junction, one drives straight on"
        return Maneuver.STRAIGHT, entity.told.get("moves", Basis()), reason
    if junction.kind is JunctionKind.ROUNDABOUT:
        return None
    told = entity.told
    underway = told.get("moves") or (entity.heading_basis if entity.bound else None)
    through = told.get("through") if entity.ego or entity.claimed else None
    stays = "moves" not in told and entity.sets_off < 0 and not entity.pulls_out
    held = (told.get("held") or (entity.stands if entity.ego else None)) if stays else None
    if "stays_put" not in told and any(token.low == "green" for token in draft.tokens):
        held = None  # "stands at a red light", and it turns green
    if entity.ego and held is not None and held is entity.stands:
        return Maneuver.STAY, held, "nothing says that it goes on"
    for words, why in (
        (_turned_across(entity, draft), "its way is crossed"),
        (_has_the_way(entity, draft), "it has the way"),
        (underway if entity.heading is not None else None, "it keeps its heading"),
        (through, "it drives through"),
        (_oncoming(entity, draft), "it comes on"),
        (told.get("waits") if held is None else None, "it waits for the light"),
    ):
        if words is not None:
            return Maneuver.STRAIGHT, words, f"{why}: nothing says that it turns"
    return (Maneuver.STAY, held, "nothing says that it goes on") if held is not None else None


def _has_the_way(entity: Entity, draft: Draft) -> Basis | None:
    """``pulls out of a driveway in front of a bus``: the bus keeps to its road."""
    if "access" not in draft.implied or not entity.moving_vehicle:
        return None
    for danger in draft.dangers:
        met = [e for e in draft.entities if e.moving_vehicle and e not in danger.by]
        alone = entity.ego or met == [entity]
        suffers = entity in danger.to or (not danger.to and alone)
        along = suffers and entity not in danger.by
        if danger.kind in _OUT_OF_THE_ACCESS and along:
            return danger.basis
    return None


def _turned_across(entity: Entity, draft: Draft) -> Basis | None:
    """``turns left across the path of the van``: the van goes straight on."""
    ego = entity.ego and "ego" in entity.named_by
    lefts = [d for d in draft.dangers if {Maneuver.LEFT} in [e.maneuvers for e in d.by]]
    kinds = {HazardKind.FAILURE_TO_YIELD: lefts, HazardKind.UNPROTECTED_LEFT_TURN: draft.dangers}
    turns = (d for d in draft.dangers if d in kinds.get(d.kind, []))
    met = (d for d in turns if (entity in d.to or (not d.to and ego)) and entity not in d.by)
    return next((d.basis for d in met), None)


def _oncoming(entity: Entity, draft: Draft) -> Basis | None:
    """``yields to oncoming traffic``: who is called oncoming keeps coming."""
    called = not entity.ego and "opposite" in entity.dirs
    seen = [p.basis for p in draft.placements_of(entity) if p.approaches == {Approach.OPPOSITE}]
    return seen[0] if called and seen else None


def _ways_left(entity: Entity) -> set[Maneuver]:
    """The ways over a junction that are not ruled out; empty where nothing is said."""
    if not entity.excluded & _OVER_A_JUNCTION or not entity.is_vehicle:
        return set()
    return set(_OVER_A_JUNCTION - entity.excluded)


def some_of(
    draft: Draft, happenings: Happenings, kind: JunctionKind, proofs: Proofs
) -> tuple[Group, ...]:
    """What some of several alike do; they themselves are left free.

    On a plain road nobody has ways to choose from.
    """
    found: list[Group] = []
    for members in _alike(draft, happenings) if kind is not JunctionKind.STRAIGHT else []:
        told = [e for e in members if e.maneuvers]
        if len(members) < 2 or not told or not all(e.some for e in told):
            continue
        ways = Counter(frozenset(e.maneuvers) for e in told)
        if max(ways.values()) == len(members):
            continue  # all of them
        words = {frozenset(e.maneuvers): e.maneuver_basis or e.basis for e in told}
        for entity in members:
            entity.maneuvers, entity.maneuver_basis = set(), None
            entity.told.pop("waits", None)
        names = tuple(e.name for e in members)
        for maneuvers, number in ways.items():
            proofs.add(f"groups.{len(found)}", words[maneuvers])
            found.append(Group(members=names, number=number, maneuvers=maneuvers))
    return tuple(found)


def _alike(draft: Draft, happenings: Happenings) -> list[list[Entity]]:
    """Those who came up together and of whom nothing else is said that tells them apart."""
    apart = {id(e) for p in draft.placements for e in (p.entity, p.reference)}
    apart |= {id(e) for d in draft.dangers for e in (*d.by, *d.to)}
    apart |= {id(a.entity) for a in happenings.acts}
    apart |= {id(e) for s in happenings.spacings for e in (s.entity, s.reference)}
    apart |= {id(e) for e in (happenings.ending.between if happenings.ending else ())}
    classes: dict[tuple[object, ...], list[Entity]] = {}
    for entity in draft.entities:
        if id(entity) not in apart:
            classes.setdefault(_signature(entity), []).append(entity)
    return list(classes.values())


def _signature(entity: Entity) -> tuple[object, ...]:
    """All that tells one from another beside the way that it takes."""
    basis: Basis = entity.basis
    sets = (entity.approaches, entity.entries, entity.labels, entity.excluded)
    return (
        entity.kind, basis.i, basis.j, entity.parked, entity.heading, entity.speed,
        entity.stands, entity.beside, entity.told.get("circulates"), entity.crosses,
        entity.start_lane, entity.light,
        *(frozenset(s) for s in sets),
    )  # fmt: skip

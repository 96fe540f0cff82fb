"""Chooses the ego where the text does not name it: who is tested, met, seen or endangered."""

from scegen.scenario.roadway import Strip
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver, ParticipantKind
from scegen.understanding.draft import Danger, Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list

_ALONG = frozenset({Approach.AHEAD, Approach.BEHIND, Approach.OPPOSITE})
_SIDES = frozenset({Approach.LEFT, Approach.RIGHT})
_SIDEWAYS = _ALONG | _SIDES
"""A single vehicle "from the left" is seen by somebody; of two, each may see the other."""
_ENDANGERS = frozenset({HazardKind.CUT_IN, HazardKind.HARD_BRAKING, HazardKind.STOPPING,
                        HazardKind.ONCOMING_LANE, HazardKind.REVERSING,
                        HazardKind.OVERTAKING})  # fmt: skip
"""What one vehicle does to another, which a text need not name."""
_TO_ITSELF = frozenset({HazardKind.LOSS_OF_CONTROL, HazardKind.SWERVING, HazardKind.OBSTACLE})
_TWO = 2
_PARTIES = ("insured", "claimant")
"""Whose case a report tells."""


def choose_ego(draft: Draft, *, crossing: bool) -> tuple[Entity, Basis]:
    """The ego with the reason for the choice; adds one if nobody that is named can be it."""
    named = draft.ego
    if named is not None and "speaks" in named.named_by and not named.is_vehicle:
        _look_on(draft, named)
    elif named is not None:
        _put_in_a_bay(draft, named)
        words = named.basis.i is not None
        return named, Basis(named.basis.i, named.basis.j) if words else named.basis
    vehicles = [e for e in draft.entities if e.moving_vehicle]
    movers = [e for e in vehicles if not e.stays]
    if not movers and crossing and len(draft.entities) == len(vehicles) > 1:
        movers = vehicles  # "two cars stand at a crossroads": nobody else is there
    about = _about(vehicles, draft)
    if about is not None:
        about[0].ego = True
        return about
    roles = word_list("targets") | {"adversary"}
    hiding = draft.causing(HazardKind.OCCLUSION)
    movers = [e for e in movers if roles.isdisjoint(e.labels | e.named_by) and e not in hiding]
    motor = [e for e in movers if e.kind is not ParticipantKind.BICYCLE]
    crossers = draft.causing(HazardKind.CROSSING_CYCLIST)
    candidates = motor or [e for e in movers if e not in crossers]
    if not candidates:
        return _added(draft, "the text names no moving vehicle; a car is added as the ego")
    last = next((e for e in candidates if draft.only(e, Approach.BEHIND)), None)
    if last is not None and any(draft.only(e, Approach.AHEAD) for e in vehicles):
        last.ego = True
        return last, Basis(reason="the text names no ego; this vehicle follows the other")
    afoot = [e for e in draft.entities if not e.is_vehicle]
    alone = len(candidates) == 1 == len(movers) and not afoot
    whence = [p.approaches for e in candidates for p in draft.placements_of(e) if not p.reference]
    alike = whence == [whence[0]] * len(movers) if whence and not afoot else False
    alike = alike and (len(movers) != _TWO or whence[0] != _SIDES)  # they cross each other
    sides = _SIDEWAYS if alone or alike else _ALONG  # "three cars come from the left"
    exposed = bool(afoot) or len(candidates) < len(movers)
    met = exposed and len(candidates) == 1 and _met(draft, candidates[0])
    sides = sides | {Approach.ADJACENT} if len(candidates) == 1 == len(movers) else sides
    sides = frozenset() if met else sides  # "a car comes from behind": behind the jogger
    if all(_seen(draft, e, sides) for e in candidates):
        reason = "positions are given as seen from a vehicle that is not named; a car is added"
        return _added(draft, reason)
    all_cut_in = not crossing and _all_cut_in(draft, movers)
    if all_cut_in or (alone and _endangers_unnamed(draft, crossing=crossing)):
        return _added(draft, "whoever moves endangers another; a car is added as the ego")
    chosen, reason = _designate(draft, candidates)
    chosen.ego = True
    pair = len(afoot) == len(candidates) == len(movers) == 1
    if pair and all(p.reference for p in draft.placements_of(afoot[0])):
        for placement in draft.placements_of(chosen):
            facing = Approach.OPPOSITE in placement.approaches  # "an approaching taxi": to nobody
            if placement.reference is None and not facing:
                placement.reference = afoot[0]
    return chosen, Basis(reason=f"the text names no ego; {reason}")


def _put_in_a_bay(draft: Draft, ego: Entity) -> None:
    """``parked on the right, it pulls out``: out of a bay; one that does not stays there."""
    stood = ego.was_parked or (ego.parked_basis if ego.parked else None)
    stood = stood or (ego.stands if ego.strip is not None else None)
    ego.parked = False
    if stood is None:
        return
    if not (ego.pulls_out or ego.sets_off >= 0):
        ego.maneuvers, ego.maneuver_basis = {Maneuver.STAY}, stood
    kerb, i, j = {Approach(draft.kerb)}, stood.i or 0, stood.j or 0
    sides = [p.basis for p in draft.placements_of(ego) if p.approaches == kerb]
    ends = [(min(i, b.i or 0), max(j, b.j or 0)) for b in sides if b.i is not None]
    ego.strip = ego.strip or (Strip.PARKING, Basis(*ends[0]) if ends else stood)


def _endangers_unnamed(draft: Draft, *, crossing: bool) -> bool:
    """``a van comes the wrong way``, ``a taxi brakes hard``: a danger to whom nobody names.

    So is one to whom a measure is told: ``a van pulls out with a TTC of 2 s``.
    """
    measured = any(t.low in word_list("to_another") for t in draft.tokens)
    if measured and draft.dangers and len(draft.entities) == 1:
        return True
    caused = set() if crossing else {d.kind for d in draft.dangers}
    first, *rest = draft.entities
    known = first.labels or draft.tokens[first.basis.i or 0].low == "the"  # "the car stops"
    return not (rest or known) and bool(caused & _ENDANGERS) and not caused & _TO_ITSELF


def _all_cut_in(draft: Draft, movers: list[Entity]) -> bool:
    """``2 s after cutting in, the van brakes``: in front of somebody who is not named."""
    cut_in = [d for d in draft.dangers if d.kind is HazardKind.CUT_IN]
    return not any(d.to for d in cut_in) and all(any(e in d.by for d in cut_in) for e in movers)


def _look_on(draft: Draft, teller: Entity) -> None:
    """Who tells it on foot is no ego; what is seen is seen from there."""
    teller.ego = False
    draft.placements = [p for p in draft.placements if p.entity is not teller or p.reference]
    for placement in draft.placements:
        if placement.reference is None:
            placement.reference = teller


def _about(vehicles: list[Entity], draft: Draft) -> tuple[Entity, Basis] | None:
    """Whom a text without an ego is about: its first word, the party whose case it tells, V1."""
    told = next((e for e in vehicles if _told_of(e, draft)), None)
    if told is not None:
        return told, Basis(reason="the text names no ego; it is about this vehicle")
    party = next((e for name in _PARTIES for e in vehicles if name in e.labels), None)
    if party is not None:
        return party, Basis(reason="the text names no ego; it tells this party's case")
    numbered = [e for e in vehicles if e.numbered and not _seen(draft, e, _SIDES)]
    if numbered:
        first = min(numbered, key=lambda e: sorted(e.labels))
        return first, Basis(reason="the text names no ego; this vehicle has the first number")
    return None


def _told_of(entity: Entity, draft: Draft) -> bool:
    """``Vehicle is turning left at …``: the one that a text without articles begins with."""
    i, j = entity.basis.i, entity.basis.j
    first = draft.tokens[0].low if draft.tokens else ""
    ahead = draft.only(entity, Approach.AHEAD)  # "Vehicle in front turns …"
    return i == 0 and j == 1 and first in word_list("bare") and not ahead


def _added(draft: Draft, reason: str) -> tuple[Entity, Basis]:
    ego = draft.add(ParticipantKind.CAR, Basis(reason=reason))
    ego.ego = True
    return ego, Basis(reason=reason)


def _met(draft: Draft, entity: Entity) -> bool:
    """``a pedestrian … and an approaching car``: it comes towards the one who is no car."""
    named = {t.low for t in draft.tokens[entity.basis.i or 0 : entity.basis.j or 0]}
    comes = draft.only(entity, Approach.OPPOSITE) and "approaching" in named
    return comes or draft.only(entity, Approach.BEHIND)


def _seen(draft: Draft, entity: Entity, seen: frozenset[Approach]) -> bool:
    """``the car ahead``, ``an oncoming van``: there is somebody from whom it is seen."""
    after = [t.low for t in draft.tokens[entity.basis.j or 0 :][:1]]
    told = [p.approaches for p in draft.placements_of(entity) if p.reference is None]
    lane = entity.start_lane or entity.by_ramp
    beside = {Approach.ADJACENT} in told and lane is None  # "in the next lane"
    ahead = entity.basis.j is not None and after == ["ahead"]
    led = [p.reference for p in draft.placements_of(entity) if p.approaches == {Approach.AHEAD}]
    ahead |= any(e and draft.only(e, Approach.AHEAD) for e in led)  # beyond the car ahead
    first = draft.entities[0]  # "the car ahead overtakes a truck": somebody else sees both
    new = draft.tokens[entity.basis.i or 0].low in word_list("introducing")
    ahead |= new and entity is not first and first.is_vehicle and draft.only(first, Approach.AHEAD)
    return (
        ahead
        or (beside and Approach.ADJACENT in seen)
        or any(approaches <= seen - {Approach.ADJACENT} for approaches in told)
    )


def _designate(draft: Draft, candidates: list[Entity]) -> tuple[Entity, str]:
    placed = [p.entity for p in draft.placements if p.reference is None]
    led = [e for e in candidates if not draft.only(e, Approach.AHEAD)]
    free = [e for e in candidates if e not in placed] or led or candidates
    facing = next((e for d in draft.dangers if (e := _facing_entry(d, free)) is not None), None)
    if facing is not None:
        return facing, "this vehicle comes towards the one that turns left"
    sufferers, causers = draft.suffering(), draft.causing()
    for entity in (e for e in free if e in sufferers):
        return entity, "this vehicle suffers a hazard"
    for entity in (e for e in free if causers and e not in causers):
        return entity, "this is the first vehicle that causes no hazard"
    return free[0], "this is the first vehicle"


def _facing_entry(danger: Danger, candidates: list[Entity]) -> Entity | None:
    """Who enters opposite the one that turns left, where the text fixes the arms."""
    if danger.kind is not HazardKind.UNPROTECTED_LEFT_TURN or len(danger.by) != 1:
        return None
    arms = 1 + max((arm for e in (*danger.by, *candidates) for arm in e.entries), default=0)
    opposite = {(arm + arms // 2) % arms for arm in danger.by[0].entries}
    facing = (e for e in candidates if e.entries == opposite and e not in danger.by)
    return next(facing, None) if opposite and not arms % 2 else None

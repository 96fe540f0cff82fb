"""Restates every position as seen from the ego; what is said of one place goes together."""

from collections.abc import Collection, Iterator

from scegen.scenario.control import controlled_arms
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import (
    Approach,
    Control,
    CrossedArm,
    HazardKind,
    JunctionKind,
    Maneuver,
)
from scegen.understanding.draft import Draft, Placement
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.semantics.lanes import INVERSE
from scegen.understanding.words.tokens import low_at

_COMPASS = ("north", "east", "south", "west")
_SEEN = {1: Approach.LEFT, 2: Approach.OPPOSITE, 3: Approach.RIGHT}
"""Quarter turns clockwise from the ego's heading to the other's -> where the other comes from."""
_FRAME = {Approach.LEFT: "east", Approach.RIGHT: "west", Approach.OPPOSITE: "south"}
"""Headings of those who come from a side, for an observer who looks north."""
_SEEN_BACK = frozenset({Approach.AHEAD, Approach.BEHIND, Approach.OPPOSITE, Approach.ADJACENT})
_ASIDE = frozenset({Approach.LEFT, Approach.RIGHT})
_ALONG = frozenset({Approach.AHEAD, Approach.BEHIND})
Placed = tuple[Entity, Entity, set[Approach], Basis]
"""Who is where, seen from whom, by which words."""


def relative_to(ego: str, other: str) -> set[Approach]:
    """Where one comes from, by the compass headings of both; empty for the same heading."""
    quarters = (_COMPASS.index(other) - _COMPASS.index(ego)) % 4
    return {_SEEN[quarters]} if quarters in _SEEN else set()


def settle_positions(draft: Draft, ego: Entity) -> list[Placed]:
    """Fills in ``approaches`` of everybody; returns the relations between others."""
    own = _own_side(draft, ego)
    relations: list[Placed] = []
    for placement in draft.placements:
        entity, reference, approaches = _oriented(placement, ego)
        if entity is ego:
            continue
        if reference is ego:
            if own is not None and placement.reference is None:
                approaches = _reframed(own, approaches)
            allow(entity, _in_a_lane_there(placement, approaches, ego, draft), placement.basis)
        elif any(
            Maneuver.CROSS in one.maneuvers and other.still
            for one, other in ((entity, reference), (reference, entity))
        ):
            continue  # "hidden behind two parked cars": no place along the road
        elif not any(r[0] is entity and r[1] is reference for r in relations):
            relations.append((entity, reference, set(approaches), placement.basis))
    _against_the_ego(draft, ego)
    if ego.heading is not None:
        for entity in draft.entities:
            if entity is ego or entity.heading is None or entity.approaches:
                continue
            basis, seen = entity.heading_basis or Basis(), ego.heading_basis or Basis()
            basis = basis.because(f"headed {entity.heading}, the ego {ego.heading}")
            entity.comes_from(relative_to(ego.heading, entity.heading), basis)
            entity.by_heading = seen.because(f"the ego is headed {ego.heading}")
    for entity, basis in unplaced_dangers(draft, ego, {HazardKind.CUT_IN}):
        if entity.moving_vehicle:
            reason = "who cuts in comes from the next lane"
            entity.comes_from({Approach.ADJACENT}, basis.because(reason))
    _in_the_next_number(draft, ego)
    _in_file(relations)
    ego.approaches = set()
    return relations


def _in_a_lane_there(
    placement: Placement, seen: set[Approach], ego: Entity, draft: Draft
) -> set[Approach]:
    """``behind us on the left``, ``ahead on the right``: in the lane there, not out of a road.

    Where the ego turns that depends on whither.
    """
    entity, words = placement.entity, placement.basis
    turns = bool(ego.maneuvers & {Maneuver.LEFT, Maneuver.RIGHT})
    crosses = Maneuver.CROSS in entity.maneuvers
    stands = entity.still or "from_kerb" in draft.implied
    if turns or crosses or stands or not entity.is_vehicle or not set() < seen < _ASIDE:
        return seen
    told = (p for p in draft.placements_of(entity) if p.reference in (None, ego))
    said = (p for p in told if p.approaches <= _ALONG and not p.basis.reason)
    along = any(_side_by_side(p.basis, words) for p in said)
    if words.i is None or not along or draft.tokens[words.i].low == "from":
        return seen
    entity.beside = entity.beside or (next(iter(seen)).value, words)
    return {Approach.ADJACENT}


def _side_by_side(first: Basis, second: Basis) -> bool:
    """Whether one stands right behind the other, but for a comma."""
    pairs = ((first.j, second.i), (second.j, first.i))
    return any(a is not None and b is not None and 0 <= b - a <= 1 for a, b in pairs)


def _in_file(relations: list[Placed]) -> None:
    """``a van from the left, and a bus behind it``: both come from there."""
    turned = [(b, a, {INVERSE[x] for x in s}, basis) for a, b, s, basis in relations]
    for entity, leader, approaches, basis in (*relations, *turned):
        seen = leader.approaches
        across = seen <= {Approach.LEFT, Approach.RIGHT, Approach.OPPOSITE}
        along = len(seen) == 1 and approaches in ({Approach.AHEAD}, {Approach.BEHIND})
        free = not entity.approaches and entity.heading is None and not entity.entries
        if along and (across or seen == approaches) and free and not entity.parked:
            entity.comes_from(set(seen), basis.because("it is in one file with another"))


def _against_the_ego(draft: Draft, ego: Entity) -> None:
    """``while the ego comes from the opposite direction``, ``I'm right alongside``: of whom?"""
    placed = draft.placements_of(ego)
    said = [p for p in placed if p.reference is None and p.approaches <= _SEEN_BACK]
    others = [e for e in draft.entities if e.moving_vehicle and e is not ego]
    towards = bool(said) and said[0].approaches == {Approach.OPPOSITE}
    for other in others if said and (towards or len(others) == 1) else []:
        if not other.approaches and other.heading is None:
            allow(other, {INVERSE[a] for a in said[0].approaches}, said[0].basis)


def unplaced_dangers(
    draft: Draft, ego: Entity, kinds: Collection[HazardKind]
) -> Iterator[tuple[Entity, Basis]]:
    """Who endangers the ego in one of some ways and is nowhere yet, with the words for that."""
    for danger in draft.dangers:
        if danger.kind in kinds and (not danger.to or ego in danger.to):
            for entity in danger.by:
                if entity is not ego and not entity.approaches:
                    yield entity, danger.basis


def _in_the_next_number(draft: Draft, ego: Entity) -> None:
    """Who drives in lane 1 is beside who drives in lane 2."""
    for entity in [e for e in draft.entities if e.lane is not None and e is not ego]:
        away = abs((entity.lane or 0) - ego.lane) if ego.lane is not None else None
        if entity.start_lane is not None and away == 1 and entity.approaches <= _ALONG:
            allow(entity, {Approach.ADJACENT}, entity.start_lane[1])


def _own_side(draft: Draft, ego: Entity) -> Approach | None:
    """The side that an observer gives for the ego itself ("one car from the left, …")."""
    own = next(_from_aside(draft, ego), None)
    others = [e for e in draft.entities if own and e.moving_vehicle and e is not ego]
    met = [(p.basis, p.approaches) for e in others for p in _from_aside(draft, e)]
    alike = any(own and (own.basis == i or own.approaches == sides) for i, sides in met)
    if "ego" in ego.named_by and (alike or not met):
        return None  # what is said of its place is not a view from outside
    said = next((p.approaches for p in draft.placements_of(ego) if p.reference is None), set())
    return next(iter(said)) if len(said) == 1 and said <= _FRAME.keys() else None


def _from_aside(draft: Draft, entity: Entity) -> Iterator[Placement]:
    """``the ego comes from the left, a van from the right``: as somebody else sees both."""
    for placement in draft.placements_of(entity):
        aside = placement.reference is None and placement.approaches < _ASIDE
        ends = low_at(draft.tokens, placement.basis.j or 0) in {",", ".", ";", "and", ""}
        if aside and ends and draft.tokens[placement.basis.i or 0].low == "from":
            yield placement


def _reframed(own: Approach, approaches: set[Approach]) -> set[Approach]:
    if len(approaches) != 1:
        return approaches
    side = next(iter(approaches))
    return relative_to(_FRAME[own], _FRAME[side]) if side in _FRAME else approaches


def _oriented(placement: Placement, ego: Entity) -> tuple[Entity, Entity, set[Approach]]:
    """A position of the ego seen from another is a position of the other seen from the ego."""
    reference = placement.reference or ego
    if placement.entity is ego and reference is not ego:
        return reference, ego, {INVERSE[a] for a in placement.approaches}
    return placement.entity, reference, set(placement.approaches)


def next_to(entity: Entity) -> bool:
    """Whether it is in a lane beside, on either side."""
    return {Approach.ADJACENT} <= entity.approaches <= {Approach.ADJACENT, *_ASIDE}


def allow(entity: Entity, approaches: set[Approach], basis: Basis) -> None:
    """Two statements narrow each other down; where they differ, both are allowed."""
    if approaches and approaches <= _ALONG and next_to(entity):
        entity.in_next_lane = entity.in_next_lane or (approaches, basis)
        return
    if not approaches or (approaches == {Approach.AHEAD} and entity.approaches - approaches):
        return  # "… from the left and stops in front of the ego": where it gets to
    if approaches == {Approach.ADJACENT} and entity.approaches and entity.approaches <= _ALONG:
        entity.in_next_lane = entity.approaches, entity.approach_basis or entity.basis
        entity.approaches = set()  # "30 m ahead in the next lane": beside, so far ahead
    common = entity.approaches & approaches
    either = entity.approaches | approaches
    if Approach.OPPOSITE in either:
        either -= _ALONG  # "of two oncoming cars the one behind"
    if not entity.is_vehicle and either & set(_SIDES.values()):
        either -= {Approach.BEHIND}  # "walks behind it, coming from the left"
    beside = common == {Approach.ADJACENT} and either - common < _ASIDE
    entity.approaches = either if beside else common or either  # "on its right, side by side"
    if entity.approach_basis is None or common:
        entity.approach_basis = basis


_SIDES = {Maneuver.LEFT: Approach.LEFT, Maneuver.RIGHT: Approach.RIGHT}
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
        side = side if along else INVERSE[side]
        said = [p.approaches & _ASIDE for p in draft.placements_of(entity)]
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

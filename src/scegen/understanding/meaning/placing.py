"""Where participants come from: "from the right", "in the next lane", "northbound"."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, Maneuver, ParticipantKind
from scegen.understanding.chunks import Event, Mention, Place, Prep, Thing
from scegen.understanding.clauses.bearing import from_the_wrong_lane
from scegen.understanding.clauses.located import landmark
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.meaning.approaches import (
    BY_DIR,
    INVERSE,
    SIDES,
    adjective_approaches,
    place_approaches,
)
from scegen.understanding.meaning.lanes_named import Lanes, within_the_lane
from scegen.understanding.words.quantities import ends_a_quantity
from scegen.understanding.words.terms import Term

_STEADY = frozenset(
    {"move", "stop", "brake", "hard_brake", "slow", "locate", "wait", "park", "accelerate",
     "approach", "speed", "tailgate", "follow", "light", "hide", "appear", "walk",
     "unknown", "inert", "pass", "lose_control", "swerve", "reverse", "crawl", "merge", "unpark"}
)  # fmt: skip
_ROADS = frozenset({"road", "highway", "lane"})
_SIDEWAYS = frozenset({"lane_change", "merge", "cut_in"})


def _between_lanes(approaches: frozenset[Approach], event: Event | None) -> frozenset[Approach]:
    """``changes into the lane from the other side``: out of another lane."""
    sideways = event is not None and event.name in _SIDEWAYS
    return BY_DIR["adjacent"] if sideways and approaches == BY_DIR["lateral"] else approaches


def _differ(place: Place) -> bool:
    """``different arms``, ``each from a different direction``."""
    apart = any(m.value in {"different", "another"} for m in place.mods)
    return apart and place.kind in {"leg", "direction", "side", "road"}


def _in_line(prep: Prep, entities: list[Entity], event: Event) -> bool:
    """``enters the roundabout behind a car``: as it follows that one, which is not in it yet."""
    after = event.name in {"enter", "turn"} and prep.value == "behind"
    led = prep.target.entities if isinstance(prep.target, Mention) else []
    comes = any("opposite" in e.dirs for e in (*entities, *led))
    return after and not comes and not any(e.circulates for e in led)


def _of_which(place: Place, event: Event) -> Place:
    """``the right side of the road``, ``the middle of the ego's lane``: of what it is a part."""
    whole = next((p.target for p in event.pps if p.word.i == place.j), None)
    return whole if isinstance(whole, Place) else place


def _at_its_side(prep: Prep, event: Event | None) -> bool:
    """``drives to the right of the bus``: where somebody is, not where it goes."""
    side = prep.target
    sided = isinstance(side, Place) and side.kind == "side" and bool(set(side.dirs) & set(SIDES))
    owned = side is not None and not isinstance(side, Event) and side.owner is not None
    steady = event is not None and event.name in _STEADY
    return prep.value == "to" and sided and owned and steady


def _ends_there(event: Event, prep: Prep) -> bool:
    """``swerves behind the ego``, ``sweeps left in front of the bus``: where it gets to."""
    turns = any(d.value in SIDES for d in event.dirs)
    onto = event.name == "swerve" and any(p.value == "into" for p in event.pps)
    onto = onto or any(
        p.value in {"to", "into"} and isinstance(p.target, Place) and p.target.kind == "lane"
        for p in event.pps
    )
    afoot = isinstance(prep.target, Mention) and not any(e.is_vehicle for e in prep.target.entities)
    backs_out = event.name == "reverse" and any(
        isinstance(p.target, Place) and p.target.kind in {"parking", "access"} for p in event.pps
    )
    if prep.value == "ahead" and backs_out:
        return True  # "a car comes the other way; the ego goes in front of it"
    if afoot and (event.name, prep.value) == ("stop", "ahead"):
        return True  # "stops 1 m in front of her"
    return (event.name, prep.value) == ("swerve", "behind") or (
        (turns or onto) and prep.value == "ahead"
    )


_BOTH = ("left", "right")


def _same_way(prep: Prep) -> bool:
    """``in the same direction as the ego``."""
    place = prep.target
    return isinstance(place, Place) and place.kind == "direction" and "same" in place.dirs


def _past_the_parked(approaches: set[Approach], entities: list[Entity]) -> bool:
    """``1 m beside the parked cars``: they have no lane of their own."""
    return approaches == {Approach.ADJACENT} and any(e.parked for e in entities)


def _steadily(event: Event | None, prep: Prep) -> bool:
    """Whether a lane that is named is the one where somebody is at first."""
    return event is None or event.name in _STEADY or prep.value == "from"


_ACROSS = {"left": Approach.RIGHT, "right": Approach.LEFT}
_FROM = {"north": "south", "south": "north", "east": "west", "west": "east"}


class Placer:
    """Applies words of place to participants."""

    def __init__(self, draft: Draft) -> None:
        self._draft = draft
        self._lanes = Lanes(draft)

    def adjectives(self, mention: Mention) -> None:
        """``the oncoming car``, ``a northbound truck``."""
        approaches = adjective_approaches(mention.dirs)
        term = mention.mod("dir") or mention.head
        coming = term is not None and self._draft.tokens[term.i].low == "next"
        for entity in mention.entities if not coming else []:  # "the next car ahead"
            if approaches and term is not None:
                self._draft.place(entity, None, set(approaches), Basis(term.i, term.j))
        for mod in mention.mods:
            for entity in mention.entities if "bound" in mod.data else []:
                entity.bound = True
            if mod.cat == "compass":
                self._head(mention.entities, mod.value, Basis(mod.i, mod.j))

    def phrase(self, prep: Prep, entities: list[Entity], event: Event | None) -> None:
        """One prepositional phrase that belongs to some participants.

        Args:
            prep: the phrase.
            entities: whom it places.
            event: the event that it belongs to; None if it follows a noun.
        """
        if prep.word.cat == "locus":
            self._locus(prep, entities, event)
            return
        target = prep.target
        word = self._draft.tokens[prep.word.i].low
        # "gets past a bus via the oncoming lane"
        through = event is None and word in word_list("by_way_of")
        if not isinstance(target, Place) or through:
            return
        if not self._on_both_sides(prep, target, entities):
            self._at_place(prep, target, entities, event)

    def _at_place(
        self, prep: Prep, target: Place, entities: list[Entity], event: Event | None
    ) -> None:
        basis = Basis(prep.word.i, target.j)
        compass = target.mod("compass")
        if compass is not None and prep.value in {"from", "to", "in"}:
            bound = "bound" in compass.data  # "from southbound Elm Street"
            back = prep.value == "from" and not bound
            heading = _FROM[compass.value] if back else compass.value
            own = event is not None and any(m.cat == "compass" for m in event.mods)
            if (bound and prep.value == "to") or (own and prep.value == "in"):
                return  # "turned onto eastbound Elm Street": where it gets to
            self._head(entities, heading, basis)
            return
        if _at_its_side(prep, event):
            self._beside(target, entities, basis)
            return
        if event is not None and (event.name, prep.value, target.kind) == ("cross", "to", "side"):
            whence = {_ACROSS[d] for d in target.dirs if d in _ACROSS}  # "crosses to the left"
            vehicles = any(e.moving_vehicle and e.kind != ParticipantKind.BICYCLE for e in entities)
            for entity in entities if len(whence) == 1 and not vehicles else []:
                self._draft.place(entity, None, whence, basis)
            return
        if prep.value not in {"from", "in"} and not (prep.value == "to" and event is None):
            return
        self._lanes.drives_in(entities, target, steady=_steadily(event, prep), basis=basis)
        if target.kind == "ramp" and prep.value == "from":
            self._from_a_ramp(entities, basis)
        elif not within_the_lane(prep, entities, self._draft.tokens):
            self._seen_at(prep, target, entities, event, basis)

    def _from_a_ramp(self, entities: list[Entity], basis: Basis) -> None:
        """``merges from the on-ramp``: from a lane on the side of the kerb."""
        for entity in entities:
            entity.by_ramp = entity.by_ramp or basis
            entity.beside = entity.beside or (self._draft.kerb, basis)
            self._draft.place(entity, None, {Approach.ADJACENT}, basis)

    def _seen_at(
        self,
        prep: Prep,
        target: Place,
        entities: list[Entity],
        event: Event | None,
        basis: Basis,
    ) -> None:
        facing = target.kind in {"direction", "side", "road"} and "opposite" in target.dirs
        allowed = _STEADY | ({"cross", "turn"} if facing else {"cross"})
        steady = event is None or event.name in allowed
        if (prep.value == "in" and not steady) or from_the_wrong_lane(prep, event):
            return
        if len(entities) > 1 and _differ(target):
            self._apart(entities, basis)
            return
        word = self._draft.tokens[prep.word.i].low
        at_edge = self._draft.tokens[target.j - 1].low in {"edge", "kerb", "curb"}
        if at_edge and prep.value == "from" and ends_a_quantity(self._draft.tokens, prep.word.i):
            return  # "0.5 m from the right edge"
        edge = self._draft.tokens[target.j - 1].low == "edge" or self._of_the_road(target, event)
        edge = edge and prep.value == "in"
        parks = event is not None and event.name == "park"
        edge = edge and not parks
        entities = [e for e in entities if not (edge and e.is_vehicle)]  # within its lane
        approaches = place_approaches(target, word if word in word_list("past") else prep.value)
        approaches = _between_lanes(approaches, event)
        if not approaches:
            of = target if event is None else _of_which(target, event)
            self._in_the_egos_lane(prep, of, entities, basis)
            return
        plural = target.head is not None and target.head.form == "s"
        plural = plural or any(m.form == "s" for m in target.mods if m.cat == "dir")
        if approaches == BY_DIR["opposite"] and plural and len(entities) > 1:
            for entity in entities:
                entity.opposed |= {e.index for e in entities} - {entity.index}
                entity.approach_basis = basis
            return
        over = [t.low for t in self._draft.tokens[target.j : target.j + 2]]
        if prep.value == "from" and over[:1] == ["to"] and over[-1] in SIDES:
            basis = Basis(basis.i, target.j + 2)  # "from left to right"
        seen_by = target.beside or target.owner
        reference = seen_by.entities[0] if seen_by and seen_by.entities else None
        wrong = target.kind == "lane" and approaches == BY_DIR["opposite"]
        for entity in entities:
            if wrong and Maneuver.OVERTAKE in entity.maneuvers:
                continue  # who overtakes is in the oncoming lane, but does not come from there
            self._lanes.beside(entity, target, reference, approaches, basis)
            kerb = target.kind in {"sidewalk", "shoulder"} and prep.value == "from"
            entity.pulls_out = entity.pulls_out or kerb
            self._draft.place(entity, reference, set(approaches), basis)

    def _of_the_road(self, side: Place, event: Event | None) -> bool:
        """``rides on the right side of the road``: in the lane that is there."""
        moves = event is not None and event.name in {"move", "walk"}
        whole = _of_which(side, event) if event is not None else side
        road = whole is not side and whole.kind in _ROADS
        return moves and road and self._draft.kerb in side.dirs

    def _in_the_egos_lane(
        self, prep: Prep, lane: Place, entities: list[Entity], basis: Basis
    ) -> None:
        """``a truck drives in the ego's lane``: one of those before or behind it."""
        owner = lane.owner.entities if lane.owner is not None else []
        ours = any(m.value == "first_person" for m in lane.mods) or any(e.ego for e in owner)
        within = self._draft.tokens[prep.word.i].low in {"in", "on"} and lane.kind == "lane"
        for entity in entities if within and ours else []:
            entity.in_egos_lane = entity.in_egos_lane or basis

    def _on_both_sides(self, prep: Prep, side: Place, entities: list[Entity]) -> bool:
        """``two vans on either side of the bus``: abreast of it."""
        both = any(m.cat == "quant" for m in side.mods) or (
            self._draft.tokens[side.i - 1].low == "either"
        )
        owner = side.owner.entities[0] if side.owner and side.owner.entities else None
        if not both or side.dirs or prep.value != "in" or side.kind != "side":
            return False
        basis = Basis(prep.word.i, side.j)
        movers = [e for e in entities if e.moving_vehicle and not e.ego]
        for entity in movers:
            self._draft.place(entity, owner, {Approach.ADJACENT}, basis)
        if len(movers) == len(_BOTH) and (owner is None or owner.ego):
            for entity, value in zip(movers, _BOTH, strict=True):
                entity.beside = entity.beside or (value, basis)
        return bool(movers)

    def _beside(self, side: Place, entities: list[Entity], basis: Basis) -> None:
        """``drives to the right of the bus``: abreast; people stand on that side."""
        owner = side.owner.entities[0] if side.owner and side.owner.entities else None
        for entity in entities:
            sides = {SIDES[d] for d in side.dirs if d in SIDES}
            abreast = entity.moving_vehicle and entity.kind is not ParticipantKind.BICYCLE
            where = {Approach.ADJACENT} if abreast else sides
            self._draft.place(entity, owner, where, basis)
            if abreast and len(sides) == 1 and (owner is None or owner.ego):
                entity.beside = entity.beside or (next(iter(sides)).value, basis)

    def _apart(self, entities: list[Entity], basis: Basis) -> None:
        """``from different arms``: no two come from the same one."""
        elsewhere = {Approach.LEFT, Approach.RIGHT, Approach.OPPOSITE}
        for number, entity in enumerate(entities):
            for other in entities[:number]:
                self._draft.place(entity, other, elsewhere, basis)

    def _locus(self, prep: Prep, entities: list[Entity], event: Event | None) -> None:
        target = landmark(prep.target)
        basis = Basis(prep.word.i, target.j if isinstance(target, Mention) else prep.word.j)
        if isinstance(target, Thing | Place):
            return
        if prep.value == "between":
            by = target.entities if isinstance(target, Mention) else []
            for entity in entities if len(by) == 1 and by[0].ego else []:
                self._draft.place(entity, None, {Approach.ADJACENT}, basis)
            return  # "between the ego and the kerb"
        follows = event is not None and _in_line(prep, entities, event)
        if event is not None and event.name not in _STEADY and prep.outer != "from" and not follows:
            self._behind_the_ego(prep, entities, basis)
            return
        out_of = prep.outer == "from" and isinstance(target, Mention)
        if event is not None and target and (out_of or _ends_there(event, prep)):
            return
        comes = target is None and (prep.outer, prep.value) == ("from", "ahead")
        approaches = {Approach.OPPOSITE if comes else Approach(prep.value)}
        reference: Entity | None = None
        if isinstance(target, Mention):
            if not target.entities:
                return
            reference = target.entities[0]
        if _past_the_parked(approaches, [*entities, *([reference] if reference else [])]):
            return
        same = event is not None and any(_same_way(p) for p in event.pps)
        for entity in entities:
            if entity.is_vehicle or prep.value != "ahead" or same:
                self._draft.place(entity, reference, approaches, basis)
        further = target.entities[1:] if isinstance(target, Mention) else []
        for other in further if len(entities) == 1 else []:
            self._draft.place(other, entities[0], {INVERSE[a] for a in approaches}, basis)

    def _behind_the_ego(self, prep: Prep, entities: list[Entity], basis: Basis) -> None:
        """``crosses behind the ego``: on foot, that is where they are."""
        ego = prep.target if prep.value == "behind" else None
        seen = isinstance(ego, Mention) and any(e.ego for e in ego.entities)
        for entity in entities if seen else []:
            if not entity.is_vehicle:
                self._draft.place(entity, None, {Approach.BEHIND}, basis)

    def _head(self, entities: list[Entity], heading: str, basis: Basis) -> None:
        for entity in entities:
            if entity.heading is None:
                entity.heading, entity.heading_basis = heading, basis

    def heading(self, term: Term, entities: list[Entity]) -> None:
        """``travelling northbound``."""
        self._head(entities, term.value, Basis(term.i, term.j))
        for entity in entities if "bound" in term.data else []:
            entity.bound = True

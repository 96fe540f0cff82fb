"""Where a phrase of place puts those of whom it is said: seen from the ego, in a lane, headed."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

from scegen.scenario.vocabulary import Approach, ParticipantKind
from scegen.understanding.chunks import Mention, NounPhrase, Place, Prep
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.lanes import (
    BY_DIR,
    FACING,
    INVERSE,
    SIDES,
    place_approaches,
)
from scegen.understanding.words.quantities import ends_a_quantity


@dataclass(frozen=True, slots=True)
class Site:
    """A noun with the preposition that governs it, or an object or subject (no preposition)."""

    noun: NounPhrase
    prep: Prep | None
    basis: Basis
    clause: Clause
    context: Context

    @property
    def place(self) -> Place:
        """The noun, of a row that asks for a place.

        Raises:
            TypeError: if it is none.
        """
        if not isinstance(self.noun, Place):
            msg = f"no place: {type(self.noun).__name__}"
            raise TypeError(msg)
        return self.noun

    @property
    def value(self) -> str:
        """Which preposition."""
        return self.prep.value if self.prep is not None else ""

    @property
    def word(self) -> str:
        """The preposition as it stands in the text."""
        return self.context.tokens[self.prep.word.i].low if self.prep is not None else ""


Put: TypeAlias = Callable[[Entity, Site], None]


def seen(entity: Entity, site: Site) -> None:
    """``from the right``, ``in the next lane``, ``on the pavement``."""
    place, draft = site.place, site.context.draft
    approaches = place_approaches(
        place, site.word if site.word in word_list("past") else site.value
    )
    if not approaches:
        _in_the_egos_lane(entity, site)
        return
    plural = any(
        t.form == "s" for t in (place.head, *place.mods) if t and t.cat in {"place", "dir", "leg"}
    )
    together = [e for e in site.clause.actors if e is not entity]
    if approaches == BY_DIR["opposite"] and plural and together:  # "from opposite directions"
        draft.place(entity, site.clause.actors[0], set(approaches), site.basis)
        return
    if approaches == BY_DIR["same"]:
        approaches = _where_another_came_from(entity, site) or approaches
    reference = _first(place.beside or place.owner)
    sides = [d for d in place.dirs if d in SIDES]  # "in the right adjacent lane of the ego"
    named = _lane_of(place) or next(iter(sides), None)
    if named in SIDES and approaches == BY_DIR["adjacent"] and (not reference or reference.ego):
        entity.beside = entity.beside or (named, site.basis)
    kerb = place.kind in {"sidewalk", "shoulder"} and site.value == "from"
    entity.pulls_out = entity.pulls_out or kerb
    draft.place(entity, reference, set(approaches), _to_the_other_side(site))


def _where_another_came_from(entity: Entity, site: Site) -> frozenset[Approach]:
    """``a dog runs across from the left and a child follows from the same side``."""
    told = site.context.draft.placements
    before = [p for p in told if p.entity is not entity and p.reference is None]
    there = before[-1].approaches & {Approach.OPPOSITE, *SIDES.values()} if before else set()
    if there:  # its noun was read before what the other does
        told[:] = [p for p in told if p.entity is not entity or p.approaches != BY_DIR["same"]]
    return frozenset(there)


def _first(whose: Mention | None) -> Entity | None:
    return next(iter(whose.entities), None) if whose is not None else None


def _to_the_other_side(site: Site) -> Basis:
    """``from left to right``."""
    j, basis = site.place.j, site.basis
    over = site.context.lows(j, j + 2)
    across = site.value == "from" and over[:1] == ["to"] and over[-1] in SIDES
    return Basis(basis.i, j + 2) if across else basis


def _in_the_egos_lane(entity: Entity, site: Site) -> None:
    """``a truck drives in the ego's lane``: one of those before or behind it."""
    lane = site.place
    ours = lane.has("possessive", "first_person") or any(e.ego for e in lane.owned_by)
    if ours and lane.kind == "lane" and site.word in {"in", "on", "of"}:
        entity.in_egos_lane = entity.in_egos_lane or site.basis


def _lane_of(place: Place) -> str | None:
    """Which lane of several a phrase names: ``left``, ``middle``, ``fast``."""
    if place.kind != "lane" or place.owner is not None:
        return None
    data = place.head.data if place.head is not None else {}
    return data.get("rank") or next((d for d in place.dirs if d in SIDES), None)


def _start_lane(entity: Entity, site: Site) -> None:
    """``drives in the middle lane``, ``cuts in from the left lane``: where it is at first."""
    place = site.place
    # "in the lane to its right": which one that is, depends on whose it is
    after = place.head is not None and any(m.i > place.head.i for m in place.mods)
    named = _lane_of(place) if "adjacent" not in place.dirs and not after else None
    if named is None:
        return
    site.context.draft.implied.setdefault("lanes", site.basis.because(SEVERAL))
    if entity.start_lane is None and not entity.parked:
        entity.start_lane = named, site.basis


def _by_a_ramp(entity: Entity, site: Site) -> None:
    """``merges from the on-ramp``: from a lane on the side of the kerb."""
    draft = site.context.draft
    entity.by_ramp = entity.by_ramp or site.basis
    entity.beside = entity.beside or (draft.kerb, site.basis)
    draft.place(entity, None, {Approach.ADJACENT}, site.basis)


def _headed(entity: Entity, site: Site) -> None:
    """``on westbound Elm Street``, ``from the north``."""
    term = site.place.mod("compass")
    if term is None or entity.heading is not None:
        return
    back = site.value == "from" and "bound" not in term.data
    entity.heading = FACING[term.value] if back else term.value
    entity.heading_basis = site.basis


def _crossing_to(entity: Entity, site: Site) -> None:
    """``crosses to the left``: from the right."""
    whence = {INVERSE[SIDES[d]] for d in site.place.dirs if d in SIDES}
    if len(whence) == 1:
        site.context.draft.place(entity, None, whence, site.basis)


def settle_far_sides(draft: Draft) -> None:
    """Not the side where somebody else is said to be, else not the one of the ego's kerb."""
    crossing = [e for e in draft.entities if e.far_side is not None]
    others = [p for p in draft.placements if not p.reference and p.entity not in crossing]
    named = {a for p in others for a in p.approaches if len(p.approaches) == 1}
    named &= set(SIDES.values())
    near = named.pop() if len(named) == 1 else SIDES[draft.kerb]
    for entity in crossing:
        draft.place(entity, None, {INVERSE[near]}, entity.far_side or Basis())


def _abreast(entity: Entity, site: Site) -> None:
    """``drives to the right of the bus``: beside it; people stand on that side."""
    owner = _first(site.place.owner)
    sides = {SIDES[d] for d in site.place.dirs if d in SIDES}
    abreast = entity.moving_vehicle and entity.kind is not ParticipantKind.BICYCLE
    where = {Approach.ADJACENT} if abreast else sides
    site.context.draft.place(entity, owner, where, site.basis)
    if abreast and len(sides) == 1 and (owner is None or owner.ego):
        entity.beside = entity.beside or (next(iter(sides)).value, site.basis)


def _either_side(entity: Entity, site: Site) -> None:
    """``two vans on either side of the bus``: abreast of it, one on each; parked ones in turn."""
    owner = _first(site.place.owner)
    if entity.parked or entity.was_parked is not None:
        kerb = site.context.draft.kerb  # who pulls out is the first, beside the lane
        sides = sorted(SIDES, key=lambda side: side != kerb)
        which = sides[site.clause.actors.index(entity) % len(sides)]
        site.context.draft.place(entity, None, {SIDES[which]}, site.basis)
        return
    site.context.draft.place(entity, owner, {Approach.ADJACENT}, site.basis)
    pair = [e for e in site.clause.drivers if not e.ego]
    if len(pair) == len(SIDES) and (owner is None or owner.ego):
        side = list(SIDES)[pair.index(entity)]
        entity.beside = entity.beside or (side, site.basis)


def _apart(entity: Entity, site: Site) -> None:
    """``from different arms``: no two come from the same one."""
    elsewhere = {Approach.LEFT, Approach.RIGHT, Approach.OPPOSITE}
    for other in site.clause.actors[: site.clause.actors.index(entity)]:
        site.context.draft.place(entity, other, elsewhere, site.basis)


SEVERAL = "one of several lanes is named"
SEEN: dict[str, Put] = {
    "seen": seen,
    "start_lane": _start_lane,
    "ramp": _by_a_ramp,
    "headed": _headed,
    "crossing_to": _crossing_to,
    "abreast": _abreast,
    # "from the other side": which one that is, the whole text tells
    "far_side": lambda entity, site: setattr(entity, "far_side", entity.far_side or site.basis),
    "either_side": _either_side,
    "apart": _apart,
    "egos_lane": _in_the_egos_lane,
}
"""Name -> what a phrase of place says of where somebody is seen, or headed."""


def _is_offset(phrase: Prep, clause: Clause, context: Context) -> bool:
    """``offset 0.5 m to the left``, ``the lane change of the lead to the left``: no place."""
    tokens, i, value, place = context.tokens, phrase.word.i, phrase.value, phrase.target
    if value == "to" and any(e.dirs & {"ahead", "behind"} for e in clause.actors):
        return True
    across = not word_list("counted_off").isdisjoint(context.lows(i - 1, i))
    number = ends_a_quantity(tokens, i - across)
    dimension = number.dimension if number is not None else ""
    if value == "from":  # "hit at 25 % from the left", "0.5 m from the right edge"
        edge = isinstance(place, Place) and tokens[place.j - 1].low in word_list("edges")
        return dimension == "percentage" or (bool(dimension) and edge)
    aside = dimension in {"length", "percentage"}
    aside = aside or not word_list("within_lane").isdisjoint(context.lows(i - 1, i))
    return value in {"to", "in"} and aside


FACTS = {
    "within_the_lane": lambda clause, c: any(_is_offset(p, clause, c) for p in clause.event.pps),
    "own_heading": lambda clause, _: any(m.cat == "compass" for m in clause.event.mods),
}
"""Words of conditions that ask what a phrase of place is."""

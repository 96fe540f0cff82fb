"""Lanes by name: "in the next lane to the left", "in the middle lane", "offset to the right"."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach
from scegen.understanding.chunks import Place, Prep
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.quantities import ends_a_quantity
from scegen.understanding.words.tokens import Token

_SIDE_REACH = 3
_SIDES = frozenset({"left", "right"})


class Lanes:
    """Notes in which lane somebody drives, and on which side of the ego that is."""

    def __init__(self, draft: Draft) -> None:
        self._draft = draft

    def beside(
        self,
        entity: Entity,
        lane: Place,
        reference: Entity | None,
        approaches: frozenset[Approach],
        basis: Basis,
    ) -> None:
        """``in the right lane``: to the right of the ego's, unless the ego drives there.

        Args:
            entity: who drives there.
            lane: the lane.
            reference: whose lane it is named by; None is the ego.
            approaches: where the lane lies.
            basis: its words.
        """
        named = _lane_of(lane) or self._side_after(lane)
        seen = reference is None or reference.ego
        if named in _SIDES and named is not None and seen and approaches == {Approach.ADJACENT}:
            entity.beside = entity.beside or (named, basis)

    def drives_in(self, entities: list[Entity], lane: Place, *, steady: bool, basis: Basis) -> None:
        """``drives in the middle lane``, ``cuts in from the left lane``: where it is at first.

        Args:
            entities: who drives there.
            lane: the lane.
            steady: it is where they are, not where they get to.
            basis: its words.
        """
        # "in the lane to its right": which one that is, depends on whose it is
        after = lane.head is not None and any(m.i > lane.head.i for m in lane.mods)
        named = _lane_of(lane) if "adjacent" not in lane.dirs and steady and not after else None
        for entity in entities if named is not None else []:
            implied = self._draft.lanes_implied
            reason = "one of several lanes is named"
            self._draft.lanes_implied = implied or Basis(basis.i, basis.j, reason)
            if entity.start_lane is None and named is not None and not entity.parked:
                entity.start_lane = (named, basis)

    def _side_after(self, lane: Place) -> str | None:
        """``in the next lane to the left``."""
        after = [t.low for t in self._draft.tokens[lane.j : lane.j + _SIDE_REACH]]
        opened = len(after) == _SIDE_REACH and after[0] in {"to", "on"}
        return after[2] if opened and "adjacent" in lane.dirs and after[2] in _SIDES else None


def within_the_lane(prep: Prep, entities: list[Entity], tokens: list[Token]) -> bool:
    """``offset 0.5 m to the left``, ``the lane change of the lead to the left``: no place.

    Args:
        prep: a phrase that names a side.
        entities: of whom it is said.
        tokens: the tokens of the text.
    """
    before = tokens[prep.word.i - 1].low if prep.word.i else ""
    if prep.value == "to" and any(e.dirs & {"ahead", "behind"} for e in entities):
        return True
    number = ends_a_quantity(tokens, prep.word.i)
    share = number is not None and number.dimension == "percentage"  # "hit at 25 % from the left"
    offset = (
        before in word_list("within_lane") or share or (number and number.dimension == "length")
    )
    return bool(offset) and (prep.value in {"to", "in"} or (share and prep.value == "from"))


def _lane_of(place: Place) -> str | None:
    """Which lane of several a phrase names: ``left``, ``middle``, ``fast``, ``2`` from inside."""
    if place.kind != "lane" or place.owner is not None:
        return None
    data = place.head.data if place.head is not None else {}
    if "number" in data:
        return str(data["number"])
    return data.get("rank") or next((d for d in place.dirs if d in {"left", "right"}), None)

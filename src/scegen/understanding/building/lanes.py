"""How many lanes the road has: as said, as is meant, or as somebody needs."""

from __future__ import annotations

from itertools import pairwise

from scegen.errors import InfeasibleError
from scegen.scenario.junction import MAX_LANES
from scegen.scenario.vocabulary import Approach, JunctionKind
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis
from scegen.understanding.lexicon import word_list
from scegen.understanding.road.lengthwise import Lengthwise
from scegen.understanding.road.surroundings import Surroundings

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

    Args:
        draft: participants and what they do, positions settled.
        around: what the text says about lanes.
        along: what it says about the road along its length.
        kind: the shape of the road.
        arms: how many arms it has.

    Raises:
        InfeasibleError: it names a lane beyond those that are built.
    """
    ring, plain = kind is JunctionKind.ROUNDABOUT, kind is JunctionKind.STRAIGHT
    implied = draft.lanes_implied
    adjacent = next((e for e in draft.entities if Approach.ADJACENT in e.approaches), None)
    if implied is None and adjacent is not None:
        basis = adjacent.approach_basis or adjacent.basis
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
    if ring and around.two_lane is not None:
        return (2,) * arms, 2, around.two_lane
    passing = draft.passing_implied
    if implied is None and passing is not None:
        if not ring and not _parted(along) and _against_oncoming(draft, around):
            reason = "who overtakes uses the oncoming lane"
            return (1,) * arms, None, passing.because(reason)
        implied = passing.because("overtaking needs a second lane")
    if implied is None and plain and around.two_lane is not None and not _parted(along):
        counted = around.two_lane
        return (1,) * arms, None, counted.because("two lanes, one each way")
    if implied is None and around.highway is not None:
        reason = "highways have two lanes per direction unless said otherwise"
        implied = around.highway.because(reason)
    lanes = [e.start_lane for e in draft.entities if e.start_lane is not None]
    named = [name for name, _ in lanes]
    if implied is None or not (ring or named or around.highway is not None):
        return (), None, None  # as many as it takes
    count = _MOST_LANES if "middle" in named or _middle_lane(draft) else _FEWEST_TO_NAME
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


def _parted(along: Lengthwise) -> bool:
    """Whether the words part the directions for sure."""
    return along.carriageway is not None and not along.presumed


def _against_oncoming(draft: Draft, around: Surroundings) -> bool:
    """Whether somebody overtakes on a road where others come towards them."""
    facing = any(Approach.OPPOSITE in e.approaches for e in draft.entities)
    return facing or (around.two_lane is not None and around.highway is None)

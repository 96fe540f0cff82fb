"""How long and how wide somebody or something is."""

from __future__ import annotations

from collections.abc import Sequence

from scegen.scenario.bodies import LENGTHS_M, WIDTHS_M
from scegen.scenario.things import SIZES_M
from scegen.understanding.amounts.sentences import Sentences
from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Thing
from scegen.understanding.draft import Draft, Entity
from scegen.understanding.frames import Measured
from scegen.understanding.happenings import Amount, Happenings, Item, exactly
from scegen.understanding.lexicon import word_list

SIZES = {"long": "length_m", "wide": "width_m"}
"""Role of a number -> field of a participant or an object."""
_LIMITS = {"length_m": LENGTHS_M, "width_m": WIDTHS_M}


def size_of(number: Measured, text: Sentences, found: Happenings, draft: Draft) -> bool:
    """Gives a number to the one whose size it is; whether there is one.

    Args:
        number: the number.
        text: the text with its clauses.
        found: what the text tells of.
        draft: where it is noted what is too small or too large to be built.
    """
    noun = named_beside(number, text)
    if noun is None:
        return False
    whose: Sequence[Entity | Item] = [i for i in found.items if i.basis.i == noun.i]
    limits = SIZES_M
    field = SIZES[number.frame.role]
    if isinstance(noun, Mention):
        whose, limits = noun.entities, _LIMITS[field]
    amount = exactly(number)
    if not limits[0] <= amount.value.low <= amount.value.high <= limits[1]:
        instead = f"nothing less than {limits[0]:g} m or more than {limits[1]:g} m is built so"
        draft.note(number.i, number.j, f"{instead} {number.frame.role}; left out")
        return True
    for each in whose:
        each.sizes.setdefault(field, amount)
    return bool(whose) and all(_same(each.sizes[field], amount) for each in whose)


def _same(one: Amount, other: Amount) -> bool:
    return one.value == other.value


def named_beside(number: Measured, text: Sentences) -> NounPhrase | None:
    """The noun in whose phrase a number stands ("a 12 m bus"), else which it follows.

    Of a noun and the place where that is said to be ("the truck in the left lane, which is 12 m
    long") it is the noun; but the lane may be so wide.
    """
    within = owns(number, text.chunks)
    if within is None and text.low(number.j + 1, number.j + 2) == " and ":
        within = _around(number.j + 2, text.chunks)  # "a 2.5 m wide and 12 m long bus"
    if within is not None:
        return within
    start, _ = text.bounds(number.i)
    for chunk in reversed([c for c in text.chunks if start <= c.i and c.j <= number.i]):
        if isinstance(chunk, Thing) and text.tokens[chunk.j - 1].low in word_list("extents"):
            if chunk.owner is not None:
                return chunk.owner
            continue  # "a van, length 6 m"
        if isinstance(chunk, Mention | Thing):
            return chunk if _has_a_size(chunk) else None
        lane = isinstance(chunk, Place) and (chunk.prep is None or number.frame.role == "wide")
        if isinstance(chunk, Event) or lane:
            return None
    return None


def owns(number: Measured, chunks: Sequence[Chunk]) -> NounPhrase | None:
    """``a 12 m bus``: somebody or something in whose phrase a number stands."""
    return _around(number.i, chunks)


def _around(i: int, chunks: Sequence[Chunk]) -> NounPhrase | None:
    phrases = [c for c in chunks if isinstance(c, Mention | Thing) and _has_a_size(c)]
    return next((p for p in phrases if p.head is not None and p.i <= i < p.head.i), None)


def _has_a_size(noun: Mention | Thing) -> bool:
    if isinstance(noun, Mention):
        return bool(noun.entities)
    return noun.head is not None and "thing" in noun.head.data

"""How long and how wide somebody or something is."""

from __future__ import annotations

from collections.abc import Sequence

from scegen.scenario.bodies import LENGTHS_M, WIDTHS_M
from scegen.scenario.things import SIZES_M
from scegen.understanding.amounts.figures import Figure, has_a_size
from scegen.understanding.chunks import Event, Mention, NounPhrase, Place, Thing
from scegen.understanding.entity import Entity
from scegen.understanding.happenings import Item
from scegen.understanding.lexicon import word_list

_LIMITS = {"length_m": LENGTHS_M, "width_m": WIDTHS_M}


def sized(figure: Figure, field: str) -> bool:
    """Gives a number to a field of the one whose size it is; whether there is one."""
    noun = _named_beside(figure)
    if noun is None:
        return False
    items = figure.text.found.items
    whose: Sequence[Entity | Item] = [i for i in items if i.basis.i == noun.i]
    limits = SIZES_M
    if isinstance(noun, Mention):
        whose, limits = noun.entities, _LIMITS[field]
    amount = figure.exactly
    if not limits[0] <= amount.value.low <= amount.value.high <= limits[1]:
        built = f"nothing less than {limits[0]:g} m or more than {limits[1]:g} m is built so"
        figure.note(f"{built} {figure.role}; left out")
        return True
    for each in whose:
        each.sizes.setdefault(field, amount)
    return bool(whose) and all(each.sizes[field].value == amount.value for each in whose)


def _named_beside(figure: Figure) -> NounPhrase | None:
    """The noun in whose phrase a number stands ("a 12 m bus"), else which it follows.

    Of a noun and the place where that is said to be ("the truck in the left lane, which is 12 m
    long") it is the noun; but the lane may be so wide.
    """
    within, text = figure.inside, figure.text
    if within is None and text.low(figure.j + 1, figure.j + 2) == " and ":
        within = figure.phrase_around(figure.j + 2)  # "a 2.5 m wide and 12 m long bus"
    if within is not None:
        return within
    before = [c for c in text.chunks if figure.start <= c.i and c.j <= figure.i]
    for chunk in reversed(before):
        if isinstance(chunk, Thing) and text.tokens[chunk.j - 1].low in word_list("extents"):
            if chunk.owner is not None:
                return chunk.owner
            continue  # "a van, length 6 m"
        if isinstance(chunk, Mention | Thing):
            return chunk if has_a_size(chunk) else None
        lane = isinstance(chunk, Place) and (chunk.prep is None or figure.role == "wide")
        if isinstance(chunk, Event) or lane:
            return None
    return None

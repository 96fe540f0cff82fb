"""Rows of numbers: which field one fills, by what it measures and the clause in which it stands."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import Any

from scegen.scenario.acts import FAR, LASTING, ActKind
from scegen.understanding.amounts.aside import off_its_lane
from scegen.understanding.amounts.doings import comes_to, fill, made, rests, until_the_next
from scegen.understanding.amounts.figures import Figure
from scegen.understanding.amounts.items import sized
from scegen.understanding.amounts.outcomes import impact
from scegen.understanding.amounts.placed import apart, at_rest, to_a_thing
from scegen.understanding.amounts.releasing import driven, sets_off
from scegen.understanding.amounts.speeds import held, relative
from scegen.understanding.amounts.timing import at_green, delayed, earlier
from scegen.understanding.semantics.context import Context
from scegen.understanding.semantics.rows import Families, read_rows

_KEYS = frozenset({"if", "also", "take", "fills", "of", "makes"})
TAKES: dict[str, Callable[[Figure], bool]] = {
    "held": held,
    "comes_to": comes_to,
    "relative": relative,
    "rests": rests,
    "until_the_next": until_the_next,
    "driven": driven,
    "earlier": earlier,
    "at_green": at_green,
    "delayed": delayed,
    "impact": impact,
    "length": lambda figure: sized(figure, "length_m"),
    "width": lambda figure: sized(figure, "width_m"),
    "sets_off": sets_off,
    "at_rest": at_rest,
    "to_a_thing": to_a_thing,
    "off_its_lane": off_its_lane,
    "apart": apart,
}
"""What gives a number its place, if there is one."""
_ACTS = {
    "along": frozenset({ActKind.BRAKE, ActKind.ACCELERATE, ActKind.STOP, ActKind.SET_OFF}),
    "aside": frozenset({ActKind.CHANGE_LANE, ActKind.SWERVE}),
    "lasting": LASTING,
    "far": FAR,
}


@dataclass(frozen=True, slots=True)
class Fills:
    """Gives a number to a field of an act: of some kinds, or of one that only this number tells."""

    field: str
    kinds: frozenset[ActKind]
    makes: ActKind | None

    def __call__(self, figure: Figure, _: Context) -> bool:
        """Whether there is such an act."""
        if self.makes is not None:
            return made(figure, self.makes, self.field)
        return fill(figure, self.field, self.kinds)


def _effects(row: dict[str, Any]) -> Iterable[Any]:
    if "take" in row:
        take = TAKES[row["take"]]
        yield lambda figure, _: take(figure)
    if "fills" in row:
        makes = ActKind(row["makes"]) if "makes" in row else None
        yield Fills(row["fills"], _ACTS[row.get("of", "along")], makes)


@lru_cache(maxsize=1)
def rows() -> Families:
    """All rows by what is measured, read once.

    Raises:
        KeyError: names the family, and what in it means nothing.
    """
    return read_rows("figures", effects=_effects, keys=_KEYS)


@cache
def says_how(role: str) -> bool:
    """Whether numbers that measure this say how something is done."""
    own = rows().rows.get(f"figures.{role}", ())
    return any(isinstance(effect, Fills) for row in own for effect in row.effects)


def place(figure: Figure) -> bool:
    """Gives a number its place; whether it has one."""
    context = figure.text.context
    for row in rows().asked(f"figures.{figure.role}", figure.event):
        if all(test(figure, context) for test in row.tests):
            taken = [effect(figure, context) for effect in row.effects]
            if any(taken) or not row.also:
                return any(taken)
    return False

"""Sizes that are said: of those who take part, and of things."""

from collections.abc import Callable, Iterator
from functools import partial

from scegen.claims.claim import Claim, ClaimKind, Judged, always
from scegen.claims.told import Told, amount, plain
from scegen.claims.view import View
from scegen.scenario.bodies import Body
from scegen.scenario.model import Interval

SAME_M = 0.05
Side = Callable[[Body], tuple[float, ...]]
"""The sides of a box that may be the one that is meant."""


def claims(told: Told) -> Iterator[Claim]:
    """Of everybody and everything whose length or width is said."""
    for person in told.people:
        group, what = "participants", person.id
        yield from _of(group, person.id, what, "long", person.length_m, lambda b: (b.length_m,))
        yield from _of(group, person.id, what, "wide", person.width_m, lambda b: (b.width_m,))
    for thing in told.functional.objects:
        group, what = "objects", thing.called or plain(thing.kind)
        # What lies across the road has its length there.
        sides: Side = lambda b: (b.length_m, b.width_m)  # noqa: E731
        yield from _of(group, thing.id, what, "long", thing.length_m, sides)
        yield from _of(group, thing.id, what, "wide", thing.width_m, lambda b: (b.width_m,))


def _of(
    group: str, name: str, what: str, how: str, said: Interval | None, side: Side
) -> Iterator[Claim]:
    if said is None:
        return
    part = "length_m" if how == "long" else "width_m"
    statement, field = f"{what} is {amount(said)} m {how}", f"{group}.{name}.{part}"
    test, kind = partial(_sized, name, said, side), ClaimKind.BODY
    yield Claim(f"size.{name}.{part}", kind, statement, field, "m", test, SAME_M, fixed=True)


def _sized(name: str, said: Interval, side: Side, view: View) -> Judged:
    """How far outside of what is said the nearest of its sides is."""
    if name not in view.index:
        return always(view, holds=False)
    nearest = min(side(view.body(name)), key=lambda m: abs(said.clip(m) - m))
    return always(view, holds=abs(said.clip(nearest) - nearest) <= SAME_M, measured=nearest)

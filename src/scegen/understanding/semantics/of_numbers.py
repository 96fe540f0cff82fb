"""What rows may ask of a number: how much it is, and which words stand around it."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.patterns import listed

Test: TypeAlias = Callable[[Clause, Context], bool]


def _least(rest: str) -> Test:
    name, value = rest.split()
    return lambda clause, _: any(
        v is not None and v.low >= float(value) for v in clause.amounts.get(name, ())
    )


def _below(rest: str) -> Test:
    name, value = rest.split()
    return lambda clause, _: (
        name in clause.amounts
        and all(v is not None and v.high < float(value) for v in clause.amounts[name])
    )


def _opens(rest: str) -> Test:
    return lambda clause, _: clause.around is not None and clause.around.opens(rest)


def _closes(rest: str) -> Test:
    return lambda clause, _: clause.around is not None and clause.around.closes(rest)


def _led(rest: str) -> Test:
    words = listed(rest)
    return lambda clause, _: clause.around is not None and any(map(clause.around.preceded, words))


def _opened(rest: str) -> Test:
    words = listed(rest)
    return lambda clause, _: clause.opened in words


KINDS: dict[str, Callable[[str], Test]] = {
    "least": _least, "below": _below,
    "opens": _opens, "closes": _closes, "led": _led, "opened": _opened,
}  # fmt: skip
"""Words of conditions about numbers."""

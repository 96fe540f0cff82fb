"""What a predicate returns, and how its conditions make one margin."""

from collections.abc import Callable
from dataclasses import dataclass

from scegen.claims.hazards.thresholds import Threshold
from scegen.claims.series import clipped, filled
from scegen.claims.view import View
from scegen.motion.batch.arrays import Floats

NEVER = -3.0
"""The relative margin of what is undefined."""
_EXACTLY = 1e-6
"""Who is said to do as much as the threshold does it, whatever rounding leaves of that."""


@dataclass(frozen=True)
class Part:
    """One condition over all candidates, (c,): values, threshold, when; margin > 0: it holds.

    ``margin`` and ``value`` are in ``unit``; ``relative`` margins can be compared.
    """

    name: str
    value: Floats
    threshold: float
    unit: str
    margin: Floats
    relative: Floats
    time_s: Floats


Test = Callable[[View, str, str], list[Part]]
"""Conditions between who causes and who suffers; alone, both are the same."""
Order = Callable[[View, str, str, Floats], Part]
"""Where who causes it is, seen from who suffers it, when it does so (c,)."""


@dataclass(frozen=True, slots=True)
class Predicate:
    """How a danger is recognised.

    ``pairwise``: between two; else one alone does it. ``conflict``: those two come near each
    other by it, so that a target is about them. ``order``: a condition that no amounts replace.
    ``before_nobody``: who is alone on the road does it before a sign or light that says stop, too.
    """

    test: Test
    pairwise: bool = True
    conflict: bool = True
    before_nobody: bool = False
    order: Order | None = None


def at_least(
    name: str, value: Floats, limit: Threshold, time_s: Floats, threshold: float | None = None
) -> Part:
    """The value must reach the threshold."""
    bound = limit.value if threshold is None else threshold
    return part(name, value, bound, limit, value - bound + _EXACTLY, time_s)


def at_most(
    name: str, value: Floats, limit: Threshold, time_s: Floats, threshold: float | None = None
) -> Part:
    """The value must not exceed the threshold."""
    bound = limit.value if threshold is None else threshold
    return part(name, value, bound, limit, bound - value + _EXACTLY, time_s)


def part(
    name: str, value: Floats, bound: float, limit: Threshold, margin: Floats, time_s: Floats
) -> Part:
    """A condition by its margin, whose scale is the limit's."""
    relative = clipped(filled(margin / limit.scale, NEVER), NEVER, -NEVER)
    return Part(name, value, bound, limit.unit, margin, relative, time_s)

"""Right of way for the solver: facts about signs, lights and views, and who gives way to whom."""

# mypy does not follow clorm: it knows neither the base class nor its argument ``name``.
# mypy: allow-subclassing-any, disable-error-code=call-arg

from __future__ import annotations

from clorm import ConstantStr, Predicate

# --- facts ----------------------------------------------------------------------------------


class Minor(Predicate):
    """A yield or stop sign stands at an arm."""

    arm: int


class Phase(Predicate):
    """An arm has green in a phase."""

    arm: int
    number: int


class Oncoming(Predicate):
    """The traffic of two arms comes towards each other."""

    arm: int
    other: int


class RightOf(Predicate, name="right_of"):
    """Who enters at ``arm`` has the traffic of ``other`` to its right."""

    arm: int
    other: int


class EntryFirst(Predicate, name="entry_first"):
    """A roundabout where those who come in go before those on the ring."""


class Crosswalk(Predicate):
    """Who crosses this arm does so on a marked crosswalk."""

    arm: int


class CurvesMeet(Predicate, name="curves_meet"):
    """As drawn, two ways cross although their ends do not interleave."""

    entry: int
    exit: int
    other_entry: int
    other_exit: int


# --- answers --------------------------------------------------------------------------------


class GivesWay(Predicate, name="gives_way"):
    """The driver on ``entry`` -> ``exit`` gives way to the other one."""

    entry: int
    exit: int
    other_entry: int
    other_exit: int
    rule: ConstantStr


class Open(Predicate):
    """Of two drivers nobody can say in advance who gives way."""

    entry: int
    exit: int
    other_entry: int
    other_exit: int
    rule: ConstantStr


class LetsCross(Predicate, name="lets_cross"):
    """A driver gives way to one who crosses an arm."""

    entry: int
    exit: int
    arm: int
    rule: ConstantStr


class WaitsToCross(Predicate, name="waits_to_cross"):
    """One who crosses an arm gives way to a driver."""

    entry: int
    exit: int
    arm: int
    rule: ConstantStr


class OpenToCross(Predicate, name="open_to_cross"):
    """Between a driver and one who crosses, the light decides."""

    entry: int
    exit: int
    arm: int
    rule: ConstantStr


class Stuck(Predicate):
    """A way that a deadlock may hold up."""

    way: tuple[int, int]

"""What the solver tells: atoms of answer sets, and assumptions about them, as clorm types."""

# mypy does not follow clorm: it knows neither the base class nor its argument ``name``.
# mypy: allow-subclassing-any, disable-error-code=call-arg

from __future__ import annotations

from clorm import ConstantStr, Predicate


class Enters(Predicate):
    """A vehicle enters at an arm."""

    id: ConstantStr
    arm: int


class Drive(Predicate):
    """A vehicle's entry, symbolic move and manner."""

    id: ConstantStr
    entry: int
    move: int
    manner: ConstantStr


class Two(Predicate):
    """The drives of two vehicles, each (entry, move, manner)."""

    id: ConstantStr
    way: tuple[int, int, ConstantStr]
    other: ConstantStr
    other_way: tuple[int, int, ConstantStr]


class GoesOnFoot(Predicate, name="goes_on_foot"):
    """The arm and the way of one who is not in the traffic."""

    id: ConstantStr
    arm: int
    way: ConstantStr


class Place(Predicate):
    """A vehicle is ahead of, behind or beside another on the same arm."""

    id: ConstantStr
    reference: ConstantStr
    word: ConstantStr


class Wanted(Predicate):
    """What the words allow a vehicle that enters at ``entry``."""

    id: ConstantStr
    entry: int
    move: int
    manner: ConstantStr


class Needs(Predicate):
    """What a hazard demands of the one who causes it and the one who suffers it."""

    statement: int
    by: ConstantStr
    to: ConstantStr
    what: ConstantStr


class TurnsAcross(Predicate, name="turns_across"):
    """A hazard by which a vehicle turns left."""

    statement: int
    id: ConstantStr


class Dependent(Predicate):
    """A vehicle whose move matters to others."""

    id: ConstantStr


class Meets(Predicate):
    """How the ways ``entry`` -> ``exit`` and ``other_entry`` -> ``other_exit`` meet."""

    entry: int
    exit: int
    other_entry: int
    other_exit: int
    kind: ConstantStr


class Holds(Predicate):
    """A statement is kept."""

    statement: int

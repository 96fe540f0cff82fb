"""How facts for the solver are declared: a line each, as clorm types."""

from __future__ import annotations

from clorm import ConstantStr, Predicate

WORD = ConstantStr
WAYS = {"entry": int, "exit": int, "other_entry": int, "other_exit": int}
"""The ways of two: from which arm to which."""


def fact(name: str, means: str, **fields: type) -> type[Predicate]:
    """The type of the facts ``name(…)`` with these fields, in this order, and what they say."""
    made: type[Predicate] = type(Predicate)(
        name,
        (Predicate,),
        {"__module__": __name__, "__doc__": means, "__annotations__": fields},
        name=name,
    )
    return made

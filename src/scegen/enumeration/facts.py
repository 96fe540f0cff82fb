"""How facts for the solver are declared: by their signature, as clorm types."""

from clorm import ConstantStr, Predicate

_TYPES = {"int": int, "word": ConstantStr, "way": tuple[int, int]}


def fact(signature: str, means: str) -> type[Predicate]:
    """The type of the facts of a signature such as ``enters(id: word, arm: int)``."""
    name, _, fields = signature.removesuffix(")").partition("(")
    told = (field.split(": ") for field in fields.split(", ") if field)
    annotations = {field: _TYPES[kind] for field, kind in told}
    made: type[Predicate] = type(Predicate)(
        name,
        (Predicate,),
        {"__module__": __name__, "__doc__": means, "__annotations__": annotations},
        name=name,
    )
    return made

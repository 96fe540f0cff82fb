"""What is wrong with a file, in words: which field, what was found there, what may stand there."""

from collections.abc import Callable, Mapping
from datetime import date
from difflib import get_close_matches

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from scegen.scenario.locating import Models, models_at, of_likely_members, place_of, shortened
from scegen.scenario.model import Interval

MOST_SHOWN = 3

_PATTERNS = {
    r"^[a-z][a-z0-9_]*$": "a name of small letters, digits and _, such as car_1",
    r"^[a-z0-9-]+$": "a name of small letters, digits and -, such as ego-left",
    r"^[A-Za-z0-9_-]+$": "a name of letters, digits, _ and -",
    r"^static\.prop\.[a-z0-9_]+$": "a name such as static.prop.box01",
}
_WHOLE, _NUMBER, _TEXT, _LIST = "a whole number", "a number", "text", "a list"
_NEEDED = {
    "int_type": _WHOLE,
    "int_parsing": _WHOLE,
    "int_from_float": _WHOLE,
    "int_parsing_size": "a whole number of fewer digits",
    "float_type": _NUMBER,
    "float_parsing": _NUMBER,
    "finite_number": "a number that is finite",
    "string_type": _TEXT,
    "string_sub_type": _TEXT,
    "string_unicode": "text without broken characters",
    "bool_type": "true or false",
    "bool_parsing": "true or false",
    "none_required": "nothing (null)",
    "list_type": _LIST,
    "tuple_type": _LIST,
    "set_type": _LIST,
    "frozen_set_type": _LIST,
    "iterable_type": _LIST,
    "set_item_not_hashable": "a single value",
    "invalid_key": "text as the name of every field",
}
"""What is needed where the kind of value is wrong."""
_BOUNDS = {
    "greater_than": ("more than", "gt"),
    "greater_than_equal": ("at least", "ge"),
    "less_than": ("less than", "lt"),
    "less_than_equal": ("at most", "le"),
}
_LENGTHS = {
    "too_short": ("at least", "min_length", ""),
    "too_long": ("at most", "max_length", ""),
    "string_too_short": ("at least", "min_length", " characters"),
    "string_too_long": ("at most", "max_length", " characters"),
}


def in_words(error: ValidationError, cls: type[BaseModel], data: object) -> str:
    """The first complaints about a file's data, and how many more there are.

    Args:
        error: why ``data`` is no ``cls``.
        cls: the model of the whole file.
        data: what the file holds.
    """
    said: dict[str, None] = {}
    for item in of_likely_members(error.errors(include_url=False), data):
        models = models_at(cls, item["loc"])
        place = place_of(item, data)
        sentence = _sentence(item, models)
        said[f"{place}: {sentence}" if place else sentence] = None
    shown = list(said)[:MOST_SHOWN]
    more = len(said) - len(shown)
    return "; ".join(shown) + (f"; and {more} more" if more else "")


def outside(error: ValidationError) -> str:
    """The first number that lies outside what a file may hold, of one that was never written."""
    item = error.errors(include_url=False)[0]
    return ": ".join([str(part) for part in item["loc"][-1:]] + [_sentence(item, ())])


def _sentence(item: ErrorDetails, models: Models) -> str:
    kind, context, value = item["type"], item.get("ctx", {}), found(item["input"])
    if kind in _SENTENCES:
        return _SENTENCES[kind](item, models)
    if kind in _NEEDED:
        return f"{value} is not {_NEEDED[kind]}"
    if kind in _BOUNDS:
        word, name = _BOUNDS[kind]
        return f"{value} is not allowed: it must be {word} {context[name]:g}"
    if kind in _LENGTHS:
        word, name, things = _LENGTHS[kind]
        return f"needs {word} {context[name]}{things}, has {_length(item['input'])}"
    return f"{value} cannot be used"


def _unknown_field(item: ErrorDetails, models: Models) -> str:
    known = [name for model in models for name in model.model_fields]
    return f"there is no such field{_nearest(item['loc'][-1], known)}"


def _unknown_word(item: ErrorDetails, _: Models) -> str:
    words = item.get("ctx", {})["expected"].replace(" or ", ", ").replace("'", "").split(", ")
    nearest = _nearest(item["input"], words, say_all=True)
    return f"{found(item['input'])} is not one of the words allowed{nearest}"


def _unknown_tag(item: ErrorDetails, _: Models) -> str:
    context = item.get("ctx", {})
    words = context["expected_tags"].replace("'", "").split(", ")
    tag = item["input"].get("type", context["tag"])
    return f"{found(tag)} is not one of the types allowed{_nearest(tag, words, say_all=True)}"


def _no_tag(item: ErrorDetails, _: Models) -> str:
    return f"lacks its {item.get('ctx', {})['discriminator']}".replace("'", "")


def _no_model(item: ErrorDetails, models: Models) -> str:
    if models == (Interval,):
        return f"{found(item['input'])} is neither a number nor a range with low and high"
    fields = ", ".join(models[0].model_fields) if len(models) == 1 else ""
    return f"{found(item['input'])} stands where fields are needed" + (fields and f": {fields}")


def _no_name(item: ErrorDetails, _: Models) -> str:
    pattern = item.get("ctx", {})["pattern"]
    return f"{found(item['input'])} is not {_PATTERNS.get(pattern, 'spelt as it must be')}"


def _own_words(item: ErrorDetails, _: Models) -> str:
    """What the model itself says."""
    return str(item.get("ctx", {})["error"])


_SENTENCES: Mapping[str, Callable[[ErrorDetails, Models], str]] = {
    "missing": lambda _, __: "is missing",
    "extra_forbidden": _unknown_field,
    "enum": _unknown_word,
    "literal_error": _unknown_word,
    "union_tag_invalid": _unknown_tag,
    "union_tag_not_found": _no_tag,
    "model_type": _no_model,
    "model_attributes_type": _no_model,
    "dict_type": _no_model,
    "string_pattern_mismatch": _no_name,
    "value_error": _own_words,
}


def found(value: object) -> str:
    """A value as a file shows it, shortened."""
    if value is None:
        return "nothing (null)"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Mapping):
        return "a group of fields"
    if isinstance(value, list | tuple | set | frozenset):
        return "a list"
    if isinstance(value, bytes):
        return "binary data"
    text = shortened(value.isoformat() if isinstance(value, date) else str(value))
    return text if isinstance(value, int | float) else repr(text)


def _length(value: object) -> int:
    return len(value) if isinstance(value, str | list | tuple | Mapping) else 0


def _nearest(value: object, words: list[str], *, say_all: bool = False) -> str:
    """What may have been meant; if nothing is near, all that there is."""
    near = get_close_matches(str(value), words, n=1)
    if near:
        return f"; did you mean {near[0]}?"
    return f": {', '.join(words)}" if say_all or words else ""

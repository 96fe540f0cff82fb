"""Where in a file a complaint belongs: the path, the models there, and who meant it."""

from collections.abc import Iterator
from typing import Any, get_args

from pydantic import BaseModel
from pydantic_core import ErrorDetails

Path = tuple[int | str, ...]
Models = tuple[type[BaseModel], ...]
_LONGEST = 40
_NOWHERE = object()


def shortened(text: str) -> str:
    """In one short line that can be written anywhere."""
    text = " ".join(text.encode(errors="replace").decode().split())
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"


def place_of(item: ErrorDetails, data: object) -> str:
    """The path to what is wrong; whoever has an id is called by it, tags of unions are left out."""
    place, value = "", data
    for number, part in enumerate(item["loc"], start=1):
        inside = _step(value, part)
        if inside is not _NOWHERE:
            name = inside.get("id") if isinstance(inside, dict) else None
            if isinstance(value, dict) or isinstance(name, str):
                place += f".{shortened(str(part if isinstance(value, dict) else name))}"
            else:
                place += f"[{part}]"
            value = inside
        elif number == len(item["loc"]) and item["type"] == "missing":
            place += f".{part}"
    return place.removeprefix(".")


def of_likely_members(items: list[ErrorDetails], data: object) -> Iterator[ErrorDetails]:
    """Of a union without tags every member complains: only the one that was meant is heard."""
    unions: dict[Path, dict[str, list[ErrorDetails]]] = {}
    for item in items:
        place = _member_tag(item["loc"], data)
        if place is None:
            if not (item["type"] == "too_short" and _complains_inside(items, item["loc"])):
                yield item
            continue
        members = unions.setdefault(item["loc"][:place], {})
        members.setdefault(str(item["loc"][place]), []).append(item)
    for path, members in unions.items():
        type_ = _type_of(path, data)
        meant = next((name for name in members if name.lower() == type_), None)
        if type_ is None or meant is not None:
            yield from members[meant or min(members, key=lambda name: len(members[name]))]
            continue
        context = {"tag": type_, "expected_tags": ", ".join(members).lower()}
        yield {
            "type": "union_tag_invalid",
            "loc": (*path, "type"),
            "msg": "",
            "input": {"type": type_},
            "ctx": context,
        }


def _complains_inside(items: list[ErrorDetails], path: Path) -> bool:
    """Whether what is in a list is wrong, so that it was not counted."""
    return any(item["loc"][: len(path)] == path != item["loc"] for item in items)


def _member_tag(path: Path, data: object) -> int | None:
    """Where a path names a class, the member of a union, instead of going further into data."""
    value = data
    for number, part in enumerate(path):
        inside = _step(value, part)
        if inside is _NOWHERE and isinstance(part, str) and part[:1].isupper():
            return number
        value = value if inside is _NOWHERE else inside
    return None


def _type_of(path: Path, data: object) -> str | None:
    value = data
    for part in path:
        inside = _step(value, part)
        value = value if inside is _NOWHERE else inside
    type_ = value.get("type") if isinstance(value, dict) else None
    return type_ if isinstance(type_, str) else None


def _step(value: object, part: int | str) -> object:
    if isinstance(value, list) and isinstance(part, int) and part < len(value):
        return value[part]
    if isinstance(value, dict) and part in value:
        return value[part]
    return _NOWHERE


def models_at(cls: type[BaseModel], path: Path) -> Models:
    """The models that may stand at a path, or that hold the field that it ends in."""
    models: Models = (cls,)
    for part in path:
        if isinstance(part, int):
            continue
        having = [model for model in models if part in model.model_fields]
        if having:
            inside = tuple(m for h in having for m in members_of(h.model_fields[part].annotation))
            if not inside:
                return models
            models = inside
        else:
            models = tuple(m for m in models if part in {m.__name__, _tag(m)}) or models
    return models


def _tag(model: type[BaseModel]) -> Any:  # noqa: ANN401 - a field's default
    field = model.model_fields.get("type")
    return None if field is None else field.default


def members_of(annotation: Any) -> Iterator[type[BaseModel]]:  # noqa: ANN401 - any annotation
    """The models in an annotation: through unions, tuples and whatever else wraps them."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
        return
    for argument in get_args(annotation):
        yield from members_of(argument)

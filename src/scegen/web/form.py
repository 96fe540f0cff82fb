"""The functional scenario as a form: what its fields are, told from its types.

Nothing here names a field of the scenario but the few that the form leaves out; a new field or
word appears in the form by itself. Every word comes with its definition.
"""

import types
from enum import Enum, StrEnum
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from annotated_types import Ge, Gt, Le, Lt
from pydantic import BaseModel
from pydantic.fields import FieldInfo

from scegen.report.words import KMH
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.glossary import meaning_of
from scegen.scenario.junction import MAX_ARMS
from scegen.scenario.model import ArmSet, Identifier, Interval
from scegen.scenario.vocabulary import ParticipantKind
from scegen.understanding import Finding, ParseReport, Standing
from scegen.units import parted

LEFT_OUT = frozenset({"level", "description", "evidence", "unsupported"})
Spec = dict[str, Any]


def form_spec() -> list[Spec]:
    """The sections of the form, one for each field of the functional scenario."""
    return [spec for spec in _fields(FunctionalScenario) if spec["name"] not in LEFT_OUT]


def _fields(model: type[BaseModel]) -> list[Spec]:
    return [_field(name, field) for name, field in model.model_fields.items()]


def _field(name: str, field: FieldInfo) -> Spec:
    label, unit = parted(name)
    is_speed = unit == "m/s"
    annotation: Any = field.annotation
    if field.metadata:
        annotation = Annotated[(annotation, *field.metadata)]
    default = None if field.is_required() else field.get_default(call_default_factory=True)
    spec: Spec = {
        "name": name,
        "label": label.replace("_", " "),
        "unit": "km/h" if is_speed else unit,
        "factor": KMH if is_speed else 1.0,
        "required": field.is_required(),
        "default": _plain(default),
    }
    return {**spec, **_type(annotation, name), **_bounds(field)}


def _bounds(field: FieldInfo) -> Spec:
    bounds = ((Ge, "ge", "min"), (Gt, "gt", "above"), (Le, "le", "max"), (Lt, "lt", "below"))
    return {
        told: getattr(item, name)
        for item in field.metadata
        for kind, name, told in bounds
        if isinstance(item, kind)
    }


def _type(annotation: Any, name: str) -> Spec:  # noqa: ANN401 - any annotation
    """How a field of this type is shown and edited."""
    plain, extra = _unwrapped(annotation)
    optional = _optional(plain)
    if optional is not None:
        return {**_type(optional, name), "optional": True}
    if _is(annotation, ArmSet):
        return {"type": "numbers", "most": MAX_ARMS}
    if get_origin(plain) in {Union, types.UnionType}:
        return {"type": "choice", "members": [_member(m) for m in get_args(plain)]}
    if get_origin(plain) is Literal:
        return {"type": "word", "words": [{"value": v, "means": ""} for v in get_args(plain)]}
    if get_origin(plain) is frozenset:
        return {"type": "words", "words": _words(get_args(plain)[0])}
    if get_origin(plain) is tuple:
        return _list(get_args(plain)[0], name)
    if plain is str and any(getattr(item, "pattern", None) for item in extra):
        return {"type": "id"} if name == "id" else {"type": "name", "of": _of(name)}
    return _single(plain)


def _single(plain: Any) -> Spec:  # noqa: ANN401 - any annotation
    if isinstance(plain, type):
        if issubclass(plain, Interval):
            return {"type": "interval"}
        if issubclass(plain, BaseModel):
            return {"type": "group", "fields": _fields(plain), "means": _told(plain)}
        if issubclass(plain, StrEnum):
            return {"type": "word", "words": _words(plain)}
        if issubclass(plain, bool):
            return {"type": "flag"}
        if issubclass(plain, int | float):
            return {"type": "number", "whole": issubclass(plain, int)}
    return {"type": "text"}


def _list(item: Any, name: str) -> Spec:  # noqa: ANN401 - any annotation
    plain, _ = _unwrapped(item)
    if isinstance(plain, type) and issubclass(plain, BaseModel) and not issubclass(plain, Interval):
        return {"type": "list", "fields": _fields(plain), "means": _told(plain)}
    if _is(item, Identifier):
        return {"type": "names", "of": _of(name)}
    return {"type": "sequence", "whole": plain is int}


def _member(annotation: Any) -> Spec:  # noqa: ANN401 - a model
    """One model of a union that is told apart by its field ``type``."""
    model, _ = _unwrapped(annotation)
    fields = _fields(model)
    tag = next(f for f in fields if f["name"] == "type")["default"]
    rest = [f for f in fields if f["name"] != "type"]
    return {"tag": tag, "label": str(tag).replace("_", " "), "fields": rest, "means": _told(model)}


def _of(name: str) -> str:
    """What a name stands for: a moment, an act, or whoever takes part (or is an object)."""
    return {"at": "moments", "act": "acts"}.get(name, "participants")


def _words(words: type[StrEnum]) -> list[Spec]:
    taken = [word for word in words if word is not ParticipantKind.DOOR]  # that is no participant
    return [{"value": str(word), "means": meaning_of(word).sentence} for word in taken]


def _told(model: type[BaseModel]) -> str:
    """What a model is, in the sentence that its documentation begins with."""
    return " ".join((model.__doc__ or "").split("\n\n")[0].split()).replace("``", "")


def _unwrapped(annotation: Any) -> tuple[Any, tuple[Any, ...]]:  # noqa: ANN401 - any annotation
    if get_origin(annotation) is Annotated:
        plain, *extra = get_args(annotation)
        deeper = (e.metadata if isinstance(e, FieldInfo) else [e] for e in extra)
        return plain, tuple(item for items in deeper for item in items)
    return annotation, ()


def _optional(plain: Any) -> Any:  # noqa: ANN401 - any annotation
    """What an optional field holds if it is there; None if it is not optional."""
    if get_origin(plain) not in {Union, types.UnionType}:
        return None
    members = [member for member in get_args(plain) if member is not type(None)]
    if len(members) == len(get_args(plain)):
        return None
    return members[0] if len(members) == 1 else Union[tuple(members)]  # noqa: UP007 - of a list


def _is(annotation: Any, known: Any) -> bool:  # noqa: ANN401 - any annotations
    """Whether an annotation is one of the project's own, with or without more metadata."""
    plain, extra = _unwrapped(annotation)
    wanted, own = _unwrapped(known)
    return bool(plain == wanted and set(map(repr, own)) <= set(map(repr, extra)))


def _plain(value: Any) -> Any:  # noqa: ANN401 - a default
    """A default as JSON."""
    if isinstance(value, BaseModel):
        return value.model_dump(mode="json")
    if isinstance(value, frozenset | tuple):
        return [_plain(item) for item in value]
    return value.value if isinstance(value, Enum) else value


def standings(report: ParseReport | None) -> dict[str, Spec]:
    """What each field rests on, by its path: its standing and why."""
    found: dict[str, Spec] = {}
    for finding in report.findings if report else ():
        if finding.field is not None and finding.standing is not Standing.UNSUPPORTED:
            found.setdefault(finding.field, {"standing": finding.standing, "why": _why(finding)})
    return found


def _why(finding: Finding) -> str:
    words = f"“{finding.words}”" if finding.words else ""
    return ": ".join(part for part in (words, finding.reason or "") if part)

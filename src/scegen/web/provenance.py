"""What fields rest on after somebody has changed them by hand."""

from typing import Any

from scegen.scenario.evidence import Evidence, EvidenceSource
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.paths import NOWHERE, value_at
from scegen.web.form import Spec, form_spec

BY_HAND, CONFIRMED = "set by hand", "confirmed by hand"
_NAMING = frozenset({"by", "to", "hides", "in_way_of", "into", "between"})
"""Fields that name participants, objects or acts and can do without."""


def carried_over(old: FunctionalScenario, new: FunctionalScenario) -> tuple[Evidence, ...]:
    """The evidence of ``old`` for ``new``: fields that were changed rest on whoever changed them.

    Fields that are gone have none; fields that had none get none.
    """
    before, after = old.model_dump(mode="json"), new.model_dump(mode="json")
    kept = []
    for item in old.evidence:
        value = value_at(after, item.field)
        if value is NOWHERE:
            continue
        same = value == value_at(before, item.field)
        kept.append(item if same else _from_hand(item.field, BY_HAND))
    return tuple(kept)


def confirmed(scenario: FunctionalScenario, field: str) -> FunctionalScenario:
    """The scenario where a field that was assumed counts as meant."""
    evidence = tuple(
        _from_hand(field, CONFIRMED)
        if item.field == field and item.source is not EvidenceSource.STATED
        else item
        for item in scenario.evidence
    )
    return scenario.but(evidence=evidence)


def _from_hand(field: str, reason: str) -> Evidence:
    return Evidence(field=field, source=EvidenceSource.INFERRED, reason=reason)


def renamed(scenario: FunctionalScenario, old: str, new: str) -> dict[str, Any]:
    """The data of a functional scenario in which a participant, an object or an act has a new name.

    Fields that hold names are told from their types, so that no other word is taken for one. What
    rested on words of the text rests on them under the new name.
    """
    data = scenario.model_dump(mode="json")
    data |= _named_anew({"type": "group", "fields": form_spec()}, data, old, new)
    lists = ("participants.", "objects.", "acts.")
    for item in data["evidence"]:
        parts = item["field"].split(".")
        if item["field"].startswith(lists) and parts[1] == old:
            item["field"] = ".".join([parts[0], new, *parts[2:]])
    return data


def _named_anew(spec: Spec, value: Any, old: str, new: str) -> Any:  # noqa: ANN401 - JSON-able data
    """The value of a field, or of an item of a list, with the new name for the old."""
    if value is None:
        return None
    kind = spec["type"]
    if kind in {"id", "name"}:
        return new if value == old else value
    if kind == "names":
        return [new if name == old else name for name in value]
    if kind == "list":
        return [_named_anew({**spec, "type": "group"}, item, old, new) for item in value]
    if kind == "choice":
        fields = next(m["fields"] for m in spec["members"] if m["tag"] == value["type"])
        return {**value, **_named_anew({"type": "group", "fields": fields}, value, old, new)}
    if kind == "group":
        parts = {f["name"]: _named_anew(f, value[f["name"]], old, new) for f in spec["fields"]}
        return {**value, **parts}
    return value


def without(data: Any, name: str) -> Any:  # noqa: ANN401 - JSON-able data
    """The data of a functional scenario without a participant, an object or an act.

    The name is taken out of lists of names; what needs it (a hazard nobody causes any more keeps
    its kind, a spacing does not go without its reference) goes with it.
    """
    if isinstance(data, dict):
        return {
            key: _forgotten(value, name) if key in _NAMING else without(value, name)
            for key, value in data.items()
        }
    if not isinstance(data, list):
        return data
    return [without(item, name) for item in data if not _needs(item, name)]


def _forgotten(value: Any, name: str) -> Any:  # noqa: ANN401 - JSON-able data
    """A field that names somebody, without the name."""
    if isinstance(value, list):
        return [item for item in value if item != name]
    return None if value == name else value


def _needs(item: Any, name: str) -> bool:  # noqa: ANN401 - JSON-able data
    """Whether an item of a list is that of the name, or is about it alone."""
    if not isinstance(item, dict):
        return False
    own = (item.get(key) for key in ("id", "participant", "reference", "at"))
    when = item.get("when") or {}
    needed = (when.get(key) for key in ("act", "participant", "reference"))
    members = item.get("members")
    return name in {*own, *needed} or (isinstance(members, list) and name in members)

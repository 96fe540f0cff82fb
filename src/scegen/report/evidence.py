"""The description cut into spans, each with what was understood from it."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

from scegen.report.words import hazard_words, plain
from scegen.scenario.functional import Evidence, FunctionalScenario
from scegen.scenario.vocabulary import EvidenceSource

LONGEST_SHOWN = 20_000
"""Characters of a description that are shown."""
UNSUPPORTED = "unsupported"
_UNITS = {"_mps": "m/s", "_deg": "°", "_m": "m"}
_RANK = (UNSUPPORTED, *EvidenceSource)


@dataclass(frozen=True, slots=True)
class Span:
    """Consecutive characters; ``kind`` is the strongest source that rests on them, or empty."""

    text: str
    kind: str = ""
    tooltip: str = ""


@dataclass(frozen=True, slots=True)
class FieldRow:
    """One understood field: its value, what it rests on, the words or the reason."""

    field: str
    value: str
    source: str
    ground: str


def spans(functional: FunctionalScenario) -> list[Span]:
    """The description as spans; overlapping evidence is cut at every boundary."""
    text = functional.description[:LONGEST_SHOWN]
    claims = [
        (item.start, item.end, str(item.source), _claim(item))
        for item in functional.evidence
        if item.start is not None and item.end is not None
    ]
    for phrase in functional.unsupported:
        tip = f"not expressible; instead: {phrase.instead}"
        claims.append((phrase.start, phrase.end, UNSUPPORTED, tip))
    claims = [(max(a, 0), min(b, len(text)), kind, tip) for a, b, kind, tip in claims]
    claims = [claim for claim in claims if claim[0] < claim[1]]
    marks = sorted({0, len(text), *(c[0] for c in claims), *(c[1] for c in claims)})
    result = []
    for a, b in pairwise(marks):
        here = [c for c in claims if c[0] <= a and b <= c[1]]
        kinds = {c[2] for c in here}
        kind = next((k for k in _RANK if k in kinds), "")
        tips = list(dict.fromkeys(c[3] for c in here))
        result.append(Span(text[a:b], str(kind), "\n".join(tips)))
    if len(functional.description) > LONGEST_SHOWN:
        hidden = len(functional.description) - LONGEST_SHOWN
        result.append(Span(f" … ({hidden:,} more characters)"))
    return result


def field_rows(functional: FunctionalScenario) -> list[FieldRow]:
    """The evidence as a table, one row for each field."""
    return [
        FieldRow(
            _field_words(item.field),
            _value(functional, item.field),
            str(item.source),
            _ground(item),
        )
        for item in functional.evidence
    ]


def _ground(item: Evidence) -> str:
    quoted = f"“{item.text}”" if item.text else ""
    return " — ".join(part for part in (quoted, item.reason) if part)


def _claim(item: Evidence) -> str:
    reason = f" ({item.reason})" if item.reason else ""
    return f"{item.source}: {_field_words(item.field)}{reason}"


def _field_words(field: str) -> str:
    group, *rest = field.split(".")
    if group == "participants" and rest:
        return " › ".join([rest[0], *(_quantity_words(part) for part in rest[1:])])
    return " › ".join(_quantity_words(part) for part in (group, *rest))


def _quantity_words(name: str) -> str:
    for ending, unit in _UNITS.items():
        if name.endswith(ending):
            return f"{plain(name.removesuffix(ending))} ({unit})"
    return plain(name)


def _value(functional: FunctionalScenario, field: str) -> str:
    """The value at a path, in words; empty where the path leads nowhere."""
    if field.startswith("hazards."):
        kind, _, part = field.removeprefix("hazards.").partition(".")
        meant = [h for h in functional.hazards if h.kind == kind]
        if part == "to":
            return ", ".join(dict.fromkeys(name for h in meant for name in h.to))
        return "; ".join(hazard_words(h) for h in meant)
    here: object = functional.model_dump(mode="json")
    for part in field.split("."):
        if isinstance(here, dict):
            here = here.get(part)
        elif isinstance(here, list):
            named = [
                x for x in here if isinstance(x, dict) and part in {x.get("id"), x.get("kind")}
            ]
            if not named:
                return ""
            here = named[0]
        else:
            return ""
    return _in_words(here)


def _in_words(value: object) -> str:
    if value is None or value == "":
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:g}"
    if isinstance(value, list):
        return ", ".join(_in_words(item) for item in value)
    if isinstance(value, dict) and value.keys() == {"low", "high"}:
        low, high = value["low"], value["high"]
        return f"{low:.1f}" if low == high else f"{low:.1f} to {high:.1f}"
    if isinstance(value, dict):
        pairs = ((plain(str(k)), _in_words(v)) for k, v in value.items() if v not in (None, [], ""))
        return ", ".join(f"{k} {v}" for k, v in pairs if v)
    return plain(str(value))

"""The glossary: every word of the contract with its definition, for prompts, schemas and pages."""

from collections.abc import Iterable
from enum import StrEnum
from typing import Any

from scegen.scenario.acts import ActKind
from scegen.scenario.definitions import Definition, Word
from scegen.scenario.environment import RoadSurface, TimeOfDay, Visibility, Weather
from scegen.scenario.evidence import EvidenceSource
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.outcome import BodySide, OutcomeKind
from scegen.scenario.roadway import AuxiliaryLane, Carriageway, Strip
from scegen.scenario.signals import AtLight
from scegen.scenario.spacings import Measure
from scegen.scenario.things import ThingKind
from scegen.scenario.vocabulary import (
    Approach,
    ArmsMode,
    Control,
    CrossedArm,
    DrivingSide,
    HazardKind,
    JunctionKind,
    Maneuver,
    ParticipantKind,
    Reduction,
    Role,
    Side,
)

VOCABULARY: dict[type[StrEnum], str] = {
    JunctionKind: "junction.kind",
    Control: "junction.control",
    DrivingSide: "junction.driving_side",
    Carriageway: "junction.carriageway",
    Strip: "junction.strips",
    AuxiliaryLane: "junction.auxiliary",
    ParticipantKind: "participants[].kind",
    Role: "participants[].role",
    Approach: "participants[].approaches",
    Maneuver: "participants[].maneuvers",
    CrossedArm: "participants[].crosses",
    AtLight: "participants[].light",
    HazardKind: "hazards[].kind",
    ThingKind: "objects[].kind",
    Measure: "spacings[].measure",
    ActKind: "acts[].kind",
    Side: "objects[].side, spacings[].side, acts[].side",
    OutcomeKind: "outcome.kind",
    BodySide: "outcome.struck",
    Weather: "environment.weather",
    TimeOfDay: "environment.time_of_day",
    RoadSurface: "environment.road_surface",
    Visibility: "environment.visibility",
    EvidenceSource: "evidence[].source",
    Reduction: "reduction",
    ArmsMode: "arms",
}
"""Every list of words, with where it stands in the files."""


def meaning_of(word: StrEnum) -> Definition:
    """What a word of the contract means.

    Raises:
        KeyError: it is no word of the contract.
    """
    if isinstance(word, Word):
        return word.meaning
    if isinstance(word, HazardKind):
        return HAZARDS[word].meaning
    raise KeyError(word)


def defined(words: Iterable[StrEnum]) -> str:
    """Words with their definitions, one on a line."""
    return "\n".join(f"- `{word}`: {meaning_of(word).sentence}" for word in words)


def explain(schema: dict[str, Any]) -> dict[str, Any]:
    """A JSON Schema with the definitions of all words in its descriptions; changes it."""
    named = {words.__name__: words for words in VOCABULARY}
    for name, definition in schema.get("$defs", {}).items():
        if name in named:
            told = definition.get("description", "")
            definition["description"] = f"{told}\n\n{defined(named[name])}".strip()
    return schema


def page() -> str:
    """The glossary as a page of Markdown."""
    parts = [
        "# Glossary",
        "Every word that may stand in a scenario file. The definitions stand beside the words in "
        "`src/scegen/scenario/`.",
    ]
    for words, place in VOCABULARY.items():
        title = (words.__doc__ or words.__name__).split(";")[0].split(":")[0].split("\n")[0]
        parts.append(
            f"## `{place.replace(', ', '`, `')}`\n\n{title.rstrip('.')}.".replace("``", "`")
        )
        rows = [(f"`{word}`", *meaning_of(word)) for word in words]
        parts.append(_table(("word", "means", "is not", "for example"), rows))
        if words is HazardKind:
            parts += ["### Who, where and how", _HAZARDS_READ, _hazards()]
    return "\n\n".join(parts) + "\n"


_HAZARDS_READ = (
    "Who causes and who suffers a danger where the text does not say: the first that is found. "
    "What it needs of the ways of both; the rule of the road that it breaks; in which direction "
    "it happens; what who causes it does, if the text gives no act of it."
)


def _hazards() -> str:
    rows = [
        (
            f"`{kind}`",
            ", ".join(row.causes),
            ", ".join(row.suffers),
            "; ".join(f"{case}: {', '.join(needs)}" for case, needs in row.needs.items()),
            row.breaks or "",
            row.moves,
            ", ".join(row.acts),
        )
        for kind, row in HAZARDS.items()
    ]
    head = ("kind", "by", "to", "needs", "breaks", "moves", "acts")
    return _table(head, rows)


def _table(head: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> str:
    lines = [head, ("---",) * len(head), *rows]
    return "\n".join(f"| {' | '.join(cells)} |" for cells in lines)

"""The agents' parts put together: one scenario, every field with words that the text really has."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from pydantic import BaseModel, ValidationError

from scegen.scenario.functional import (
    Environment,
    Evidence,
    FunctionalScenario,
    Junction,
    Participant,
    Unsupported,
)
from scegen.scenario.vocabulary import EvidenceSource
from scegen.understanding.agents.quoting import find_quote
from scegen.understanding.agents.replies import (
    Basis,
    EnvironmentReply,
    HazardsReply,
    ParticipantsReply,
    Reply,
    RoadReply,
)
from scegen.understanding.agents.result import Objection, Part

_ALWAYS = frozenset({"junction.kind", "junction.arms", "junction.control", "junction.driving_side"})
"""Junction fields that always get a line, said or not, as the offline reader gives them."""


@dataclass(frozen=True, slots=True)
class Parts:
    """One answer of every agent."""

    road: RoadReply
    participants: ParticipantsReply
    hazards: HazardsReply
    environment: EnvironmentReply

    def replies(self) -> tuple[Reply, ...]:
        """All four."""
        return (self.road, self.participants, self.hazards, self.environment)


@dataclass(frozen=True, slots=True)
class Draft:
    """The scenario, or the objections to the parts that do not fit together."""

    scenario: FunctionalScenario | None
    objections: tuple[Objection, ...] = ()
    notes: tuple[str, ...] = ()


def assemble(description: str, parts: Parts) -> Draft:
    """One scenario from the parts."""
    unsupported, notes = _unsupported(description, parts)
    evidence, doubts = _evidence(description, parts)
    try:
        scenario = FunctionalScenario(
            description=description,
            junction=parts.road.junction,
            participants=parts.participants.participants,
            relations=parts.participants.relations,
            hazards=parts.hazards.hazards,
            environment=parts.environment.environment,
            evidence=tuple(evidence),
            unsupported=unsupported,
        )
    except ValidationError as error:
        return Draft(None, tuple(_objection(e["msg"]) for e in error.errors()))
    return Draft(scenario, notes=notes + doubts)


def _objection(message: str) -> Objection:
    about = Part.HAZARDS if "hazards." in message else Part.PARTICIPANTS
    return Objection(about=about, problem=message[:400])


def _unsupported(description: str, parts: Parts) -> tuple[tuple[Unsupported, ...], tuple[str, ...]]:
    found: dict[tuple[int, int], Unsupported] = {}
    notes = []
    for passage in (p for reply in parts.replies() for p in reply.unsupported):
        quote = find_quote(description, passage.words)
        if quote is None:
            notes.append(
                f'left out as not expressible: "{passage.words}", which the text does not have'
            )
        else:
            found.setdefault(
                (quote.start, quote.end),
                Unsupported(
                    text=quote.text, start=quote.start, end=quote.end, instead=passage.instead
                ),
            )
    return tuple(found[place] for place in sorted(found)), tuple(notes)


def _evidence(description: str, parts: Parts) -> tuple[list[Evidence], tuple[str, ...]]:
    given: dict[str, Basis] = {}
    for prefix, reply in (
        ("junction", parts.road),
        ("participants", parts.participants),
        ("hazards", parts.hazards),
        ("environment", parts.environment),
    ):
        for basis in reply.basis:
            given.setdefault(_path(prefix, basis.field), basis)
    evidence, doubts = [], []
    for path, is_default in _fields(parts):
        item = _grounded(description, path, given.get(path), is_default=is_default)
        evidence.append(item)
        quoted = given[path].words if path in given else None
        if quoted and item.source is not EvidenceSource.STATED:
            doubts.append(f'{path}: the model quoted "{quoted}", which the text does not have')
    return evidence, tuple(doubts)


def _path(prefix: str, field: str) -> str:
    """A field's path, whether or not the model wrote its beginning, hazards by kind alone."""
    path = field if field.startswith(f"{prefix}.") else f"{prefix}.{field}"
    return ".".join(path.split(".")[:2]) if prefix == "hazards" else path


def _fields(parts: Parts) -> Iterator[tuple[str, bool]]:
    """Paths of all fields that need a ground, and whether each has its default value."""
    yield from _filled("junction", parts.road.junction, Junction)
    for participant in parts.participants.participants:
        place = f"participants.{participant.id}"
        yield f"{place}.kind", False
        yield f"{place}.role", participant.role is Participant.model_fields["role"].default
        for path, is_default in _filled(place, participant, Participant):
            if path not in {f"{place}.kind", f"{place}.role", f"{place}.id"}:
                yield path, is_default
    if parts.participants.relations:
        yield "relations", False
    for kind in dict.fromkeys(h.kind for h in parts.hazards.hazards):
        yield f"hazards.{kind}", False
    yield from _filled("environment", parts.environment.environment, Environment)


def _filled(place: str, model: BaseModel, cls: type[BaseModel]) -> Iterator[tuple[str, bool]]:
    for name, info in cls.model_fields.items():
        is_default = not info.is_required() and getattr(model, name) == info.default
        path = f"{place}.{name}"
        if path in _ALWAYS or not is_default:
            yield path, is_default


def _grounded(description: str, path: str, basis: Basis | None, *, is_default: bool) -> Evidence:
    """Stated if the words are really there; otherwise concluded, or a default."""
    quote = find_quote(description, basis.words) if basis else None
    if quote is not None and basis is not None:
        return Evidence(
            field=path,
            source=EvidenceSource.STATED,
            text=quote.text,
            start=quote.start,
            end=quote.end,
            reason=basis.reason or None,
        )
    if basis is not None and basis.words:
        reason = f'the model rests it on words that the text does not have: "{basis.words}"'
    elif basis is not None and basis.reason:
        reason = basis.reason
    elif is_default:
        return Evidence(field=path, source=EvidenceSource.DEFAULT, reason="not said")
    else:
        reason = "concluded by the model, which named no words"
    return Evidence(field=path, source=EvidenceSource.INFERRED, reason=reason)

"""What the text states in so many words, as the offline reader found it."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass

from scegen.scenario.evidence import Evidence, EvidenceSource, Unsupported
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.junction import Junction
from scegen.scenario.model import FrozenModel, Interval
from scegen.scenario.vocabulary import ParticipantKind
from scegen.understanding.agents.result import Objection, Part
from scegen.understanding.words.numbers import number_at
from scegen.understanding.words.tokens import tokenize


@dataclass(frozen=True, slots=True)
class Words:
    """Words of the description and where they stand."""

    text: str
    start: int
    end: int

    @property
    def numbers(self) -> frozenset[float]:
        """The numbers among them, in digits or words."""
        tokens = tokenize(self.text)
        found = (number_at(tokens, i) for i in range(len(tokens)))
        return frozenset(n.value for n in found if n is not None)

    def within(self, other: Words) -> bool:
        """Whether these are the other words, or a part of them."""
        return other.start <= self.start and self.end <= other.end

    def overlaps(self, other: Words | Unsupported) -> bool:
        """Whether they share a character."""
        return self.start < other.end and other.start < self.end


@dataclass(frozen=True, slots=True)
class Count:
    """So many participants of a kind, counted by the text in these words."""

    kind: ParticipantKind
    count: int
    words: Words


def words_of(scenario: FunctionalScenario, field: str) -> Words | None:
    """The words that state a field; None if none do."""
    found = (item for item in scenario.evidence if item.field == field)
    return next(map(_words, found), None)


def counts(scenario: FunctionalScenario) -> tuple[Count, ...]:
    """Participants that the text counts with a number ("three cars"), group by group."""
    groups: dict[tuple[ParticipantKind, Words], int] = defaultdict(int)
    for participant in scenario.participants:
        words = words_of(scenario, f"participants.{participant.id}.kind")
        if words is not None and not participant.parked:
            groups[participant.kind, words] += 1
    return tuple(
        Count(kind, count, words)
        for (kind, words), count in groups.items()
        if float(count) in words.numbers
    )


def miscounted(reader: FunctionalScenario, scenario: FunctionalScenario) -> tuple[Objection, ...]:
    """Objections where fewer participants of a kind are listed than the text counts."""
    wanted: dict[ParticipantKind, list[Count]] = defaultdict(list)
    for count in counts(reader):
        wanted[count.kind].append(count)
    objections = []
    for kind, groups in wanted.items():
        total = sum(group.count for group in groups)
        found = sum(p.kind is kind and not p.parked for p in scenario.participants)
        if found < total:
            said = ", ".join(f'"{group.words.text}"' for group in groups)
            objections.append(
                Objection(
                    about=Part.PARTICIPANTS,
                    problem=f"the text says {said}, so at least {total} of kind {kind}; "
                    f"{found} are listed",
                    words=groups[0].words.text,
                )
            )
    return tuple(objections)


def holds_number(scenario: FunctionalScenario, field: str) -> bool:
    """Whether a field is of a quantity, or of a moment that a quantity may tell."""
    place = place_of(scenario, field)
    if place is None:
        return False
    value = getattr(place[1], place[2], None)
    return (
        isinstance(value, Interval)
        or (isinstance(value, float) and isinstance(place[1], Junction))
        or place[2] == "when"
    )


def place_of(scenario: FunctionalScenario, field: str) -> tuple[int, FrozenModel, str] | None:
    """Where a path leads: the number in its list, whose field it is, and the field."""
    head, *steps = field.split(".")
    part = getattr(scenario, head, None)
    if isinstance(part, FrozenModel) and len(steps) == 1:
        return 0, part, steps[0]
    if not isinstance(part, tuple) or not steps:
        return None
    for number, one in enumerate(part):
        if steps[0] in {str(number), getattr(one, "id", None)}:
            return number, one, steps[1] if len(steps) > 1 else "value"
    return None


def _words(item: Evidence) -> Words | None:
    if item.source is not EvidenceSource.STATED or item.text is None:
        return None
    if item.start is None or item.end is None:
        return None
    return Words(item.text, item.start, item.end)

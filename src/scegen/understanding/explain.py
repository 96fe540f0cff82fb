"""Which words of the description carry which fields, for a terminal or a page to mark."""

from __future__ import annotations

from dataclasses import dataclass

from scegen.scenario.functional import FunctionalScenario


@dataclass(frozen=True, slots=True)
class Mark:
    """A stretch of the description.

    Attributes:
        start: first character.
        end: offset after the last character.
        fields: the fields that rest on exactly these words, in order.
        source: ``stated``, ``inferred``, ``default`` or ``unsupported``; the strongest one.
    """

    start: int
    end: int
    fields: tuple[str, ...]
    source: str


_STRENGTH = {"stated": 0, "inferred": 1, "default": 2, "unsupported": 3}


def marks(scenario: FunctionalScenario) -> tuple[Mark, ...]:
    """The marked stretches, sorted by place, equal stretches merged.

    Args:
        scenario: a scenario with evidence.
    """
    found: dict[tuple[int, int], list[tuple[str, str]]] = {}
    for item in scenario.evidence:
        if item.start is not None and item.end is not None:
            entry = (item.source.value, item.field)
            found.setdefault((item.start, item.end), []).append(entry)
    for left in scenario.unsupported:
        found.setdefault((left.start, left.end), []).append(("unsupported", "unsupported"))
    return tuple(
        Mark(
            start,
            end,
            tuple(dict.fromkeys(name for _, name in entries)),
            min((source for source, _ in entries), key=_STRENGTH.__getitem__),
        )
        for (start, end), entries in sorted(found.items())
    )

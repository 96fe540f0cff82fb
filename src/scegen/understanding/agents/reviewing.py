"""What the reviewer is shown: the scenario, what each field rests on, what its words mean."""

import json
import re
from collections.abc import Iterable, Iterator
from enum import StrEnum

from scegen.llm.prompting import as_data
from scegen.scenario.definitions import Word
from scegen.scenario.evidence import Evidence, EvidenceSource
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.glossary import VOCABULARY, meaning_of
from scegen.scenario.vocabulary import HazardKind


def review_question(scenario: FunctionalScenario) -> str:
    """The message to the reviewer."""
    shown = scenario.model_copy(update={"description": "", "evidence": ()})
    used = list(_words(shown.model_dump(exclude_defaults=True)))
    # equal strings of different lists are different words
    words = {(type(word), word): word for word in [*used, *_neighbours(used)]}.values()
    return "\n".join(
        [
            as_data(scenario.description),
            "",
            "The scenario to review:",
            *_lines(shown),
            "",
            "What its fields rest on, where the text says anything:",
            *(
                _told(item)
                for item in scenario.evidence
                if item.source is not EvidenceSource.DEFAULT
            ),
            "",
            "What its words mean, and those that they are not to be taken for:",
            *(f"- {VOCABULARY[type(w)]} `{w}`: {meaning_of(w).sentence}" for w in words),
        ]
    )


def _lines(scenario: FunctionalScenario) -> Iterator[str]:
    """Every field that is filled, and everybody in it, on a line."""
    for name, value in scenario.model_dump(mode="json", exclude_defaults=True).items():
        several = isinstance(value, list)
        for one in value if several else [value]:
            yield f"{name}{'[]' if several else ''}: {json.dumps(one, ensure_ascii=False)}"


def _told(item: Evidence) -> str:
    words = f' "{item.text}"' if item.source is EvidenceSource.STATED else ""
    reason = f" ({item.reason})" if item.reason else ""
    return f"- {item.field}: {item.source}{words}{reason}"


def _neighbours(words: Iterable[StrEnum]) -> Iterator[StrEnum]:
    """The words of the same lists from which the definitions tell these apart."""
    for word in words:
        for name in re.findall(r"`(\w+)`", meaning_of(word).is_not):
            if name in set(type(word)):
                yield type(word)(name)


def _words(data: object) -> Iterator[StrEnum]:
    """All words of the contract in a dumped model, in the order of its fields."""
    if isinstance(data, Word | HazardKind):
        yield data
    elif isinstance(data, dict):
        for value in data.values():
            yield from _words(value)
    elif isinstance(data, list | tuple | frozenset):
        for value in sorted(data) if isinstance(data, frozenset) else data:
            yield from _words(value)

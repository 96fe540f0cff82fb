"""Numbers of the text: none gets lost, and where both read one differently the reader's stands."""

from collections.abc import Iterator

from scegen.scenario.evidence import Unsupported
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.model import Interval
from scegen.understanding.agents.deciding import Decider, close
from scegen.understanding.agents.result import Objection, Part
from scegen.understanding.agents.stated import Words, holds_number, place_of, words_of

_WHOSE = {
    "junction": Part.ROAD,
    "participants": Part.PARTICIPANTS,
    "objects": Part.PARTICIPANTS,
    "acts": Part.ACTS,
    "spacings": Part.ACTS,
    "outcome": Part.ACTS,
}
"""Groups of fields that hold quantities, and the agents that fill them."""
_COMPARED = ("acts", "spacings")


def lost(reader: FunctionalScenario, scenario: FunctionalScenario) -> tuple[Objection, ...]:
    """Objections to quantities that the reader found and on whose words nothing rests.

    Args:
        reader: the offline reader's scenario.
        scenario: the agents'.
    """
    stated = [words_of(scenario, e.field) for e in scenario.evidence]
    used: list[Words | Unsupported] = [*scenario.unsupported, *(w for w in stated if w is not None)]
    found: dict[Words, str] = {}
    for field, words in _quantities(reader):
        if not any(words.overlaps(other) for other in used):
            found.setdefault(words, field)
    return tuple(
        Objection(
            about=_WHOSE[field.split(".")[0]],
            problem=f'no field rests on the number in "{words.text}", and `unsupported` does not '
            f"name it; {field.split('.')[-1]} might hold it",
            words=words.text,
        )
        for words, field in found.items()
    )


def _quantities(scenario: FunctionalScenario) -> Iterator[tuple[str, Words]]:
    """Fields for a quantity that the text states by a number."""
    for item in scenario.evidence:
        words = words_of(scenario, item.field)
        if words is not None and words.numbers and holds_number(scenario, item.field):
            yield item.field, words


def compare_numbers(decider: Decider) -> None:
    """Amounts of acts and spacings that rest on the same words, in the same field."""
    reader = decider.reader
    for field, words in _quantities(reader):
        group = field.split(".")[0]
        if group not in _COMPARED:
            continue
        for item in decider.scenario.evidence:
            ours = words_of(decider.scenario, item.field)
            if ours is not None and ours.overlaps(words) and item.field.split(".")[0] == group:
                _compare(decider, field, item.field, words)


def _compare(decider: Decider, theirs: str, ours: str, words: Words) -> None:
    there = place_of(decider.reader, theirs)
    here = place_of(decider.scenario, ours)
    if there is None or here is None or there[2] != here[2]:
        return
    if getattr(there[1], "measure", None) != getattr(here[1], "measure", None):
        return
    number, one, name = here
    said, held = getattr(there[1], name), getattr(one, name)
    if not (isinstance(said, Interval) and isinstance(held, Interval)) or close(said, held):
        return
    group = ours.partition(".")[0]
    changed = list(getattr(decider.scenario, group))
    changed[number] = one.model_copy(update={name: said})
    update = {group: tuple(changed)}
    decider.decide(ours, words, _shown(said), _shown(held), update, number=True, proof=theirs)


def _shown(value: Interval) -> str:
    low, high = f"{value.low:.4g}", f"{value.high:.4g}"
    return low if low == high else f"{low} to {high}"

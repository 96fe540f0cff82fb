"""One fact at a time: whose value stands, why, and what becomes of the evidence."""

from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError

from scegen.scenario.acts import Act
from scegen.scenario.evidence import Evidence
from scegen.scenario.functional import FunctionalScenario, Participant, Relation
from scegen.scenario.model import Interval
from scegen.scenario.things import Thing
from scegen.understanding.agents.stated import Words, holds_number, place_of, words_of
from scegen.understanding.report.parse_report import Disagreement, Kept

_SAME_WITHIN = 0.02
"""Quantities that differ by less were only rounded."""
_NUMBERS_WIN = "numbers stated in the text win"
EVERYBODYS = ("participants", "relations", "objects", "hazards", "acts", "spacings", "outcome")
"""Fields that name participants: who takes over another's participants takes over all of them."""
_LEXICON_WINS = "the reader's lexicon has these words, and the agents make nothing else of them"


class Decider:
    """Takes facts from the reader into the agents' scenario.

    Args:
        agents: the agents' scenario.
        reader: the offline reader's.
    """

    def __init__(self, agents: FunctionalScenario, reader: FunctionalScenario) -> None:
        self.scenario = self._agents = agents
        self.reader = reader
        self.disagreements: list[Disagreement] = []

    def decide(
        self,
        path: str,
        words: Words,
        theirs: object,
        ours: object,
        update: Mapping[str, Any],
        *,
        number: bool = False,
        proof: str | None = None,
    ) -> None:
        """Keep one value, and say which and why.

        Args:
            path: the field.
            words: what states it, as the reader has it.
            theirs: the reader's value.
            ours: the agents'.
            update: group -> what changes in the scenario if the reader's value is kept.
            number: the words state it by a number.
            proof: the field of the reader that proves it, if that has another path.
        """
        if isinstance(theirs, float) and isinstance(ours, float) and near(theirs, ours):
            self.scenario = self.updated(update) or self.scenario  # the same, not rounded
            return
        concluded = _concluded(ours, theirs)
        reason = self._read_otherwise(path, words, number=number, concluded=concluded)
        combined = None if reason else self.updated(update, path, proof or path)
        if combined is None:
            reason = reason or "the reader's value does not fit the rest of the scenario"
            self.note(path, words, theirs, ours, Kept.AGENTS, reason)
            return
        self.scenario = combined
        reason = _NUMBERS_WIN if number else _LEXICON_WINS
        self.note(path, words, theirs, ours, Kept.READER, reason)

    def _read_otherwise(
        self, path: str, words: Words, *, number: bool, concluded: bool
    ) -> str | None:
        """What the agents make of these words, or of the field, if that is not the reader's fact.

        What a word or a number means the reader knows well; whose it is, the agents know better.
        """
        quoted = words_of(self.scenario, path)
        if quoted is not None:
            same = quoted.overlaps(words) if number else quoted.within(words)
            return None if same else f'the agents rest it on the words "{quoted.text}"'
        for item in self._agents.evidence:
            own = words_of(self._agents, item.field)
            if own is None or not own.overlaps(words) or item.field == path:
                continue
            if _rivals(self._agents, path, item.field, number=number):
                return f"the agents take these words for {item.field}"
        for left in self._agents.unsupported:
            if words.overlaps(left):
                return f"the agents find no field for these words: {left.instead}"
        return "the agents conclude it from the text as a whole" if concluded else None

    def updated(
        self, update: Mapping[str, Any], path: str | None = None, proof: str | None = None
    ) -> FunctionalScenario | None:
        """The scenario with other values, if that is valid.

        Args:
            update: group -> its new content, or field -> value within it.
            path: the field that the reader's evidence goes to; None leaves evidence alone.
            proof: the reader's field that the evidence comes from.
        """
        data = self.scenario.model_dump()
        for group, values in update.items():
            data[group] = {**data[group], **values} if isinstance(values, dict) else values
        if path is not None:
            data["evidence"] = self._evidence(update, path, proof or path)
        try:
            return FunctionalScenario.model_validate(data)
        except ValidationError:
            return None

    def _evidence(self, update: Mapping[str, Any], path: str, proof: str) -> list[Any]:
        """The agents' evidence, with the reader's in place of what is replaced."""
        places = {f"{g}.{n}" for g, v in update.items() if isinstance(v, dict) for n in v}
        groups = EVERYBODYS if set(EVERYBODYS) <= set(update) else ()

        def replaced(field: str) -> bool:
            return field in places or field.startswith(groups)

        kept = [e for e in self.scenario.evidence if e.field != path and not replaced(e.field)]
        new = [e for e in self.reader.evidence if e.field != proof and replaced(e.field)]
        moved = (e for e in self.reader.evidence if e.field == proof)
        return [*kept, *new, *(e.model_copy(update={"field": path}) for e in moved)]

    def note(
        self, path: str, words: Words, theirs: object, ours: object, kept: Kept, reason: str
    ) -> None:
        """Write a disagreement down, also beside the evidence of the field."""
        item = Disagreement(
            field=path,
            words=words.text,
            start=words.start,
            end=words.end,
            reader=shown(theirs),
            agents=shown(ours),
            kept=kept,
            reason=reason,
        )
        self.disagreements.append(item)
        evidence = tuple(_remarked(e, item) for e in self.scenario.evidence)
        self.scenario = self.scenario.model_copy(update={"evidence": evidence})


def _concluded(ours: object, theirs: object) -> bool:
    """Whether the agents say something else; not if only the side differs, which is a slip."""
    if not isinstance(ours, frozenset) or not isinstance(theirs, frozenset):
        return False
    sides = [{str(word) for word in said} & {"left", "right"} for said in (ours, theirs)]
    return bool(ours) and not (all(sides) and sides[0] != sides[1])


def _rivals(scenario: FunctionalScenario, path: str, other: str, *, number: bool) -> bool:
    """Whether another field can hold what is read for the path: a number, or the same of others."""
    if number:
        return holds_number(scenario, other)
    one, two = (_whose(scenario, field) for field in (path, other))
    return one is not None and two is not None and one[0] != two[0] and one[1] == two[1]


def _whose(scenario: FunctionalScenario, field: str) -> tuple[str, str] | None:
    """Of whom a field says something, and what; None if it is of nobody."""
    found = place_of(scenario, field)
    if found is None:
        return None
    _, one, name = found
    if isinstance(one, Act):
        return one.participant, "maneuvers" if name == "kind" else name
    if isinstance(one, Relation):
        return f"{one.participant} to {one.reference}", "approaches"
    return (str(one.id), name) if isinstance(one, Participant | Thing) else None


def _remarked(evidence: Evidence, item: Disagreement) -> Evidence:
    counted = evidence.field.startswith(f"{item.field}.") and evidence.start == item.start
    if evidence.field != item.field and not counted:
        return evidence
    who, value = ("agents", item.agents) if item.kept is Kept.READER else ("reader", item.reader)
    said = f"read in two ways, by the {who} as: {value}; {item.reason}"
    return evidence.model_copy(update={"reason": "; ".join(filter(None, (evidence.reason, said)))})


def near(one: float, other: float) -> bool:
    """Whether two quantities differ by no more than rounding."""
    return abs(one - other) <= _SAME_WITHIN * max(abs(one), abs(other))


def close(one: Interval, other: Interval) -> bool:
    """Whether two ranges differ by no more than rounding."""
    return near(one.low, other.low) and near(one.high, other.high)


def shown(value: object) -> str:
    """A value in words."""
    if value is None or value in ((), frozenset()):
        return "not said"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, Interval):
        same = near(value.low, value.high)
        return f"{value.low:.1f} m/s" if same else f"{value.low:.1f} to {value.high:.1f} m/s"
    if isinstance(value, float):
        return f"{value:.1f}"
    if isinstance(value, frozenset):
        return " or ".join(sorted(str(item) for item in value))
    if isinstance(value, tuple):
        return ", ".join(str(item) for item in value)
    return str(value)

"""Reader and agents combined: where they differ on a stated fact, both are shown and one kept.

Numbers that the text states win, as the reader parsed them. Elsewhere the agents' value stands if
they quoted more or other words for it than the reader; what rests on the very same words, or on
none, gives way to the lexicon.
"""

from __future__ import annotations

from typing import Any

from pydantic import ValidationError

from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.model import Interval
from scegen.understanding.agents.result import Disagreement, Kept
from scegen.understanding.agents.stated import Words, miscounted, words_of

_SHAPE = ("kind", "arms", "arm_angles_deg", "lanes", "ring_lanes", "crosswalks")
"""Fields of a junction that only fit together."""
_JUNCTION = ("kind", "arms", "lanes", "ring_lanes", "speed_limit_mps", "driving_side", "control")
_NUMBERS = frozenset({"arms", "lanes", "ring_lanes", "speed_limit_mps"})
_ENVIRONMENT = ("weather", "time_of_day", "road_surface", "visibility")
_SAME_WITHIN = 0.02
"""Quantities that differ by less were only rounded."""


class Combiner:
    """Takes facts from the reader into the agents' scenario, one by one.

    Args:
        agents: the agents' scenario.
        reader: the offline reader's.
    """

    def __init__(self, agents: FunctionalScenario, reader: FunctionalScenario) -> None:
        self.scenario = agents
        self.disagreements: list[Disagreement] = []
        self._reader = reader

    def run(self) -> FunctionalScenario:
        """The combined scenario; it is valid whatever the two said."""
        for name in _JUNCTION:
            self._junction(name)
        for name in _ENVIRONMENT:
            self._environment(name)
        self._counts()
        for participant in self._reader.participants:
            if participant.speed_mps is not None:
                self._speed(participant, participant.speed_mps)
        return self.scenario

    def _junction(self, name: str) -> None:
        path = f"junction.{name}"
        words = words_of(self._reader, path)
        theirs, ours = getattr(self._reader.junction, name), getattr(self.scenario.junction, name)
        if words is None or theirs == ours:
            return
        number = name in _NUMBERS and bool(words.numbers)
        if name == "arms" and not number:
            return  # it only follows from the kind, which is compared by itself
        names = _SHAPE if name in _SHAPE else (name,)
        update = {n: getattr(self._reader.junction, n) for n in names}
        if name == "arms" and self._reader.junction.kind is not self.scenario.junction.kind:
            fitting = self._with({"junction": {"arms": theirs, "arm_angles_deg": (), "lanes": ()}})
            update = {"arms": theirs, "arm_angles_deg": (), "lanes": ()} if fitting else update
        self._decide(path, words, theirs, ours, {"junction": update}, number=number)

    def _environment(self, name: str) -> None:
        path = f"environment.{name}"
        words = words_of(self._reader, path)
        theirs = getattr(self._reader.environment, name)
        ours = getattr(self.scenario.environment, name)
        if words is not None and theirs != ours:
            self._decide(path, words, theirs, ours, {"environment": {name: theirs}}, number=False)

    def _counts(self) -> None:
        """Fewer of a kind than the text counts: the reader's participants replace the agents'."""
        objections = miscounted(self._reader, self.scenario)
        if not objections:
            return
        replaced = {
            "participants": self._reader.participants,
            "relations": self._reader.relations,
            "hazards": self._reader.hazards,
        }
        words = _place(self._reader, objections[0].words or "")
        theirs, ours = _tally(self._reader), _tally(self.scenario)
        self._decide("participants", words, theirs, ours, replaced, number=True)

    def _speed(self, theirs: Participant, speed: Interval) -> None:
        """A speed in numbers, of the one participant whom both must mean."""
        path = f"participants.{theirs.id}.speed_mps"
        words = words_of(self._reader, path)
        if words is None or not words.numbers:
            return
        alike = [p for p in self.scenario.participants if p.kind is theirs.kind]
        if any(p.speed_mps is not None and _close(p.speed_mps, speed) for p in alike):
            return
        peers = [p for p in self._reader.participants if p.kind is theirs.kind]
        if len(alike) != 1 or len(peers) != 1:
            said = ", ".join(_shown(p.speed_mps) for p in alike) or "nobody of this kind"
            reason = "it is not clear whose speed it is"
            self._note(path, words, _shown(speed), said, Kept.AGENTS, reason)
            return
        ours = alike[0]
        participants = tuple(
            p.model_copy(update={"speed_mps": speed}) if p is ours else p
            for p in self.scenario.participants
        )
        path = f"participants.{ours.id}.speed_mps"
        self._decide(
            path, words, speed, ours.speed_mps, {"participants": participants}, number=True
        )

    def _decide(
        self,
        path: str,
        words: Words,
        theirs: object,
        ours: object,
        update: dict[str, Any],
        *,
        number: bool,
    ) -> None:
        """Keep one value, and say which and why."""
        if isinstance(theirs, float) and isinstance(ours, float) and _near(theirs, ours):
            self.scenario = self._with(update) or self.scenario  # the same, not rounded
            return
        quoted = words_of(self.scenario, path)
        shown = (_shown(theirs), _shown(ours))
        if quoted is not None and not number and not quoted.within(words):
            reason = f'the agents rest it on the words "{quoted.text}"'
            self._note(path, words, *shown, Kept.AGENTS, reason)
            return
        combined = self._with(update, evidence_from=path)
        if combined is None:
            reason = "the reader's value does not fit the rest of the scenario"
            self._note(path, words, *shown, Kept.AGENTS, reason)
            return
        reason = (
            "numbers stated in the text win"
            if number
            else "the reader's lexicon has these words, and the agents named no others"
        )
        self.scenario = combined
        self._note(path, words, *shown, Kept.READER, reason)

    def _with(
        self, update: dict[str, Any], evidence_from: str | None = None
    ) -> FunctionalScenario | None:
        """The scenario with other values and the reader's evidence for them, if that is valid."""
        data = self.scenario.model_dump()
        for group, values in update.items():
            data[group] = {**data[group], **values} if isinstance(values, dict) else values
        if evidence_from is not None:
            data["evidence"] = self._evidence(update, evidence_from)
        try:
            return FunctionalScenario.model_validate(data)
        except ValidationError:
            return None

    def _evidence(self, update: dict[str, Any], path: str) -> list[Any]:
        """The agents' evidence, with the reader's in place of what is replaced."""
        places = {f"{g}.{n}" for g, v in update.items() if isinstance(v, dict) for n in v} | {path}
        groups = ("participants.", "relations", "hazards.") if "hazards" in update else ()

        def replaced(field: str) -> bool:
            return field in places or field.startswith(groups)

        kept = [e for e in self.scenario.evidence if not replaced(e.field)]
        new = [e for e in self._reader.evidence if replaced(e.field)]
        return [*kept, *new]

    def _note(
        self, path: str, words: Words, theirs: str, ours: str, kept: Kept, reason: str
    ) -> None:
        self.disagreements.append(
            Disagreement(
                field=path,
                words=words.text,
                start=words.start,
                end=words.end,
                reader=theirs,
                agents=ours,
                kept=kept,
                reason=reason,
            )
        )


def _near(one: float, other: float) -> bool:
    return abs(one - other) <= _SAME_WITHIN * max(abs(one), abs(other))


def _close(one: Interval, other: Interval) -> bool:
    return _near(one.low, other.low) and _near(one.high, other.high)


def _tally(scenario: FunctionalScenario) -> str:
    kinds = [str(p.kind) for p in scenario.participants]
    return ", ".join(f"{kinds.count(kind)} {kind}" for kind in dict.fromkeys(kinds))


def _place(scenario: FunctionalScenario, text: str) -> Words:
    start = max(scenario.description.find(text), 0)
    return Words(text, start, start + len(text))


def _shown(value: object) -> str:
    if value is None or value == ():
        return "not said"
    if isinstance(value, Interval):
        same = _near(value.low, value.high)
        return f"{value.low:.1f} m/s" if same else f"{value.low:.1f} to {value.high:.1f} m/s"
    if isinstance(value, float):
        return f"{value:.1f}"
    if isinstance(value, tuple):
        return ", ".join(str(item) for item in value)
    return str(value)

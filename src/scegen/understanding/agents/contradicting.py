"""A text that contradicts itself: a model may say how it reads it, but not pass over it."""

from dataclasses import dataclass

from scegen.errors import InfeasibleError, InputError
from scegen.scenario.functional import FunctionalScenario
from scegen.understanding.agents.result import Objection, Part
from scegen.understanding.agents.stated import Words
from scegen.understanding.report.parse_report import Disagreement, Kept, report_on_contradiction


@dataclass(frozen=True, slots=True)
class Contradiction:
    """What the offline reader found to be impossible, and the words that say so."""

    error: InfeasibleError
    words: tuple[Words, ...]

    def objections(self, scenario: FunctionalScenario) -> tuple[Objection, ...]:
        """An objection to a scenario that says nothing about any of these words."""
        if self._answers(scenario):
            return ()
        about = Part.ROAD if self.error.where == "junction" else Part.PARTICIPANTS
        said = f"the text seems to contradict itself: {self.error.message}. Name these words in "
        said += "`unsupported`, and say there how you read them instead"
        return (Objection(about=about, problem=said[:500], words=self.words[0].text),)

    def resolved_by(self, scenario: FunctionalScenario, model: str) -> list[Disagreement]:
        """What the agents did with the contradiction.

        Raises:
            InfeasibleError: they are silent about it; what the text states wins over that.
        """
        answers = self._answers(scenario)
        if not answers:
            raise InfeasibleError(
                f"{self.error.message}; {model} answered all the same, without a word on it",
                where=self.error.where,
                hint=self.error.hint,
            )
        return [
            Disagreement(
                field=self.error.where or "description",
                words=words.text,
                start=words.start,
                end=words.end,
                reader=self.error.message,
                agents=instead,
                kept=Kept.AGENTS,
                reason="the agents say how they read the contradiction",
            )
            for words, instead in answers
        ]

    def _answers(self, scenario: FunctionalScenario) -> list[tuple[Words, str]]:
        return [
            (words, phrase.instead)
            for words in self.words
            for phrase in scenario.unsupported
            if words.overlaps(phrase)
        ]


def contradiction_in(text: str, refusal: InputError | None) -> Contradiction | None:
    """The contradiction that made the reader refuse a text; None if it had other reasons.

    Args:
        text: the description.
        refusal: the reader's error.
    """
    if not isinstance(refusal, InfeasibleError):
        return None
    words = tuple(
        Words(found.words, found.start, found.end)
        for found in report_on_contradiction(text, refusal).findings
        if found.words is not None and found.start is not None and found.end is not None
    )
    # without words it is a limit of the reader, which is not the agents'
    return Contradiction(refusal, words) if words else None

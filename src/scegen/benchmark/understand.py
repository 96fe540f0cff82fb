"""How much of a labelled file is understood: per field, as a whole, per kind and hazard."""

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

from scegen.benchmark.stability import Stability, facts
from scegen.benchmark.tallies import Tally, count_hazards, count_participants, table
from scegen.errors import InfeasibleError, InputError, NotTrafficError
from scegen.scenario.functional import FunctionalScenario
from scegen.understanding import Case, read, score


@dataclass(frozen=True, slots=True)
class Record:
    """A description and what must be true of it when it runs."""

    id: str
    text: str
    facts: dict[str, Any]


Described = Case | Record
Understand = Callable[[Described, int], FunctionalScenario]
"""Reads a description; the number counts the runs over it, from 1."""


class StoppedError(Exception):
    """Nobody can be asked any more; what is scored so far stands."""


@dataclass(frozen=True, slots=True)
class Failure:
    """A description that is not understood as a whole in some runs, with what is wrong."""

    case: str
    text: str
    problems: tuple[str, ...]
    runs: tuple[int, ...] = (1,)


@dataclass(slots=True)
class Result:
    """The score of a file.

    There are more ``readings`` than ``cases`` where each is read again; ``understood`` of them hold
    as a whole. ``fields`` tell how often each holds and how often it is judged, ``kinds`` and
    ``hazards`` are by kind, ``held`` is by (description, run). ``stopped`` is why the ``left`` ones
    were not read.
    """

    cases: int = 0
    readings: int = 0
    understood: int = 0
    fields: dict[str, tuple[int, int]] = field(default_factory=dict)
    kinds: dict[str, Tally] = field(default_factory=dict)
    hazards: dict[str, Tally] = field(default_factory=dict)
    failures: list[Failure] = field(default_factory=list)
    stability: Stability = field(default_factory=Stability)
    held: dict[tuple[str, int], bool] = field(default_factory=dict)
    stopped: str | None = None
    left: int = 0

    @property
    def all_fields(self) -> tuple[int, int]:
        """How many judged fields hold, and how many there are."""
        return sum(h for h, _ in self.fields.values()), sum(n for _, n in self.fields.values())

    @property
    def perfect(self) -> bool:
        """Whether everything was read and understood."""
        return self.stopped is None and self.understood == self.readings

    def to_data(self) -> dict[str, Any]:
        """The result as data that JSON can hold."""
        held, judged = self.all_fields
        return {
            "cases": self.cases,
            "readings": self.readings,
            "understood": self.understood,
            "fields_held": held,
            "fields_judged": judged,
            "fields": {k: {"held": h, "judged": n} for k, (h, n) in sorted(self.fields.items())},
            "participants": table(self.kinds),
            "hazards": table(self.hazards),
            "failures": [asdict(failure) for failure in self.failures],
            "stability": self.stability.to_data(),
            "stopped": self.stopped,
            "left": self.left,
        }


def offline(case: Described, _run: int) -> FunctionalScenario:
    """What the offline reader makes of a description."""
    return read(case.text)


def run(
    cases: Sequence[Case],
    understand: Understand = offline,
    *,
    repeat: int = 1,
    told: Callable[[str], None] = lambda _: None,
) -> Result:
    """Scores labelled descriptions.

    ``understand`` raises :class:`StoppedError` where it cannot go on; ``told`` hears of each
    reading.
    """
    result = Result(stability=Stability(runs=repeat))
    for number, case in enumerate(cases, start=1):
        try:
            readings = []
            for k in range(1, repeat + 1):
                readings.append(_reading(case, k, understand))
                result.readings += 1
                result.held[case.id, k] = not readings[-1].problems
                again = f", run {k}" if repeat > 1 else ""
                outcome = "; ".join(readings[-1].problems) or "understood"
                told(f"{number}/{len(cases)} {case.id}{again}: {outcome}")
        except StoppedError as stop:
            result.stopped = str(stop)
        except KeyboardInterrupt:
            result.stopped = "interrupted"
        _add(result, case, readings)
        if result.stopped is not None:
            break
    result.left = len(cases) - result.cases
    return result


def about_the_text(error: InputError) -> bool:
    """Whether it is the description that cannot be used, and not a setting or a recording."""
    return isinstance(error, NotTrafficError | InfeasibleError) or error.where == "description"


@dataclass(frozen=True, slots=True)
class _Reading:
    """What came of reading a description once; the scenario is None where it was refused."""

    scenario: FunctionalScenario | None
    fields: dict[str, bool]
    problems: tuple[str, ...]


def _reading(case: Case, number: int, understand: Understand) -> _Reading:
    try:
        scenario = understand(case, number)
    except InputError as error:
        if not about_the_text(error):
            raise
        # every judged field of a description that was refused is wrong
        return _Reading(None, dict.fromkeys(case.expect, False), (error.render(),))
    judged = score(case.expect, scenario)
    return _Reading(scenario, dict(judged.fields), judged.problems)


def _add(result: Result, case: Case, readings: list[_Reading]) -> None:
    """The readings of one description."""
    result.cases += bool(readings)
    failed: dict[tuple[str, ...], list[int]] = {}
    for number, reading in enumerate(readings, start=1):
        result.understood += not reading.problems
        for name, holds in reading.fields.items():
            held, judged = result.fields.get(name, (0, 0))
            result.fields[name] = (held + holds, judged + 1)
        count_participants(result.kinds, case.expect, reading.scenario)
        count_hazards(result.hazards, case.expect, reading.scenario)
        if reading.problems:
            failed.setdefault(reading.problems, []).append(number)
    for problems, runs in failed.items():
        result.failures.append(Failure(case.id, case.text, problems, tuple(runs)))
    result.stability.add([(facts(r.scenario), r.fields) for r in readings])

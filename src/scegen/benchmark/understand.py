"""How much of a labelled file is understood: per field, as a whole, per kind and hazard."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

from scegen.errors import ScegenError
from scegen.scenario.functional import FunctionalScenario
from scegen.understanding import Case, read, score

Understand = Callable[[str], FunctionalScenario]


@dataclass(slots=True)
class Tally:
    """Right finds, wrong finds and misses of one kind.

    What a label allows without asking for it counts neither way.
    """

    right: int = 0
    wrong: int = 0
    missed: int = 0

    @property
    def precision(self) -> float:
        """Share of the finds that are right; 1 if there are none."""
        found = self.right + self.wrong
        return self.right / found if found else 1.0

    @property
    def recall(self) -> float:
        """Share of what is there that was found; 1 if nothing is there."""
        there = self.right + self.missed
        return self.right / there if there else 1.0

    @property
    def f1(self) -> float:
        """Harmonic mean of precision and recall."""
        both = 2 * self.right + self.wrong + self.missed
        return 2 * self.right / both if both else 1.0

    def to_data(self) -> dict[str, float]:
        """Counts and shares as data that JSON can hold."""
        shares = {"precision": self.precision, "recall": self.recall, "f1": self.f1}
        return asdict(self) | {name: round(share, 4) for name, share in shares.items()}


@dataclass(frozen=True, slots=True)
class Failure:
    """A description that is not understood as a whole, with what is wrong."""

    case: str
    text: str
    problems: tuple[str, ...]


@dataclass(slots=True)
class Result:
    """The score of a file.

    Attributes:
        cases: number of descriptions.
        understood: how many of them hold as a whole.
        fields: field -> (how often it holds, how often it is judged).
        kinds: participant kind -> its tally.
        hazards: hazard kind -> its tally.
        failures: the descriptions that do not hold.
    """

    cases: int = 0
    understood: int = 0
    fields: dict[str, tuple[int, int]] = field(default_factory=dict)
    kinds: dict[str, Tally] = field(default_factory=dict)
    hazards: dict[str, Tally] = field(default_factory=dict)
    failures: list[Failure] = field(default_factory=list)

    @property
    def all_fields(self) -> tuple[int, int]:
        """How many judged fields hold, and how many there are."""
        return sum(h for h, _ in self.fields.values()), sum(n for _, n in self.fields.values())

    def to_data(self) -> dict[str, Any]:
        """The result as data that JSON can hold."""
        held, judged = self.all_fields
        return {
            "cases": self.cases,
            "understood": self.understood,
            "fields_held": held,
            "fields_judged": judged,
            "fields": {k: {"held": h, "judged": n} for k, (h, n) in sorted(self.fields.items())},
            "participants": _table(self.kinds),
            "hazards": _table(self.hazards),
            "failures": [asdict(f) for f in self.failures],
        }


def total(tallies: Mapping[str, Tally]) -> Tally:
    """All tallies added up.

    Args:
        tallies: kind -> tally.
    """
    added = Tally()
    for tally in tallies.values():
        added.right += tally.right
        added.wrong += tally.wrong
        added.missed += tally.missed
    return added


def run(cases: Iterable[Case], understand: Understand = read) -> Result:
    """Scores labelled descriptions.

    Args:
        cases: descriptions with labels.
        understand: who reads them, the offline reader unless said otherwise.
    """
    result = Result()
    for case in cases:
        result.cases += 1
        try:
            scenario = understand(case.text)
        except ScegenError as error:
            _not_read(result, case, error)
            continue
        judged = score(case.expect, scenario)
        for name, holds in judged.fields.items():
            _count(result, name, holds=holds)
        _participants(result, case.expect, scenario)
        _hazards(result, case.expect, {h.kind.value for h in scenario.hazards})
        if judged.understood:
            result.understood += 1
        else:
            result.failures.append(Failure(case.id, case.text, judged.problems))
    return result


def _not_read(result: Result, case: Case, error: ScegenError) -> None:
    """Every judged field of a description that was refused is wrong."""
    for name in case.expect:
        _count(result, name, holds=False)
    for kind, (fewest, _) in case.expect.get("actors", {}).items():
        result.kinds.setdefault(kind, Tally()).missed += fewest
    _hazards(result, case.expect, set())
    result.failures.append(Failure(case.id, case.text, (error.render(),)))


def _count(result: Result, name: str, *, holds: bool) -> None:
    held, judged = result.fields.get(name, (0, 0))
    result.fields[name] = (held + holds, judged + 1)


def _participants(result: Result, expect: Mapping[str, Any], scenario: FunctionalScenario) -> None:
    if "actors" not in expect:
        return
    found = Counter(
        f"parked_{p.kind.value}" if p.parked else p.kind.value for p in scenario.participants
    )
    wanted: Mapping[str, list[int]] = expect["actors"]
    for kind in sorted({*found, *wanted}):
        fewest, most = wanted.get(kind, (0, 0))
        tally = result.kinds.setdefault(kind, Tally())
        tally.right += min(found[kind], most)
        tally.wrong += max(0, found[kind] - most)
        tally.missed += max(0, fewest - found[kind])


def _hazards(result: Result, expect: Mapping[str, Any], found: set[str]) -> None:
    if "hazards" not in expect:
        return
    must, may = set(expect["hazards"]["must"]), set(expect["hazards"]["may"])
    for kind in sorted(must | (found - may)):
        tally = result.hazards.setdefault(kind, Tally())
        tally.right += kind in must and kind in found
        tally.wrong += kind not in must
        tally.missed += kind not in found


def _table(tallies: Mapping[str, Tally]) -> dict[str, dict[str, float]]:
    rows = {kind: tally.to_data() for kind, tally in sorted(tallies.items())}
    return rows | {"all": total(tallies).to_data()}

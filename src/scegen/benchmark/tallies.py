"""Finds, wrong finds and misses by kind: precision and recall of participants and hazards."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import asdict, astuple, dataclass
from typing import Any

from scegen.scenario.functional import FunctionalScenario


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


def total(tallies: Mapping[str, Tally]) -> Tally:
    """All tallies added up."""
    return Tally(*map(sum, zip(*map(astuple, tallies.values()), strict=True)))


def table(tallies: Mapping[str, Tally]) -> dict[str, dict[str, float]]:
    """The tallies and their total as data that JSON can hold."""
    rows = {kind: tally.to_data() for kind, tally in sorted(tallies.items())}
    return rows | {"all": total(tallies).to_data()}


def count_participants(
    tallies: dict[str, Tally], expect: Mapping[str, Any], scenario: FunctionalScenario | None
) -> None:
    """Adds the participants of a scenario, by kind; none where the text was refused."""
    if "actors" not in expect:
        return
    everybody = scenario.participants if scenario is not None else ()
    found = Counter(f"parked_{p.kind.value}" if p.parked else p.kind.value for p in everybody)
    wanted: Mapping[str, list[int]] = expect["actors"]
    for kind in sorted({*found, *wanted}):
        fewest, most = wanted.get(kind, (0, 0))
        tally = tallies.setdefault(kind, Tally())
        tally.right += min(found[kind], most)
        tally.wrong += max(0, found[kind] - most)
        tally.missed += max(0, fewest - found[kind])


def count_hazards(
    tallies: dict[str, Tally], expect: Mapping[str, Any], scenario: FunctionalScenario | None
) -> None:
    """Adds the hazards of a scenario, by kind; none where the text was refused."""
    if "hazards" not in expect:
        return
    found = {h.kind.value for h in scenario.hazards} if scenario is not None else set()
    must, may = set(expect["hazards"]["must"]), set(expect["hazards"]["may"])
    for kind in sorted(must | (found - may)):
        tally = tallies.setdefault(kind, Tally())
        tally.right += kind in must and kind in found
        tally.wrong += kind not in must
        tally.missed += kind not in found

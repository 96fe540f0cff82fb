"""What a report is made of: a small model of its own, free of checkers and pipelines."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from scegen.criticality.careful_driver import Verdict
from scegen.criticality.reactivity.sensitivity import Sensitivity
from scegen.report.gallery import Tiles
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalSet
from scegen.scenario.proof import Proof

if TYPE_CHECKING:  # what speaks to language models takes a tenth of a short run to load
    from scegen.understanding.agents import Understanding

VERDICTS = {"passed": "held", "failed": "failed"}
"""What the status of a check comes to, as statements do; any other one leaves it open."""


@dataclass(frozen=True, slots=True)
class CheckRow:
    """The result of one checker: its name, its status in one word, what it found."""

    checker: str
    status: str
    detail: str

    @property
    def verdict(self) -> str:
        """``held``, ``failed``, or ``open`` where nothing can be said."""
        return VERDICTS.get(self.status, "open")


@dataclass(frozen=True, slots=True)
class ConcreteEntry:
    """A concrete scenario, its folder as seen from the report, what the player plays, its checks.

    ``scene`` is from ``player.scene``, ``before`` that of the first timing, None where nothing was
    changed. The verdict and the sensitivity are None where nobody judged, the proof where nothing
    was searched. ``files`` are the names of what lies in the folder.
    """

    concrete: ConcreteScenario
    folder: str
    scene: dict[str, Any]
    before: dict[str, Any] | None = None
    checks: tuple[CheckRow, ...] = ()
    verdict: Verdict | None = None
    sensitivity: Sensitivity | None = None
    proof: Proof | None = None
    files: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class ReportInput:
    """Everything that the report shows; levels that the run did not pass through are None.

    ``skipped`` holds names of scenarios that could not be made, each with the reason; ``voice``
    is None where no language model was asked, ``tiles`` where none are drawn yet.
    """

    functional: FunctionalScenario | None
    logical_set: LogicalSet | None
    concretes: tuple[ConcreteEntry, ...] = ()
    skipped: tuple[tuple[str, str], ...] = ()
    voice: Understanding | None = None
    tiles: Tiles | None = None

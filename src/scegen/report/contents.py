"""What a report is made of: a small model of its own, free of checkers and pipelines."""

from __future__ import annotations

from dataclasses import dataclass

from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalSet


@dataclass(frozen=True, slots=True)
class CheckRow:
    """The result of one checker: its name, its status in one word, what it found."""

    checker: str
    status: str
    detail: str


@dataclass(frozen=True, slots=True)
class ConcreteEntry:
    """A concrete scenario, its picture, its folder as seen from the report, its checks."""

    concrete: ConcreteScenario
    preview_png: bytes
    folder: str
    checks: tuple[CheckRow, ...] = ()


@dataclass(frozen=True, slots=True)
class ReportInput:
    """Everything that the report shows; levels that the run did not pass through are None.

    ``skipped`` holds names of scenarios that could not be made, each with the reason.
    """

    functional: FunctionalScenario | None
    logical_set: LogicalSet | None
    concretes: tuple[ConcreteEntry, ...] = ()
    skipped: tuple[tuple[str, str], ...] = ()

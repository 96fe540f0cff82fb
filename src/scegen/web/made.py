"""What lies in a folder that was made: read from its files, whoever made it."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter

from scegen.checking.subject import CONCRETE_FILE, FUNCTIONAL_FILE, read_proof
from scegen.criticality.careful_driver import Verdict
from scegen.errors import InputError
from scegen.pipeline.folder import SUMMARY_FILE, summary_of
from scegen.pipeline.source import GIVEN_FILE
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import load, load_if_there, read_text
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.proof import Proof
from scegen.scenario.rule_file import RULES_FILE
from scegen.scenario.vocabulary import ArmsMode, Reduction

_SCENARIOS = "scenarios"


@dataclass(frozen=True, slots=True)
class MadeScenario:
    """One concrete scenario with its proof, and what the summary says of it."""

    name: str
    concrete: ConcreteScenario
    proof: Proof | None
    summary: dict[str, Any]

    @property
    def state(self) -> str:
        """What came of it: ``held``, ``failed``, or ``open`` where something was not reached.

        Failed: a check, or a statement that does not hold. Open: the target, a danger that was
        asked for, or a checker that could not run.
        """
        checks = self.summary.get("checks", {}).values()
        if "failed" in checks or (self.proof is not None and self.proof.missed):
            return "failed"
        reached = self.proof is None or self.proof.reached
        return "held" if reached and "not_run" not in checks else "open"

    @property
    def verdict(self) -> Verdict | None:
        """What a careful driver could have done; None if nobody judged it."""
        data = self.summary.get("verdict")
        if not isinstance(data, dict):
            return None
        far = data.get("distance_m")
        whole = {**data, "distance_m": float("inf") if far is None else far}
        return TypeAdapter(Verdict).validate_python(whole)


@dataclass(frozen=True, slots=True)
class Made:
    """A folder of ``scegen generate``, or one that holds a functional scenario alone.

    ``given`` are the numbers that a search began from, where it did not begin from a first timing;
    ``rules`` are those that the logical scenarios keep.
    """

    folder: Path
    functional: FunctionalScenario | None
    reduction: Reduction
    arms: ArmsMode
    rules: str
    given: ConcreteScenario | None
    scenarios: tuple[MadeScenario, ...]
    skipped: dict[str, str]
    summary: dict[str, Any]


def read_made(folder: Path) -> Made:
    """Read a folder.

    Raises:
        InputError: a file in it cannot be used; names it by its place in the folder.
    """
    summary = summary_of(folder)
    enumeration = summary.get("enumeration") or {}
    scenarios = []
    for row in summary.get("scenarios", []):
        place = folder / _SCENARIOS / str(row["name"])
        if place.resolve().parent != (folder / _SCENARIOS).resolve():
            raise InputError("names a scenario outside its folder", where=SUMMARY_FILE)
        concrete = load(place / CONCRETE_FILE, ConcreteScenario)
        scenarios.append(MadeScenario(str(row["name"]), concrete, read_proof(place), row))
    return Made(
        folder,
        load_if_there(folder / FUNCTIONAL_FILE, FunctionalScenario),
        Reduction(enumeration.get("reduction", Reduction.EXACT)),
        ArmsMode(enumeration.get("arms", ArmsMode.DISTINCT)),
        read_text(folder / RULES_FILE) if (folder / RULES_FILE).is_file() else "",
        load_if_there(folder / GIVEN_FILE, ConcreteScenario),
        tuple(scenarios),
        {str(k): str(v) for k, v in summary.get("skipped", {}).items()},
        summary,
    )

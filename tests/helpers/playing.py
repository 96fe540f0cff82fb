"""Random situations made whole, played, and judged by their claims in either simulation."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from scegen.checking.esmini.layout import simulated_csv
from scegen.checking.esmini.recording import read_recording
from scegen.checking.recording import record
from scegen.checking.said import recorded_view
from scegen.claims import claims_of, prove
from scegen.concretization import concretize
from scegen.criticality import raise_criticality
from scegen.enumeration import enumerate_scenarios
from scegen.errors import InfeasibleError
from scegen.pipeline.export import SCENARIO_FILE, export_scenario
from scegen.pipeline.picking import pick
from scegen.pipeline.raising import chosen_target
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.proof import ClaimProof, Proof


@dataclass(frozen=True)
class Played:
    """What became of a situation; ``refused`` says why nothing could be made of it."""

    functional: FunctionalScenario
    refused: str = ""
    concrete: ConcreteScenario | None = None
    proof: Proof | None = None
    recorded: tuple[ClaimProof, ...] = ()

    @property
    def missed(self) -> list[ClaimProof]:
        """Statements of which the program says that they do not hold."""
        return list(self.proof.missed) if self.proof else []

    @property
    def disagreeing(self) -> list[tuple[ClaimProof, ClaimProof]]:
        """Statements that are judged otherwise on the recording: ours, the player's."""
        ours = {claim.id: claim for claim in self.proof.claims} if self.proof else {}
        return [
            (ours[claim.id], claim)
            for claim in self.recorded
            if claim.id not in ours or ours[claim.id].holds is not claim.holds
        ]


def play(functional: FunctionalScenario, seed: int = 0, *, files: bool = True) -> Played:
    """Make one of its scenarios, raise its danger, and judge it twice.

    Once as the program does, and once on what runs: the ``files`` in esmini, where that is on PATH,
    else our own simulation from the numbers.
    """
    try:
        listed = enumerate_scenarios(functional, limit=50)
        # Others than the first are as good, and less often looked at.
        scenario = pick(listed, None)[seed % len(listed.scenarios)]
        concrete = concretize(functional, scenario, seed=seed)
        target = chosen_target(None, functional)
        raised = raise_criticality(functional, concrete, target=target, seed=seed)
    except InfeasibleError as error:
        return Played(functional, refused=error.render())
    claims = claims_of(functional, raised.concrete.logical, touching=_touching(raised.proof))
    csv = _played(raised.concrete) if files else simulated_csv(raised.concrete)
    recorded = prove(claims, recorded_view(raised.concrete, read_recording(csv)))
    return Played(functional, "", raised.concrete, raised.proof, recorded)


def _played(concrete: ConcreteScenario) -> str:
    with TemporaryDirectory() as folder:
        for name, content in export_scenario(concrete).items():
            (Path(folder) / name).write_bytes(content)
        return record(Path(folder) / SCENARIO_FILE, concrete).csv


def _touching(proof: Proof) -> tuple[str, ...]:
    return proof.pair if proof.target == "collision" else ()

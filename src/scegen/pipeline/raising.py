"""The stage between numbers and files: make the danger happen, or say why it does not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from time import perf_counter
from typing import TYPE_CHECKING

from scegen.criticality import OfflineProposer, Proposer, raise_criticality
from scegen.criticality.target import AVOIDED, COLLISION, NEAR_MISS, parse_target
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.proof import Advice, Proof
from scegen.scenario.wording import with_article

if TYPE_CHECKING:  # what speaks to language models takes a tenth of a short run to load
    from scegen.llm import Session

NO_SEARCH = "none"
_TARGETS: dict[OutcomeKind | None, str] = {
    OutcomeKind.COLLISION: COLLISION,
    OutcomeKind.AVOIDED: AVOIDED,
}


@dataclass(frozen=True, slots=True)
class Raising:
    """The scenarios with their danger raised, and proofs and seconds taken, by name.

    ``firsts`` are the first timings of those that the search has changed.

    ``skipped`` are solutions asked for that were not found, and why.
    """

    concretes: list[ConcreteScenario]
    proofs: dict[str, Proof] = field(default_factory=dict)
    firsts: dict[str, ConcreteScenario] = field(default_factory=dict)
    search_s: dict[str, float] = field(default_factory=dict)
    skipped: dict[str, str] = field(default_factory=dict)


def chosen_target(asked: str | None, functional: FunctionalScenario | None) -> str | None:
    """The target of a run, which follows from the outcome if it is not given; None: no search.

    Numbers that somebody gave (``functional`` is None) are not touched unless a target is asked
    for.

    Raises:
        InputError: the option names no target.
    """
    if asked is None:
        if functional is None:
            return None
        outcome = functional.outcome.kind if functional.outcome else None
        alone = len(functional.participants) + len(functional.objects) == 1
        return _TARGETS.get(outcome, AVOIDED if alone else NEAR_MISS)
    return None if asked.strip().lower() == NO_SEARCH else parse_target(asked).text


def raise_danger(
    functional: FunctionalScenario | None,
    concrete: ConcreteScenario,
    target: str | None,
    seed: int,
    progress: Callable[[str], None],
    session: Session | None = None,
    *,
    solutions: int = 1,
) -> Raising:
    """Raise the danger of a scenario; without a target it stays as it is.

    Different solutions are told apart by a number at the end of their names. The models of
    ``session`` propose where the search begins, or the offline rules.
    """
    if target is None:
        return Raising([concrete])
    proposer: Proposer = OfflineProposer()
    if session is not None:
        from scegen.criticality.agent import ParameterAgent  # noqa: PLC0415 - see above

        proposer = ParameterAgent(session, progress)
    progress(f"searching for {with_article(str(target))} in {concrete.name}")
    begin = perf_counter()
    result = raise_criticality(
        functional,
        concrete,
        target=target,
        seed=seed,
        solutions=solutions,
        proposer=proposer,
        progress=progress,
    )
    raising = Raising([], search_s={concrete.name: perf_counter() - begin})
    found = [(result.concrete, result.proof), *result.others]
    if result.proof.in_band and len(found) < solutions:
        name = f"{concrete.name}, solution {len(found) + 1}"
        raising.skipped[name] = f"no more than {len(found)} that differ were found"
    for number, (made, proof) in enumerate(found, start=1):
        name = concrete.name if number == 1 else f"{concrete.name[:96]}-{number}"
        raising.concretes.append(made.but(name=name))
        raising.proofs[name] = proof
        if proof.changed:
            raising.firsts[name] = concrete
    return raising


def proof_summary(proof: Proof | None) -> dict[str, object]:
    """What ``summary.json`` says of a search; nothing without one."""
    if proof is None:
        return {}
    measure = proof.of(proof.measure)
    return {
        "claims": {
            "asked": len(proof.claims),
            "hold": len(proof.claims) - len(proof.missed),
            "statements": [claim.model_dump(mode="json") for claim in proof.claims],
        },
        "danger": {
            "target": proof.target,
            "in_band": proof.in_band,
            "measure": proof.measure,
            "pair": list(proof.pair),
            "before": measure.before if measure else None,
            "after": measure.after if measure else None,
            "hazards": {
                "asked": len(proof.hazards),
                "happened": [str(h.kind) for h in proof.hazards if h.happened],
                "missing": [str(h.kind) for h in proof.hazards if not h.happened],
            },
            "blocked_by": proof.blocked_by,
            "proposals": _advice_summary(proof.advice),
        },
    }


def _advice_summary(advice: Advice | None) -> dict[str, object] | None:
    """Who proposed the numbers that the search began at, and what became of them."""
    if advice is None:
        return None
    return {
        "by": advice.speaker,
        "accepted": advice.accepted,
        "replaced": advice.replaced,
        "dropped": advice.dropped,
        "led": advice.led,
        "notes": list(advice.notes),
    }

"""Which of the logical scenarios are made: those in which all that is said holds come first."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING

from scegen.concretization import concretize
from scegen.criticality.target import AVOIDED, COLLISION, NEAR_MISS
from scegen.errors import InfeasibleError
from scegen.pipeline.options import Options
from scegen.pipeline.raising import Raising, raise_danger
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.outcome import Outcome, OutcomeKind
from scegen.scenario.proof import Proof
from scegen.scenario.wording import counted

if TYPE_CHECKING:  # what speaks to language models takes a tenth of a short run to load
    from scegen.llm import Session

MOST_SPARE = 7
"""So many more scenarios are tried than are asked for, where no number names them."""


def make_one(
    functional: FunctionalScenario,
    scenario: LogicalScenario,
    target: str | None,
    seed: int,
    progress: Callable[[str], None] = lambda _: None,
    session: Session | None = None,
    *,
    solutions: int = 1,
    free: bool = False,
) -> Raising:
    """One logical scenario made concrete in memory, its danger raised, its claims proved.

    Where nobody asked for the target (it is ``free``) or tells of the end, and all that is said
    allows of no near miss, nobody is endangered, or they touch.

    Raises:
        InfeasibleError: it cannot be made.
    """
    wanted = functional
    if target == COLLISION and functional.outcome is None:  # asked for, so nobody brakes for it
        wanted = functional.but(outcome=Outcome(kind=OutcomeKind.COLLISION))
    concrete = concretize(wanted, scenario, seed=seed)
    raising = raise_danger(
        functional, concrete, target, seed, progress, session, solutions=solutions
    )
    if not (free and target == NEAR_MISS):
        return raising
    other = partial(make_one, functional, scenario, seed=seed, progress=progress, session=session,
                    solutions=solutions)  # fmt: skip
    return _or_otherwise(functional, raising, other)


def _or_otherwise(
    functional: FunctionalScenario, raising: Raising, other: Callable[..., Raising]
) -> Raising:
    """What comes of it where nobody tells of the end, and what is said allows of no near miss.

    Nobody is endangered, if all that is said holds so (no model is asked for that); else they
    touch.
    """
    if _flaws(raising) == (0, 0) or functional.outcome is not None:
        return raising
    for asked in ({"target": AVOIDED, "session": None}, {"target": COLLISION}):
        try:
            found = other(**asked)
        except InfeasibleError:  # no way to touch: the near miss, and why it fails, is told
            continue
        if _flaws(found) == (0, 0):
            name, proof = next(iter(raising.proofs.items()))
            found.skipped[f"{name}, a near miss"] = _why(proof)
            return found
    return raising


def make_some(
    functional: FunctionalScenario,
    picked: Sequence[LogicalScenario],
    target: str | None,
    options: Options,
    progress: Callable[[str], None],
    session: Session | None = None,
) -> Raising:
    """Concrete scenarios of the logical ones, as many as are asked for, their danger raised.

    Those that were picked by name are made whatever comes of them. Of the others, one in which a
    statement does not hold or the target is not reached is made only if no other will do, and
    before that the first that ends otherwise, if nobody asked for the target; what was passed
    over is told.

    Raises:
        InfeasibleError: none of them can be made.
    """
    wanted = len(picked) if options.pick else min(options.count, len(picked))
    most = len(picked) if options.pick else wanted + MOST_SPARE
    tried: dict[str, Raising] = {}
    skipped: dict[str, str] = {}

    solutions, free = options.solutions, options.target is None
    make = partial(make_one, functional, seed=options.seed, progress=progress, session=session,
                   solutions=solutions)  # fmt: skip

    def good() -> int:
        return sum(_flaws(raising) == (0, 0) for raising in tried.values())

    for scenario in picked:
        name = scenario.name
        if len(tried) >= most or (wanted <= good() and not options.pick):
            break
        progress(f"concretizing {name}")
        try:
            tried[name] = make(scenario, target=target, free=free and bool(options.pick))
        except InfeasibleError as error:
            skipped[name] = error.render()
    otherwise = free and target == NEAR_MISS and not options.pick
    for name in sorted(tried, key=lambda name: _flaws(tried[name])) if otherwise else ():
        if good():
            break
        scenario = next(each for each in picked if each.name == name)
        tried[name] = _or_otherwise(functional, tried[name], partial(make, scenario))
    if not tried:
        name, reason = next(iter(skipped.items()))
        more = f" (and {len(skipped) - 1} more)" if len(skipped) > 1 else ""
        raise InfeasibleError(f"none of the scenarios can be made: {name}{more}: {reason}")
    made = list(tried.values())
    chosen = made if options.pick else sorted(made, key=_flaws)[:wanted]
    passed_over = {
        name: _why(proof)
        for raising in made
        if all(raising is not taken for taken in chosen)
        for name, proof in list(raising.proofs.items())[:1]
    }
    return _joined(chosen, skipped | passed_over)


def _flaws(raising: Raising) -> tuple[int, int]:
    """Statements that do not hold, targets that are not reached."""
    proofs = raising.proofs.values()
    return sum(len(p.missed) for p in proofs), sum(not p.in_band for p in proofs)


def _why(proof: Proof) -> str:
    """Why a scenario was passed over for another."""
    if proof.missed:
        missed = "; ".join(claim.statement for claim in proof.missed[:3])
        do = "does" if len(proof.missed) == 1 else "do"
        counts = f"{len(proof.missed)} of {counted(len(proof.claims), 'statement')}"
        return f"passed over: {counts} {do} not hold ({missed})"
    return f"passed over: the target is not reached ({proof.blocked_by or proof.target})"


def _joined(chosen: Sequence[Raising], skipped: dict[str, str]) -> Raising:
    joined = Raising([], skipped=dict(skipped))
    for raising in chosen:
        joined.concretes.extend(raising.concretes)
        joined.proofs.update(raising.proofs)
        joined.firsts.update(raising.firsts)
        joined.search_s.update(raising.search_s)
        joined.skipped.update(raising.skipped)
    return joined

"""scegen generate: all stages."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from scegen.cli.console import result, say, working
from scegen.cli.llm import Asked, Listener, asks_models, tell_proposals
from scegen.cli.options import (
    ArmsOption,
    ReductionOption,
    RulesOption,
    SeedOption,
    WhereOption,
    rules_of,
)
from scegen.cli.parse_report import tell_unsupported
from scegen.pipeline.options import CheckDepth, EgoMode, Options, OscVersion
from scegen.scenario.vocabulary import ArmsMode, Reduction
from scegen.scenario.wording import counted

if TYPE_CHECKING:
    from scegen.pipeline.generate import Result
    from scegen.scenario.functional import FunctionalScenario
    from scegen.scenario.proof import Proof


@asks_models
def generate(
    source: Annotated[
        str,
        typer.Argument(
            metavar="TEXT|FILE|-",
            help="A description, or a file: text, functional.yaml, logical.json, concrete.yaml; "
            "- reads standard input.",
        ),
    ],
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder to make.")],
    pick: Annotated[
        str | None,
        typer.Option(help="Logical scenarios to make: all, numbers (3), ranges (0-4), names."),
    ] = None,
    count: Annotated[
        int, typer.Option(help="How many to make where --pick names none, richest first.")
    ] = 1,
    seed: SeedOption = 0,
    reduction: ReductionOption = Reduction.EXACT,
    arms: ArmsOption = ArmsMode.DISTINCT,
    osc: Annotated[OscVersion, typer.Option(help="Version of OpenSCENARIO.")] = OscVersion.V1_0,
    check: Annotated[
        CheckDepth, typer.Option(help="quick leaves out the ASAM checkers.")
    ] = CheckDepth.QUICK,
    force: Annotated[
        bool, typer.Option("--force", help="Replace what somebody has changed there, too.")
    ] = False,
    ego: Annotated[
        EgoMode, typer.Option(help="external writes the ego without motion, for your own driver.")
    ] = EgoMode.SCRIPTED,
    target: Annotated[
        str | None,
        typer.Option(
            help="What the danger is raised to: near-miss (default), collision, pet=0.3..1.0, "
            "ttc=…, distance=…, headway=…, drac=…, or none. A concrete.yaml stays as it is "
            "unless this is given."
        ),
    ] = None,
    solutions: Annotated[
        int, typer.Option(min=1, help="How many different ways to reach the target.")
    ] = 1,
    where: WhereOption = None,
    rules: RulesOption = None,
    json: Annotated[bool, typer.Option("--json", help="Print summary.json.")] = False,
    *,
    models: Asked,
) -> None:
    """Make simulator files from a description (or from any level, edited by hand)."""
    from scegen.pipeline.folder import require_usable
    from scegen.pipeline.generate import generate as run
    from scegen.pipeline.source import origin_of, resolve_source

    settings = models.settings()
    with working() as progress:
        progress("understanding")
        options = Options(
            pick=pick,
            count=count,
            seed=seed,
            reduction=reduction,
            arms=arms,
            osc=osc,
            depth=check,
            force=force,
            ego=ego,
            target=target,
            solutions=solutions,
            where=where,
            rules=rules_of(rules),
        )
        require_usable(output, force=force)  # before a model is paid for
        listener = Listener(settings, progress)
        scenario, origin = resolve_source(source, listener), origin_of(source)
        listener.tell()
        understanding, session = listener.understanding, listener.session
        made = run(scenario, output, options, progress, understanding, session, origin)
        if session is not None:
            tell_proposals(session, made.proofs.values())
    if json:
        result((output / "summary.json").read_text(encoding="utf-8"))
    else:
        _tell(made)
    if not made.ok:
        raise typer.Exit(1)


def _tell(made: Result) -> None:
    functional, logical = made.functional, made.logical
    if functional is not None:
        tell_unsupported(functional)
    if logical is not None:
        certificate = logical.certificate
        say(
            f"{counted(certificate.total, 'assignment')}, "
            f"{counted(certificate.count, 'distinct scenario')} "
            f"(reduction {logical.reduction}, arms {logical.arms})"
        )
    for name, reason in made.skipped.items():
        say(f"skipped {name}: {reason}")
    for name, proof in made.proofs.items():
        for line in _proof_lines(proof, functional):
            say(f"{name}: {line}")
    for name, report in made.checks.items():
        told = made.proofs[name].missed if name in made.proofs else ()
        told_above = {(f"said.{claim.kind}", claim.field) for claim in told}
        states = ", ".join(f"{r.checker} {r.status}" for r in report.results)
        result(f"{made.folder / 'scenarios' / name}  {states}".rstrip())
        for item in report.results:
            for finding in item.errors:
                if (finding.rule, finding.place) in told_above:
                    continue
                say(f"  {item.checker}: {finding.place}: {finding.message} [{finding.rule}]")
    if logical is not None and len(made.checks) < (there := len(logical.scenarios)):
        listed = " listed" if there < logical.certificate.count else ""
        say(f"made {len(made.checks)} of {there:,}{listed}; more with --count or --pick")
    say(f"open {made.folder / 'report.html'}")


def _proof_lines(proof: Proof, functional: FunctionalScenario | None) -> Iterator[str]:
    """A line on the target, one on all statements, and one for each that does not hold."""
    measure = proof.of(proof.measure)
    values = "" if measure is None else f" ({measure.in_words})"
    pair = " and ".join(proof.pair)
    if proof.in_band:
        about = f" of {pair}: {proof.measure}{values}" if pair else ": nobody else is on the road"
        yield f"{proof.target}{about}"
    elif not pair:
        yield f"TARGET NOT REACHED: {proof.target}: {proof.blocked_by or 'there is no pair'}"
    else:
        why = f"; {proof.blocked_by}" if proof.blocked_by else ""
        yield f"TARGET NOT REACHED: {proof.target} of {pair}: {proof.measure}{values}{why}"
    if proof.claims:
        unjudged = functional.unjudged if functional is not None else None
        yield f"{proof.held}; {unjudged}" if unjudged else proof.held
    for claim in proof.missed:
        words = f' ("{claim.words}")' if claim.words else ""
        yield f"DOES NOT HOLD: {claim.statement}{words}: {claim.found}"
        yield f"  what would help: {claim.helps}"

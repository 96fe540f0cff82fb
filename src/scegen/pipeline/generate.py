"""All stages in a row, from a source at any level to a finished folder."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from scegen.checking import CHECKERS, QUICK_CHECKERS, CheckReport, check_files
from scegen.checking.subject import FUNCTIONAL_FILE, PROOF_FILE
from scegen.criticality import prove_as_it_is
from scegen.enumeration import LIST_LIMIT, enumerate_scenarios
from scegen.errors import InputError, NoScenarioError
from scegen.pipeline.attempts import make_some
from scegen.pipeline.command import recipe
from scegen.pipeline.contents import Made, folder_files
from scegen.pipeline.export import export_scenario
from scegen.pipeline.folder import replace_content, require_usable, write_files
from scegen.pipeline.judging import Judged, judge
from scegen.pipeline.options import CheckDepth, Options
from scegen.pipeline.picking import pick
from scegen.pipeline.raising import Raising, chosen_target, raise_danger
from scegen.pipeline.source import Origin, Source
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import to_json, to_yaml
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalSet
from scegen.scenario.proof import Proof

if TYPE_CHECKING:  # what speaks to language models takes a tenth of a short run to load
    from scegen.llm import Session
    from scegen.understanding.agents import Understanding

Progress = Callable[[str], None]
_CHECKERS = {CheckDepth.NONE: (), CheckDepth.QUICK: QUICK_CHECKERS, CheckDepth.FULL: CHECKERS}


@dataclass(frozen=True, slots=True)
class Result:
    """What was made: scenario folders by name, their checks, and what could not be made.

    ``proofs`` say what the search for danger has reached, ``search_s`` how long it took,
    ``judged`` what the careful driver makes of it.
    """

    folder: Path
    functional: FunctionalScenario | None
    logical: LogicalSet | None
    checks: dict[str, CheckReport]
    skipped: dict[str, str]
    proofs: dict[str, Proof] = field(default_factory=dict)
    search_s: dict[str, float] = field(default_factory=dict)
    judged: dict[str, Judged] = field(default_factory=dict)
    target_asked: bool = False

    @property
    def ok(self) -> bool:
        """Whether no check failed, all that is said holds, and targets asked for are reached."""
        proofs = self.proofs.values()
        reached = not self.target_asked or all(proof.in_band for proof in proofs)
        said = not any(proof.missed for proof in proofs)
        return said and reached and all(report.ok for report in self.checks.values())


def generate(
    source: Source,
    folder: Path,
    options: Options,
    progress: Progress = lambda _: None,
    understanding: Understanding | None = None,
    session: Session | None = None,
    origin: Origin | None = None,
) -> Result:
    """Make the folder ``folder`` from ``source``; it is written whole or not at all.

    ``understanding`` says how language models came to the source, if they did; those of ``session``
    propose numbers. Numbers that somebody changed are held against the ``origin`` they had.

    Raises:
        InputError: the source, the options or the folder cannot be used.
        InfeasibleError: nothing with these properties exists.
    """
    require_usable(folder, force=options.force)
    if options.count < 1:
        raise InputError(f"must be at least 1, not {options.count}", where="--count")
    if options.solutions < 1:
        raise InputError(f"must be at least 1, not {options.solutions}", where="--solutions")
    functional = source if isinstance(source, FunctionalScenario) else None
    logical = source if isinstance(source, LogicalSet) else None
    if functional is not None:
        progress("enumerating logical scenarios")
        logical = enumerate_scenarios(
            functional,
            reduction=options.reduction,
            arms=options.arms,
            limit=LIST_LIMIT,
            where=options.where,
            rules=options.rules,
        )
        if not logical.scenarios:
            raise NoScenarioError("no scenario is as asked for", where=f"--where {options.where}")
    elif options.where or options.rules:
        raise InputError(
            "--where and --rules narrow the enumeration of a functional scenario",
            hint="Name a functional.yaml or a description, or leave them out.",
        )
    elif options.pick and isinstance(source, ConcreteScenario):
        raise InputError(
            "a concrete scenario is one: there is nothing to pick",
            where="--pick",
            hint="Name a logical.json, or leave it out.",
        )
    if logical is not None:
        functional = logical.functional
    origin = origin if isinstance(source, ConcreteScenario) and origin is not None else Origin()
    raised = _raised(source, logical, options, progress, session, origin)
    known, listed = functional or origin.functional, logical or origin.logical
    concretes, proofs, skipped = raised.concretes, raised.proofs, raised.skipped

    with tempfile.TemporaryDirectory(prefix="scegen-") as staging:
        staged = Path(staging)
        files: dict[str, dict[str, bytes]] = {}
        for concrete in concretes:
            progress(f"writing {concrete.name}")
            files[concrete.name] = export_scenario(concrete, osc=options.osc, ego=options.ego)
            if concrete.name in proofs:
                proof = to_json(proofs[concrete.name])
                files[concrete.name][PROOF_FILE] = proof.encode()
            write_files(staged / "scenarios" / concrete.name, files[concrete.name])
        if known is not None:
            write_files(staged, {FUNCTIONAL_FILE: to_yaml(known).encode()})
        progress("checking")
        checks = _checks(staged, [concrete.name for concrete in concretes], options.depth)
        progress("judging")
        judged = {c.name: judge(c, proofs.get(c.name)) for c in concretes}
        made = [
            Made(
                c,
                files[c.name],
                checks[c.name],
                judged[c.name],
                proofs.get(c.name),
                raised.firsts.get(c.name),
            )
            for c in concretes
        ]
        progress("drawing the report")
        write_files(
            staged,
            folder_files(
                known,
                listed,
                made,
                skipped,
                options.seed,
                recipe(source, concretes, options),
                understanding,
                session.usage if session is not None else None,
            ),
        )
        replace_content(folder, staged)
    asked = options.target is not None
    return Result(
        folder, functional, logical, checks, skipped, proofs, raised.search_s, judged, asked
    )


def _raised(
    source: Source,
    logical: LogicalSet | None,
    options: Options,
    progress: Progress,
    session: Session | None,
    origin: Origin,
) -> Raising:
    """The concrete scenarios asked for, their danger raised."""
    target = chosen_target(options.target, None if logical is None else logical.functional)
    if logical is not None:
        picked = pick(logical, options.pick)
        return make_some(logical.functional, picked, target, options, progress, session)
    if not isinstance(source, ConcreteScenario):  # a source is of one of the three levels
        raise InputError("has no logical scenarios")
    seed, solutions = options.seed, options.solutions
    if origin.functional and origin.target and options.target is None:
        proof = prove_as_it_is(origin.functional, source, target=origin.target)
        return Raising([source], {source.name: proof})
    return raise_danger(
        origin.functional, source, target, seed, progress, session, solutions=solutions
    )


def _checks(staged: Path, names: list[str], depth: CheckDepth) -> dict[str, CheckReport]:
    places = [staged / "scenarios" / name for name in names]
    reports = check_files(places, _CHECKERS[depth])
    return {
        name: CheckReport(f"scenarios/{name}", report.results)
        for name, report in zip(names, reports, strict=True)
    }

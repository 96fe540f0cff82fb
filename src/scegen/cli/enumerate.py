"""scegen enumerate: list, count, narrow and choose logical scenarios."""

from __future__ import annotations

from collections import deque
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from scegen.cli.certificates import (
    coverage_json,
    coverage_lines,
    head,
    line,
    tell_claim,
    tell_count,
)
from scegen.cli.console import result, say, write_bytes
from scegen.cli.gallery import require_picture, write_picture
from scegen.cli.listing import listing_under_way, stream_json, stream_lines, write_json
from scegen.cli.options import (
    ArmsOption,
    JsonFlag,
    ReductionOption,
    RulesOption,
    WhereOption,
    rules_of,
)
from scegen.errors import InputError
from scegen.scenario.vocabulary import ArmsMode, Reduction
from scegen.scenario.wording import covering

if TYPE_CHECKING:
    from scegen.enumeration.choosing.coverage import Coverage
    from scegen.scenario.functional import FunctionalScenario
    from scegen.scenario.logical import LogicalSet


MOST_COMPARED = 200_000
"""Of more scenarios than this, only a selection is looked at to rank, sample or cover."""


def enumerate_(
    source: Annotated[
        str | None,
        typer.Argument(
            metavar="FUNCTIONAL|TEXT|-", help="functional.yaml or a text; - reads standard input."
        ),
    ] = None,
    reduction: ReductionOption = Reduction.EXACT,
    arms: ArmsOption = ArmsMode.DISTINCT,
    count_only: Annotated[bool, typer.Option("--count-only", help="Count, do not list.")] = False,
    limit: Annotated[
        int, typer.Option(min=1, help="Of more than so many, list a selection that covers them.")
    ] = 2000,
    every: Annotated[bool, typer.Option("--all", help="List all, however many.")] = False,
    where: WhereOption = None,
    rules: RulesOption = None,
    rank: Annotated[bool, typer.Option("--rank", help="Richest in conflicts first.")] = False,
    sample: Annotated[
        int | None, typer.Option(min=1, help="Choose so many that differ as much as possible.")
    ] = None,
    cover: Annotated[
        bool, typer.Option("--cover", help="Choose the fewest that cover every meeting.")
    ] = False,
    coverage: Annotated[
        bool, typer.Option("--coverage", help="Show which meetings are covered, which missing.")
    ] = False,
    entries: Annotated[
        str | None, typer.Option(help="Entry arms of free cars, such as 0,1,2, instead of a file.")
    ] = None,
    junction_arms: Annotated[
        int | None, typer.Option(min=2, max=8, help="With --entries: arms of the junction.")
    ] = None,
    gallery: Annotated[
        Path | None, typer.Option(help="Draw the scenarios to this file, .svg or .png.")
    ] = None,
    json: JsonFlag = False,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write logical.json to this file.")
    ] = None,
) -> None:
    """List, count or choose among all logical scenarios of a functional one."""
    from scegen.enumeration import LIST_LIMIT, count_scenarios, open_listing
    from scegen.scenario.files import to_json

    if sample is not None and cover:
        raise InputError("--sample and --cover both choose: use one of them")
    if gallery is not None:
        require_picture(gallery, "--gallery")
    functional = _counted_cars(source, entries, junction_arms)
    narrows = rank or cover or sample is not None
    if count_only and where is None and rules is None:
        certificate = count_scenarios(functional, reduction=reduction, arms=arms)
        tell_count(certificate, reduction, arms, as_json=json)
        return
    listing = open_listing(
        functional,
        reduction=reduction,
        arms=arms,
        limit=None if every or narrows else limit,
        where=where,
        rules=rules_of(rules),
    )
    if narrows and not every and listing.expected > MOST_COMPARED:
        listing.limit = LIST_LIMIT
    if count_only:
        with listing_under_way(listing) as scenarios:
            deque(scenarios, maxlen=0)
        tell_count(listing.certificate(), reduction, arms, as_json=json, notes=listing.notes)
        return
    if not (rank or sample or cover or coverage or output or gallery):
        stream_json(listing) if json else stream_lines(listing)
        return
    with listing_under_way(listing) as scenarios:
        whole = listing.finished(tuple(scenarios))
    logical = _chosen(whole, rank=rank, sample=sample, cover=cover, limit=limit)
    if output is not None:
        write_bytes(to_json(logical).encode(), output)
    if gallery is not None:
        write_picture(logical, gallery)
    reached = None
    if coverage:
        narrowed = bool(where or rules or not whole.certificate.complete)
        reached = _reached(whole, logical, narrowed=narrowed)
    if json:
        last: dict[str, object] = {} if reached is None else {"coverage": coverage_json(reached)}
        data = head(logical.certificate, reduction, arms)
        write_json(data, logical.scenarios, lambda: last)
    elif output is None and gallery is None:
        _tell(logical, reached)


def _reached(whole: LogicalSet, logical: LogicalSet, *, narrowed: bool) -> Coverage:
    """What is covered, of everything that there is without --where, --rules and --limit."""
    from scegen.enumeration import LIST_LIMIT, open_listing
    from scegen.enumeration.choosing.coverage import coverage

    functional, everything = whole.functional, whole.scenarios
    if narrowed:
        listing = open_listing(functional, reduction=whole.reduction, arms=whole.arms)
        if listing.expected > MOST_COMPARED:
            say(f"compared with a selection of {LIST_LIMIT:,}, not with all {listing.expected:,}")
            listing.limit = LIST_LIMIT
        everything = tuple(listing)
    return coverage(functional, everything, logical.scenarios)


def _chosen(
    logical: LogicalSet, *, rank: bool, sample: int | None, cover: bool, limit: int
) -> LogicalSet:
    """The set with those scenarios alone that were asked for, and a note on how."""
    from scegen.enumeration.choosing.covering import smallest_cover
    from scegen.enumeration.choosing.ranking import richest_first
    from scegen.enumeration.choosing.sampling import diverse_sample

    functional, scenarios = logical.functional, logical.scenarios
    notes = list(logical.notes)
    if cover:
        found = smallest_cover(scenarios, functional)
        proof = "no fewer do" if found.proved else "fewer may do: the search was cut short"
        notes.append(f"{covering(len(found.scenarios))}; {proof}.")
        scenarios = found.scenarios
    if sample is not None:
        scenarios = diverse_sample(scenarios, functional, sample)
        notes.append(f"A sample of {len(scenarios)}, each as far from the others as possible.")
    if rank:
        scenarios = tuple(sorted(scenarios, key=lambda s: richest_first(s, functional)))
    if cover or sample or rank:
        scenarios = scenarios[:limit]
    certificate = logical.certificate
    if len(scenarios) < len(logical.scenarios):
        certificate = certificate.but(complete=False)
    return logical.but(scenarios=scenarios, notes=tuple(notes), certificate=certificate)


def _tell(logical: LogicalSet, reached: Coverage | None) -> None:
    tell_claim(logical.certificate, logical.reduction, logical.arms, logical.notes)
    for scenario in logical.scenarios:
        result(line(scenario))
    if reached is not None:
        for row in coverage_lines(reached):
            result(row)


def _counted_cars(
    source: str | None, entries: str | None, junction_arms: int | None
) -> FunctionalScenario:
    from scegen.enumeration import plain_crossing
    from scegen.pipeline.source import functional_of

    if (source is None) == (entries is None):
        raise InputError("name one of the two: a functional file (or a text), or --entries")
    if source is not None:
        return functional_of(source)
    if junction_arms is None:
        raise InputError("--entries needs --junction-arms, the number of arms of the junction")
    try:
        numbers = tuple(int(part) for part in (entries or "").split(","))
    except ValueError as error:
        raise InputError(
            f"{entries!r} is not a list of arm numbers", where="--entries", hint="such as 0,1,2"
        ) from error
    return plain_crossing(entries=numbers, arms=junction_arms)

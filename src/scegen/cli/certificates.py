"""How lists of logical scenarios, their certificates and their coverage are printed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict
from typing import TYPE_CHECKING

from scegen.cli.console import result, result_json, say
from scegen.scenario.wording import counted

if TYPE_CHECKING:
    from scegen.enumeration.choosing.coverage import Coverage
    from scegen.scenario.logical import Certificate, LogicalScenario
    from scegen.scenario.vocabulary import ArmsMode, Reduction


def head(certificate: Certificate, reduction: Reduction, arms: ArmsMode) -> dict[str, object]:
    """The certificate as JSON data."""
    told = certificate.model_dump(mode="json", exclude_none=True)
    first = {name: told.pop(name) for name in ("total", "count", "complete", "method")}
    return {**first, "reduction": reduction.value, "arms": arms.value, **told}


def tell_count(
    certificate: Certificate,
    reduction: Reduction,
    arms: ArmsMode,
    *,
    as_json: bool,
    notes: tuple[str, ...] = (),
) -> None:
    """The count alone, as a result; what else there is to say, beside it."""
    for note in notes:
        say(note)
    if as_json:
        result_json(head(certificate, reduction, arms))
    else:
        result(_counts(certificate))


def tell_claim(
    certificate: Certificate, reduction: Reduction, arms: ArmsMode, notes: tuple[str, ...]
) -> None:
    """What a list claims to be, beside the list."""
    say(f"{_counts(certificate)} (reduction {reduction}, arms {arms}; {certificate.method})")
    if certificate.symmetry is not None:
        say(f"symmetry (group order {certificate.group_order:,}): {certificate.symmetry}")
    if certificate.looked_at == certificate.total:
        say(f"the class sizes add up to the total, {certificate.total:,}")
    for note in notes:
        say(note)


def _counts(certificate: Certificate) -> str:
    matching = "" if certificate.matching is None else f"{certificate.matching:,} matching of "
    of = counted(certificate.total, "assignment")
    return f"{matching}{counted(certificate.count, 'scenario')} of {of}"


def line(scenario: LogicalScenario) -> str:
    """A scenario in a line."""
    ways = "  ".join(f"{d.participant} {d.entry}→{d.exit}" for d in scenario.drives)
    times = f"  ×{scenario.class_size}" if scenario.class_size > 1 else ""
    return f"{scenario.name}  {ways}{times}"


def coverage_lines(reached: Coverage) -> Iterator[str]:
    """A table: every possible meeting, in how many scenarios it occurs and in how many chosen."""
    covered = len(reached.possible) - len(reached.missing)
    yield f"{covered} of {counted(len(reached.possible), 'meeting')} covered"
    for meeting in sorted(reached.possible):
        chosen, possible = reached.chosen[meeting], reached.possible[meeting]
        mark = "" if chosen else "  missing"
        yield f"{chosen:>6} of {possible:<6} {meeting.in_words()}{mark}"


def coverage_json(reached: Coverage) -> list[dict[str, object]]:
    """The same as data."""
    return [
        {**asdict(m), "scenarios": reached.possible[m], "chosen": reached.chosen[m]}
        for m in sorted(reached.possible)
    ]

"""scegen benchmark understand: the scores as tables, the failures one below the other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from scegen.cli.console import result

if TYPE_CHECKING:
    from collections.abc import Mapping

    from scegen.benchmark.understand import Result, Tally


def print_scores(outcome: Result) -> None:
    """Prints failures, fields, kinds and hazards.

    Args:
        outcome: the scores of a file.
    """
    for failure in outcome.failures:
        result(f"{failure.case}: {failure.text}")
        for problem in failure.problems:
            result(f"    {problem}")
    if outcome.failures:
        result("")
    held, judged = outcome.all_fields
    result(f"understood  {_share(outcome.understood, outcome.cases)}")
    result(f"fields      {_share(held, judged)}")
    for name, (holds, times) in sorted(outcome.fields.items()):
        result(f"  {name:10}{_share(holds, times)}")
    _table("participants", outcome.kinds)
    _table("hazards", outcome.hazards)


def _share(part: int, whole: int) -> str:
    percent = 100 * part / whole if whole else 100.0
    return f"{part}/{whole} ({percent:.1f} %)"


def _table(title: str, tallies: Mapping[str, Tally]) -> None:
    from scegen.benchmark.understand import total

    result("")
    header = ("right", "wrong", "missed", "precision", "recall", "F1")
    result(f"{title:24}" + "".join(f"{name:>11}" for name in header))
    for kind, tally in [*sorted(tallies.items()), ("all", total(tallies))]:
        counts = f"{tally.right:11}{tally.wrong:11}{tally.missed:11}"
        result(f"{kind:24}{counts}{tally.precision:11.3f}{tally.recall:11.3f}{tally.f1:11.3f}")

"""scegen benchmark understand: the scores as tables, the failures one below the other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from scegen.cli.console import result

if TYPE_CHECKING:
    from collections.abc import Mapping

    from scegen.benchmark.agents import Measured
    from scegen.benchmark.stability import Stability
    from scegen.benchmark.tallies import Tally
    from scegen.benchmark.understand import Result


def print_scores(outcome: Result, measured: Measured | None = None) -> None:
    """Prints failures, fields, kinds and hazards, and what language models took."""
    runs = outcome.stability.runs
    for failure in outcome.failures:
        again = f" (run {', '.join(map(str, failure.runs))} of {runs})" if runs > 1 else ""
        result(f"{failure.case}{again}: {failure.text}")
        for problem in failure.problems:
            result(f"    {problem}")
    if outcome.failures:
        result("")
    held, judged = outcome.all_fields
    result(f"understood  {_share(outcome.understood, outcome.readings)}")
    result(f"fields      {_share(held, judged)}")
    for name, (holds, times) in sorted(outcome.fields.items()):
        result(f"  {name:10}{_share(holds, times)}")
    _table("participants", outcome.kinds)
    _table("hazards", outcome.hazards)
    if measured is not None:
        print_language_models(measured, outcome)
    if runs > 1:
        _stability(outcome.stability)
    if outcome.stopped is not None:
        result("")
        result(f"stopped early: {outcome.left} descriptions were not read")


def print_language_models(measured: Measured, outcome: Result) -> None:
    """Prints who spoke, how well, and what it took."""
    data = measured.to_data(outcome)
    result("")
    result("language models")
    for name, (count, understood) in measured.by_speaker(outcome).items():
        result(f"  spoke         {name}: {count} times, {_share(understood, count)} understood")
    faults = ", ".join(f"{kind} {count}" for kind, count in data["faults"].items())
    result(f"  faults        {faults or 'none'}")
    result(f"  disagreements {measured.disagreements} with the offline reader")
    latency = data["latency_s"]
    if latency["median"] is not None:
        result(f"  latency       median {latency['median']:.1f} s, p95 {latency['p95']:.1f} s")
    result(f"  used          {measured.usage.in_words()}")
    cost = data["cost_usd_per_reading"]
    priced = "cost not known" if cost is None else f"{cost:.4f} USD"
    result(f"  per reading   {data['tokens_per_reading']} tokens, {priced}")


def _stability(stability: Stability) -> None:
    result("")
    title = f"stability over {stability.runs} runs"
    result(f"{title:24}{'identical':>20}{'equally judged':>20}")
    for name, one in [("whole", stability.whole), *sorted(stability.fields.items())]:
        identical = _share(one.identical, one.cases)
        equally = _share(one.equally_judged, one.judged) if one.judged else "-"
        result(f"  {name:22}{identical:>20}{equally:>20}")


def _share(part: int, whole: int) -> str:
    percent = 100 * part / whole if whole else 100.0
    return f"{part}/{whole} ({percent:.1f} %)"


def _table(title: str, tallies: Mapping[str, Tally]) -> None:
    from scegen.benchmark.tallies import total

    result("")
    header = ("right", "wrong", "missed", "precision", "recall", "F1")
    result(f"{title:24}" + "".join(f"{name:>11}" for name in header))
    for kind, tally in [*sorted(tallies.items()), ("all", total(tallies))]:
        counts = f"{tally.right:11}{tally.wrong:11}{tally.missed:11}"
        result(f"{kind:24}{counts}{tally.precision:11.3f}{tally.recall:11.3f}{tally.f1:11.3f}")

"""Does a scenario with parameters play as the concrete scenarios that it stands for?"""

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from lxml import etree

from scegen.checking.documents import parse_document
from scegen.checking.esmini import CHECKER as ESMINI
from scegen.checking.esmini.log import check_log
from scegen.checking.esmini.playing import TIMEOUT_S, NotPlayedError, Played, play, play_sets
from scegen.checking.esmini.recording import RecordingError, read_recording
from scegen.checking.results import (
    CheckResult,
    Finding,
    Severity,
    as_remarks,
    error,
    not_run,
    unchecked,
    verdict,
)

CHECKER = "parameters"
MOST_APART_M = 0.05
_SECONDS_PER_SET = 3.0
_LONGEST_S = 120.0
"""After so long the sets that are left are not looked at."""


def check_parameters(scenario: Path, values: Path, alone: Mapping[str, Path]) -> CheckResult:
    """Play every set of values, and beside it the scenario of its own that has them.

    ``alone`` are the scenario files of their own by name of the set, in the order of the sets.
    """
    findings: list[Finding] = []
    worst = 0.0
    try:
        together = play_sets(scenario, values, TIMEOUT_S + _SECONDS_PER_SET * len(alone))
        if len(together) != len(alone):
            message = f"{len(together)} of {len(alone)} sets were played"
            return verdict(CHECKER, [error("parameters.played", values.name, message)])
        for played, (name, file) in zip(together, alone.items(), strict=True):
            findings += (f for f in check_log(played.log) if f.severity is Severity.ERROR)
            apart, where = _apart_m(played, play(file))
            worst = max(worst, apart)
            if apart > MOST_APART_M:
                message = f"{where}: {100 * apart:.1f} cm from where it is without parameters"
                findings.append(error("parameters.position", name, message))
    except NotPlayedError as reason:
        return not_run(CHECKER, str(reason))
    except RecordingError as problem:
        return verdict(CHECKER, [*findings, error("parameters.played", values.name, str(problem))])
    return verdict(CHECKER, findings, f"{len(alone)} sets, {100 * worst:.2f} cm apart at most")


def check_values(values: Path, content: bytes) -> CheckResult:
    """Play a file of values with the scenario that it names: esmini must take every set."""
    root = parse_document(values.name, content, "OpenSCENARIO").root
    named = root.find("ParameterValueDistribution/ScenarioFile")
    path = named.get("filepath", "") if named is not None else ""
    scenario = values.parent / path
    if not path or not scenario.is_file():
        message = f"names the scenario file {path!r}, which does not exist"
        return verdict(ESMINI, [error("parameters.scenario", values.name, message)])
    sets = _sets(root)
    limit_s = min(TIMEOUT_S + _SECONDS_PER_SET * sets, _LONGEST_S)
    try:
        together = play_sets(scenario, values, limit_s)
    except NotPlayedError as reason:
        return not_run(ESMINI, str(reason))
    findings = [f for played in together for f in check_log(played.log)]
    findings = [f for f in findings if f.severity is Severity.ERROR]
    codes = {played.code for played in together}
    message = f"{len(together)} of {sets} sets were played"
    if codes <= {0, None}:
        findings = list(as_remarks(findings))  # it takes the values all the same
    if None in codes:
        message += f" within {limit_s:g} s, the last one not to its end"
        findings.append(unchecked("parameters.played", values.name, message))
    elif len(together) < sets or codes != {0}:
        findings.append(error("parameters.played", values.name, message))
    return verdict(ESMINI, findings, f"played {len(together)} sets of values")


def _sets(root: etree._Element) -> int:
    """How many sets of values a file stands for (OpenSCENARIO 1.2, deterministic distributions)."""
    drawn = root.find("ParameterValueDistribution/Stochastic")
    if drawn is not None:
        return int(drawn.get("numberOfTestRuns", "1"))
    count = 1
    for several in root.iter("DeterministicMultiParameterDistribution"):
        count *= max(1, sum(1 for _ in several.iter("ParameterValueSet")))
    for single in root.iter("DeterministicSingleParameterDistribution"):
        elements = sum(1 for _ in single.iter("Element"))
        steps = [_steps(e) for e in single.iter("DistributionRange")]
        count *= max(1, elements or sum(steps))
    return count


def _steps(element: etree._Element) -> int:
    limits = element.find("Range")
    if limits is None:
        return 1
    try:
        low, high = (float(limits.get(name, "")) for name in ("lowerLimit", "upperLimit"))
        return int((high - low) / float(element.get("stepWidth", "")) + 1e-9) + 1
    except (ValueError, ZeroDivisionError):
        return 1  # what they are stands in parameters; the schema judges the rest


def _apart_m(one: Played, other: Played) -> tuple[float, str]:
    """The greatest distance between two plays of the same, and of whom it is and when."""
    theirs = {movement.entity: movement for movement in read_recording(other.recording)}
    worst, where = 0.0, "nobody"
    for movement in read_recording(one.recording):
        same = theirs.pop(movement.entity, None)
        if same is None or abs(len(same.point) - len(movement.point)) > 1:
            return float("inf"), f"{movement.entity} is played for another time"
        steps = min(len(same.point), len(movement.point))
        off = np.abs(same.point[:steps] - movement.point[:steps])
        if float(off.max()) > worst:
            worst, step = float(off.max()), int(off.argmax())
            where = movement.when(step)
    return (float("inf"), f"{min(theirs)} is missing") if theirs else (worst, where)

"""Does a scenario with parameters play as the concrete scenarios that it stands for?"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from scegen.checking.documents import parse_document
from scegen.checking.esmini import CHECKER as ESMINI
from scegen.checking.esmini.log import check_log
from scegen.checking.esmini.playing import TIMEOUT_S, NotPlayedError, Played, play, play_sets
from scegen.checking.esmini.recording import RecordingError, read_recording
from scegen.checking.results import CheckResult, Finding, Severity, error, not_run, verdict

CHECKER = "parameters"
MOST_APART_M = 0.05
_SECONDS_PER_SET = 3.0


def check_parameters(scenario: Path, values: Path, alone: Mapping[str, Path]) -> CheckResult:
    """Play every set of values, and beside it the scenario of its own that has them.

    Args:
        scenario: the file with parameters.
        values: the file of sets.
        alone: by name of the set, the scenario files of their own, in the order of the sets.
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
    sets = sum(1 for _ in root.iter("ParameterValueSet"))
    try:
        together = play_sets(scenario, values, TIMEOUT_S + _SECONDS_PER_SET * sets)
    except NotPlayedError as reason:
        return not_run(ESMINI, str(reason))
    findings = [f for played in together for f in check_log(played.log)]
    findings = [f for f in findings if f.severity is Severity.ERROR]
    if len(together) < sets or any(played.code != 0 for played in together):
        message = f"{len(together)} of {sets} sets were played"
        findings.append(error("parameters.played", values.name, message))
    return verdict(ESMINI, findings, f"played {len(together)} sets of values")


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
            where = f"{movement.entity} t = {movement.time_s[step]:.2f} s"
    return (float("inf"), f"{min(theirs)} is missing") if theirs else (worst, where)

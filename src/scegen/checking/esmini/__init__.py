"""The reference player: does it play the file, and does what it plays make sense?"""

from collections.abc import Callable
from pathlib import Path

from scegen.checking.esmini.log import check_log
from scegen.checking.esmini.movement import check_movements
from scegen.checking.esmini.playing import TIMEOUT_S, NotPlayedError, Played, play
from scegen.checking.esmini.recording import RecordingError, read_recording
from scegen.checking.opendrive.network import Network
from scegen.checking.results import CheckResult, as_remarks, error, not_run, verdict
from scegen.scenario.concrete import ConcreteScenario

CHECKER = "esmini"


def check_esmini(
    scenario: Path,
    network: Network | None = None,
    concrete: ConcreteScenario | None = None,
    driven_from_outside: frozenset[str] = frozenset(),
    once: Callable[[], Played] | None = None,
) -> CheckResult:
    """Play a scenario without a window, and check its log and every movement.

    esmini exits with 0 for a lane or road that does not exist, so the log decides. Entities
    ``driven_from_outside`` have no way of their own in the file: only their physics is checked.
    ``once`` plays it, for others too.
    """
    try:
        played = once() if once is not None else play(scenario)
    except NotPlayedError as reason:
        return not_run(CHECKER, str(reason))
    findings = list(check_log(played.log))
    if concrete is None and played.code == 0:
        findings = list(as_remarks(findings))  # it plays the file of somebody else all the same
    if played.code is None:
        message = f"the scenario did not end within {TIMEOUT_S:g} s"
        return verdict(CHECKER, [*findings, error("esmini.end", scenario.name, message)])
    if played.code != 0:
        message = f"esmini ended with exit code {played.code}"
        findings.append(error("esmini.exit", scenario.name, message))
        return verdict(CHECKER, findings)
    try:
        recording = read_recording(played.recording)
    except RecordingError as problem:
        findings.append(error("esmini.recording", scenario.name, str(problem)))
        return verdict(CHECKER, findings)
    findings += check_movements(recording, network, concrete, driven_from_outside)
    seconds = recording[0].time_s[-1] if recording else 0.0
    return verdict(CHECKER, findings, f"played {seconds:.2f} s, {len(recording)} entities")

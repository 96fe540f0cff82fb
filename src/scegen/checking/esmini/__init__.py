"""The reference player: does it play the file, and does what it plays make sense?"""

from __future__ import annotations

import tempfile
from pathlib import Path

from scegen.checking.environment import ESMINI_HINT, esmini
from scegen.checking.esmini.log import check_log
from scegen.checking.esmini.movement import check_movements
from scegen.checking.esmini.recording import RecordingError, read_recording
from scegen.checking.limits import run_limited
from scegen.checking.opendrive.network import Network
from scegen.checking.results import CheckResult, error, not_run, verdict
from scegen.scenario.concrete import ConcreteScenario

CHECKER = "esmini"
STEP_S = 0.05
TIMEOUT_S = 30.0


def check_esmini(
    scenario: Path,
    network: Network | None = None,
    concrete: ConcreteScenario | None = None,
    timeout_s: float = TIMEOUT_S,
) -> CheckResult:
    """Play a scenario without a window, and check its log and every movement.

    esmini exits with 0 for a lane or road that does not exist, so the log decides.
    """
    player = esmini()
    if player is None:
        return not_run(CHECKER, f"esmini is not on PATH; {ESMINI_HINT}")
    with tempfile.TemporaryDirectory(prefix="scegen-esmini-") as name:
        folder = Path(name)
        command = [str(player), "--osc", str(scenario.absolute()), "--headless", "--collision"]
        command += ["--fixed_timestep", str(STEP_S), "--csv_logger", "played.csv"]
        command += ["--disable_stdout", "--logfile_path", "played.log"]
        try:
            ran = run_limited(command, folder, timeout_s)
        except OSError as failure:
            return not_run(CHECKER, f"{player} cannot be started: {failure.strerror}")
        findings = list(check_log(_text(folder / "played.log")))
        if ran.code is None:
            message = f"the scenario did not end within {timeout_s:g} s"
            return verdict(CHECKER, [*findings, error("esmini.end", scenario.name, message)])
        if ran.code != 0:
            message = f"esmini ended with exit code {ran.code}"
            findings.append(error("esmini.exit", scenario.name, message))
            return verdict(CHECKER, findings)
        try:
            recording = read_recording(_text(folder / "played.csv"))
        except RecordingError as problem:
            findings.append(error("esmini.recording", scenario.name, str(problem)))
            return verdict(CHECKER, findings)
    findings += check_movements(recording, network, concrete)
    seconds = recording[0].time_s[-1] if recording else 0.0
    return verdict(CHECKER, findings, f"played {seconds:.2f} s, {len(recording)} entities")


def _text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""

"""Running the reference player: one scenario, without a window, in a folder of its own."""

import re
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from scegen.checking.environment import ESMINI_HINT, esmini
from scegen.checking.limits import run_limited
from scegen.motion.trigger_steps import STEP_S

TIMEOUT_S = 30.0
_OF_A_SET = re.compile(r"played_(\d+)_of_\d+\.csv")
"""What esmini calls the recording of one set of values."""


class NotPlayedError(Exception):
    """There is no player, or it cannot be started. Never leaves the package."""


@dataclass(frozen=True, slots=True)
class Played:
    """How a play ended: exit code (None = stopped at the time limit), log, recording as CSV."""

    code: int | None
    log: str
    recording: str


def play(scenario: Path, timeout_s: float = TIMEOUT_S) -> Played:
    """Play a scenario in fixed steps of ``STEP_S``, with its contacts in the log.

    Raises:
        NotPlayedError: esmini is not there or cannot be started.
    """
    with tempfile.TemporaryDirectory(prefix="scegen-esmini-") as name:
        folder = Path(name)
        code = _run(scenario, folder, timeout_s)
        return Played(code, _text(folder / "played.log"), _text(folder / "played.csv"))


def play_once(scenario: Path) -> Callable[[], Played]:
    """What plays a scenario when it is first asked for, and then remembers how it went.

    The callable raises as :func:`play` does.
    """
    return cache(lambda: play(scenario))


def play_sets(scenario: Path, values: Path, timeout_s: float) -> list[Played]:
    """Play a scenario with each set of its parameters' values, in the order of the sets.

    Raises:
        NotPlayedError: esmini is not there or cannot be started.
    """
    with tempfile.TemporaryDirectory(prefix="scegen-esmini-") as name:
        folder = Path(name)
        code = _run(scenario, folder, timeout_s, "--param_dist", str(values.absolute()))
        found = {
            int(match[1]): file
            for file in folder.iterdir()
            if (match := _OF_A_SET.fullmatch(file.name))
        }
        return [
            Played(code, _text(found[number].with_suffix(".log")), _text(found[number]))
            for number in sorted(found)
        ]


def _run(scenario: Path, folder: Path, timeout_s: float, *more: str) -> int | None:
    """Play into a folder; its exit code, None if it had to be stopped."""
    player = esmini()
    if player is None:
        raise NotPlayedError(f"esmini is not on PATH; {ESMINI_HINT}")
    command = [str(player), "--osc", str(scenario.absolute()), "--headless", "--collision"]
    command += ["--fixed_timestep", str(STEP_S), "--csv_logger", "played.csv"]
    command += ["--disable_stdout", "--logfile_path", "played.log", *more]
    try:
        return run_limited(command, folder, timeout_s).code
    except OSError as failure:
        raise NotPlayedError(f"{player} cannot be started: {failure.strerror}") from failure


def _text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""

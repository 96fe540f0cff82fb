"""What a scenario's files look like when they run: played by esmini, or by our own simulation."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

from scegen.checking.environment import esmini
from scegen.checking.esmini.layout import simulated_csv
from scegen.checking.esmini.playing import TIMEOUT_S, NotPlayedError, Played, play
from scegen.errors import InputError
from scegen.scenario.concrete import ConcreteScenario


class Player(StrEnum):
    """Who ran it."""

    ESMINI = "esmini"
    OWN = "our own simulation"


@dataclass(frozen=True, slots=True)
class Recorded:
    """A recording in the layout of esmini's CSV log, and who made it."""

    player: Player
    csv: str


def record(
    scenario: Path,
    concrete: ConcreteScenario,
    *,
    timeout_s: float = TIMEOUT_S,
    once: Callable[[], Played] | None = None,
) -> Recorded:
    """Run a scenario: in esmini where it is there, else in our own simulation.

    ``once`` plays it in esmini, for others too.

    Raises:
        InputError: esmini is there but does not play the file.
        RoadInfeasibleError, MotionInfeasibleError: the numbers cannot be built.
    """
    if esmini() is None:
        return Recorded(Player.OWN, simulated_csv(concrete))
    try:
        played = once() if once is not None else play(scenario, timeout_s)
    except NotPlayedError as reason:
        raise InputError(str(reason), where=str(scenario)) from reason
    if played.code != 0:
        ended = "did not end" if played.code is None else f"ended with exit code {played.code}"
        raise InputError(f"esmini {ended}", where=str(scenario))
    return Recorded(Player.ESMINI, played.recording)

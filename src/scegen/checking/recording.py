"""What a scenario's files look like when they run: played by esmini, or by our own simulation."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

import numpy as np

from scegen.checking.environment import esmini
from scegen.checking.esmini.layout import simulated_csv
from scegen.checking.esmini.playing import NotPlayedError, Played, play
from scegen.checking.esmini.recording import Movement, RecordingError, read_recording
from scegen.errors import InputError
from scegen.motion.model import Trace
from scegen.scenario.bodies import Body
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
    scenario: Path, concrete: ConcreteScenario, once: Callable[[], Played] | None = None
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
        played = once() if once is not None else play(scenario)
    except NotPlayedError as reason:
        raise InputError(str(reason), where=str(scenario)) from reason
    if played.code != 0:
        ended = "did not end" if played.code is None else f"ended with exit code {played.code}"
        raise InputError(f"esmini {ended}", where=str(scenario))
    return Recorded(Player.ESMINI, played.recording)


def traces_of(recorded: Recorded, concrete: ConcreteScenario) -> dict[str, Trace]:
    """What the participants of a recording did; ``s_m`` is the way gone.

    Raises:
        InputError: the recording cannot be read, or somebody does not take part in it.
    """
    try:
        movements = {m.entity: m for m in read_recording(recorded.csv)}
    except RecordingError as problem:
        raise InputError(str(problem), where=concrete.name) from problem
    if lacking := [p.id for p in concrete.participants if p.id not in movements]:
        raise InputError(f"{lacking[0]} does not take part in what is played", where=concrete.name)
    return {p.id: trace_of(movements[p.id], p.body) for p in concrete.participants}


def trace_of(movement: Movement, body: Body) -> Trace:
    """A movement as a trace: the way gone counts as the place."""
    return Trace(
        participant=movement.entity,
        body=body,
        time_s=movement.time_s,
        s_m=np.concatenate(([0.0], np.cumsum(np.abs(np.diff(movement.point))))),
        x_m=movement.point.real,
        y_m=movement.point.imag,
        heading_rad=np.unwrap(movement.heading_rad),
        speed_mps=movement.speed_mps,
    )

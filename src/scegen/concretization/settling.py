"""Let whoever reverses change direction exactly where it comes to rest.

A simulator stops it within some centimetres of the place planned. If it changed direction in mid
step later on, the way within that step would be no longer than the straight line that players add
up, and triggers behind would fire a step late. What is moved is the place, not the motion: it is
put where the reference simulator comes to rest, at the step that files are played with.
"""

from __future__ import annotations

import numpy as np

from scegen.motion.batch.playing import play
from scegen.motion.model import Trace
from scegen.motion.paths import build_path
from scegen.motion.trigger_steps import STEP_S
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import (
    ConcreteParticipant,
    ConcreteScenario,
    DriveMotion,
    SpeedPhase,
    Travelled,
)
from scegen.scenario.reversing import BacksOut, BacksUp

_NEAR_M = 0.2
_SETTLED_M = 6e-4
_TIMES = 4
_DECIMALS = 4


def settle(concrete: ConcreteScenario, network: RoadNetwork) -> ConcreteScenario:
    """The scenario with everybody who reverses changing direction where it stands."""
    for participant in concrete.participants:
        if isinstance(participant.motion, DriveMotion) and participant.motion.reversal is not None:
            for end in (0, 1):
                for _ in range(_TIMES):
                    settled = _moved(concrete, network, participant.id, end)
                    if settled is None:
                        break
                    concrete = settled
    return concrete


def _moved(
    concrete: ConcreteScenario, network: RoadNetwork, who: str, end: int
) -> ConcreteScenario | None:
    """With one place moved to where it rests; None if it rests there, or never near it."""
    paths = {p.id: build_path(p.motion, p.kind, network, p.id) for p in concrete.participants}
    participant = concrete.participant(who)
    motion = participant.motion
    if not isinstance(motion, DriveMotion):
        return None
    place = paths[who].backwards[0][end]
    trace = play(concrete, paths, dt_s=STEP_S)[who]
    rests = (trace.speed_mps == 0.0) & (np.abs(trace.s_m - place) < _NEAR_M)
    if not rests.any():
        return None
    short = place - float(trace.s_m[int(rests.argmax())])
    program = tuple(
        _between_steps(phase, participant, place, trace) for phase in participant.speed_program
    )
    reversal = motion.reversal
    rolls = end == 0 and isinstance(reversal, BacksOut)  # a length that is fixed, and fits
    if reversal is not None and abs(short) >= _SETTLED_M and not rolls:
        beyond = paths[who].backwards[0][1] + _NEAR_M
        name, later = _shortened(reversal, end, short)
        value = round(getattr(reversal, name) - short, _DECIMALS)
        motion = motion.model_copy(update={"reversal": reversal.model_copy(update={name: value})})
        program = tuple(_shifted(p, who, place, beyond, short, later) for p in program)
    elif program == participant.speed_program:
        return None
    moved = participant.model_copy(update={"motion": motion, "speed_program": program})
    people = tuple(moved if p.id == who else p for p in concrete.participants)
    return concrete.model_copy(update={"participants": people})


def _shortened(reversal: BacksUp | BacksOut, end: int, short: float) -> tuple[str, float]:
    """What becomes shorter by ``short``, and by how much the whole way does."""
    if isinstance(reversal, BacksOut):
        return "setback_m", short
    # What it stops short of before going back, it does not have to come back.
    return ("from_m", 0.0) if end == 0 else ("length_m", 2 * short)


def _own_place_m(phase: SpeedPhase, who: str) -> float | None:
    trigger = phase.trigger
    if isinstance(trigger, Travelled) and trigger.participant == who:
        return trigger.distance_m
    return None


def _between_steps(
    phase: SpeedPhase, participant: ConcreteParticipant, place: float, trace: Trace
) -> SpeedPhase:
    """One that stops just short of the place, triggered half way between two steps."""
    at = _own_place_m(phase, participant.id)
    if at is None or phase.target_speed_mps > 0.0 or not place - _NEAR_M < at < place + _NEAR_M:
        return phase
    step = int(np.searchsorted(trace.s_m, at))
    if not 0 < step < len(trace.s_m):
        return phase
    middle = round(float(trace.s_m[step - 1 : step + 1].mean()), _DECIMALS)
    if abs(middle - at) < 2 * 10**-_DECIMALS:
        return phase
    return phase.model_copy(
        update={"trigger": phase.trigger.model_copy(update={"distance_m": middle})}
    )


def _shifted(
    phase: SpeedPhase, who: str, place: float, beyond: float, short: float, later: float
) -> SpeedPhase:
    """With a trigger behind the place shifted as what lies behind it is."""
    at = _own_place_m(phase, who)
    if at is None or at <= place:
        return phase
    shift = short if at < beyond else later
    distance = round(at - shift, _DECIMALS)
    return phase.model_copy(
        update={"trigger": phase.trigger.model_copy(update={"distance_m": distance})}
    )

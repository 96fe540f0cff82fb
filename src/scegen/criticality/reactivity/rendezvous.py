"""Hold somebody back until the ego is near, so that both still arrive together.

Who is to meet the ego approaches more slowly than planned, from a place nearer to the meeting.
Once the ego is so many seconds short of it (time to arrival, by its own speed), it speeds up and
is from then on exactly where it was planned to be. An ego that comes earlier or later is thus
met all the same; what is left over is what the other rolls while it waits.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from scegen.claims.ways import Way
from scegen.motion.batch.arrays import Floats
from scegen.motion.friction import GRAVITY_MPS2
from scegen.motion.model import NEGLIGIBLE, Path, Trace
from scegen.motion.trigger_steps import arrivals_s
from scegen.scenario.concrete import (
    ArrivalBelow,
    Change,
    ConcreteParticipant,
    ConcreteScenario,
    DriveMotion,
    SpeedPhase,
    Travelled,
)

_LONG_ENOUGH_S = 0.5
_EARLIER_S = 0.1
_LEAD_IN_S = 1.0
_BEFORE_CHANGE_M = 0.5
_SPEEDING_UP_MPS2 = 2.5
_DECIMALS = 3


@dataclass(frozen=True, slots=True)
class Join:
    """Back on the plan: at ``time_s``, at a steady ``speed_mps``, ``s_m`` from the start.

    Phases from number ``phase`` on are still to come.
    """

    time_s: float
    s_m: float
    speed_mps: float
    phase: int


def joins(
    participant: ConcreteParticipant, trace: Trace, fired_s: Floats, until_s: float
) -> list[Join]:
    """Where somebody drives steadily before ``until_s``, the earliest first.

    Nothing after a phase that serves a danger: that must not be left out. ``fired_s`` (phases,) is
    when its phases fire, inf for never, ``until_s`` when it must be on its plan, s.
    """
    found: list[Join] = []
    begins, program = 0.0, participant.speed_program
    for n in range(len(program) + 1):
        ends = min(float(fired_s[n]) if n < len(program) else np.inf, until_s)
        if ends - begins >= _LONG_ENOUGH_S:
            at = ends - _EARLIER_S
            speed = float(np.interp(at, trace.time_s, trace.speed_mps))
            if speed > NEGLIGIBLE:
                s = float(np.interp(at, trace.time_s, trace.s_m))
                found.append(Join(at, s, speed, n))
        if n == len(program) or ends >= until_s or program[n].hazard is not None:
            break
        change = abs(program[n].target_speed_mps - np.interp(ends, trace.time_s, trace.speed_mps))
        begins = ends + float(change) / program[n].rate_mps2
    return found


def held_back(
    concrete: ConcreteScenario,
    ways: Mapping[str, Way],
    ego: Trace,
    who: str,
    join: Join,
    *,
    share: float,
    meeting_s: float,
    friction: float,
) -> ConcreteScenario | None:
    """The scenario with ``who`` held back at ``share`` of its speed; None where there is no room.

    ``ways`` begin where everybody starts, ``ego`` is the ego's movement; ``who`` must drive, and is
    back on its plan at ``join``. ``share``, below 1, is its speed while it waits, of that at the
    join. At ``meeting_s`` the two meet as planned; where the ego is then, it is waited for.
    ``friction`` is the coefficient between tyre and road.
    """
    participant, way = concrete.participant(who), ways[who]
    motion = participant.motion
    if not isinstance(motion, DriveMotion) or way.laid is None or motion.reversal is not None:
        return None
    slow = round(share * join.speed_mps, _DECIMALS)
    most = participant.body.max_acceleration_mps2
    rate = round(min(_SPEEDING_UP_MPS2, most, friction * GRAVITY_MPS2), _DECIMALS)
    speeding_up_s = (join.speed_mps - slow) / rate
    go_s = join.time_s - speeding_up_s
    if go_s < _LEAD_IN_S:
        return None
    rolls_m = slow * go_s + (slow + join.speed_mps) / 2 * speeding_up_s
    nearer_m = join.s_m - rolls_m
    turns = [way.turn_start_m] if way.turn_end_m > way.turn_start_m else [way.path.length_m]
    latest_m = min([*turns, *(c.start_m for c in way.changes)]) - _BEFORE_CHANGE_M
    if not 0.0 <= nearer_m <= latest_m:
        return None
    waits = waits_until(ego, ways[concrete.ego.id].path, go_s, meeting_s)
    if waits is None:
        return None
    go = SpeedPhase(
        trigger=ArrivalBelow(participant=concrete.ego.id, place_m=waits[0], time_s=waits[1]),
        target_speed_mps=round(join.speed_mps, _DECIMALS),
        rate_mps2=rate,
    )
    station = round(way.laid.station_m(nearer_m), _DECIMALS)
    waiting = participant.but(
        speed_mps=slow,
        motion=motion.but(start_m=station),
        speed_program=(go, *participant.speed_program[join.phase :]),
    )
    since = [_since(waiting if p.id == who else p, who, nearer_m) for p in concrete.participants]
    people = [person for person in since if person is not None]
    if len(people) < len(since):
        return None
    reason = f"waits for the ego: goes when it is {waits[1]:.2f} s short of where they meet"
    noted = (
        ("start_m", motion.start_m, station),
        ("speed_mps", participant.speed_mps, slow),
        ("speed_program.0.trigger.time_s", None, waits[1]),
    )
    changes = (
        Change(parameter=f"{who}.{name}", by="reactivity", before=was, after=now, reason=reason)
        for name, was, now in noted
    )
    return concrete.changed(people, changes)


def waits_until(
    ego: Trace, path: Path, go_s: float, meeting_s: float
) -> tuple[float, float] | None:
    """(place on the ego's way, time to arrival there) that come true at ``go_s`` and not before."""
    place_m = round(float(np.interp(meeting_s, ego.time_s, ego.s_m)), _DECIMALS)
    step = int(np.searchsorted(ego.time_s, go_s))
    arrival = arrivals_s(ego, ego.speed_mps, path.pose(place_m))
    if step < 1 or not np.isfinite(arrival[step - 1 : step + 1]).all():
        return None
    # Between two steps, so that rounding decides nothing.
    time_s = round(float(arrival[step - 1 : step + 1].mean()), _DECIMALS)
    if time_s <= 0.0 or (arrival[:step] < time_s).any() or arrival[step] >= time_s:
        return None
    return place_m, time_s


def _since(
    participant: ConcreteParticipant, who: str, nearer_m: float
) -> ConcreteParticipant | None:
    """Triggers that look at how far ``who`` has come, from its new start; None if that is over."""
    phases = []
    for phase in participant.speed_program:
        trigger = phase.trigger
        if isinstance(trigger, Travelled | ArrivalBelow) and trigger.participant == who:
            field = "distance_m" if isinstance(trigger, Travelled) else "place_m"
            left = round(getattr(trigger, field) - nearer_m, _DECIMALS)
            if left < 0.0:
                return None
            trigger = trigger.but(**{field: left})
        phases.append(phase.but(trigger=trigger))
    return participant.but(speed_program=tuple(phases))

"""From the candidate found back to a concrete scenario, with the reason of every change."""

from __future__ import annotations

from collections.abc import Mapping

from scegen.criticality.hazards.ways import Way
from scegen.motion.batch.arrays import Candidates
from scegen.scenario.concrete import (
    AtTime,
    Change,
    ConcreteParticipant,
    ConcreteScenario,
    DriveMotion,
    SpeedPhase,
)

_NOTICED = 1.5e-3
DECIMALS = 3


def rebuilt(
    concrete: ConcreteScenario,
    ways: Mapping[str, Way],
    made: Candidates,
    row: int,
    duration_s: float,
    why: str,
    *,
    by: str = "search",
) -> ConcreteScenario:
    """The scenario with a candidate's numbers.

    Args:
        concrete: the scenario as it was.
        ways: the ways from the outer ends of the arms, on which the candidate's starts lie.
        made: the candidates.
        row: which of them.
        duration_s: how long it takes.
        why: the reason noted for every change.
        by: who makes them.
    """
    changes: list[Change] = []
    people, first = [], 0
    for i, participant in enumerate(concrete.participants):
        fresh = _participant(participant, ways[participant.id], made, row, i, first)
        first += len(participant.speed_program)
        changes += _changes(participant, fresh, why, by)
        people.append(fresh)
    if not changes:
        return concrete
    return concrete.model_copy(
        update={
            "participants": tuple(people),
            "duration_s": round(duration_s * 20) / 20,
            "provenance": (*concrete.provenance, *changes),
        }
    )


def _participant(
    participant: ConcreteParticipant, way: Way, made: Candidates, row: int, i: int, first: int
) -> ConcreteParticipant:
    motion = participant.motion
    if isinstance(motion, DriveMotion) and way.laid is not None:
        station = way.laid.station_m(float(made.start_m[row, i]))
        if abs(station - motion.start_m) > _NOTICED:
            motion = motion.model_copy(update={"start_m": round(station, DECIMALS)})
    program = tuple(
        _phase(phase, made, row, first + n) for n, phase in enumerate(participant.speed_program)
    )
    speed = _settled(participant.speed_mps, float(made.speed_mps[row, i]))
    return participant.model_copy(
        update={"motion": motion, "speed_mps": speed, "speed_program": program}
    )


def _phase(phase: SpeedPhase, made: Candidates, row: int, k: int) -> SpeedPhase:
    trigger = phase.trigger
    field = "time_s" if isinstance(trigger, AtTime) else "distance_m"
    before = getattr(trigger, field)
    value = _settled(before, float(made.trigger[row, k]))
    if isinstance(trigger, AtTime) and value != before:
        value = off_the_steps(value)
    return phase.model_copy(
        update={
            "trigger": trigger.model_copy(update={field: value}),
            "target_speed_mps": _settled(
                phase.target_speed_mps, float(made.target_speed_mps[row, k])
            ),
            "rate_mps2": _settled(phase.rate_mps2, float(made.rate_mps2[row, k])),
        }
    )


def off_the_steps(time_s: float) -> float:
    """A time between the steps of 0.01 s, on which rounding would decide in every simulator."""
    beside = round(time_s * 1000) % 10
    return round(time_s + (0.003 if beside < 2 or beside > 8 else 0.0), DECIMALS)


def _settled(before: float, after: float) -> float:
    """The new value as written to files; the old one if nothing but rounding changed."""
    return before if abs(before - after) <= _NOTICED else round(after, DECIMALS)


def _changes(
    before: ConcreteParticipant, after: ConcreteParticipant, why: str, by: str
) -> list[Change]:
    """What differs between two versions of one participant."""
    name = before.id
    values: list[tuple[str, float, float]] = [
        (f"{name}.speed_mps", before.speed_mps, after.speed_mps)
    ]
    if isinstance(before.motion, DriveMotion) and isinstance(after.motion, DriveMotion):
        values.append((f"{name}.start_m", before.motion.start_m, after.motion.start_m))
    pairs = zip(before.speed_program, after.speed_program, strict=True)
    for n, (old, new) in enumerate(pairs):
        place = f"{name}.speed_program.{n}"
        field = "time_s" if isinstance(old.trigger, AtTime) else "distance_m"
        values += [
            (
                f"{place}.trigger.{field}",
                getattr(old.trigger, field),
                getattr(new.trigger, field),
            ),
            (f"{place}.target_speed_mps", old.target_speed_mps, new.target_speed_mps),
            (f"{place}.rate_mps2", old.rate_mps2, new.rate_mps2),
        ]
    return [
        Change(parameter=parameter, by=by, before=old, after=new, reason=why)
        for parameter, old, new in values
        if old != new
    ]

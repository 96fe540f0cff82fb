"""From the candidate found back to a concrete scenario, with the reason of every change."""

from collections.abc import Mapping

from scegen.claims.ways import Way
from scegen.motion.batch.arrays import Candidates
from scegen.scenario.concrete import (
    ArrivalBelow,
    AtTime,
    Change,
    ConcreteParticipant,
    ConcreteScenario,
    DriveMotion,
    SpeedPhase,
    StoodStill,
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

    ``ways`` are those from the outer ends of the arms, on which the candidate's starts lie; ``row``
    is its number, ``why`` and ``by`` whom are noted for every change.
    """
    changes: list[Change] = []
    people, first = [], 0
    moved_m = {
        participant.id: _moved_m(participant, ways[participant.id], float(made.start_m[row, i]))
        for i, participant in enumerate(concrete.participants)
    }
    for i, participant in enumerate(concrete.participants):
        fresh = _participant(participant, ways[participant.id], made, row, i, first, moved_m)
        first += len(participant.speed_program)
        changes += _changes(participant, fresh, why, by)
        people.append(fresh)
    if not changes:
        return concrete
    return concrete.changed(people, changes, duration_s=round(duration_s * 20) / 20)


def _moved_m(participant: ConcreteParticipant, way: Way, start_m: float) -> float:
    """How much later on its way somebody starts than before."""
    if isinstance(participant.motion, DriveMotion) and way.laid is not None:
        return start_m - way.laid.path_s_m(participant.motion.start_m)
    return 0.0


def _participant(
    participant: ConcreteParticipant,
    way: Way,
    made: Candidates,
    row: int,
    i: int,
    first: int,
    moved_m: Mapping[str, float],
) -> ConcreteParticipant:
    motion = participant.motion
    if isinstance(motion, DriveMotion) and way.laid is not None:
        station = way.laid.station_m(float(made.start_m[row, i]))
        if abs(station - motion.start_m) > _NOTICED:
            motion = motion.but(start_m=round(station, DECIMALS))
    program = tuple(
        _phase(phase, made, row, first + n, moved_m)
        for n, phase in enumerate(participant.speed_program)
    )
    speed = _settled(participant.speed_mps, float(made.speed_mps[row, i]))
    return participant.but(motion=motion, speed_mps=speed, speed_program=program)


def _phase(
    phase: SpeedPhase, made: Candidates, row: int, k: int, moved_m: Mapping[str, float]
) -> SpeedPhase:
    trigger = phase.trigger
    before = getattr(trigger, trigger.measured)
    value = _settled(before, float(made.trigger[row, k]))
    if isinstance(trigger, AtTime | StoodStill) and value != before:
        value = off_the_steps(value)
    update: dict[str, float] = {trigger.measured: value}
    if isinstance(trigger, ArrivalBelow):
        place = max(0.0, trigger.place_m - moved_m[trigger.participant])
        update["place_m"] = _settled(trigger.place_m, place)
    return phase.but(
        trigger=trigger.but(**update),
        target_speed_mps=_settled(phase.target_speed_mps, float(made.target_speed_mps[row, k])),
        rate_mps2=_settled(phase.rate_mps2, float(made.rate_mps2[row, k])),
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
        for field, was in old.numbers.items():
            values.append((f"{name}.speed_program.{n}.{field}", was, new.numbers[field]))
    return [
        Change(parameter=parameter, by=by, before=old, after=new, reason=why)
        for parameter, old, new in values
        if old != new
    ]

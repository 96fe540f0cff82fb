"""From scenarios and paths to the arrays of the batch simulator, and from traces to batches."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from scegen.motion.batch.arrays import (
    COS,
    SIN,
    BatchTraces,
    Candidates,
    ContactTable,
    PathTable,
    PhaseTable,
    Program,
    TriggerKind,
    empty_traces,
    mark_backwards,
)
from scegen.motion.model import Path, Trace
from scegen.motion.standing import object_path
from scegen.scenario.concrete import (
    ArrivalBelow,
    AtTime,
    ConcreteScenario,
    DistanceBelow,
    SpeedPhase,
    StoodStill,
    Travelled,
    Trigger,
)

_KINDS: dict[type[Trigger], TriggerKind] = {
    AtTime: TriggerKind.TIME,
    Travelled: TriggerKind.TRAVELLED,
    DistanceBelow: TriggerKind.DISTANCE_BELOW,
    ArrivalBelow: TriggerKind.ARRIVAL_BELOW,
    StoodStill: TriggerKind.STOOD_STILL,
}


@dataclass(frozen=True, slots=True)
class Phase:
    """A phase of a speed program in numbers.

    ``subject`` is the index of the participant that the trigger looks at (ignored for TIME);
    ``value`` is in s or m by ``kind``; ``position_m`` is the point on the subject's path that
    ARRIVAL_BELOW looks at.
    """

    kind: TriggerKind
    subject: int
    value: float
    target_speed_mps: float
    rate_mps2: float
    position_m: float = 0.0


def compile_program(
    concrete: ConcreteScenario, paths: Mapping[str, Path]
) -> tuple[Program, Candidates]:
    """The arrays of a scenario: its program, and its own numbers as the one candidate.

    Participants keep the scenario's order, and objects follow them; the phases of a participant
    follow one another.

    Args:
        concrete: the scenario.
        paths: its paths by participant, as :func:`scegen.motion.build_paths` makes them.
    """
    index = {p.id: i for i, p in enumerate(concrete.participants)}
    still = [object_path(thing) for thing in concrete.objects]
    programs = [[_phase(phase, index) for phase in p.speed_program] for p in concrete.participants]
    program, candidate = build_program(
        [*(paths[name] for name in index), *still],
        [*(p.speed_mps for p in concrete.participants), *(0.0 for _ in still)],
        [*programs, *([] for _ in still)],
    )
    return program._replace(contacts=_contacts(concrete)), candidate


def build_program(
    paths: Sequence[Path], speeds_mps: Sequence[float], phases: Sequence[Sequence[Phase]]
) -> tuple[Program, Candidates]:
    """The arrays for hand-made motions; arguments have one entry per participant."""
    flat = [phase for own in phases for phase in own]
    points = [paths[p.subject].pose(p.position_m) for p in flat]
    table = PhaseTable(
        first=_offsets([len(own) for own in phases]),
        kind=np.array([int(p.kind) for p in flat], dtype=np.int64),
        subject=np.array([p.subject for p in flat], dtype=np.int64),
        point_x_m=np.array([p.x_m for p in points], dtype=np.float64),
        point_y_m=np.array([p.y_m for p in points], dtype=np.float64),
    )
    candidate = Candidates(
        start_m=np.zeros((1, len(paths))),
        speed_mps=np.array([speeds_mps], dtype=np.float64),
        trigger=np.array([[p.value for p in flat]], dtype=np.float64),
        target_speed_mps=np.array([[p.target_speed_mps for p in flat]], dtype=np.float64),
        rate_mps2=np.array([[p.rate_mps2 for p in flat]], dtype=np.float64),
    )
    nobody = np.full(len(paths), -1, dtype=np.int64)
    contacts = ContactTable(nobody, *(np.zeros(len(paths)) for _ in range(4)))
    return Program(path_table(paths), table, contacts), candidate


def _contacts(concrete: ConcreteScenario) -> ContactTable:
    index = {entity.id: i for i, entity in enumerate(concrete.entities)}
    struck = [p.on_contact for p in concrete.participants] + [None for _ in concrete.objects]
    bodies = [entity.body for entity in concrete.entities]
    return ContactTable(
        np.array([-1 if s is None else index[s.participant] for s in struck], dtype=np.int64),
        np.array([0.0 if s is None else s.rate_mps2 for s in struck]),
        np.array([body.length_m / 2 for body in bodies]),
        np.array([body.width_m / 2 for body in bodies]),
        np.array([body.centre_ahead_m for body in bodies]),
    )


def path_table(paths: Sequence[Path]) -> PathTable:
    """Polylines one after another."""
    heading = np.concatenate([p.heading_rad for p in paths]).astype(np.float64)
    return PathTable(
        first=_offsets([len(p.s_m) for p in paths]),
        s_m=np.concatenate([p.s_m for p in paths]).astype(np.float64),
        x_m=np.concatenate([p.x_m for p in paths]).astype(np.float64),
        y_m=np.concatenate([p.y_m for p in paths]).astype(np.float64),
        heading_rad=heading,
        cos=np.cos(heading),
        sin=np.sin(heading),
        backwards=np.array(
            [(i, *part) for i, path in enumerate(paths) for part in path.backwards],
            dtype=np.float64,
        ).reshape(-1, 3),
    )


def repeat(candidates: Candidates, count: int) -> Candidates:
    """``count`` writable copies of the first candidate, to vary from there."""
    return Candidates(*(np.repeat(array[:1], count, axis=0) for array in candidates))


def stack_traces(traces: Sequence[Trace], paths: Sequence[Path] = ()) -> BatchTraces:
    """Movements (of a player, or of single participants) as a batch of one candidate.

    Args:
        traces: one per participant, at the same times, which start at 0 and are evenly spaced.
        paths: their paths, which tell where somebody reverses; without them nobody does.
    """
    times = traces[0].time_s
    dt_s = float(times[-1] / (len(times) - 1)) if len(times) > 1 else 1.0
    batch = empty_traces(1, len(times), len(traces), 0, dt_s)
    for i, trace in enumerate(traces):
        batch.s_m[0, :, i] = trace.s_m
        batch.x_m[0, :, i] = trace.x_m
        batch.y_m[0, :, i] = trace.y_m
        batch.heading_rad[0, :, i] = trace.heading_rad
        batch.tracks[0, i, COS] = np.cos(trace.heading_rad)
        batch.tracks[0, i, SIN] = np.sin(trace.heading_rad)
        batch.speed_mps[0, :, i] = trace.speed_mps
    mark_backwards(batch, path_table(paths).backwards if paths else np.empty((0, 3)))
    return batch


def stack_scenario(
    concrete: ConcreteScenario, traces: Mapping[str, Trace], paths: Mapping[str, Path] | None = None
) -> BatchTraces:
    """Movements of a scenario as a batch of one candidate, in the order of its entities.

    Args:
        concrete: the scenario.
        traces: by participant, as for :func:`stack_traces`; objects stand where they are.
        paths: by participant; without them nobody reverses.
    """
    names = [p.id for p in concrete.participants]
    times_s = traces[names[0]].time_s
    still = np.zeros_like(times_s)
    lying = [
        Trace(thing.id, thing.body, times_s, still, *object_path(thing).places(still), still)
        for thing in concrete.objects
    ]
    return stack_traces(
        [*(traces[n] for n in names), *lying], [paths[n] for n in names] if paths else ()
    )


def _phase(phase: SpeedPhase, index: Mapping[str, int]) -> Phase:
    """A contract phase in numbers."""
    trigger = phase.trigger
    return Phase(
        kind=_KINDS[type(trigger)],
        subject=0 if isinstance(trigger, AtTime) else index[trigger.participant],
        value=getattr(trigger, trigger.measured),
        target_speed_mps=phase.target_speed_mps,
        rate_mps2=phase.rate_mps2,
        position_m=trigger.place_m if isinstance(trigger, ArrivalBelow) else 0.0,
    )


def _offsets(lengths: Sequence[int]) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
    """Where each of several runs of these lengths begins, and where the last ends."""
    return np.concatenate(([0], np.cumsum(lengths, dtype=np.int64))).astype(np.int64)

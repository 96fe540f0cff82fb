"""Bind those who meet the ego to it, where the danger then survives an earlier or later ego."""

from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np

from scegen.claims.ways import paths_of, ways_of
from scegen.criticality.reactivity.rendezvous import held_back, joins
from scegen.criticality.reactivity.sensitivity import Sensitivity, ego_start_sensitivity
from scegen.motion.batch.compilation import compile_program
from scegen.motion.batch.simulation import simulate_batch, traces_of
from scegen.motion.friction import friction_of
from scegen.motion.trigger_steps import put_between_steps
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import ConcreteScenario, DriveMotion
from scegen.scenario.vocabulary import JunctionKind

IN_TRAFFIC = (0.6, 0.45)
SHARES = (*IN_TRAFFIC, 0.3, 0.15, 0.0)
"""Speeds while waiting, as shares of the planned one: the most natural first. Without a junction
nobody crawls or stands for the ego."""
_DT_S = 0.01
_BEFORE_MEETING_S = 0.5


def bind_to_ego(
    concrete: ConcreteScenario,
    network: RoadNetwork,
    meetings_s: Mapping[str, Sequence[float]],
    stands: Callable[[ConcreteScenario], bool],
) -> ConcreteScenario:
    """Let those who meet the ego wait for it, if their danger then meets a slower and faster one.

    What happens as planned stays as it is: the same danger, at the same time. Those who look at the
    ego already, and those for whom waiting helps nothing, are left alone. ``meetings_s``: whose
    danger it is, in order of importance, and when it may be said to happen. ``stands``: whether a
    scenario still shows all that is wanted.
    """
    for name, times_s in meetings_s.items():
        concrete = _bound(concrete, network, name, times_s, stands)
    return concrete


def _bound(
    concrete: ConcreteScenario,
    network: RoadNetwork,
    who: str,
    times_s: Sequence[float],
    stands: Callable[[ConcreteScenario], bool],
) -> ConcreteScenario:
    before = _sensitivity(concrete, network, who)
    if before is None or not before.own.critical:
        return concrete
    # One that survives by chance is bound all the same, if it then still does.
    best, most = concrete, 1 if before.reactive else _held(before)
    for tried in _waiting(concrete, network, who, times_s):
        found = _sensitivity(tried, network, who)
        if found is None or found.others_touch or _held(found) <= most or not stands(tried):
            continue
        best, most = tried, _held(found)
        if found.reactive:
            break
    return best


def _held(found: Sensitivity) -> int:
    """How many of the two other starts stay critical."""
    return int(found.slower.critical) + int(found.faster.critical)


def _sensitivity(concrete: ConcreteScenario, network: RoadNetwork, who: str) -> Sensitivity | None:
    return ego_start_sensitivity(concrete, paths_of(ways_of(concrete, network)), partner=who)


def _waiting(
    concrete: ConcreteScenario, network: RoadNetwork, who: str, times_s: Sequence[float]
) -> Iterator[ConcreteScenario]:
    """The ways to wait, the most natural first; none for one who looks at the ego already."""
    participant, ego = concrete.participant(who), concrete.ego
    if not isinstance(participant.motion, DriveMotion) or not times_s:
        return
    ways = ways_of(concrete, network)
    program, own = compile_program(concrete, paths_of(ways))
    batch = simulate_batch(program, own, duration_s=concrete.duration_s, dt_s=_DT_S)
    index = concrete.participants.index(participant)
    first = program.phases.first[index]
    fired = batch.fired_step[0, first : first + len(participant.speed_program)]
    fired_s = np.where(fired >= 0, fired * _DT_S, np.inf)
    for phase, at_s in zip(participant.speed_program, fired_s, strict=True):
        if at_s < max(times_s) and getattr(phase.trigger, "participant", None) == ego.id:
            return
    shares = IN_TRAFFIC if concrete.road.kind is JunctionKind.STRAIGHT else SHARES
    traces = traces_of(concrete, batch)
    for meeting_s in times_s:
        for join in joins(participant, traces[who], fired_s, meeting_s - _BEFORE_MEETING_S):
            for share in shares:
                tried = held_back(
                    concrete,
                    ways,
                    traces[ego.id],
                    who,
                    join,
                    share=share,
                    meeting_s=meeting_s,
                    friction=friction_of(concrete.environment),
                )
                if tried is not None:
                    yield put_between_steps(tried, paths_of(ways_of(tried, network)))

"""From a logical scenario to numbers, step by step; the same seed gives the same numbers."""

from math import ceil

import numpy as np
from pydantic import ValidationError

from scegen.concretization.along.compose import compose_along, tells_along
from scegen.concretization.along.parked import opens
from scegen.concretization.answering import answer, note_answers
from scegen.concretization.arms import lay_on_arms
from scegen.concretization.aside import keep_aside
from scegen.concretization.assemble import assemble
from scegen.concretization.clock import require_arms, schedule
from scegen.concretization.deeds import do_acts, lead_in_missing_s, stand_in_line
from scegen.concretization.drafts import DriveDraft, Wait
from scegen.concretization.encounters import conflict_meetings, join_traffic
from scegen.concretization.fitting import conditioned, fit
from scegen.concretization.lights import STOOD_S, WAITS_S, set_lights
from scegen.concretization.limits import FAST_LATERAL_MPS2, JITTER, LATERAL_MPS2
from scegen.concretization.meeting_lanes import choose_junction_lanes
from scegen.concretization.meetings import Meeting
from scegen.concretization.moments import traffic_of
from scegen.concretization.occluders import hide
from scegen.concretization.possible import require_possible
from scegen.concretization.reversing import prepare_to_reverse, reverse
from scegen.concretization.rings import cut_in_in_rings
from scegen.concretization.roads import LONGEST_ARM_M, first_arm_m, plan
from scegen.concretization.setup import NeedsLongerArms, Setup, acts_of
from scegen.concretization.stationary import go_round_stationary, place_stationary, pull_out
from scegen.concretization.tale import as_meant, pace_of
from scegen.concretization.walkers import leaves_s, place_walkers, stop_in_the_way
from scegen.errors import MotionInfeasibleError
from scegen.motion.rules.stopping import must_stop
from scegen.road import build_network
from scegen.scenario.acts import ActKind
from scegen.scenario.complaints import outside
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.logical import Drive, LogicalScenario
from scegen.scenario.signals import AtLight
from scegen.scenario.vocabulary import HazardKind, Maneuver

_ARM_STEP_M = 10.0
_SPARE = 0.15
_SLOWEST_MPS = 1.0
_AGAIN = 3
_FAST = frozenset({HazardKind.SPEEDING, HazardKind.SUDDEN_TURN})
"""The dangers of those who go fast through bends."""


def concretize(
    functional: FunctionalScenario, logical: LogicalScenario, *, seed: int = 0
) -> ConcreteScenario:
    """The first concrete scenario: those in conflict arrive together, dangers get numbers.

    Args:
        functional: what the description says.
        logical: who enters and leaves where, one of the functional scenario's.
        seed: of all random choices (small differences of speed, strength of dangers).

    Raises:
        MotionInfeasibleError: it cannot be driven, or needs something unsupported.
        RoadInfeasibleError: the junction cannot be built.
    """
    require_possible(functional)
    functional = as_meant(functional, logical)
    try:
        return _concretize(functional, logical, seed)
    except ValidationError as error:  # no file holds such numbers
        raise MotionInfeasibleError(
            f"what is told leads to {outside(error)}",
            where="concrete scenario",
            hint="Tell of smaller or larger amounts.",
        ) from error


def _concretize(
    functional: FunctionalScenario, logical: LogicalScenario, seed: int
) -> ConcreteScenario:
    if tells_along(functional, logical):
        return compose_along(functional, logical, seed=seed)
    for name in opens(functional):
        raise MotionInfeasibleError(
            "opens its door: that is made only on a road without a junction",
            where=name,
            hint="Leave the junction out, or let somebody pull out or stand in the way.",
        )
    return _on_long_enough_arms(functional, logical, seed)


def _on_long_enough_arms(
    functional: FunctionalScenario, logical: LogicalScenario, seed: int
) -> ConcreteScenario:
    arm_m = first_m = first_arm_m(logical)
    acts = acts_of(functional, logical)
    while True:
        parameters = plan(functional, logical, arm_m)
        network = build_network(parameters)
        # The same draws in every attempt: lengthening the road must not change the rest.
        rng = np.random.Generator(np.random.PCG64(seed))
        scene = Setup(functional, logical, acts, parameters, network, rng)
        try:
            return _compose(scene, seed)
        except NeedsLongerArms as need:
            # Who starts farther out often needs more than was missing.
            least_m, more_m = arm_m + need.metres, need.metres + (arm_m if arm_m > first_m else 0.0)
            wanted_m = max(least_m, min(least_m + _SPARE * more_m, LONGEST_ARM_M))
            arm_m = ceil(wanted_m / _ARM_STEP_M) * _ARM_STEP_M
            if arm_m > LONGEST_ARM_M:
                longest = max(arm.length_m for arm in parameters.arms)
                raise MotionInfeasibleError(
                    f"the arms ({longest:.0f} m) are {need.metres:.0f} m too short for its run-up",
                    where=need.who,
                    hint="Give longer arms, or fewer or slower vehicles.",
                ) from need


def _compose(scene: Setup, seed: int) -> ConcreteScenario:
    place_stationary(scene)
    for drive in scene.logical.drives:
        if drive.participant not in scene.stands:
            scene.drives[drive.participant] = _draft(scene, drive)
    prepare_to_reverse(scene)
    choose_junction_lanes(scene)
    keep_aside(scene)
    for draft in scene.drives.values():
        draft.lay(scene.network)
    join_traffic(scene)
    place_walkers(scene)
    meetings = [*reverse(scene), *cut_in_in_rings(scene), *lay_on_arms(scene)]
    go_round_stationary(scene)
    stand_in_line(scene)
    meetings += pull_out(scene)
    stop_in_the_way(scene)
    meetings += conflict_meetings(scene, meetings)
    _start(scene, meetings)
    return hide(scene.functional, assemble(scene, seed), scene.network)


def _draft(scene: Setup, drive: Drive) -> DriveDraft:
    participant = scene.functional.participant(drive.participant)
    others = {each.participant for each in scene.logical.drives}
    wait = scene.first_act(participant.id, ActKind.WAIT)
    cruise = _cruise_speed_mps(scene, participant, drive.entry)
    at_line = scene.stands_at_line(participant.id)
    waits_s = STOOD_S if at_line else WAITS_S if participant.light is AtLight.WAITS else None
    if scene.sets_off(participant.id) or at_line or drive.maneuver is Maneuver.STAY:
        cruise = scene.driven_mps(participant.id, scene.limit_mps)  # so it came there
    fast = scene.kinds_by(participant.id) & _FAST
    return DriveDraft(
        id=participant.id,
        body=participant.body,
        drive=drive,
        speed_mps=cruise,
        lateral_mps2=FAST_LATERAL_MPS2 if fast else LATERAL_MPS2,
        grip_mps2=scene.grip_mps2,
        waits=None if waits_s is None else Wait(waits_s),
        stops_at_line=(
            participant.id in must_stop(scene.functional, scene.logical)
            and not scene.runs_into_standing(participant.id)
        )
        or (wait is not None and wait.into in others),
    )


def _cruise_speed_mps(scene: Setup, participant: Participant, arm: int) -> float:
    """The parameter's default with a little jitter.

    Traffic that comes on one ``arm`` has one speed unless something else is said.
    """
    pace = pace_of(scene.functional, scene.logical, participant.id)
    # Drawn in any case, so that one participant's range does not shift another's draws.
    drawn = 1.0 + float(scene.rng.uniform(-JITTER, JITTER))
    factor = scene.paces.setdefault((arm, pace.default), drawn)
    top = participant.body.top_speed_mps
    speed = max(min(max(pace.default * factor, pace.low), pace.high, top), _SLOWEST_MPS)
    scene.note(pace.name, speed, pace.reason)
    return speed


def _start(scene: Setup, meetings: list[Meeting]) -> None:
    schedule(scene, meetings)
    do_acts(scene)
    _with_lead_in(scene)
    require_arms(scene)
    answer(traffic_of(scene))
    note_answers(scene, scene.drives)
    reasons = {m.second: f"{m.reason} with {m.first}" for m in reversed(meetings) if m.reason}
    for name, draft in scene.drives.items():
        draft.start_m = 0.0 if draft.backs_out else draft.course.s_at(-draft.offset_s)
        station = draft.laid.station_m(draft.start_m)
        scene.note(f"{name}.start_m", station, reasons.get(name, "in line on its arm"))
    set_lights(scene)


def _with_lead_in(scene: Setup) -> None:
    """Starts and acts as is said, everybody undisturbed for a moment before the first act."""
    late_s = {name: draft.offset_s for name, draft in scene.drives.items()}
    for _ in range(_AGAIN):
        for name, draft in scene.drives.items():
            draft.offset_s = late_s[name]
        for name, walk in scene.walks.items():
            walk.sets_off_s = None
            walk.sets_off_s = leaves_s(scene, name) if conditioned(scene, name) else None
        fit(scene)
        early = lead_in_missing_s(scene)
        if early <= 0.0:
            break
        late_s = {name: late + early for name, late in late_s.items()}

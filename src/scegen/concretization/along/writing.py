"""From the story to the numbers of the files: roads, starts, phases, changes of lane."""

from collections.abc import Callable
from math import hypot

from scegen.concretization.along.frame import Frame
from scegen.concretization.along.parked import endangered, opening_s
from scegen.concretization.along.runner import FORTH_M, Runner
from scegen.concretization.along.story import Story
from scegen.concretization.others import Walk
from scegen.concretization.profile import NEVER_S, SpeedChange
from scegen.concretization.written import as_they_come, written, written_phase
from scegen.errors import MotionInfeasibleError
from scegen.motion.doors import WAY_M
from scegen.motion.standing import crossing_path
from scegen.motion.trigger_steps import just_before_step_s
from scegen.road.model import RoadNetwork
from scegen.scenario.acts import Act, AfterStart
from scegen.scenario.concrete import (
    AtTime,
    ConcreteParticipant,
    DistanceBelow,
    DriveMotion,
    LaneChange,
    SpeedPhase,
    StandingMotion,
    SwingingMotion,
    Trigger,
    door_of,
)
from scegen.scenario.reversing import MOST_BACK_M, BacksUp
from scegen.scenario.vocabulary import ParticipantKind

_LEAST_MOVE_M = 2.0
_BETWEEN_M = 0.1
"""Two changes of lane without anything between would share a vertex, and players round."""
_SPARE_M = 3.0
_LOOK_S = 0.25
_FLUNG_MPS2 = 6.0


def written_runner(
    story: Story, frame: Frame, network: RoadNetwork, name: str
) -> ConcreteParticipant:
    """One along the road."""
    runner = story.runners[name]
    entry = frame.ego_arm if runner.forward else 1 - frame.ego_arm
    changes = written_changes(runner, lambda s: frame.station_m(runner, runner.x_m(s)))
    last = changes[-1].lane_after if changes else runner.lane
    joint = frame.joint_station_m(runner)
    start = frame.station_m(runner, runner.at_m or 0.0)
    reversal = None
    if runner.backs:
        back = runner.profile.way_m(frame.lasts_s) - FORTH_M
        if back + _SPARE_M > MOST_BACK_M:
            raise MotionInfeasibleError(
                f"it would back up for {back:.0f} m, more than {MOST_BACK_M:g} m",
                where=name,
                hint="Say when it stops, or at which speed it reverses.",
            )
        reversal = BacksUp(from_m=round(start + FORTH_M, 3), length_m=round(back + _SPARE_M, 3))
    motion = DriveMotion(
        entry=entry,
        entry_lane=runner.lane,
        exit=1 - entry,
        exit_lane=last,
        start_m=round(start, 3),
        offset_m=round(runner.offset_m, 3),
        turning_starts_m=round(joint - frame.gaps_m[entry], 3),
        turning_ends_m=round(joint + frame.gaps_m[1 - entry], 3),
        lane_changes=changes,
        reversal=reversal,
    )
    program = tuple(
        written_phase(story, step, _trigger(story, (frame, network), runner, step))
        for step in sorted(runner.steps, key=lambda step: step.begins_s)
    )
    speed = runner.speed_mps
    return written(story, name, motion, speed_mps=speed, program=program, parked=runner.stands)


def written_changes(runner: Runner, station_m: Callable[[float], float]) -> tuple[LaneChange, ...]:
    """Moves to the side as places on the way: what is travelled meanwhile is their length."""
    changes, before = [], 0.0
    for move in sorted(runner.moves, key=lambda m: m.begins_s):
        begins = max(station_m(move.begins_s), before)
        length = max(station_m(move.ends_s) - begins, _LEAST_MOVE_M)
        changes.append(
            LaneChange(
                position_m=round(begins, 3),
                length_m=round(length, 3),
                lane_after=move.lane,
                offset_m=round(move.offset_m, 3),
                hazard=move.hazard,
            )
        )
        before = round(begins, 3) + round(length, 3) + _BETWEEN_M
    return tuple(changes)


def _trigger(
    story: Story, place: tuple[Frame, RoadNetwork], runner: Runner, step: SpeedChange
) -> Trigger:
    """What sets a step off: time if that is said, who it answers, or how far the ego has come."""
    if step.timed:
        return AtTime(time_s=step.begins_s)
    moment = just_before_step_s(step.begins_s)
    if step.reacts_to is not None and step.reacts_to in story.runners:
        other = story.runners[step.reacts_to]
        apart = _apart_m(*place, runner, other, moment)
        # Who has been passed by was as near before.
        looks = range(int(max(moment - _LOOK_S, 0.0) / _LOOK_S))
        first = all(_apart_m(*place, runner, other, n * _LOOK_S) > apart for n in looks)
        along = other.speed_at_mps(moment) * runner.sign * other.sign
        closing = runner.speed_at_mps(moment) > along + 0.05
        participant = not other.thing
        if closing and participant and first:
            return DistanceBelow(participant=other.id, distance_m=round(apart, 3))
        if participant and step.act is None:
            return as_they_come((other, story.ego, runner), moment)
    return as_they_come((story.ego, runner), moment)


def _apart_m(
    frame: Frame, network: RoadNetwork, one: Runner, other: Runner, time_s: float
) -> float:
    """The straight distance of two reference points."""
    here, there = (frame.pose(network, w.x_m(time_s), w.y_m(time_s)) for w in (one, other))
    return hypot(here.x_m - there.x_m, here.y_m - there.y_m)


def written_walk(
    story: Story, frame: Frame, network: RoadNetwork, walk: Walk
) -> ConcreteParticipant:
    """One who goes across the road."""
    motion = walk.motion_at(frame.from_junction_m(walk.crossing.arm, walk.x_m))
    length = crossing_path(network, motion, walk.id).length_m
    program = walk.program_by((story.runners[walk.meets],), walk.sets_off_s, length)
    return written(story, walk.id, motion, program=program)


def written_parked(story: Story, frame: Frame, name: str) -> ConcreteParticipant:
    """One who is parked."""
    standing = story.standing(name)
    away = frame.from_junction_m(standing.arm, story.parked[name].x_m(0.0))
    motion = StandingMotion(
        arm=standing.arm,
        side=standing.side,
        from_junction_m=round(away, 3),
        strip=story.functional.participant(name).strip,
    )
    return written(story, name, motion, parked=True)


def written_door(story: Story, act: Act, vehicle: ConcreteParticipant) -> ConcreteParticipant:
    """The door of one who is parked, which opens as the first whom it endangers has come so far."""
    if not isinstance(vehicle.motion, StandingMotion):
        raise TypeError(f"{vehicle.id} does not stand")
    names = sorted(endangered(story.functional, vehicle.id))
    coming = [story.runners[name] for name in names if name in story.runners]
    begins, lasts = story.begins_s[act.id], opening_s(act)
    timed = isinstance(act.when, AfterStart)
    trigger = as_they_come(() if timed else (*coming, story.ego), begins)
    # It gains speed and is stopped where it is open: way = v (t - v / 2a).
    speed = _FLUNG_MPS2 * (lasts - max(lasts**2 - 2 * WAY_M / _FLUNG_MPS2, 0.0) ** 0.5)
    phase = SpeedPhase(
        trigger=trigger, target_speed_mps=round(speed, 4), rate_mps2=_FLUNG_MPS2, act=act.id
    )
    return ConcreteParticipant(
        id=door_of(vehicle.id),
        kind=ParticipantKind.DOOR,
        speed_mps=0.0,
        motion=SwingingMotion(
            vehicle=vehicle.id,
            kind=vehicle.kind,
            stands=vehicle.motion,
            length_m=vehicle.length_m,
            width_m=vehicle.width_m,
        ),
        speed_program=(phase,),
    )


def ends_s(story: Story) -> float:
    """When the last thing has happened that the story tells, the closest approach included."""
    moments = [4.0]
    for runner in story.runners.values():
        moments += [move.ends_s for move in runner.moves]
        moments += [runner.profile.settles_s(step.begins_s) for step in runner.steps]
    for walk in story.walks.values():
        across = walk.setback_m + 2 * story.lane_count * story.ego.lane_width_m + walk.body.length_m
        moments.append(walk.sets_off_s + walk.runs_s(across))
        meets = story.runners[walk.meets]
        moments.append(meets.profile.time_s(abs(walk.x_m - meets.x_m(0.0)) + meets.body.rear_m))
    return max(moment for moment in moments if moment < NEVER_S)

"""From the story to the numbers of the files: roads, starts, phases, changes of lane."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import ceil, copysign, hypot

from scegen.concretization.along.auxiliary import fitted, gaps_m, joint_m, room_m
from scegen.concretization.along.crossing import Walk
from scegen.concretization.along.parked import Parked
from scegen.concretization.along.runner import FORTH_M, Runner, Step
from scegen.concretization.along.story import Story
from scegen.concretization.profile import NEVER_S
from scegen.errors import MotionInfeasibleError
from scegen.motion.paths import END_MARGIN_M
from scegen.motion.trigger_steps import just_before_step_s
from scegen.road.defaults import LANE_WIDTH_M
from scegen.road.geometry import Pose, Segment
from scegen.road.straight import Curve, curve_of
from scegen.scenario.bodies import BODIES
from scegen.scenario.concrete import (
    AtTime,
    ConcreteParticipant,
    CrossingMotion,
    DistanceBelow,
    DriveMotion,
    LaneChange,
    RoadParameters,
    SpeedPhase,
    StandingMotion,
    Travelled,
    Trigger,
)
from scegen.scenario.functional import Participant
from scegen.scenario.logical import Crossing, Drive, Standing
from scegen.scenario.reversing import BacksUp
from scegen.scenario.vocabulary import HazardKind, ParticipantKind

_ARM_MARGIN_M = 3.0
_JOINT_CLEAR_M = 8.0
_LEAST_ARM_M = 40.0
_ROUND_M = 10.0
_STOPS_SHORT_M = 0.15
_LEAST_MOVE_M = 2.0
_SPARE_M = 3.0
_MOVES_MPS = 0.1
_KINDS = {
    ParticipantKind.PEDESTRIAN: HazardKind.CROSSING_PEDESTRIAN,
    ParticipantKind.BICYCLE: HazardKind.CROSSING_CYCLIST,
}


@dataclass(frozen=True, slots=True)
class Frame:
    """Where the road lies on the story's axis: from ``begin_m`` to ``end_m``, joint between.

    The axis is the middle of the ego's lane, ``axis_y_m`` left of the centre line; ``curve`` is the
    road's bend as the ego drives it. ``met_s`` is when each runner is where the story has it: who
    drives in another lane of a bend comes along it faster or slower than on the axis.
    ``gaps_m`` is how far from the joint the inner ends of arms 0 and 1 are: a ramp parts them.
    """

    begin_m: float
    joint_m: float
    end_m: float
    ego_arm: int
    lasts_s: float = 0.0
    curve: Curve | None = None
    axis_y_m: float = 0.0
    met_s: Mapping[str, float] = field(default_factory=dict)
    gaps_m: tuple[float, float] = (0.0, 0.0)

    def station_m(self, runner: Runner, x_m: float) -> float:
        """The place on a drive, from the outer end of its entry arm."""
        straight = x_m - self.begin_m if runner.forward else self.end_m - x_m
        if self.curve is None:
            return straight
        met_m = runner.x_m(self.met_s[runner.id])
        lane_y = runner.lane_y_m(runner.lane_at(self.met_s[runner.id]))
        outer_m = self.begin_m if runner.forward else self.end_m
        own = abs(self._beside_m(met_m, lane_y) - self._beside_m(outer_m, lane_y))
        return straight + own - (abs(met_m - outer_m))

    def _beside_m(self, x_m: float, y_m: float) -> float:
        """How far beyond the joint a place of the axis is, measured ``y_m`` left of the centre."""
        away = x_m - self.joint_m
        if self.curve is None:
            return away
        k, half = self.curve.curvature_1pm, self.curve.half_arc_m
        arc, own = half * (1.0 - k * self.axis_y_m), half * (1.0 - k * y_m)
        inside = min(abs(away), arc)
        return copysign(inside * own / arc + abs(away) - inside, away)

    def joint_station_m(self, runner: Runner) -> float:
        """Where the joint is on a drive, by the length of the lane in which it starts."""
        lane_y = runner.lane_y_m(runner.lane)
        return abs(self._beside_m(self.begin_m if runner.forward else self.end_m, lane_y))

    def centre_m(self, x_m: float) -> float:
        """How far beyond the joint a place of the axis is, measured along the centre line."""
        return self._beside_m(x_m, 0.0)

    def from_junction_m(self, arm: int, x_m: float) -> float:
        """How far a place is before the inner end of an arm."""
        beyond = self.centre_m(x_m)
        before = (-beyond if arm == self.ego_arm else beyond) - self.gaps_m[arm]
        if before < 0.0 < self.gaps_m[arm]:
            raise MotionInfeasibleError(
                f"somebody is {-before:.0f} m inside the junction of a ramp, beside arm {arm}",
                hint="Say where it is, or leave the ramp out.",
            )
        return max(before, 0.0)

    def pose(self, x_m: float, y_m: float) -> Pose:
        """The place in a frame whose origin is where the ego comes into the bend."""
        beyond = self.centre_m(x_m)
        if self.curve is None:
            return Pose(beyond, y_m, 0.0)
        k, half = self.curve.curvature_1pm, self.curve.half_arc_m
        arc = Segment(Pose(0.0, 0.0, 0.0), 2 * half, k)
        s = min(max(beyond + half, 0.0), 2 * half)
        return arc.pose(s).shifted(forward_m=beyond + half - s, left_m=y_m)


def frame_of(
    story: Story,
    walks: list[Walk],
    parked: list[Parked],
    road: RoadParameters,
    closest_s: float,
    lasts_s: float,
) -> Frame:
    """A road long enough for everybody until the end, with the joint where their arms need it.

    A bend lies about where the ego is when the others come closest.
    """
    assignment = story.logical.assignment(story.ego.id)
    arm = assignment.entry if isinstance(assignment, Drive) else 0
    lows, highs = [], []
    for runner in story.runners.values():
        for time_s in (0.0, lasts_s):
            low, high = runner.ends_m(time_s)
            lows.append(low)
            highs.append(high)
    own = [w.x_m for w in walks if w.crossing.arm == arm]
    own += [p.x_m + p.body.length_m for p in parked if p.standing.arm == arm]
    far = [w.x_m for w in walks if w.crossing.arm != arm]
    far += [p.x_m - p.body.length_m for p in parked if p.standing.arm != arm]
    forward = [r.ends_m(0.0)[1] for r in story.runners.values() if r.forward]
    backward = [r.ends_m(0.0)[0] for r in story.runners.values() if not r.forward]
    everything = [*own, *far]
    begin = min([*lows, *everything]) - _ARM_MARGIN_M - _LEAST_ARM_M
    end = max([*highs, *everything]) + _ARM_MARGIN_M + END_MARGIN_M
    least = max([*own, *forward], default=begin) + _JOINT_CLEAR_M
    most = min([*far, *backward], default=end) - _JOINT_CLEAR_M
    joint = least if least <= most or not far else min(far) - _JOINT_CLEAR_M
    curve = curve_of(road)
    if curve is None:
        if road.auxiliary is not None:
            joint = joint_m(story.functional, story.runners, joint)
            before, after = room_m(fitted(road, story.functional, story.runners, joint))
            begin, end = min(begin, joint - before), max(end, joint + after)
        joint = max(joint, begin + _LEAST_ARM_M)
        end = max(end, joint + _LEAST_ARM_M)
        return Frame(
            joint - ceil((joint - begin) / _ROUND_M) * _ROUND_M,
            joint,
            joint + ceil((end - joint) / _ROUND_M) * _ROUND_M,
            arm,
            lasts_s,
            gaps_m=gaps_m(road),
        )
    joint = max(joint, min(story.ego.x_m(closest_s), max(most, joint)))
    if arm == 1:
        curve = Curve(-curve.curvature_1pm, curve.half_arc_m)
    axis_y = story.ego.lane_y_m(story.ego.lane)
    arc = curve.half_arc_m * (1.0 - curve.curvature_1pm * axis_y)
    joint = max(joint, begin + _LEAST_ARM_M)
    begin, end = min(begin, joint - arc - _LEAST_ARM_M), max(end, joint + arc + _LEAST_ARM_M)
    met = {name: _met_s(runner, story.ego, closest_s) for name, runner in story.runners.items()}
    return Frame(begin, joint, end, arm, lasts_s, curve, axis_y, met)


def _met_s(runner: Runner, ego: Runner, closest_s: float) -> float:
    """When it matters most where somebody is: as it moves aside, as it meets who comes along."""
    if runner.moves:
        return min(move.begins_s for move in runner.moves)
    if runner.forward == ego.forward:
        return closest_s
    times = [closest_s * n / 50 for n in range(101)]
    return min(times, key=lambda t: abs(runner.x_m(t) - ego.x_m(t)))


def road_of(road: RoadParameters, frame: Frame) -> RoadParameters:
    """The road with arms as long as the frame."""
    near, beyond = -frame.centre_m(frame.begin_m), frame.centre_m(frame.end_m)
    lengths = [
        (near if arm.id == frame.ego_arm else beyond) - frame.gaps_m[arm.id] for arm in road.arms
    ]
    arms = tuple(
        arm.model_copy(update={"length_m": round(length, 3)})
        for arm, length in zip(road.arms, lengths, strict=True)
    )
    return road.model_copy(update={"arms": arms})


def written_runner(story: Story, frame: Frame, participant: Participant) -> ConcreteParticipant:
    """One along the road."""
    runner = story.runners[participant.id]
    entry = frame.ego_arm if runner.forward else 1 - frame.ego_arm
    changes = _changes(frame, runner)
    last = changes[-1].lane_after if changes else runner.lane
    joint = frame.joint_station_m(runner)
    start = frame.station_m(runner, runner.at_m or 0.0)
    reversal = None
    if runner.backs:
        back = runner.profile.way_m(frame.lasts_s) - FORTH_M
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
    return ConcreteParticipant(
        id=participant.id,
        kind=participant.kind,
        role=participant.role,
        parked=runner.stands,
        speed_mps=round(runner.speed_mps, 4),
        motion=motion,
        speed_program=tuple(_phase(story, frame, runner, step) for step in _in_order(runner)),
    )


def _in_order(runner: Runner) -> list[Step]:
    return sorted(runner.steps, key=lambda step: step.begins_s)


def _changes(frame: Frame, runner: Runner) -> tuple[LaneChange, ...]:
    """Moves to the side as places on the way: what is travelled meanwhile is their length."""
    changes, before = [], 0.0
    for move in sorted(runner.moves, key=lambda m: m.begins_s):
        begins = frame.station_m(runner, runner.x_m(move.begins_s))
        ends = frame.station_m(runner, runner.x_m(move.ends_s))
        begins = max(begins, before)
        length = max(ends - begins, _LEAST_MOVE_M)
        changes.append(
            LaneChange(
                position_m=round(begins, 3),
                length_m=round(length, 3),
                lane_after=move.lane,
                offset_m=round(move.offset_m, 3),
                hazard=move.hazard,
            )
        )
        before = round(begins, 3) + round(length, 3)
    return tuple(changes)


def _phase(story: Story, frame: Frame, runner: Runner, step: Step) -> SpeedPhase:
    return SpeedPhase(
        trigger=_trigger(story, frame, runner, step),
        target_speed_mps=round(step.target_mps, 4),
        rate_mps2=round(step.rate_mps2, 4),
        hazard=step.hazard,
        act=step.act if any(a.id == step.act for a in story.functional.acts) else None,
    )


def _trigger(story: Story, frame: Frame, runner: Runner, step: Step) -> Trigger:
    """What sets a step off: time if that is said, who it answers, or how far the ego has come."""
    if step.timed:
        return AtTime(time_s=round(step.begins_s, 3))
    moment = just_before_step_s(step.begins_s)
    if step.reacts_to is not None and step.reacts_to in story.runners:
        other = story.runners[step.reacts_to]
        here, there = (
            frame.pose(who.x_m(moment), who.y_m(moment, LANE_WIDTH_M)) for who in (runner, other)
        )
        apart = hypot(here.x_m - there.x_m, here.y_m - there.y_m)
        along = other.speed_at_mps(moment) * runner.sign * other.sign
        closing = runner.speed_at_mps(moment) > along + 0.05
        participant = any(p.id == other.id for p in story.functional.participants)
        if closing and participant:
            return DistanceBelow(participant=other.id, distance_m=round(apart, 3))
    return _come_so_far((story.ego, runner), moment)


def _come_so_far(whose: Sequence[Runner], moment_s: float) -> Trigger:
    """How far the first of them who moves has come at a moment; that moment if nobody does."""
    for who in whose:
        if who.speed_at_mps(moment_s) > _MOVES_MPS:
            return Travelled(participant=who.id, distance_m=round(who.profile.way_m(moment_s), 3))
    return AtTime(time_s=round(moment_s, 3))


def written_walk(story: Story, frame: Frame, walk: Walk, length_m: float) -> ConcreteParticipant:
    """One who goes across the road; ``length_m`` is how long its way is."""
    participant = story.functional.participant(walk.id)
    braking = walk.speed_mps**2 / (2 * walk.rate_mps2)
    end = max(0.0, length_m - braking - _STOPS_SHORT_M)
    meets = story.runners[walk.meets]
    trigger: Trigger = AtTime(time_s=round(walk.sets_off_s, 3))
    if not walk.timed:
        trigger = _come_so_far([meets], just_before_step_s(walk.sets_off_s))
    stops = walk.stops_after_m is not None
    return ConcreteParticipant(
        id=walk.id,
        kind=walk.kind,
        role=participant.role,
        speed_mps=0.0,
        motion=walk_motion(frame, walk),
        speed_program=(
            SpeedPhase(
                trigger=trigger,
                target_speed_mps=round(walk.speed_mps, 4),
                rate_mps2=walk.rate_mps2,
                hazard=_KINDS.get(walk.kind),
                act=walk.act,
            ),
            SpeedPhase(
                trigger=Travelled(participant=walk.id, distance_m=round(end, 3)),
                target_speed_mps=0.0,
                rate_mps2=walk.rate_mps2,
                hazard=HazardKind.STOPPING if stops else None,
            ),
        ),
    )


def walk_motion(frame: Frame, walk: Walk) -> CrossingMotion:
    """The way across."""
    crossing: Crossing = walk.crossing
    stops = walk.stops_after_m
    return CrossingMotion(
        arm=crossing.arm,
        start_side=crossing.start,
        from_junction_m=round(frame.from_junction_m(crossing.arm, walk.x_m), 3),
        setback_m=round(walk.setback_m, 3),
        stops_after_m=None if stops is None else round(stops, 3),
    )


def written_parked(story: Story, frame: Frame, parked: Parked) -> ConcreteParticipant:
    """One who is parked: its box's middle lies where the story has it."""
    standing: Standing = parked.standing
    participant, body = story.functional.participant(parked.id), BODIES[parked.kind]
    away = frame.from_junction_m(standing.arm, parked.x_m)
    # It heads the way of the traffic on its side; its reference point lies behind its middle.
    towards = (parked.on_left == story.ego.keeps_left) == (standing.arm == frame.ego_arm)
    away += body.centre_ahead_m if towards else -body.centre_ahead_m
    return ConcreteParticipant(
        id=parked.id,
        kind=parked.kind,
        role=participant.role,
        parked=True,
        speed_mps=0.0,
        motion=StandingMotion(
            arm=standing.arm, side=standing.side, from_junction_m=round(max(0.0, away), 3)
        ),
    )


def ends_s(story: Story, walks: list[Walk]) -> float:
    """When the last thing has happened that the story tells, the closest approach included."""
    moments = [4.0]
    for runner in story.runners.values():
        moments += [move.ends_s for move in runner.moves]
        moments += [runner.profile.settles_s(step.begins_s) for step in runner.steps]
    for walk in walks:
        across = walk.setback_m + 2 * story.lane_count * LANE_WIDTH_M + walk.body.length_m
        moments.append(walk.sets_off_s + walk.runs_s(across))
        meets = story.runners[walk.meets]
        moments.append(meets.profile.time_s(abs(walk.x_m - meets.x_m(0.0)) + meets.body.rear_m))
    return max(moment for moment in moments if moment < NEVER_S)

"""Where the road of a story along it lies: its arms, its joint, its bend, its auxiliary lane.

The joint is where a ramp's lane meets the others. Who merges comes along the ramp, gains speed in
the lane that ends, and leaves it well before; who takes the exit slows down in it.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import ceil, copysign

from scegen.concretization.along.runner import Runner
from scegen.concretization.along.story import Story
from scegen.errors import MotionInfeasibleError
from scegen.motion.paths import END_MARGIN_M
from scegen.road.cross_section import CROSSWALK_MIDDLE_M
from scegen.road.geometry import Pose
from scegen.road.model import RoadNetwork
from scegen.road.ramps import gore_m
from scegen.road.straight import Curve, curve_of
from scegen.scenario.road_parameters import RoadParameters
from scegen.scenario.roadway import AuxiliaryLane

_ARM_MARGIN_M = 3.0
_JOINT_CLEAR_M = 8.0
_LEAST_ARM_M = 40.0
RAMP_MPS = 90 / 3.6
"""A usual speed on ramps of motorways and at the beginning of an acceleration lane."""
ON_RAMP_S = 3.0
"""So much later who merges changes lanes than others: it comes along the ramp first."""
GAINS_MPS2, LOSES_MPS2 = 1.5, 1.5
"""Comfortable rates with which who merges gains speed, and who leaves loses it."""
_SETTLES_M, _SPARE_M = 40.0, 30.0
_LEAST_SETTLES_M = 5.0
_LEAST_M = 60.0
_LONGEST_M, _LONGEST_ARM_M = 600.0, 2000.0
_ROUND_M = 10.0


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

    def pose(self, network: RoadNetwork, x_m: float, y_m: float) -> Pose:
        """The place in the world."""
        beyond = self.centre_m(x_m)
        line = network.arm_road(self.ego_arm).line
        if self.curve is not None and beyond > 0.0:
            return network.arm_road(1 - self.ego_arm).line.reversed().pose(beyond, y_m)
        return line.pose(line.length_m + self.gaps_m[self.ego_arm] + beyond, y_m)


def frame_of(story: Story, road: RoadParameters, closest_s: float, lasts_s: float) -> Frame:
    """A road long enough for everybody until the end, with the joint where their arms need it.

    A bend lies about where the ego is when the others come closest.
    """
    arm, parked = story.ego_arm, story.parked.values()
    near = [p for p in parked if story.standing(p.id).arm == arm]
    beyond_it = [p for p in parked if p not in near]
    spans = [r.ends_m(time_s) for r in story.runners.values() for time_s in (0.0, lasts_s)]
    own = [w.x_m for w in story.walks.values() if w.crossing.arm == arm]
    own += [p.middle_m(0.0) + p.body.length_m for p in near]
    far = [w.x_m for w in story.walks.values() if w.crossing.arm != arm]
    far += [p.middle_m(0.0) - p.body.length_m for p in beyond_it]
    forward = [r.ends_m(0.0)[1] for r in story.runners.values() if r.forward]
    backward = [r.ends_m(0.0)[0] for r in story.runners.values() if not r.forward]
    everything = [*own, *far]
    begin = min([*(low for low, _ in spans), *everything]) - _ARM_MARGIN_M - _LEAST_ARM_M
    end = max([*(high for _, high in spans), *everything]) + _ARM_MARGIN_M + END_MARGIN_M
    least = max([*own, *forward], default=begin) + _JOINT_CLEAR_M
    most = min([*far, *backward], default=end) - _JOINT_CLEAR_M
    joint = least if least <= most or not far else min(far) - _JOINT_CLEAR_M
    marked = [w for w in story.walks.values() if w.crossing.arm in road.crosswalks]
    if marked:
        beyond = CROSSWALK_MIDDLE_M if marked[0].crossing.arm == arm else -CROSSWALK_MIDDLE_M
        joint = marked[0].x_m + beyond
        forward += [p.middle_m(0.0) for p in near]
        backward += [p.middle_m(0.0) for p in beyond_it]
        _joined_between(joint, forward, backward)
    curve, arc, axis_y, met = curve_of(road), 0.0, 0.0, dict[str, float]()
    if curve is not None:
        if not marked:
            joint = max(joint, min(story.ego.x_m(closest_s), max(most, joint)))
        if arm == 1:
            curve = Curve(-curve.curvature_1pm, curve.half_arc_m)
        axis_y = story.ego.lane_y_m(story.ego.lane)
        arc = curve.half_arc_m * (1.0 - curve.curvature_1pm * axis_y)
        met = {name: _met_s(each, story.ego, closest_s) for name, each in story.runners.items()}
    elif road.auxiliary is not None:
        joint = joint_m(story, joint)
        road = fitted(road, story, joint)
        before, after = (_LEAST_M + side_m for side_m in gaps_m(road, by_lane=True))
        begin, end = min(begin, joint - before), max(end, joint + after)
    joint = max(joint, begin + _LEAST_ARM_M)
    begin, end = min(begin, joint - arc - _LEAST_ARM_M), max(end, joint + arc + _LEAST_ARM_M)
    lengths = joint - begin, end - joint
    before, after = (ceil(length / _ROUND_M) * _ROUND_M for length in lengths)
    ends = joint - before, joint, joint + after
    return Frame(*ends, arm, lasts_s, curve, axis_y, met, gaps_m(road))


def _joined_between(joint_m: float, before_m: list[float], beyond_m: list[float]) -> None:
    """Refuse a crosswalk, beside which the arms meet, with somebody on the wrong side of it."""
    if max(before_m, default=joint_m) > joint_m or min(beyond_m, default=joint_m) < joint_m:
        raise MotionInfeasibleError(
            "somebody who starts on this side of the crosswalk would be beyond it",
            where="crosswalks",
            hint="Leave the crosswalk out, or say who is before it.",
        )


def _met_s(runner: Runner, ego: Runner, closest_s: float) -> float:
    """When it matters most where somebody is: as it moves aside, as it meets who comes along."""
    if runner.moves:
        return min(move.begins_s for move in runner.moves)
    times = [closest_s * n / 50 for n in range(101)]
    return min(times, key=lambda t: abs(runner.x_m(t) - ego.x_m(t)))


def road_of(road: RoadParameters, frame: Frame) -> RoadParameters:
    """The road with arms as long as the frame.

    Raises:
        MotionInfeasibleError: no road that long is built.
    """
    near, beyond = -frame.centre_m(frame.begin_m), frame.centre_m(frame.end_m)
    if max(near, beyond) > _LONGEST_ARM_M:
        raise MotionInfeasibleError(
            f"what is told takes {near + beyond:.0f} m of road",
            where="road",
            hint=f"At most {_LONGEST_ARM_M:g} m are built before its middle, and as much behind: "
            "let it take less time, or happen at lower speeds.",
        )
    lengths = {frame.ego_arm: near, 1 - frame.ego_arm: beyond}
    arms = tuple(
        arm.but(length_m=round(lengths[arm.id] - frame.gaps_m[arm.id], 3)) for arm in road.arms
    )
    return road.but(arms=arms)


def joint_m(story: Story, otherwise_m: float) -> float:
    """Where the joint must be, by the first who merges or the last who leaves."""
    moves = _moves_m(story)
    if not moves:
        return otherwise_m
    first, last = min(begins for begins, _ in moves), max(ends for _, ends in moves)
    said = story.functional.junction.auxiliary_length_m
    settles = _SETTLES_M
    if said is not None:
        settles = min(settles, max(said - (last - first), _LEAST_SETTLES_M))
    leaves = story.functional.junction.auxiliary is AuxiliaryLane.OFF_RAMP
    begun = [story.runners[n].ends_m(0.0)[0] - _JOINT_CLEAR_M for n in story.joined]
    return last + settles if leaves else min([first - settles, *begun])


def fitted(road: RoadParameters, story: Story, joint: float) -> RoadParameters:
    """The road with its auxiliary lane long enough for all who use it.

    Raises:
        MotionInfeasibleError: they change lanes too far from each other for one.
    """
    if road.auxiliary is None:
        return road
    farthest = 0.0
    for begins, ends in _moves_m(story):
        off = road.auxiliary.kind is AuxiliaryLane.OFF_RAMP
        farthest = max(farthest, joint - begins if off else ends - joint)
    needed = ceil((farthest + _SPARE_M) / _ROUND_M) * _ROUND_M if farthest else 0.0
    said = story.functional.junction.auxiliary_length_m
    most = said or _LONGEST_M
    if farthest > most - (_SPARE_M if said is None else 0.0):
        raise MotionInfeasibleError(
            f"those who use the auxiliary lane would need {farthest:.0f} m of it",
            where="junction.auxiliary",
            hint=f"At most {most:g} m are built: let them change lanes sooner or nearer.",
        )
    if said is not None:
        return road
    length = max(road.auxiliary.length_m, needed)
    return road.but(auxiliary=road.auxiliary.but(length_m=length))


def gaps_m(road: RoadParameters, *, by_lane: bool = False) -> tuple[float, float]:
    """How far from the joint the inner ends of arms 0 and 1 are: a ramp joins or leaves there.

    Or the auxiliary lane ends on the other side, if that is asked for.
    """
    lane = road.auxiliary
    if lane is None:
        return 0.0, 0.0
    ramp_m, lane_m = gore_m(road), lane.length_m + lane.taper_m if by_lane else 0.0
    return (lane_m, ramp_m) if lane.kind is AuxiliaryLane.OFF_RAMP else (ramp_m, lane_m)


def _moves_m(story: Story) -> list[tuple[float, float]]:
    """Where each who uses the auxiliary lane begins and ends its change of lane."""
    found = []
    for name in (story.merging | story.exiting) & story.runners.keys():
        runner = story.runners[name]
        lanes = [runner.lane, *(move.lane for move in runner.moves)]
        for move, before in zip(runner.moves, lanes, strict=False):
            if max(lanes) in {move.lane, before} and move.lane != before:
                found.append((runner.x_m(move.begins_s), runner.x_m(move.ends_s)))
    return found

"""Acts in time: when each begins, and the steps of speed and moves to the side that it becomes."""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from math import copysign

import numpy as np

from scegen.concretization.along.frame import GAINS_MPS2, LOSES_MPS2, ON_RAMP_S, RAMP_MPS
from scegen.concretization.along.parked import door_before, opening_s
from scegen.concretization.along.runner import Move, Runner
from scegen.concretization.along.spacing import JUST_M, first_s, is_level
from scegen.concretization.along.story import Story
from scegen.concretization.amounts import change_of_speed, goes_on_when_free, lasting_s
from scegen.concretization.boxes import missing_m
from scegen.concretization.limits import ABRUPT_LANE_CHANGE_S, HOLDS_S, LANE_CHANGE_S, REACTION_S
from scegen.concretization.profile import NEVER_S, SpeedChange
from scegen.concretization.tale import outward, pace_of
from scegen.errors import MotionInfeasibleError
from scegen.scenario.acts import (
    LEAVING,
    SLOWING,
    Act,
    ActKind,
    AfterAct,
    AfterDistance,
    AfterStart,
    WhenMeasure,
)
from scegen.scenario.concrete import MOST_OFFSET_M
from scegen.scenario.spacings import CONTACT, LENGTHWISE
from scegen.scenario.vocabulary import HazardKind, Side

_AT_ONCE_S = 0.3
"""Between two acts of one driver where the next follows at once: long enough to be two acts."""
_LATE_S, _LOOK_S = 60.0, 0.02
_SAME_MPS = 0.5
_CLEAR_OF_DOOR_M = 1.2
_PASSES_S, _SHIES_FOR_S = 1.0, 1.3
"""Who swerves round a door stays aside so long, until it has passed."""
_ABRUPT = frozenset({HazardKind.CUT_IN, HazardKind.SWERVING, HazardKind.LOSS_OF_CONTROL})


def perform_known(story: Story, acts: Sequence[Act], *, placed: bool) -> list[Act]:
    """Perform the acts whose moment is known, in their order; returns those that wait for more.

    Some wait for distances, which are told where everybody has a place (``placed``).
    """
    waiting: list[Act] = []
    for act in acts:
        moment_s = _moment_s(story, act, placed=placed)
        if moment_s < NEVER_S:
            perform(story, act, moment_s)
        else:
            waiting.append(act)
    return waiting


def is_timed_last(story: Story, act: Act) -> bool:
    """Whether an act follows upon overtaking, at once or by others: that follows from places."""
    name = act.when.act if isinstance(act.when, AfterAct) else None
    before = next((a for a in story.acts if a.id == name), None)
    if before is None:
        return False
    return story.goes_round(before) or story.comes_back(before) or is_timed_last(story, before)


def _is_placed_otherwise(story: Story, act: Act, when: WhenMeasure) -> bool:
    """Whether other statements fix how far apart the two of a trigger are, step by step."""
    pairs = [
        {s.participant, s.reference}
        for s in story.functional.spacings
        if s.measure in LENGTHWISE and s.at != CONTACT
    ]
    earlier = (a.when for a in story.acts[: story.acts.index(act)])
    pairs += [{w.participant, w.reference} for w in earlier if isinstance(w, WhenMeasure)]
    reached = {when.participant}
    for _ in pairs:
        reached |= {name for pair in pairs if pair & reached for name in pair}
    return when.reference in reached


def _moment_s(story: Story, act: Act, *, placed: bool) -> float:
    """When an act begins; ``placed``: everybody has a place, so that distances tell it, too."""
    when = act.when
    if isinstance(when, WhenMeasure) and story.comes_back(act):
        when = None  # it follows from how far ahead it is when it has passed
    if isinstance(when, WhenMeasure) and (placed or _is_placed_otherwise(story, act, when)):
        return _when_measured_s(story, when) if placed else NEVER_S
    if isinstance(when, AfterStart):
        return when.delay_s.middle
    if isinstance(when, AfterDistance):
        runner = story.runners.get(when.participant or act.participant)
        if runner is None or not placed:
            return NEVER_S
        return runner.profile.time_s(when.distance_m.middle)
    if isinstance(when, AfterAct) and not story.is_loose(act.id):
        known = story.ends_s if when.since == "end" else story.begins_s
        if when.act not in known:
            return NEVER_S
        beside = _passed_then_s(story, act, when)
        if beside is not None:
            return beside
        delay = 0.0 if goes_on_when_free(when) else when.later_s.middle
        alone = story.act(when.act).participant == act.participant
        rests = alone and story.runners[act.participant].speed_at_mps(known[when.act]) <= 0.0
        if rests and act.kind in SLOWING:
            return known[when.act]  # it stands already
        if alone and delay == 0.0 and when.since == "end":
            at_once = when.delay_s is not None and when.delay_s.high == 0.0
            delay = _AT_ONCE_S if at_once else HOLDS_S
        return known[when.act] + delay
    own = [story.ends_s[a.id] for a in story.acts_of(act.participant) if a.id in story.ends_s]
    if own:
        return max(own) + HOLDS_S
    by_ramp = story.merging - story.joined
    first_s = story.first_act_s + (ON_RAMP_S if act.participant in by_ramp else 0.0)
    told = [a for a in story.acts[: story.acts.index(act)] if a.id in story.begins_s]
    # Who goes aside for one that comes into its lane does so when that one is there.
    gives_way = act.kind in LEAVING
    comes = [story.ends_s[a.id] for a in told if gives_way and a.into == act.participant]
    return max([first_s, *(story.begins_s[a.id] for a in told), *comes])


def _passed_then_s(story: Story, act: Act, when: AfterAct) -> float | None:
    """When who goes aside as another passes has it beside itself, or just ahead if both miss."""
    passing, begins_s = story.act(when.act), story.begins_s.get(when.act)
    free = when.since == "begin" and when.delay_s is None and act.kind in LEAVING
    if begins_s is None or passing.kind is not ActKind.OVERTAKE or not free:
        return None
    pair = story.runners[passing.participant], story.runners[act.participant]
    beside_s = first_s(partial(is_level, *pair, 0.0), begins_s)
    if story.contact_wanted(*(runner.id for runner in pair)):
        return beside_s
    return first_s(lambda times_s: ~is_level(*pair, JUST_M, times_s), beside_s)


def _when_measured_s(story: Story, when: WhenMeasure) -> float:
    """The first moment at which the measure has come down to its value."""
    if not {when.participant, when.reference} <= story.runners.keys():
        return NEVER_S
    first, second = story.runners[when.participant], story.runners[when.reference]
    times = np.arange(0.0, _LATE_S, _LOOK_S)
    value = when.value.middle
    reached = missing_m(when.measure, value, second.track(times), first.track(times)) <= 0.0
    return float(times[np.argmax(reached)]) if reached.any() else NEVER_S


def perform(story: Story, act: Act, begins_s: float) -> None:
    """Add an act's steps and moves to who does it."""
    runner = story.runners[act.participant]
    answered = story.stopped_before(act) if act.when is None else None
    begins_s = begins_s if answered is None else answered.begins_s + REACTION_S
    story.begins_s[act.id] = begins_s
    if act.kind is ActKind.OPEN_DOOR:
        runner.appears_s, story.ends_s[act.id] = begins_s, begins_s + opening_s(act)
        return
    if story.goes_round(act) or story.comes_back(act):
        story.ends_s[act.id] = begins_s  # its moves follow from the places
        return
    if act.kind in {ActKind.CHANGE_LANE, ActKind.SWERVE}:
        moves = _sideways(story, act, runner, begins_s)
        runner.moves += moves
        runner.steps += _on_the_ramp(story, runner, moves)
        story.ends_s[act.id] = moves[-1].ends_s
        return
    runner.steps.append(_step(story, act, runner, begins_s))
    story.ends_s[act.id] = runner.profile.settles_s(begins_s)


def _step(story: Story, act: Act, runner: Runner, begins_s: float) -> SpeedChange:
    traffic = min(story.limit_mps, story.ego.speed_mps or story.limit_mps)
    usual = story.driven_mps(runner.id, traffic)
    before = runner.speed_at_mps(begins_s)
    change = change_of_speed(story, act, runner.body, before, usual)
    answered, rate = story.stopped_before(act), change.rate_mps2
    if answered is not None and act.rate_mps2 is None:
        rate = min(answered.rate_mps2, runner.body.max_deceleration_mps2)
    return replace(change, begins_s=begins_s, rate_mps2=rate)


def _on_the_ramp(story: Story, runner: Runner, moves: list[Move]) -> list[SpeedChange]:
    """Who merges gains the speed of the traffic meanwhile, who leaves slows down after it.

    If nothing else is said of its speed.
    """
    functional = story.functional
    drives_on = functional.participant(runner.id).unresponsive  # "without slowing"
    if runner.steps or story.speed_acts(runner.id) or drives_on:
        return []
    if runner.id in story.merging:
        others = (r for r in story.runners.values() if r.forward and r is not runner)
        traffic = max((r.speed_mps for r in others), default=story.limit_mps)
        target = min(traffic, pace_of(functional, story.logical, runner.id).high)
        said = functional.participant(runner.id).speed_mps is not None
        if said or target < runner.speed_mps + _SAME_MPS:
            return []
        lasts = (target - runner.speed_mps) / GAINS_MPS2
        begins = max(moves[0].begins_s - lasts / 2, 0.5)
        return [SpeedChange(target, GAINS_MPS2, begins)]
    if runner.id in story.exiting and runner.speed_mps > RAMP_MPS + _SAME_MPS:
        return [SpeedChange(RAMP_MPS, LOSES_MPS2, moves[-1].ends_s)]
    return []


def _sideways(story: Story, act: Act, runner: Runner, begins_s: float) -> list[Move]:
    """A change of lane, or out and back within it."""
    hazard = story.hazard_of(act)
    now = runner.lane_at(begins_s)
    if act.kind is ActKind.SWERVE or act.lateral_m is not None:
        return _swerve(story, act, runner, begins_s, hazard)
    lane = _lane_after(story, act, runner, now)
    into = story.runners.get(act.into or "", story.ego)
    if lane == 0 and story.innermost and into.forward != runner.forward:
        # Nobody crosses a median: who is on the wrong side has been there from the start.
        inner = outward(story.functional, Side.LEFT)
        there = min(story.functional.participant(runner.id).lanes, default=into.lane)
        runner.lane, runner.offset_m = 0, -inner * (there - 1) * runner.lane_width_m
        return [Move(begins_s, LANE_CHANGE_S, 0, runner.offset_m, act.id, hazard)]
    width = max(abs(lane - now), 1) * runner.lane_width_m
    usual = ABRUPT_LANE_CHANGE_S if hazard in _ABRUPT else LANE_CHANGE_S
    lasts = lasting_s(act, width, usual, story.grip_mps2)
    return [Move(begins_s, lasts, lane, 0.0, act.id, hazard)]


def _swerve(
    story: Story, act: Act, runner: Runner, begins_s: float, hazard: HazardKind | None
) -> list[Move]:
    lane = runner.lane_at(begins_s)
    side = act.side or _free_side(story, runner, lane)
    door, stays_s = door_before(story, runner.id), 0.1
    if act.lateral_m is None and door is not None:
        away = runner.y_m(0.0) - door.y_m(0.0)
        needs = (door.body.width_m + runner.body.width_m) / 2 + _CLEAR_OF_DOOR_M - abs(away)
        aside_m = runner.sign * copysign(max(needs, _CLEAR_OF_DOOR_M), away)
        lasts, stays_s = lasting_s(act, abs(aside_m), _SHIES_FOR_S, story.grip_mps2), _PASSES_S
        there, back = (lane, runner.offset_m + aside_m), runner.offset_m
    elif act.lateral_m is None and (_is_lane(story, lane, side) or act.side is None):
        side = side if _is_lane(story, lane, side) else side.opposite
        lasts = lasting_s(act, runner.lane_width_m, ABRUPT_LANE_CHANGE_S, story.grip_mps2)
        there, back = (max(0, lane + outward(story.functional, side)), 0.0), 0.0
    else:
        room_m = (runner.lane_width_m - runner.body.width_m) / 2  # up to the edge of its lane
        width = room_m if act.lateral_m is None else act.lateral_m.middle
        abrupt = hazard in _ABRUPT and act.lateral_m is None  # as quick as its tyres hold
        lasts = lasting_s(act, width, 0.0 if abrupt else LANE_CHANGE_S, story.grip_mps2)
        back = runner.moves[-1].offset_m if runner.moves else runner.offset_m
        there = lane, back + (width if side is Side.LEFT else -width)
        if abs(there[1]) > MOST_OFFSET_M:
            raise MotionInfeasibleError(
                f"{runner.id} goes {width:g} m aside, off the road",
                where=f"acts.{act.id}.lateral_m",
                hint=f"Give at most {MOST_OFFSET_M:g} m from the middle of its lane.",
            )
    out = Move(begins_s, lasts, *there, act.id, hazard)
    if act.kind is not ActKind.SWERVE:
        return [out]
    return [out, Move(out.ends_s + stays_s, lasts, lane, back, act.id, hazard)]


def _is_lane(story: Story, lane: int, side: Side) -> bool:
    """Whether there is a lane on that side to go into, be it that of the oncoming."""
    return story.innermost <= max(0, lane + outward(story.functional, side)) <= story.lane_count


def _lane_after(story: Story, act: Act, runner: Runner, now: int) -> int:
    """Who takes the exit gets there with its last change of lane, across those in between."""
    if runner.id in story.exiting and act is story.acts_of(runner.id, {act.kind})[-1]:
        return story.lane_count + 1
    into = story.runners.get(act.into or "")
    if into is not None:
        if into.forward != runner.forward:
            return 0
        if abs(into.lane - now) == 1:
            return into.lane
    side = act.side or _free_side(story, runner, now)
    lane = now + outward(story.functional, side)
    return max(story.innermost, min(lane, story.lane_count))


def _free_side(story: Story, runner: Runner, now: int) -> Side:
    """Towards whom it endangers; else towards the centre line, if there is a lane."""
    kerb, centre = story.functional.junction.kerb, story.inwards
    for other in (story.runners.get(name) for name in story.endangered_by(runner.id)):
        if other is not None and other.forward == runner.forward and other.lane != now:
            return kerb if other.lane > now else centre
        if other is not None and other.forward != runner.forward:
            return centre
    return centre if now > 1 or now == story.lane_count else kerb

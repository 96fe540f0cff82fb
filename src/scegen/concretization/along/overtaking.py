"""How one passes another, and how one that strays among the oncoming gets back."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from math import pi, sqrt

import numpy as np

from scegen.claims.boxes import free, gap_m
from scegen.concretization.along.performing import perform_known
from scegen.concretization.along.placing import place_again
from scegen.concretization.along.runner import Move, Runner
from scegen.concretization.along.spacing import JUST_M, just_misses, level
from scegen.concretization.along.story import FIRST_ACT_S, Story
from scegen.concretization.amounts import BRAKING
from scegen.concretization.limits import (
    ABRUPT_LANE_CHANGE_S,
    COMFORTABLE_ACCELERATION_MPS2,
    LANE_CHANGE_S,
    LATERAL_MPS2,
)
from scegen.concretization.profile import NEVER_S, SpeedChange
from scegen.concretization.tale import outward
from scegen.errors import MotionInfeasibleError
from scegen.motion.batch.arrays import Bools
from scegen.motion.model import Array
from scegen.scenario.acts import GAINING, Act, ActKind
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import HazardKind

_CLEAR_M, _CLEAR_HURRYING_M = 6.0, 1.0
_LONG_BACK_S = 2.5
_LOOK_S, _LONGEST_S = 0.05, 60.0
_CLEAR_BEFORE_S, _CLEAR_AFTER = 0.9, 0.6
"""Who strays has left the way of who comes so long before they are level: after this share of its
change back."""
_ASTRAY_S = 3.8
"""Who goes astray on purpose meets somebody so long after it is there, or would."""
_THERE_S = 0.1
"""Who is hit in the lane of the oncoming has been there so long."""
_STILL_THERE = 0.35
"""The share of a change back after which one is still in the way of who brakes for it."""
_FASTER_MPS, _HARDLY_MPS = 6.0, 1.5
"""By so much who overtakes one of its own speed speeds up; who is told to be faster does not."""


def overtake(story: Story) -> None:
    """Out, past, and back in: the moves of those who go round somebody, once places are known.

    Raises:
        MotionInfeasibleError: nobody is there whom one could overtake.
    """
    for act in story.acts:
        if not story.goes_round(act):
            continue
        if act.id not in story.begins_s:  # it follows upon another such act
            perform_known(story, [act], placed=True)
        slow = passed_by(story, act)
        if slow:
            fast = story.runners[act.participant]
            _pass(story, act, fast, slow)
            place_again(story, act, {r.id for r in (fast, *slow)})
        elif act.kind is ActKind.CHANGE_LANE or story.hazard_of(act) is not None:
            # Into the oncoming lane just for the oncoming; it comes back as they meet.
            out = Move(story.begins_s[act.id], LANE_CHANGE_S, 0, 0.0, act.id, story.hazard_of(act))
            story.runners[act.participant].moves.append(out)
            story.ends_s[act.id] = out.ends_s
        elif not story.parked:  # past one who is parked beside the lanes leads no change
            raise MotionInfeasibleError(
                "nobody is ahead of it whom it could overtake",
                where=act.participant,
                hint="Let another vehicle be ahead of it, or let it drive straight on.",
            )


def _meet_after(story: Story) -> None:
    """Who comes towards one in its lane meets it when it is back: just then, if that is a danger.

    Those whose place the text gives stay where they are.
    """
    said = {n for s in story.functional.spacings for n in (s.participant, s.reference)}
    # The ego's own straying counts more than what others do towards it.
    for stray in sorted(story.runners.values(), key=lambda r: r is story.ego):
        out = next((m for m in stray.moves if m.lane == 0), None)
        if out is None:
            continue
        there = (0, out.offset_m)
        later = (m for m in stray.moves if m.begins_s > out.begins_s)
        back = next((m for m in later if (min(m.lane, 1), m.offset_m) != there), None)
        free = [r for r in story.runners.values() if not {r.id, stray.id} & said]
        facing = [
            (not story.concern(stray.id, r.id), r.at_m or 0.0, r, clears) for r in free
            if r.forward != stray.forward and not r.stands and (clears := back or _dodge(r))
        ]  # fmt: skip
        if not facing:
            continue
        *_, other, clears = min(facing, key=lambda each: (each[0], each[1] * stray.sign))
        moment = _meeting_when_back_s(story, stray, other, out, clears)
        moved, fixed = (stray, other) if other is story.ego else (other, stray)
        shift = level(moved, fixed, moment) - (moved.at_m or 0.0)
        for runner in free:
            if runner.forward == moved.forward:
                runner.at_m = (runner.at_m or 0.0) + shift


def _meeting_when_back_s(
    story: Story, stray: Runner, other: Runner, out: Move, back: Move
) -> float:
    """When the two are level: in its lane if they are to touch, just not if it is a danger.

    One that brakes for it would be level with it there, if it did not. ``back`` may be the move by
    which the other leaves that lane.
    """
    if story.contact_wanted(stray.id, other.id):  # they touch before they are level
        closing = max(stray.speed_at_mps(out.ends_s) + other.speed_at_mps(out.ends_s), 1.0)
        touch_s = (stray.body.length_m + other.body.length_m) / 2 / closing
        return max((out.ends_s + back.begins_s) / 2, out.ends_s + _THERE_S + touch_s)
    if stray.id in story.endangered_by(other.id, *BRAKING):
        return back.begins_s + _STILL_THERE * back.lasts_s
    if story.concern(stray.id, other.id):
        goes, meets = (stray, other) if back in stray.moves else (other, stray)
        kept = goes.at_m

        def put(moment_s: float) -> None:
            goes.at_m = level(goes, meets, moment_s)

        found = just_misses((goes, meets), put, back.ends_s + 1.0, back.begins_s)
        goes.at_m = kept
        return found
    return back.ends_s + _LONG_BACK_S


def _dodge(other: Runner) -> Move | None:
    """The move by which one changes lanes for good."""
    return next((m for m in other.moves[-1:] if m.lane not in (0, other.lane)), None)


def passed_by(story: Story, act: Act) -> list[Runner]:
    """Who is overtaken, the last in line first: who is named, whom the danger is to, or the next.

    All whom the danger is to, or who stand in its lane, are passed in one go.
    """
    own = story.runners[act.participant]
    to = {*story.endangered_by(own.id, HazardKind.OVERTAKING)}
    alike = {
        name: runner
        for name, runner in story.runners.items()
        if runner.forward == own.forward and runner is not own and not runner.opens
    }
    meant = to if act.into is None or act.into in to else {act.into}
    named = [alike[name] for name in meant if name in alike]
    if named:
        return sorted(named, key=lambda r: (r.at_m or 0.0) * r.sign)
    order = story.ranks()
    line = [name for name, r in alike.items() if r.stands or order[name] < order[own.id]]
    ahead = [alike[name] for name in sorted(line, key=lambda name: -order[name])]
    standing = [r for r in ahead if r.stands and ahead[0].stands and r.lane == own.lane]
    return sorted(standing, key=lambda r: (r.at_m or 0.0) * r.sign) or ahead[:1]


def _pass(story: Story, act: Act, fast: Runner, line: list[Runner]) -> None:
    """Out as late as it can, past them all, and back so far ahead as is said, or usual.

    Who drives in another lane than all of them, or is made room for, stays in it until then.
    """
    hazard = story.hazard_of(act)
    slow, foremost = line[0], line[-1]
    out_lane, offset = _beside_lane(story, act, fast, slow)
    begins = story.begins_s[act.id]
    if act.when is None:
        begins = max(FIRST_ACT_S / 2, begins - FIRST_ACT_S)
    own = {fast.id, *(each.id for each in line)}
    told_now = [s for s in story.functional.spacings if s.at == act.id]
    at_once = act.when is not None or any(own >= {s.participant, s.reference} for s in told_now)
    hurries = bool(told_now) and not at_once  # who comes towards it is so near
    quick = hurries or act.kind is ActKind.SWERVE
    usual = ABRUPT_LANE_CHANGE_S if quick else LANE_CHANGE_S
    begins, lasts = _in_time(
        fast, slow, (out_lane, offset), (begins, usual), fixed=act.when is not None
    )
    told = story.functional.participant(fast.id).speed_mps is not None
    told &= not story.acts_of(foremost.id, GAINING)
    if fast.speed_mps - foremost.speed_mps < (_HARDLY_MPS if told else _FASTER_MPS / 2):
        top = min(foremost.speed_mps + _FASTER_MPS, fast.body.top_speed_mps)
        begins = story.begins_s[act.id]
        gains = SpeedChange(top, COMFORTABLE_ACCELERATION_MPS2, begins + lasts, act=act.id)
        fast.steps.append(gains)
    # The act by which it comes back in front of the other, if the text has one.
    later = story.acts[story.acts.index(act) + 1 :]
    again = (a for a in later if a.participant == fast.id and a.kind is ActKind.CHANGE_LANE)
    back = next((a for a in again if a.into in {None, slow.id}), None)
    making_room = {
        each.participant
        for each in story.acts
        if each.kind is ActKind.CHANGE_LANE and (each.side is None or each.side is not act.side)
    }
    stays = all(each.lane != fast.lane or each.id in making_room for each in line)
    aside = story.between(fast.id, slow.id, Measure.LATERAL_GAP_M)
    said = [s for s in story.functional.spacings if s.measure is Measure.GAP_M]
    ahead_m = (s.value.middle for s in said if back is not None and s.at == back.id)
    said_m = next(ahead_m, None)
    clear_m = _CLEAR_HURRYING_M if hurries else _CLEAR_M
    clear_m = said_m or (0.0 if stays and back is None else clear_m)
    is_clear = partial(_is_past, fast, foremost, clear_m)
    if not stays and not at_once and aside is None:
        reaches = _when(partial(_level, fast, slow, JUST_M), begins)
        kept = list(fast.moves)

        def put(begins_s: float) -> None:
            fast.moves = [*kept, Move(begins_s, lasts, out_lane, offset)]

        latest = just_misses((fast, slow), put, begins, max(reaches, begins))
        fast.moves = kept
        # Who is to be as near as is said when it comes back has come out by then.
        soon = NEVER_S if said_m is None else _when(is_clear, begins) - lasts
        begins = max(min(latest, soon), begins)
    clear = _when(is_clear, begins if stays else begins + lasts)
    story.begins_s[act.id] = _when(partial(_level, fast, slow, 0.0), begins) if stays else begins
    story.ends_s[act.id] = clear if stays or back is not None else clear + lasts
    if not stays:
        home = back.id if back is not None else act.id
        fast.moves = [
            Move(begins, lasts, out_lane, offset, act.id, hazard),
            Move(clear, lasts, fast.lane, 0.0, home, hazard),
        ]
    elif back is not None:
        fast.moves.append(Move(clear, lasts, slow.lane, 0.0, back.id, hazard))
    if back is not None:
        story.begins_s[back.id], story.ends_s[back.id] = clear, clear + lasts


def _in_time(
    fast: Runner, slow: Runner, place: tuple[int, float], usual_s: tuple[float, float],
    *, fixed: bool,
) -> tuple[float, float]:  # fmt: skip
    """When one pulls out and for how long, as usual or so that it is out as it reaches the other.

    Where the text puts the two close together, that is at once, and as quickly as one can steer;
    where it says when (``fixed``), it is then.
    """
    begins_s, longest_s = usual_s
    reaches_s = _when(partial(_level, fast, slow, 0.0), 0.0)
    if reaches_s == 0.0 or reaches_s >= begins_s + longest_s:
        return usual_s
    lane, offset_m = place
    aside_m = abs(fast.lane_y_m(lane) + fast.sign * offset_m - fast.y_m(0.0))
    shortest_s = sqrt(2.0 * pi * aside_m / LATERAL_MPS2)
    within_s = reaches_s - begins_s if fixed else reaches_s
    lasts_s = min(max(shortest_s, within_s), longest_s)
    return begins_s if fixed else min(begins_s, max(0.0, reaches_s - lasts_s)), lasts_s


def _is_past(fast: Runner, slow: Runner, clear_m: float, times_s: Array) -> Bools:
    return free(fast.track(times_s)[0], slow.track(times_s)[0]).rear >= clear_m


def _beside_lane(story: Story, act: Act, fast: Runner, slow: Runner) -> tuple[int, float]:
    """The lane in which one passes, and how far left of its middle.

    As far beside the other as the text says; else in the next lane.
    """
    said = story.between(fast.id, slow.id, Measure.LATERAL_GAP_M)
    if said is not None:
        apart = said.value.middle + (fast.body.width_m + slow.body.width_m) / 2
        kerb = -1 if not fast.keeps_left else 1
        wanted = slow.y_m(0.0) - kerb * fast.sign * apart
        return fast.lane, fast.sign * (wanted - fast.y_m(0.0)) + fast.offset_m
    if act.side is not None:
        return max(0, fast.lane + outward(story.functional, act.side)), 0.0
    if fast.lane == 1 and story.lane_count > 1 and slow.lane == 1:
        return 2, 0.0
    return max(0, fast.lane - 1), 0.0


def _when(true: Callable[[Array], Bools], from_s: float) -> float:
    """The first moment at which something holds, from another one on; that one if never."""
    times = from_s + np.arange(0.0, _LONGEST_S, _LOOK_S)
    return float(times[np.argmax(true(times))])


def come_back(story: Story) -> None:
    """Who strays into the lane of those who come towards it is back as they meet."""
    for runner in (r for r in story.runners.values() if r.moves and r.moves[-1].lane == 0):
        last = runner.moves[-1]
        time_s, name = min(_meetings(story, runner, last.begins_s), default=(NEVER_S, ""))
        if last.act is not None and story.goes_round(story.act(last.act)):
            time_s = last.ends_s + _ASTRAY_S
        elif time_s >= NEVER_S or story.contact_wanted(runner.id, name):
            continue
        if story.innermost and name and _dodge(story.runners[name]) is not None:
            continue  # beyond a median it stays there: the other gets out of its way
        back = max(last.ends_s + 0.1, time_s - _CLEAR_BEFORE_S - _CLEAR_AFTER * last.lasts_s)
        lane, offset = max(1, runner.lane), 0.0
        if story.innermost:  # beyond a median, it dodges into the lane beside
            lane, beside = 0, round(abs(runner.offset_m) / runner.lane_width_m) + 1
            beside = beside if beside < story.lane_count else beside - 2
            offset = (1 if not runner.keeps_left else -1) * beside * runner.lane_width_m
        runner.moves.append(Move(back, last.lasts_s, lane, offset, last.act, last.hazard))
    _meet_after(story)


def _level(first: Runner, second: Runner, within_m: float, times_s: Array) -> Bools:
    return gap_m(first.track(times_s)[0], second.track(times_s)[0]) <= within_m


def _meetings(story: Story, runner: Runner, from_s: float) -> Iterator[tuple[float, str]]:
    """When one is level with those who come towards it, and with whom."""
    for other in (r for r in story.runners.values() if r.forward != runner.forward):
        are_level = partial(_level, runner, other, 0.0)
        moment = _when(are_level, from_s)
        if are_level(np.array([moment]))[0]:
            yield moment, other.id

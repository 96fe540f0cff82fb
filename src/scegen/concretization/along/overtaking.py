"""How one passes another: out, past, and back in."""

from dataclasses import replace
from functools import partial
from math import pi, sqrt

from scegen.claims.boxes import free
from scegen.concretization.along.performing import perform_known
from scegen.concretization.along.placing import place_again
from scegen.concretization.along.runner import Move, Runner
from scegen.concretization.along.spacing import JUST_M, first_s, is_level, just_misses
from scegen.concretization.along.story import FIRST_ACT_S, Story
from scegen.concretization.limits import (
    ABRUPT_LANE_CHANGE_S,
    COMFORTABLE_ACCELERATION_MPS2,
    LANE_CHANGE_S,
    LATERAL_MPS2,
)
from scegen.concretization.profile import NEVER_S, SpeedChange
from scegen.concretization.tale import outward, told_at
from scegen.errors import MotionInfeasibleError
from scegen.motion.batch.arrays import Bools
from scegen.motion.model import Array
from scegen.scenario.acts import GAINING, Act, ActKind
from scegen.scenario.spacings import LENGTHWISE, Measure
from scegen.scenario.vocabulary import HazardKind, Maneuver, Side

_CLEAR_M, _CLEAR_HURRYING_M = 6.0, 1.0
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


def passed_by(story: Story, act: Act) -> list[Runner]:
    """Who is overtaken, the last in line first: who is named, whom the danger is to, or the next.

    All whom the danger is to, or who stand in its lane, are passed in one go.
    """
    own = story.runners[act.participant]
    to = {*story.endangered_by(own.id, HazardKind.OVERTAKING)}
    others = (r for r in story.runners.values() if r is not own and not r.opens)
    alike = {runner.id: runner for runner in others if runner.forward == own.forward}
    meant = to if act.into is None or act.into in to else {act.into}
    named = [alike[name] for name in meant if name in alike]
    if named:
        return sorted(named, key=lambda r: (r.at_m or 0.0) * r.sign)
    order = story.ranks()
    line = (r for r in alike.values() if r.stands or order[r.id] < order[own.id])
    ahead = sorted(line, key=lambda r: -order[r.id])
    standing = [r for r in ahead if r.stands and ahead[0].stands and r.lane == own.lane]
    return sorted(standing, key=lambda r: (r.at_m or 0.0) * r.sign) or ahead[:1]


def _pass(story: Story, act: Act, fast: Runner, line: list[Runner]) -> None:
    """Out as late as it can, past them all, and back so far ahead as is said, or usual.

    Who drives in another lane than all of them, or is made room for, stays in it until then; who
    is told to change lanes, and not to come back, is out for good.
    """
    hazard = story.hazard_of(act)
    slow, foremost = line[0], line[-1]
    out_lane, offset = _beside_lane(story, act, fast, slow)
    told_now = [s for s in story.functional.spacings if s.at == act.id]
    own = {fast.id, *(each.id for each in line)}
    of_them = {s.measure for s in told_now if own >= {s.participant, s.reference}}
    fixed = act.when is not None or not of_them.isdisjoint(LENGTHWISE)
    at_once = fixed or bool(of_them - {Measure.LATERAL_GAP_M})
    now = story.begins_s[act.id]
    begins = now if fixed else max(FIRST_ACT_S / 2, now - FIRST_ACT_S)
    hurries = bool(told_now) and not at_once  # who comes towards it is so near
    usual = ABRUPT_LANE_CHANGE_S if hurries or act.kind is ActKind.SWERVE else LANE_CHANGE_S
    begins, lasts = _in_time(fast, slow, (out_lane, offset), (begins, usual), fixed=fixed)
    told = story.has_said_speed(fast.id) and not story.acts_of(foremost.id, GAINING)
    least_mps = _HARDLY_MPS if told else _FASTER_MPS / 2
    too_slow = fast.speed_mps - foremost.fastest_mps < least_mps
    if too_slow:
        top = min(foremost.fastest_mps + _FASTER_MPS, fast.body.top_speed_mps)
        begins = begins if fast.speed_mps - foremost.speed_mps >= least_mps else now
        gains = SpeedChange(top, COMFORTABLE_ACCELERATION_MPS2, begins + lasts, act=act.id)
        fast.steps.append(gains)
    back = _back(story, act, slow)
    stays = all(each.lane != fast.lane or _makes_room(story, act, each) for each in line)
    aside = story.between(fast.id, slow.id, Measure.LATERAL_GAP_M)
    said_m = _said_m(story, back, foremost)
    usual_m = _CLEAR_HURRYING_M if hurries else _CLEAR_M
    clear_m = said_m or (0.0 if stays and back is None else usual_m)

    def is_clear(times_s: Array) -> Bools:
        return free(fast.track(times_s)[0], foremost.track(times_s)[0]).rear >= clear_m

    if not (stays or at_once or (too_slow and told)):  # a said speed is held until it is out
        out = Move(begins, lasts, out_lane, offset)
        latest = _latest_s(fast, slow, out, by_then=aside is not None)
        # Who is to be as near as is said when it comes back has come out by then.
        soon = NEVER_S if said_m is None else first_s(is_clear, begins) - lasts
        begins = max(min(latest, soon), begins)
    clear = first_s(is_clear, begins if stays else begins + lasts)
    story.begins_s[act.id] = (
        first_s(partial(is_level, fast, slow, 0.0), begins) if stays else begins
    )
    out_only = aside is None and out_lane > 0 and story.does(fast.id, Maneuver.LANE_CHANGE)
    comes_home = back is not None or not (stays or out_only)
    story.ends_s[act.id] = clear + lasts if comes_home and back is None else clear
    moves = fast.moves if stays else [Move(begins, lasts, out_lane, offset, act.id, hazard)]
    if comes_home:
        home = story.lane_count + 1 if fast.id in story.exiting else (slow if stays else fast).lane
        lasts *= max(abs(home - (fast.lane if stays else out_lane)), 1)  # across what is between
        moves.append(Move(clear, lasts, home, 0.0, (back or act).id, hazard))
    fast.moves = moves
    if back is not None:
        story.begins_s[back.id], story.ends_s[back.id] = clear, clear + lasts


def _latest_s(fast: Runner, slow: Runner, out: Move, *, by_then: bool) -> float:
    """The last moment at which one can pull out and misses the other, or is out ``by_then``."""
    reaches = first_s(partial(is_level, fast, slow, JUST_M), out.begins_s)
    kept = list(fast.moves)

    def put(begins_s: float) -> None:
        fast.moves = [*kept, replace(out, begins_s=begins_s)]

    last = max(reaches - (out.lasts_s if by_then else 0.0), out.begins_s)
    latest = just_misses((fast, slow), put, out.begins_s, last)
    fast.moves = kept
    return latest


def _makes_room(story: Story, act: Act, slow: Runner) -> bool:
    """Whether one who is passed changes lanes, and not to the side on which it is passed."""
    side = act.side or story.inwards
    return any(a.side is not side for a in story.acts_of(slow.id, {ActKind.CHANGE_LANE}))


def _said_m(story: Story, back: Act | None, passed: Runner) -> float | None:
    """How far ahead of whom it has passed one is said to be when it comes back."""
    if back is None:
        return None
    told = told_at(story.functional, back)
    metres = {Measure.GAP_M: 1.0, Measure.HEADWAY_S: passed.speed_mps}
    return next((t.value.middle * metres[t.measure] for t in told if t.measure in metres), None)


def _back(story: Story, act: Act, passed: Runner) -> Act | None:
    """The act by which who passes another comes back in front of it, if the text has one."""
    later = story.acts[story.acts.index(act) + 1 :]
    own = (a for a in later if (a.participant, a.kind) == (act.participant, ActKind.CHANGE_LANE))
    return next((a for a in own if a.into in {None, passed.id}), None)


def _in_time(
    fast: Runner, slow: Runner, place: tuple[int, float], usual_s: tuple[float, float],
    *, fixed: bool,
) -> tuple[float, float]:  # fmt: skip
    """When one pulls out and for how long, as usual or so that it is out as it reaches the other.

    Where the text puts the two close together, that is at once, and as quickly as one can steer;
    where it says when (``fixed``), it is then.
    """
    begins_s, longest_s = usual_s
    reaches_s = first_s(partial(is_level, fast, slow, 0.0), 0.0)
    if reaches_s == 0.0 or reaches_s >= begins_s + longest_s:
        return usual_s
    lane, offset_m = place
    aside_m = abs(fast.lane_y_m(lane) + fast.sign * offset_m - fast.y_m(0.0))
    shortest_s = sqrt(2.0 * pi * aside_m / LATERAL_MPS2)
    within_s = reaches_s - begins_s if fixed else reaches_s
    lasts_s = min(max(shortest_s, within_s), longest_s)
    return begins_s if fixed else min(begins_s, max(0.0, reaches_s - lasts_s)), lasts_s


def _beside_lane(story: Story, act: Act, fast: Runner, slow: Runner) -> tuple[int, float]:
    """The lane in which one passes, and how far left of its middle.

    As far beside the other as the text says; else in the next lane.
    """
    said = story.between(fast.id, slow.id, Measure.LATERAL_GAP_M)
    if said is not None:
        apart = said.value.middle + (fast.body.width_m + slow.body.width_m) / 2
        leftwards = 1 if (act.side or story.inwards) is Side.LEFT else -1
        wanted = slow.y_m(0.0) + leftwards * fast.sign * apart
        return fast.lane, fast.sign * (wanted - fast.y_m(0.0)) + fast.offset_m
    if act.side is not None:
        return max(0, fast.lane + outward(story.functional, act.side)), 0.0
    if fast.lane == 1 and story.lane_count > 1 and slow.lane == 1:
        return 2, 0.0
    return max(0, fast.lane - 1), 0.0

"""What the text says that drives do at a junction: its acts as marks of their courses."""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import takewhile
from math import inf

from scegen.concretization.amounts import change_of_speed, falls_back, goes_on_when_free
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.encounters import ahead_on_arm, happens_s_m, stops_for_walkers
from scegen.concretization.limits import (
    COMFORTABLE_BRAKING_MPS2,
    FAST_LATERAL_MPS2,
    HOLDS_S,
    LEAD_IN_S,
)
from scegen.concretization.moments import during_s
from scegen.concretization.profile import Profile, Sort, SpeedChange
from scegen.concretization.setup import Setup, require_room
from scegen.concretization.walkers import leaves_s
from scegen.motion.trigger_steps import STEP_S
from scegen.scenario.acts import (
    ENTERING,
    GAINING,
    SLOWING,
    Act,
    ActKind,
    AfterAct,
    AfterStart,
    BeforeJunction,
)
from scegen.scenario.logical import Reverses
from scegen.scenario.reversing import BacksUp
from scegen.scenario.signals import AtLight
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import HazardKind, Maneuver

STOOD_S = 200.0
"""One that stands at first has stood so long on its course."""
STANDS_FIRST_S = 0.5
_BEFORE_LINE_M, _QUEUE_BEFORE_LINE_M, _BEFORE_WALKER_M = 1.0, 2.0, 0.75
_QUEUE_GAP_M, _STANDS_MPS2 = 2.0, 5.0
_AFTER_WALKER_S = 0.5
_INTO_M, _ROLLS_M = 0.5, 0.4
_TURNS_AT = 0.6
_SETS_OFF_M = 8.0
"""Who waits for green does what it does besides so far behind the place where it has waited."""
_LATE = 0.5
"""One who brakes late begins with half of the braking distance left."""


def do_acts(scene: Setup) -> None:
    """Give everybody who drives the marks of its acts; places that are open are usual ones.

    Those who stand at first set off when they would have come by.
    """
    for draft in scene.drives.values():
        if draft.stands:
            draft.offset_s = -STOOD_S
            continue
        behind = (each for each in scene.drives.values() if each.stands)
        boxed_in = any(ahead_on_arm(scene, each)[-1:] == [draft] for each in behind)
        if isinstance(draft.reversal, BacksUp) and boxed_in:  # it cannot have come from there
            draft.offset_s = -draft.course.time_at(draft.path.backwards[0][0] - _ROLLS_M)
        if draft.parked_s_m is not None or draft.drive.reverses is Reverses.SQUARE:
            continue
        marks = list(marks_of(scene, draft))
        if not marks or draft.steps:
            continue
        came_s = draft.course.time_at(draft.junction_s_m - draft.body.front_m - _BEFORE_LINE_M)
        if scene.sets_off(draft.id):
            draft.stops_at_line = False  # it stands there
        if any(a.kind in GAINING and a.target_speed_mps for a in scene.speed_acts(draft.id)):
            draft.lateral_mps2 = max(draft.lateral_mps2, FAST_LATERAL_MPS2)
        draft.steps = marks
        if scene.sets_off(draft.id):
            phase = draft.course.phase_of(marks[1].act or "")
            draft.offset_s += came_s - (phase.begins_s if phase is not None else came_s)
        else:
            _place(scene, draft)


def stand_in_line(scene: Setup) -> None:
    """Those who are said to stay stand before the junction, one behind the other, for good.

    Before those who walk over their arm, too. Who waits for green does so behind them, or behind
    others who wait.
    """
    for draft in sorted(scene.drives.values(), key=lambda each: each.drive.rank):
        waits = not draft.stands and scene.waits_for_green(draft.id)
        if draft.steps or not (draft.stands or waits):
            continue
        walks = [w for w in scene.walks.values() if w.crossing.arm == draft.drive.entry]
        crossed_m = (w.from_junction_m + w.body.width_m / 2 + _BEFORE_WALKER_M for w in walks)
        free_m = max(crossed_m, default=_QUEUE_BEFORE_LINE_M)
        place = draft.junction_s_m - draft.body.front_m - free_m
        place = draft.waits_s_m if waits else place
        ahead = ahead_on_arm(scene, draft)
        for other in [o for o in ahead if o.entry_lane == draft.entry_lane][-1:]:
            said = scene.between(draft.id, other.id, Measure.GAP_M)
            gap_m = _QUEUE_GAP_M if said is None else said.value.middle
            behind = other.body.rear_m + gap_m + draft.body.front_m
            if other.stands:
                place = other.course.ends_m - behind
            elif scene.waits_for_green(other.id):
                place = other.waits_s_m - behind
            elif isinstance(back := other.reversal, BacksUp):
                comes_to = draft.laid.path_s_m(back.from_m - back.length_m) - behind
                touches = scene.contact_wanted(other.id, draft.id)
                place = comes_to + _QUEUE_GAP_M + (_INTO_M if touches else -_INTO_M)
        if waits:
            draft.queues_m = draft.waits_s_m - place
        else:
            stand(draft, min([place, *_before_slowing_m(scene, draft)]))


def stand(draft: DriveDraft, place_m: float) -> None:
    """Let it have come to a place of its way and stand there."""
    begins = place_m - draft.speed_mps**2 / (2 * _STANDS_MPS2)
    draft.steps = [SpeedChange(0.0, _STANDS_MPS2, s_m=begins, sort=Sort.ACT)]


def _before_slowing_m(scene: Setup, draft: DriveDraft) -> Iterator[float]:
    """Where it stands for those who drive into it as fast as is said, not as a bend lets them."""
    for other in scene.drives.values():
        into = draft in ahead_on_arm(scene, other) and scene.contact_wanted(other.id, draft.id)
        if into and scene.has_said_speed(other.id):
            slows_m = min((mark.s_m for mark in _slows(other)), default=inf)
            yield slows_m + other.body.front_m + draft.body.rear_m - _INTO_M


def lead_in_missing_s(scene: Setup) -> float:
    """How much too early the first act comes, where the text does not say when.

    Who goes across stands for a moment before.
    """
    marked = {mark.act for draft in scene.drives.values() for mark in draft.steps}
    begins = [
        during_s(scene, act)[0]
        for act in scene.acts
        if act.id in marked or (act.kind in ENTERING and act.participant in scene.drives)
        if not isinstance(act.when, AfterStart)
    ]
    timed = {act.participant for act in scene.acts if isinstance(act.when, AfterStart)}
    leaves = [leaves_s(scene, name) for name in scene.walks if name not in timed]
    return max(
        0.0,
        LEAD_IN_S - min(begins, default=LEAD_IN_S),
        STANDS_FIRST_S - min(leaves, default=STANDS_FIRST_S),
    )


def marks_of(scene: Setup, draft: DriveDraft) -> Iterator[SpeedChange]:
    """The marks of one's acts, the first of each chain at place 0."""
    before = draft.speed_mps
    pulls_out = draft.parked_s_m is not None
    usual = scene.driven_mps(draft.id, before) if pulls_out else before
    own: set[str] = set()
    took_s = 0.0
    if scene.sets_off(draft.id):
        place, rate = draft.parked_s_m, draft.braking_mps2(5.0)
        if place is None:
            place = draft.junction_s_m - draft.body.front_m - _BEFORE_LINE_M
        else:  # nobody sees how it came there
            rate = before**2 / place
        yield SpeedChange(0.0, rate, s_m=place - before**2 / (2 * rate), sort=Sort.ACT)
        before = 0.0
    for act in scene.speed_acts(draft.id):
        change = change_of_speed(scene, act, draft.body, before, usual)
        if falls_back(act):
            change = replace(change, target_mps=min(_turning_mps(scene, draft), before))
        when = act.when
        then = _then_s(scene, draft, act, own, took_s, stands=before == 0.0)
        place = 0.0
        if isinstance(when, BeforeJunction) and when.participant is None and then is None:
            place = draft.junction_s_m - draft.body.front_m - when.distance_m.middle
            if act.kind is ActKind.STOP:  # where it stands
                place -= before**2 / (2 * change.rate_mps2)
        yield replace(change, s_m=place, then_s=then)
        took_s = abs(change.target_mps - before) / change.rate_mps2
        before = change.target_mps
        own.add(act.id)
    if not own and _stops_at_light(scene, draft):  # only the light is told
        yield SpeedChange(0.0, draft.braking_mps2(COMFORTABLE_BRAKING_MPS2), sort=Sort.ACT)


def _then_s(
    scene: Setup, draft: DriveDraft, act: Act, own: set[str], took_s: float, *, stands: bool
) -> float | None:
    """So long after its ``own`` act before an act begins, if it follows upon that.

    The one before ``took_s``, and left it standing or not.
    """
    when = act.when
    if not own and stands:
        return STOOD_S
    if isinstance(when, AfterAct) and when.act in own:
        if stands and act.kind in SLOWING:
            return STEP_S  # it stands already
        delay_s = when.later_s.middle
        if goes_on_when_free(when):  # when walkers are over
            walkers = stops_for_walkers(scene, draft)
            delay_s = 0.0 if walkers is None else walkers[1] - took_s + _AFTER_WALKER_S
        then = max(delay_s, 0.0) or HOLDS_S
        return max(0.0, then - took_s) if when.since == "begin" else then
    return HOLDS_S if own and when is None else None


def _turning_mps(scene: Setup, draft: DriveDraft) -> float:
    """How fast one takes the turn that the text tells of: so much it brakes; 0 without one.

    Who is slow enough for it brakes a little all the same.
    """
    if not _turns(scene, draft):
        return 0.0
    return next((m.target_mps for m in _slows(draft)), _TURNS_AT * draft.speed_mps)


def _turns(scene: Setup, draft: DriveDraft) -> bool:
    """Whether the text tells of the turn that one takes."""
    said, turn = scene.functional.participant(draft.id).maneuvers, draft.drive.turn
    return turn in said and turn is not Maneuver.STRAIGHT


def _slows(draft: DriveDraft) -> Iterator[SpeedChange]:
    """How it slows down for what its way needs."""
    return (mark for mark in draft.road_changes() if mark.sort is Sort.SLOWS)


def _stops_at_light(scene: Setup, draft: DriveDraft) -> bool:
    return scene.functional.participant(draft.id).light is AtLight.STOPS


def is_open(scene: Setup, mark: SpeedChange) -> bool:
    """Whether the place of an act is free: neither said, nor that of the act before it."""
    if mark.act is None or mark.then_s is not None or _waits_at_line(scene, mark):
        return False
    when = scene.act(mark.act).when
    return not isinstance(when, BeforeJunction) or when.participant is not None


def _waits_at_line(scene: Setup, mark: SpeedChange) -> bool:
    """Whether it is how one waits at a junction, nobody says where: at its line."""
    acts = (a for a in scene.functional.acts if a.id == mark.act and a.kind is ActKind.WAIT)
    return not scene.network.plain and any(a.when is None for a in acts)


def _place(scene: Setup, draft: DriveDraft) -> None:
    """Put the first of each chain where its last is done in time for what it is about.

    Of who waits for somebody, where it stands.
    """
    free = {act.id for act in scene.acts if goes_on_when_free(act.when)}
    until = takewhile(lambda mark: mark.act not in free, draft.steps)
    way = _way_m(draft.speed_mps, until)
    first = draft.steps[0]
    place = first.s_m
    into = scene.act(first.act).into if first.act else None
    lets_by = stops_for_walkers(scene, draft, into) if into else None
    at_line = lets_by is None and _waits_at_line(scene, first)
    is_free = first.act is None or is_open(scene, first)
    if at_line or (is_free and _stops_at_light(scene, draft)):
        line = draft.stop_line_s_m - draft.body.front_m - _BEFORE_LINE_M
        place = line - _way_m(draft.speed_mps, [first])
    elif lets_by is None and is_free and scene.waits_for_green(draft.id):
        place = draft.waits_s_m + _SETS_OFF_M
    elif lets_by is not None:
        place = lets_by[0] - _way_m(draft.speed_mps, [first])
    elif is_open(scene, first):
        kind = first.hazard or HazardKind.HARD_BRAKING
        act = scene.act(first.act or "")
        late = _LATE if kind is HazardKind.DELAYED_BRAKING else 1.0
        ends = happens_s_m(scene, draft, kind, act.kind)
        if falls_back(act) and _turns(scene, draft):  # "brakes to turn right": for that
            ends = next((min(mark.by_m, mark.s_m + way) for mark in _slows(draft)), ends)
        place = ends - late * way
    least = draft.body.rear_m + LEAD_IN_S * draft.speed_mps
    require_room(draft.id, place, least, 5.0)
    later = [
        replace(mark, s_m=place + way) if is_open(scene, mark) else mark for mark in draft.steps[1:]
    ]
    draft.steps = [replace(first, s_m=place), *later]


def _way_m(speed_mps: float, marks: Iterable[SpeedChange]) -> float:
    """The way from the beginning of a chain until its last act is done."""
    profile, ready = Profile(speed_mps), 0.0
    for mark in marks:
        begins = ready + (mark.then_s or 0.0)
        profile.change(begins, mark.target_mps, mark.rate_mps2)
        ready = profile.settles_s(begins)
    return profile.way_m(ready)

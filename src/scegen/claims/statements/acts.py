"""Acts: that they happen, by how much, and what sets them off."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

from scegen.claims import tolerances
from scegen.claims.arms import arms_of
from scegen.claims.boxes import box_at, boxes, contact, free, offset, seen
from scegen.claims.claim import NEVER, Claim, ClaimKind, Judged, Test, always, within
from scegen.claims.lateral import lateral_m
from scegen.claims.moments import (
    act_begins,
    act_run,
    at,
    first,
    passed,
    rest,
    sideways_begin,
    straightened,
)
from scegen.claims.statements.act_ends import SWERVES_M, act_ends, aside_over
from scegen.claims.statements.maneuvers import LANE_M
from scegen.claims.statements.spacings import measure_at
from scegen.claims.statements.touching import hit_s
from scegen.claims.told import KPH, Told, amount, plain
from scegen.claims.view import View
from scegen.motion.batch.arrays import SPEED, Bools, Floats, Ints
from scegen.motion.doors import WAY_M
from scegen.scenario.acts import (
    GAINING,
    LEAVING,
    SLOWING,
    Act,
    ActKind,
    AfterAct,
    AfterDistance,
    AfterStart,
    BeforeJunction,
    WhenMeasure,
)
from scegen.scenario.concrete import door_of
from scegen.scenario.in_line import is_said_ahead
from scegen.scenario.logical import Drive
from scegen.scenario.model import Interval
from scegen.scenario.spacings import Measure
from scegen.scenario.verbs import does, has_done
from scegen.scenario.vocabulary import Side

_AJAR_M = 0.05
_OPENS_BEFORE_S = Interval(low=0.0, high=4.0)
"""Whoever is farther away when a door opens has time to look for another way."""
_BESIDE_M = 0.5
_SPEED_OVER_S = 0.1
_AT_ONCE_S = Interval(low=0.0, high=2.0)
"""What follows at once does so within the time of a slow reaction."""
_TURNS_AT_ONCE_S = Interval(low=0.0, high=4.0)
"""Who stood at a line comes to the bend first."""


def claims(told: Told) -> Iterator[Claim]:
    """Of every act: that it happens, each of its amounts, what sets it off."""
    for act in told.functional.acts:
        if act.kind is ActKind.GIVE_WAY:
            continue  # whom it lets go first is a claim of its own
        yield from _in_order(told, act)
        doing = f"{act.participant} {does(act.kind)}"
        yield _claim(told, act, "", doing, "s", _happens)
        if act.kind in SLOWING | GAINING:
            yield from _of_speed(told, act)
        if act.kind in LEAVING:
            yield from _sideways(told, act)
        if act.kind is ActKind.WAIT:
            yield _claim(told, act, "rest", f"{act.participant} comes to rest", "km/h", _rests)
        if act.kind is ActKind.WAIT and act.duration_s is not None:
            statement = f"{act.participant} stands for {amount(act.duration_s)} s"
            tolerance = 2 * tolerances.TIME_S
            yield _claim(told, act, "duration_s", statement, "s", _stands, tolerance=tolerance)
        if act.kind is ActKind.OPEN_DOOR:
            yield from _opens(told, act)
        if act.kind is ActKind.REVERSE and act.distance_m is not None:
            statement = f"{act.participant} goes {amount(act.distance_m)} m back"
            tolerance = tolerances.GAP_M
            yield _claim(told, act, "distance_m", statement, "m", _goes_back, tolerance=tolerance)
        yield from _triggered(told, act, doing)


def _in_order(told: Told, act: Act) -> Iterator[Claim]:
    """What one does comes in the order of the text, where no moments are given."""
    own = [a for a in told.acts_of(act.participant) if a.kind is not ActKind.GIVE_WAY]
    before = own[own.index(act) - 1] if own.index(act) else None
    if before is None or isinstance(act.when, AfterAct) or before.when is not None:
        return
    statement = f"{act.participant} {does(before.kind)} first, and then {does(act.kind)}"
    tolerance = tolerances.TIME_S
    yield _claim(told, act, "order", statement, "s", _follows, before, tolerance=tolerance)


def _follows(told: Told, act: Act, before: Act, view: View) -> Judged:
    """How much later the second begins."""
    first_s, then_s = (_when(view, _begins(told, each, view)) for each in (before, act))
    return Judged(then_s - first_s + tolerances.TIME_S, then_s - first_s, then_s)


def _claim(
    told: Told,
    act: Act,
    part: str,
    statement: str,
    unit: str,
    test: Callable[..., Judged],
    *args: object,
    tolerance: float = 0.0,
    scale: float = 1.0,
) -> Claim:
    bound: Test = partial(test, told, act, *args)
    return Claim(
        id=f"act.{act.id}.{part}" if part else f"act.{act.id}",
        kind=ClaimKind.ACT,
        statement=statement,
        field=f"acts.{act.id}.{part}" if part else f"acts.{act.id}",
        unit=unit,
        test=bound,
        tolerance=tolerance,
        scale=scale,
    )


def _begins(told: Told, act: Act, view: View) -> Ints:
    return act_begins(view, told.functional, told.logical, act)


def _when(view: View, step: Ints) -> Floats:
    return np.where(step < view.steps, view.time_of(step), np.nan)


def _happens(told: Told, act: Act, view: View) -> Judged:
    """Within the time that is played."""
    step = _begins(told, act, view)
    time_s = _when(view, step)
    return Judged(view.time_of(view.last_step) - time_s, time_s, time_s)


def _opens(told: Told, act: Act) -> Iterator[Claim]:
    """A door is closed until somebody comes, and open when that one is there."""
    coming = {to for h in told.hazards if act.participant in h.by for to in h.to} or {told.ego}
    for name in sorted(coming):
        statement = f"the door of {act.participant} is open when {name} comes to it"
        yield _claim(told, act, f"open.{name}", statement, "s", _is_open, name)
        if act.when is None:
            statement = f"the door of {act.participant} opens before {name}, shortly before"
            yield _claim(told, act, f"before.{name}", statement, "s", _shortly_before, name)


def _is_open(_told: Told, act: Act, name: str, view: View) -> Judged:
    """How long it has been open when that one is nearest."""
    door = door_of(act.participant)
    if door not in view.index:
        return always(view, holds=False)
    place = view.place_m(door)
    opened = first(place >= WAY_M - _AJAR_M)
    nearest = view.of_pair("closest_s", name, door)
    since = nearest - _when(view, opened)
    return Judged(since + tolerances.TIME_S, since, _when(view, opened))


def _shortly_before(told: Told, act: Act, name: str, view: View) -> Judged:
    """How far away that one still is, in time."""
    door, step = door_of(act.participant), _begins(told, act, view)
    if door not in view.index:
        return always(view, holds=False)
    away = measure_at(view, Measure.HEADWAY_S, act.participant, name, step)
    follows = seen(box_at(view, name, step), box_at(view, door, step)).x > 0.0
    margin = np.where((step < view.steps) & follows, within(away, _OPENS_BEFORE_S, 0.0), np.nan)
    return Judged(margin, away, _when(view, step))


def _of_speed(told: Told, act: Act) -> Iterator[Claim]:
    name = act.participant
    verb = {
        ActKind.BRAKE: "brakes",
        ActKind.STOP: "stops",
        ActKind.ACCELERATE: "accelerates",
        ActKind.SET_OFF: "sets off",
    }[act.kind]
    if act.rate_mps2 is not None:
        statement = f"{name} {verb} with {amount(act.rate_mps2)} m/s2"
        yield _claim(
            told, act, "rate_mps2", statement, "m/s2", _rate, tolerance=tolerances.RATE_MPS2
        )
    target = act.target_speed_mps
    if target is None and act.kind is ActKind.STOP:
        target = Interval(low=0.0, high=0.0)
    if target is not None:
        statement = f"{name} {verb} to {amount(target, KPH)} km/h"
        tolerance = tolerances.SPEED_MPS * KPH
        yield _claim(
            told,
            act,
            "target_speed_mps",
            statement,
            "km/h",
            _ends_at,
            target,
            tolerance=tolerance,
            scale=5.0,
        )
    if act.duration_s is not None:
        statement = f"{name} {verb} for {amount(act.duration_s)} s"
        yield _claim(told, act, "duration_s", statement, "s", _lasts, tolerance=tolerances.TIME_S)
    if act.distance_m is not None:
        statement = f"{name} {verb} over {amount(act.distance_m)} m"
        tolerance = tolerances.DISTANCE_M
        yield _claim(told, act, "distance_m", statement, "m", _goes_on, tolerance=tolerance)


def _rate(told: Told, act: Act, view: View) -> Judged:
    """Mean rate of the run without its first and last step, in which it may be cut."""
    run = act_run(view, told.functional, act)
    speed = view.speed_mps(act.participant)
    long = run.end - run.begin > 3
    low, high = np.where(long, run.begin + 1, run.begin), np.where(long, run.end - 1, run.end)
    took = np.maximum(high - low, 1) * view.dt_s
    rate = np.abs(at(speed, high) - at(speed, low)) / took
    wanted = act.rate_mps2 or Interval(low=0.0, high=0.0)
    margin = np.where(run.happens, within(rate, wanted, tolerances.RATE_MPS2), np.nan)
    return Judged(margin, rate, view.time_of(run.begin))


def _ends_at(told: Told, act: Act, target: Interval, view: View) -> Judged:
    """The speed in which the run ends; a contact before leaves it open."""
    run = act_run(view, told.functional, act)
    speed = at(view.speed_mps(act.participant), run.end)
    margin = within(speed, target, tolerances.SPEED_MPS)
    hit = hit_s(told, view, act.participant)
    cut = view.time_of(run.end) >= np.minimum(hit, view.time_of(view.last_step))
    margin = np.where(cut & np.isfinite(hit), np.maximum(margin, 0.0), margin)
    margin = np.where(run.happens, margin, np.nan)
    return Judged(margin * KPH, speed * KPH, view.time_of(run.end))


def _lasts(told: Told, act: Act, view: View) -> Judged:
    run = act_run(view, told.functional, act)
    took = view.time_of(run.end - run.begin)
    wanted = act.duration_s or Interval(low=0.0, high=0.0)
    margin = np.where(run.happens, within(took, wanted, tolerances.TIME_S), np.nan)
    return Judged(margin, took, view.time_of(run.end))


def _rests(told: Told, act: Act, view: View) -> Judged:
    """How slow it becomes once it has begun to slow down."""
    later = np.arange(view.steps) >= _begins(told, act, view)[:, None]
    speed = np.where(later, view.speed_mps(act.participant), np.inf)
    step = speed.argmin(axis=1)
    slowest = at(speed, step)
    return Judged((tolerances.STANDS_MPS - slowest) * KPH, slowest * KPH, view.time_of(step))


def _stands(told: Told, act: Act, view: View) -> Judged:
    """From when it has come to rest until it goes on."""
    begins, ends = rest(view, told.functional, act)
    stood = view.time_of(ends - begins)
    wanted = act.duration_s or Interval(low=0.0, high=0.0)
    margin = within(stood, wanted, 2 * tolerances.TIME_S)
    return Judged(np.where(ends < view.steps, margin, np.nan), stood, view.time_of(ends))


def _goes_on(told: Told, act: Act, view: View) -> Judged:
    run = act_run(view, told.functional, act)
    place = view.place_m(act.participant)
    gone = at(place, run.end) - at(place, run.begin)
    wanted = act.distance_m or Interval(low=0.0, high=0.0)
    margin = np.where(run.happens, within(gone, wanted, tolerances.DISTANCE_M), np.nan)
    return Judged(margin, gone, view.time_of(run.end))


def _goes_back(told: Told, act: Act, view: View) -> Judged:
    """The way that it goes backwards; a contact before leaves it open."""
    back = np.maximum(-view.row(act.participant, SPEED), 0.0).sum(axis=1) * view.dt_s
    wanted = act.distance_m or Interval(low=0.0, high=0.0)
    margin = within(back, wanted, tolerances.GAP_M)
    hit = np.isfinite(hit_s(told, view, act.participant)) & (back < wanted.low)
    return Judged(
        np.where(hit, np.maximum(margin, 0.0), margin), back, view.time_of(view.last_step)
    )


def _sideways(told: Told, act: Act) -> Iterator[Claim]:
    name = act.participant
    if act.kind is not ActKind.OVERTAKE:
        far = LANE_M if act.kind is ActKind.CHANGE_LANE else SWERVES_M
        to = f" to the {act.side}" if act.side else ""
        moves = "changes lane" if act.kind is ActKind.CHANGE_LANE else "swerves"
        yield _claim(told, act, "side", f"{name} {moves}{to}", "m", _aside, far)
    elif act.side is not None:
        passes = f"{name} passes on the {act.side}"
        yield _claim(told, act, "side", passes, "m", _passes_there)
    if act.lateral_m is not None:
        statement = f"{name} goes {amount(act.lateral_m)} m to the side"
        tolerance = 2 * tolerances.LATERAL_M
        yield _claim(told, act, "lateral_m", statement, "m", _far_aside, tolerance=tolerance)
    if act.lateral_mps is not None:
        statement = f"{name} goes sideways at {amount(act.lateral_mps)} m/s"
        tolerance = 2 * tolerances.LATERAL_M
        yield _claim(told, act, "lateral_mps", statement, "m/s", _fast_aside, tolerance=tolerance)
    if act.duration_s is not None:
        statement = f"{name} takes {amount(act.duration_s)} s to go aside"
        tolerance = 2 * tolerances.TIME_S
        yield _claim(told, act, "duration_s", statement, "s", _lasts_aside, tolerance=tolerance)
    if act.into is not None:
        where, test = "into the lane of", _into
        if act.kind is ActKind.OVERTAKE:
            where, test = "up beside", _beside
        yield _claim(told, act, "into", f"{name} comes {where} {act.into}", "m", test)


def _lateral(told: Told, act: Act, view: View) -> Floats:
    """Way to the side that is said, own left if none (c, t)."""
    moved = lateral_m(view, act.participant, told.drive(act.participant))
    if act.side is None:
        return np.abs(moved)
    return moved if act.side is Side.LEFT else -moved


def _aside(told: Told, act: Act, far: float, view: View) -> Judged:
    """How far it comes to that side from where the act begins."""
    moved = _lateral(told, act, view)
    begins = sideways_begin(view, told.functional, told.drive(act.participant), act)
    later = np.arange(view.steps) >= begins[:, None]
    moved = np.where(later, moved - at(moved, begins)[:, None], 0.0)
    step = moved.argmax(axis=1)
    most = at(moved, step)
    # Who hits the one beside it comes no farther.
    far_m = np.where(_hits(told, act, view), min(far, SWERVES_M), far)
    return Judged(most - far_m, most, view.time_of(step))


def _hits(told: Told, act: Act, view: View) -> Bools:
    """Whether it touches the one into whose lane it goes, as is said (c,)."""
    who, other = act.participant, act.into or told.ego
    if who == other or not told.may_touch(who, other):
        return np.zeros(view.count, dtype=np.bool_)
    return contact(view, who, other).happens


def _passes_there(told: Told, act: Act, view: View) -> Judged:
    """On which side of the one passed it is while they are level, its centre beside theirs."""
    name = act.participant
    best, when = np.full(view.count, -NEVER), np.zeros(view.count, dtype=np.int64)
    for other in passed(told.functional, act, view):
        own, frame = boxes(view, name), boxes(view, other)
        ahead, left = offset(frame, own)
        level = np.abs(ahead) < frame.half_length + own.half_length
        beside = np.where(level, left if act.side is Side.LEFT else -left, NEVER)
        step = beside.argmin(axis=1)
        least = np.where(level.any(axis=1), at(beside, step), -NEVER)
        when = np.where(least > best, step, when)
        best = np.maximum(best, least)
    return Judged(best - _BESIDE_M, best, view.time_of(when))


def _far_aside(told: Told, act: Act, view: View) -> Judged:
    moved = _lateral(told, act, view)
    step = moved.argmax(axis=1)
    most = at(moved, step)
    wanted = act.lateral_m or Interval(low=0.0, high=0.0)
    return Judged(within(most, wanted, 2 * tolerances.LATERAL_M), most, view.time_of(step))


def _fast_aside(told: Told, act: Act, view: View) -> Judged:
    moved = lateral_m(view, act.participant, told.drive(act.participant))
    n = max(1, round(_SPEED_OVER_S / view.dt_s))
    speed = np.abs(moved[:, 2 * n :] - moved[:, : -2 * n]) / (2 * n * view.dt_s)
    step = speed.argmax(axis=1)
    most = at(speed, step)
    wanted = act.lateral_mps or Interval(low=0.0, high=0.0)
    return Judged(within(most, wanted, 2 * tolerances.LATERAL_M), most, (step + n) * view.dt_s)


def _into(told: Told, act: Act, view: View) -> Judged:
    """After it has begun to move sideways, its centre comes into the other's lane."""
    step = _begins(told, act, view)
    away = np.abs(offset(boxes(view, act.into or told.ego), boxes(view, act.participant))[1])
    away = np.where(np.arange(view.steps) >= step[:, None], away, np.inf)
    nearest = away.min(axis=1)
    margin = tolerances.SAME_LANE_M - nearest
    margin = np.where(_hits(told, act, view), np.maximum(margin, 0.0), margin)
    return Judged(margin, nearest, away.argmin(axis=1) * view.dt_s)


def _beside(told: Told, act: Act, view: View) -> Judged:
    """How far it is from being level, along the road, at the least; a contact may come before."""
    clear = free(boxes(view, act.into or told.ego), boxes(view, act.participant))
    away = np.maximum(clear.front, clear.rear)
    step = away.argmin(axis=1)
    nearest = at(away, step)
    margin = np.where(_hits(told, act, view), np.maximum(-nearest, 0.0), -nearest)
    return Judged(margin, nearest, view.time_of(step))


def _triggered(told: Told, act: Act, doing: str) -> Iterator[Claim]:
    when = act.when
    if isinstance(when, AfterStart):
        statement = f"{doing} {amount(when.delay_s)} s after the start"
        yield _claim(
            told, act, "when", statement, "s", _after_start, when, tolerance=tolerances.TIME_S
        )
    elif isinstance(when, AfterAct):
        other = next(a for a in told.functional.acts if a.id == when.act)
        whose = "it" if other.participant == act.participant else other.participant
        begins = f"begins to {plain(other.kind)}"
        event = f"{whose} {begins if when.since == 'begin' else has_done(other.kind)}"
        statement = f"{doing} {_later(when)} after {event}"
        tolerance = 2 * tolerances.TIME_S
        yield _claim(
            told, act, "when", statement, "s", _after_act, when, other, tolerance=tolerance
        )
    elif isinstance(when, WhenMeasure):
        unit = tolerances.UNITS[when.measure]
        pair = f"{when.participant} to {when.reference}"
        name = plain(when.measure.rpartition("_")[0])
        statement = f"{doing} when the {name} of {pair} is {amount(when.value)} {unit}"
        tolerance = tolerances.OF_MEASURE[when.measure]
        yield _claim(told, act, "when", statement, unit, _at_measure, when, tolerance=tolerance)
    elif isinstance(when, AfterDistance):
        whose = f" of {when.participant}" if when.participant else ""
        statement = f"{doing} after {amount(when.distance_m)} m{whose}"
        tolerance = tolerances.DISTANCE_M
        yield _claim(told, act, "when", statement, "m", _driven, when, tolerance=tolerance)
    elif isinstance(when, BeforeJunction):
        who = when.participant or act.participant
        drive = told.drive(who)
        if drive is None:
            return
        whose = f" of {who}" if when.participant else ""
        statement = f"{doing} {amount(when.distance_m)} m{whose} before the junction"
        tolerance = tolerances.DISTANCE_M
        yield _claim(told, act, "when", statement, "m", _before, when, drive, tolerance=tolerance)


def _later(when: AfterAct) -> str:
    if when.delay_s is None:
        return "some time"
    return "right" if when.delay_s.high == 0.0 else f"{amount(when.delay_s)} s"


def _after_start(told: Told, act: Act, when: AfterStart, view: View) -> Judged:
    time_s = _when(view, _begins(told, act, view))
    return Judged(within(time_s, when.delay_s, tolerances.TIME_S), time_s, time_s)


def _after_act(told: Told, act: Act, when: AfterAct, other: Act, view: View) -> Judged:
    since = act_ends(told, other, view) if when.since == "end" else _begins(told, other, view)
    began = _begins(told, act, view)
    delay = np.where((since < view.steps) & (began < view.steps), began - since, np.nan)
    delay = delay * view.dt_s
    if when.delay_s is None:
        margin = delay + 2 * tolerances.TIME_S
    else:
        at_once = _TURNS_AT_ONCE_S if act.kind is ActKind.TURN else _AT_ONCE_S
        wanted = at_once if when.delay_s.high == 0.0 else when.delay_s
        margin = within(delay, wanted, 2 * tolerances.TIME_S)
    return Judged(margin, delay, view.time_of(began))


def _lasts_aside(told: Told, act: Act, view: View) -> Judged:
    """From when it leaves its line until its rear has come as far aside as its middle."""
    begins = _begins(told, act, view)
    _, _, _, over = aside_over(told, act, begins, view)
    took = view.time_of(straightened(view, act.participant, over) - begins)
    wanted = act.duration_s or Interval(low=0.0, high=0.0)
    margin = within(took, wanted, 2 * tolerances.TIME_S)
    return Judged(np.where(over < view.steps, margin, np.nan), took, view.time_of(over))


def _at_measure(told: Told, act: Act, when: WhenMeasure, view: View) -> Judged:
    """The value somewhere within the step in which it begins."""
    step = _begins(told, act, view)
    who, reference = when.participant, when.reference
    ahead = is_said_ahead(told.functional, told.hazards, who, reference, act.id)
    values = [
        measure_at(view, when.measure, who, reference, step + n, ahead=ahead) for n in (-1, 0, 1)
    ]
    low, high = np.min(values, axis=0), np.max(values, axis=0)
    tolerance = tolerances.OF_MEASURE[when.measure]
    margin = np.max([within(value, when.value, tolerance) for value in values], axis=0)
    passes = (low <= when.value.high) & (high >= when.value.low)
    margin = np.where(passes, np.maximum(margin, tolerance), margin)
    margin = np.where(step < view.steps, margin, np.nan)
    return Judged(margin, values[1], view.time_of(step))


def _driven(told: Told, act: Act, when: AfterDistance, view: View) -> Judged:
    step = _begins(told, act, view)
    place = view.place_m(when.participant or act.participant)
    gone = at(place, step) - place[:, 0]
    margin = within(gone, when.distance_m, tolerances.DISTANCE_M)
    return Judged(np.where(step < view.steps, margin, np.nan), gone, view.time_of(step))


def _before(told: Told, act: Act, when: BeforeJunction, drive: Drive, view: View) -> Judged:
    """Where it begins; of one that stops, where it stands."""
    arm = arms_of(view)[drive.entry]
    box = boxes(view, drive.participant)
    step = _begins(told, act, view)
    if act.kind is ActKind.STOP and when.participant is None:
        run = act_run(view, told.functional, act)
        step = np.where(run.happens, run.end, view.steps)
    left = arm.length_m - at(arm.place(box)[0], step) - box.half_length
    margin = within(left, when.distance_m, tolerances.DISTANCE_M)
    return Judged(np.where(step < view.steps, margin, np.nan), left, view.time_of(step))

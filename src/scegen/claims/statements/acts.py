"""Acts: that they happen, by how much, and what sets them off."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple

import numpy as np

from scegen.claims import tolerances
from scegen.claims.arms import arms_of
from scegen.claims.boxes import box_at, boxes, contact, gap_m, offset, seen, to_side
from scegen.claims.claim import (
    NEVER,
    Claim,
    ClaimKind,
    Judged,
    Test,
    always,
    as_wanted,
    best_of,
    within,
)
from scegen.claims.lateral import lateral_m
from scegen.claims.moments import (
    act_begins,
    act_run,
    aside_over,
    passed,
    rest,
    sideways_begin,
    straightened,
)
from scegen.claims.series import at, first, greatest, least
from scegen.claims.statements.act_ends import SWERVES_M, act_ends
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

_FAR_M = tolerances.DISTANCE_M
_ASIDE_M, _LONG_S = 2 * tolerances.LATERAL_M, 2 * tolerances.TIME_S
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
        if act.kind in LEAVING:
            yield from _to_a_side(told, act)
        if act.kind is ActKind.WAIT:
            yield _claim(told, act, "rest", f"{act.participant} comes to rest", "km/h", _rests)
        yield from _amounts(told, act)
        if act.kind in LEAVING and act.into is not None:
            where, test = "into the lane of", _into
            if act.kind is ActKind.OVERTAKE:
                where, test = "up beside", _beside
            statement = f"{act.participant} comes {where} {act.into}"
            yield _claim(told, act, "into", statement, "m", test)
        if act.kind is ActKind.OPEN_DOOR:
            yield from _opens(told, act)
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
    first_s, then_s = (_when(view, act_begins(told, each, view)) for each in (before, act))
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
    name = f"{act.id}.{part}" if part else act.id
    bound: Test = partial(test, told, act, *args)
    kind, field = ClaimKind.ACT, f"acts.{name}"
    return Claim(f"act.{name}", kind, statement, field, unit, bound, tolerance, scale)


def _when(view: View, step: Ints) -> Floats:
    return np.where(step < view.steps, view.time_of(step), np.nan)


def _happens(told: Told, act: Act, view: View) -> Judged:
    """Within the time that is played."""
    time_s = _when(view, act_begins(told, act, view))
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
    opened_s = _when(view, first(view.place_m(door) >= WAY_M - _AJAR_M))
    since = view.of_pair("closest_s", name, door) - opened_s
    return Judged(since + tolerances.TIME_S, since, opened_s)


def _shortly_before(told: Told, act: Act, name: str, view: View) -> Judged:
    """How far away that one still is, in time."""
    door, step = door_of(act.participant), act_begins(told, act, view)
    if door not in view.index:
        return always(view, holds=False)
    away = measure_at(view, Measure.HEADWAY_S, act.participant, name, step)
    follows = seen(box_at(view, name, step), box_at(view, door, step)).x > 0.0
    there = (step < view.steps) & follows
    return as_wanted(away, _OPENS_BEFORE_S, 0.0, _when(view, step), there=there)


def _rests(told: Told, act: Act, view: View) -> Judged:
    """How slow it becomes once it has begun to slow down."""
    later = np.arange(view.steps) >= act_begins(told, act, view)[:, None]
    slowest, step = least(np.where(later, view.speed_mps(act.participant), np.inf))
    return Judged((tolerances.STANDS_MPS - slowest) * KPH, slowest * KPH, view.time_of(step))


class _Found(NamedTuple):
    """What was measured, when, where there is something to measure, what is let pass (c,)."""

    value: Floats
    time_s: Floats
    there: Bools | bool = True
    excused: Bools | bool = False


def _rate(told: Told, act: Act, view: View) -> _Found:
    """Mean rate of the run without its first and last step, in which it may be cut."""
    run, speed = act_run(told, act, view), view.speed_mps(act.participant)
    long = run.end - run.begin > 3
    low, high = np.where(long, run.begin + 1, run.begin), np.where(long, run.end - 1, run.end)
    rate = np.abs(at(speed, high) - at(speed, low)) / (np.maximum(high - low, 1) * view.dt_s)
    return _Found(rate, view.time_of(run.begin), run.happens)


def _speed_after(told: Told, act: Act, view: View) -> _Found:
    """The speed in which the run ends; a contact before leaves it open."""
    run, hit = act_run(told, act, view), hit_s(told, view, act.participant)
    speed, time_s = at(view.speed_mps(act.participant), run.end), view.time_of(run.end)
    cut = time_s >= np.minimum(hit, view.time_of(view.last_step))
    return _Found(speed, time_s, run.happens, cut & np.isfinite(hit))


def _lasts(told: Told, act: Act, view: View) -> _Found:
    run = act_run(told, act, view)
    return _Found(view.time_of(run.end - run.begin), view.time_of(run.end), run.happens)


def _goes_on(told: Told, act: Act, view: View) -> _Found:
    run, place = act_run(told, act, view), view.place_m(act.participant)
    return _Found(at(place, run.end) - at(place, run.begin), view.time_of(run.end), run.happens)


def _stands(told: Told, act: Act, view: View) -> _Found:
    """From when it has come to rest until it goes on."""
    begins, ends = rest(told, act, view)
    return _Found(view.time_of(ends - begins), view.time_of(ends), ends < view.steps)


def _goes_back(told: Told, act: Act, view: View) -> _Found:
    """The way that it goes backwards; a contact before leaves it open."""
    back = np.maximum(-view.row(act.participant, SPEED), 0.0).sum(axis=1) * view.dt_s
    short = back < act.distance_m.low if act.distance_m else False
    hit = np.isfinite(hit_s(told, view, act.participant)) & short
    return _Found(back, view.time_of(view.last_step), excused=hit)


def _far_aside(told: Told, act: Act, view: View) -> _Found:
    most, step = greatest(_lateral(told, act, view))
    return _Found(most, view.time_of(step))


def _fast_aside(told: Told, act: Act, view: View) -> _Found:
    moved = lateral_m(view, act.participant, told.drive(act.participant))
    n = max(1, round(_SPEED_OVER_S / view.dt_s))
    most, step = greatest(np.abs(moved[:, 2 * n :] - moved[:, : -2 * n]) / (2 * n * view.dt_s))
    return _Found(most, view.time_of(step + n))


def _lasts_aside(told: Told, act: Act, view: View) -> _Found:
    """From when it leaves its line until its rear has come as far aside as its middle."""
    begins = act_begins(told, act, view)
    over = aside_over(told, act, begins, view)[-1]
    took = view.time_of(straightened(view, act.participant, over) - begins)
    return _Found(took, view.time_of(over), over < view.steps)


class _Amount(NamedTuple):
    """A field of acts of some kinds, how it is told, how exactly it must hold, how it is found."""

    part: str
    kinds: frozenset[ActKind]
    says: str
    unit: str
    tolerance: float
    find: Callable[[Told, Act, View], _Found]


_PACED = SLOWING | GAINING
_WAITING, _REVERSING = frozenset({ActKind.WAIT}), frozenset({ActKind.REVERSE})
_AMOUNTS = (
    _Amount("rate_mps2", _PACED, "{does} with {} m/s2", "m/s2", tolerances.RATE_MPS2, _rate),
    _Amount(
        "target_speed_mps", _PACED, "{does} to {} km/h", "km/h", tolerances.SPEED_MPS, _speed_after
    ),
    _Amount("duration_s", _PACED, "{does} for {} s", "s", tolerances.TIME_S, _lasts),
    _Amount("distance_m", _PACED, "{does} over {} m", "m", _FAR_M, _goes_on),
    _Amount("lateral_m", LEAVING, "goes {} m to the side", "m", _ASIDE_M, _far_aside),
    _Amount("lateral_mps", LEAVING, "goes sideways at {} m/s", "m/s", _ASIDE_M, _fast_aside),
    _Amount("duration_s", LEAVING, "takes {} s to go aside", "s", _LONG_S, _lasts_aside),
    _Amount("duration_s", _WAITING, "stands for {} s", "s", _LONG_S, _stands),
    _Amount("distance_m", _REVERSING, "goes {} m back", "m", tolerances.GAP_M, _goes_back),
)


def _amounts(told: Told, act: Act) -> Iterator[Claim]:
    """One for every number that the text gives; who stops does so to 0 km/h."""
    for row in _AMOUNTS:
        wanted: Interval | None = getattr(act, row.part) if act.kind in row.kinds else None
        if act.kind is ActKind.STOP and row.part == "target_speed_mps":
            wanted = wanted or Interval(low=0.0, high=0.0)
        if wanted is not None:
            factor, scale = (KPH, 5.0) if row.unit == "km/h" else (1.0, 1.0)
            told_so = row.says.format(amount(wanted, factor), does=does(act.kind))
            yield _claim(
                told, act, row.part, f"{act.participant} {told_so}", row.unit, _amounts_to,
                row, wanted, factor, tolerance=row.tolerance * factor, scale=scale,
            )  # fmt: skip


def _amounts_to(
    told: Told, act: Act, row: _Amount, wanted: Interval, factor: float, view: View
) -> Judged:
    """What is found of it in the range that is said."""
    value, time_s, there, excused = row.find(told, act, view)
    margin = within(value, wanted, row.tolerance)
    margin = np.where(excused, np.maximum(margin, 0.0), margin)
    return Judged(np.where(there, margin, np.nan) * factor, value * factor, time_s)


def _to_a_side(told: Told, act: Act) -> Iterator[Claim]:
    """To which side it goes, or passes."""
    name = act.participant
    if act.kind is not ActKind.OVERTAKE:
        far = LANE_M if act.kind is ActKind.CHANGE_LANE else SWERVES_M
        to = f" to the {act.side}" if act.side else ""
        yield _claim(told, act, "side", f"{name} {does(act.kind)}{to}", "m", _aside, far)
    elif act.side is not None:
        passes = f"{name} passes on the {act.side}"
        yield _claim(told, act, "side", passes, "m", _passes_there)


def _lateral(told: Told, act: Act, view: View) -> Floats:
    """Way to the side that is said, to either if none (c, t)."""
    return to_side(act.side, lateral_m(view, act.participant, told.drive(act.participant)))


def _aside(told: Told, act: Act, far: float, view: View) -> Judged:
    """How far it comes to that side from where the act begins."""
    moved, begins = _lateral(told, act, view), sideways_begin(told, act, view)
    later = np.arange(view.steps) >= begins[:, None]
    most, step = greatest(np.where(later, moved - at(moved, begins)[:, None], 0.0))
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
    passes = []
    for other in passed(told, act, view):
        own, frame = boxes(view, act.participant), boxes(view, other)
        ahead, left = offset(frame, own)
        level = np.abs(ahead) < frame.half_length + own.half_length
        beside, step = least(np.where(level, to_side(act.side, left), NEVER))
        beside = np.where(level.any(axis=1), beside, -NEVER)
        passes.append(Judged(beside - _BESIDE_M, beside, view.time_of(step)))
    return best_of(view, passes)


def _into(told: Told, act: Act, view: View) -> Judged:
    """After it has begun to move sideways, its centre comes into the other's lane."""
    begun = np.arange(view.steps) >= act_begins(told, act, view)[:, None]
    away = np.abs(offset(boxes(view, act.into or told.ego), boxes(view, act.participant))[1])
    nearest, step = least(np.where(begun, away, np.inf))
    margin = tolerances.SAME_LANE_M - nearest
    margin = np.where(_hits(told, act, view), np.maximum(margin, 0.0), margin)
    return Judged(margin, nearest, view.time_of(step))


def _beside(told: Told, act: Act, view: View) -> Judged:
    """How far it is from being level, along the road, at the least; a contact may come before."""
    away = gap_m(boxes(view, act.into or told.ego), boxes(view, act.participant))
    nearest, step = least(away)
    margin = np.where(_hits(told, act, view), np.maximum(-nearest, 0.0), -nearest)
    return Judged(margin, nearest, view.time_of(step))


def _triggered(told: Told, act: Act, doing: str) -> Iterator[Claim]:
    """What sets it off."""
    own, when, unit, tolerance = act.participant, act.when, "m", _FAR_M
    test: Callable[..., Judged]
    if isinstance(when, AfterStart):
        said, unit, tolerance = f"{amount(when.delay_s)} s after the start", "s", tolerances.TIME_S
        test = partial(_after_start, when)
    elif isinstance(when, AfterAct):
        other = next(a for a in told.functional.acts if a.id == when.act)
        whose = "it" if other.participant == own else other.participant
        event = f"begins to {plain(other.kind)}" if when.since == "begin" else has_done(other.kind)
        said, unit, tolerance = f"{_later(when)} after {whose} {event}", "s", _LONG_S
        test = partial(_after_act, when, other)
    elif isinstance(when, WhenMeasure):
        _, unit, tolerance, _ = tolerances.OF_MEASURE[when.measure]
        pair = f"{when.participant} to {when.reference}"
        name = plain(when.measure.rpartition("_")[0])
        said = f"when the {name} of {pair} is {amount(when.value)} {unit}"
        test = partial(_at_measure, when)
    elif isinstance(when, AfterDistance):
        whose = f" of {when.participant}" if when.participant else ""
        said = f"after {amount(when.distance_m)} m{whose}"
        test = partial(_driven, when)
    elif isinstance(when, BeforeJunction) and (drive := told.drive(when.participant or own)):
        whose = f" of {drive.participant}" if when.participant else ""
        said = f"{amount(when.distance_m)} m{whose} before the junction"
        test = partial(_before, when, drive)
    else:
        return
    yield _claim(told, act, "when", f"{doing} {said}", unit, test, tolerance=tolerance)


def _later(when: AfterAct) -> str:
    if when.delay_s is None:
        return "some time"
    return "right" if when.delay_s.high == 0.0 else f"{amount(when.delay_s)} s"


def _after_start(when: AfterStart, told: Told, act: Act, view: View) -> Judged:
    time_s = _when(view, act_begins(told, act, view))
    return as_wanted(time_s, when.delay_s, tolerances.TIME_S, time_s)


def _after_act(when: AfterAct, other: Act, told: Told, act: Act, view: View) -> Judged:
    since = (act_ends if when.since == "end" else act_begins)(told, other, view)
    began = act_begins(told, act, view)
    delay = np.where((since < view.steps) & (began < view.steps), began - since, np.nan)
    delay = delay * view.dt_s
    if when.delay_s is None:
        return Judged(delay + _LONG_S, delay, view.time_of(began))
    at_once = _TURNS_AT_ONCE_S if act.kind is ActKind.TURN else _AT_ONCE_S
    wanted = at_once if when.delay_s.high == 0.0 else when.delay_s
    return as_wanted(delay, wanted, _LONG_S, view.time_of(began))


def _at_measure(when: WhenMeasure, told: Told, act: Act, view: View) -> Judged:
    """The value somewhere within the step in which it begins."""
    step = act_begins(told, act, view)
    who, reference = when.participant, when.reference
    ahead = is_said_ahead(told.functional, told.hazards, who, reference, act.id)
    values = [
        measure_at(view, when.measure, who, reference, step + n, ahead=ahead) for n in (-1, 0, 1)
    ]
    low, high = np.min(values, axis=0), np.max(values, axis=0)
    tolerance = tolerances.OF_MEASURE[when.measure].tolerance
    margin = np.max([within(value, when.value, tolerance) for value in values], axis=0)
    passes = (low <= when.value.high) & (high >= when.value.low)
    margin = np.where(passes, np.maximum(margin, tolerance), margin)
    margin = np.where(step < view.steps, margin, np.nan)
    return Judged(margin, values[1], view.time_of(step))


def _driven(when: AfterDistance, told: Told, act: Act, view: View) -> Judged:
    step = act_begins(told, act, view)
    place = view.place_m(when.participant or act.participant)
    gone, there = at(place, step) - place[:, 0], step < view.steps
    return as_wanted(gone, when.distance_m, _FAR_M, view.time_of(step), there=there)


def _before(when: BeforeJunction, drive: Drive, told: Told, act: Act, view: View) -> Judged:
    """Where it begins; of one that stops, where it stands."""
    arm = arms_of(view)[drive.entry]
    box = boxes(view, drive.participant)
    step = act_begins(told, act, view)
    if act.kind is ActKind.STOP and when.participant is None:
        step = act_ends(told, act, view)
    left, there = arm.length_m - at(arm.place(box)[0], step) - box.half_length, step < view.steps
    return as_wanted(left, when.distance_m, _FAR_M, view.time_of(step), there=there)

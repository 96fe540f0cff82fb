"""Rules of the road: kept by everybody whom the text does not make break them."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims.claim import NEVER, Claim, Judged, always, rule_claim, within
from scegen.claims.moments import STANDS_MPS
from scegen.claims.series import first, longest_run
from scegen.claims.statements.touching import hit_s
from scegen.claims.told import Told, amount
from scegen.claims.tolerances import TIME_S
from scegen.claims.view import View
from scegen.motion.batch.arrays import Bools, Floats, Ints
from scegen.motion.rules.lights import RED_FOR_S, at_lights, light_runners, must_obey
from scegen.motion.rules.stopping import AT_LINE_M, OVER_LINE_M, STOPPED_MPS, STOPPED_S, must_stop
from scegen.scenario.concrete import CrossingMotion, DriveMotion
from scegen.scenario.logical import Drive
from scegen.scenario.model import Interval
from scegen.scenario.signals import AtLight, SignalGroup, SignalPlan, SignalState
from scegen.scenario.vocabulary import Control

_QUEUES_WITHIN_M = 10.0
"""So near behind one who waits at the line one waits there, too."""


def claims(told: Told) -> Iterator[Claim]:
    """One for everybody and every rule that it meets with."""
    for name in sorted(must_stop(told.functional, told.logical)):
        statement = f"{name} stands at the stop line before it goes over it"
        test = partial(_stops, name)
        yield rule_claim(f"stop.{name}", statement, test, tolerance=TIME_S, scale=0.5)
    drives = at_lights(told.functional, told.logical)
    runners = light_runners(told.functional, told.logical)
    yield from _as_said(told)
    said = {p.id for p in told.people if p.light is not None} - runners
    for name in sorted((runners | must_obey(told.functional, told.logical)) - said):
        when, test = "while it is not red", partial(_obeys, told, drives[name])
        if name in runners:
            when = f"at red, {RED_FOR_S} s or more after amber"
            test = partial(_shown, name, drives[name].entry, AtLight.RED)
        yield rule_claim(f"light.{name}", f"{name} goes over the line {when}", test, scale=2.0)
    dark = at_lights(told.functional, told.logical, Control.SIGNALS_OFF)
    for name, drive in sorted(dark.items()):
        statement = f"{name} goes over the line while its light is off"
        yield rule_claim(f"light.{name}", statement, partial(_passes_dark, drive), unit="1")


def _as_said(told: Told) -> Iterator[Claim]:
    """How one meets its light, where that is told; who drives at red runs it."""
    drives = at_lights(told.functional, told.logical)
    arms = {c.participant: c.arm for c in told.logical.crossings}
    for person in told.people:
        name, light = person.id, person.light
        if light is None or (name in drives and light is AtLight.RED):
            continue
        field = f"participants.{name}.light"
        statement, test = f"{name} {light.meaning.text}", None
        if name in drives and light is AtLight.STOPS:
            test = partial(_comes_to_rest, drives[name])
        elif name in drives and light is AtLight.WAITS:
            test = partial(_waits, drives[name])
        elif name in drives:
            statement = f"{name} goes over the line while its light is {light}"
            test = partial(_shown, name, drives[name].entry, light)
        elif name in arms:
            statement = f"{name} steps off the kerb while its light is {light}"
            test = partial(_shown, name, arms[name], light, afoot=True)
        else:
            test = partial(always, holds=False)
        yield rule_claim(f"light.{name}", statement, test, scale=2.0, field=field)
        if person.green_delay_s is not None and name in drives:
            delay = person.green_delay_s
            yield rule_claim(
                f"green_delay.{name}",
                f"{name} sets off {amount(delay)} s after its light has turned green",
                partial(_sets_off, drives[name], delay),
                tolerance=TIME_S,
                field=f"participants.{name}.green_delay_s",
            )


def _shown(
    name: str, arm: int, wanted: AtLight | None, view: View, *, afoot: bool = False
) -> Judged:
    """How far inside the time in which its light shows it one goes; measured: since that began.

    With nothing wanted it is all but red.
    """
    rested = OVER_LINE_M if wanted is AtLight.WAITS else 0.0
    step = _over_line(name, view, rested)
    if afoot:  # the front comes over the kerb
        motion = view.concrete.participant(name).motion
        setback_m = motion.setback_m if isinstance(motion, CrossingMotion) else 0.0
        step = view.beyond(name, setback_m - view.body(name).front_m)
    time_s, light = view.time_of(step), _light(view, arm, afoot=afoot)
    if light is None:
        return Judged(np.full(view.count, -NEVER), np.full(view.count, np.nan), time_s)
    plan, group = light
    begins, ends = plan.window_s(group, wanted)
    early = {None: TIME_S, AtLight.RED: -RED_FOR_S}.get(wanted, 0.0)
    since = (time_s - group.green_from_s - begins + early) % plan.cycle_s
    lasts = ends - begins + early
    margin = np.where(
        since <= lasts,
        np.minimum(since, lasts - since),
        -np.minimum(plan.cycle_s - since, since - lasts),
    )
    return Judged(np.where(step <= view.last_step, margin, -NEVER), since - early, time_s)


def _light(view: View, arm: int, *, afoot: bool = False) -> tuple[SignalPlan, SignalGroup] | None:
    """The light on an arm and the plan that it belongs to, None where none works."""
    plan = view.concrete.signals
    group = None if plan is None else plan.group_of(arm, afoot=afoot)
    return None if plan is None or group is None or not plan.working else (plan, group)


def rests_at_line(view: View, name: str) -> Bools:
    """Whether somebody stands at the stop line of the arm by which it comes (c, t)."""
    front = view.place_m(name) + view.body(name).front_m - view.ways[name].line_m
    return (front < OVER_LINE_M) & (front > -AT_LINE_M) & (view.speed_mps(name) < STOPPED_MPS)


def _rests_in_queue(view: View, name: str, behind: frozenset[str] = frozenset()) -> Bools:
    """The same, or right behind one who stands there so in its lane; not one who is ``behind``."""
    rests, way = rests_at_line(view, name), view.ways[name]
    short_m = way.line_m - view.place_m(name) - view.body(name).front_m
    stands = view.speed_mps(name) < STOPPED_MPS
    for other in _of_its_lane(view, name) - behind:
        rear_m = view.ways[other].line_m - view.place_m(other) + view.body(other).rear_m
        close = (short_m > rear_m) & (short_m - rear_m < _QUEUES_WITHIN_M)
        if (stands & close).any():
            rests = rests | (stands & close & _rests_in_queue(view, other, behind | {name}))
    return rests


def _of_its_lane(view: View, name: str) -> set[str]:
    """Others who come in by the lane in which somebody does."""
    motions = {each: way.participant.motion for each, way in view.ways.items()}
    lanes = {
        each: (motion.entry, motion.entry_lane)
        for each, motion in motions.items()
        if isinstance(motion, DriveMotion)
    }
    return {each for each, lane in lanes.items() if each != name and lane == lanes.get(name)}


def _rest_at_line(drive: Drive, view: View) -> tuple[Bools, Floats]:
    """Whether it has come to rest before its line, and for how long its light is not green then.

    Below 0: how long its light has been green (c,).
    """
    rests, light = _rests_in_queue(view, drive.participant), _light(view, drive.entry)
    at_all = np.asarray(rests.any(axis=1))
    if light is None:
        return at_all, np.full(view.count, -NEVER)
    plan, group = light
    since = (view.time_of(first(rests)) - group.green_from_s) % plan.cycle_s
    stopped = np.where(since < group.green_s, -since - TIME_S, since - group.green_s)
    return at_all, stopped


def _waits(drive: Drive, view: View) -> Judged:
    """It rests while it is not green, and goes over the line at green."""
    rests, stopped = _rest_at_line(drive, view)
    goes = _shown(drive.participant, drive.entry, AtLight.WAITS, view)
    margin = np.where(rests, np.minimum(stopped, goes.margin), -NEVER)
    return Judged(margin, goes.measured, goes.time_s)


def _sets_off(drive: Drive, delay_s: Interval, view: View) -> Judged:
    """How long after green it moves off from where it has rested at its line."""
    name, light = drive.participant, _light(view, drive.entry)
    rests, _ = _rest_at_line(drive, view)
    before = np.arange(view.steps) < _over_line(name, view, OVER_LINE_M)[:, None]
    stood = before & (view.speed_mps(name) <= STANDS_MPS)
    time_s = view.time_of(view.steps - 1 - stood[:, ::-1].argmax(axis=1))
    if light is None:
        return Judged(np.full(view.count, -NEVER), np.full(view.count, np.nan), time_s)
    plan, group = light
    half = plan.cycle_s / 2
    since = (time_s - group.green_from_s + half) % plan.cycle_s - half
    margin = within(since, delay_s, TIME_S)
    return Judged(np.where(rests & stood.any(axis=1), margin, -NEVER), since, time_s)


def _comes_to_rest(drive: Drive, view: View) -> Judged:
    """It rests at its line after its light has gone from green, since the start; and stays."""
    (rests, stopped), name = _rest_at_line(drive, view), drive.participant
    gone = _over_line(name, view, OVER_LINE_M) <= view.last_step
    at_rest = view.time_of(first(view.speed_mps(name) < STOPPED_MPS))
    margin = np.where(rests & ~gone, np.minimum(stopped, at_rest - stopped), -NEVER)
    return Judged(margin, stopped, at_rest)


def _stops(name: str, view: View) -> Judged:
    """The longest rest at the line before it is passed; at the end there is none to be missed."""
    over = _over_line(name, view, OVER_LINE_M)
    before = np.arange(view.steps) < over[:, None]
    steps, begins = longest_run(before & rests_at_line(view, name))
    rest = np.maximum(steps - 1, 0) * view.dt_s
    margin = np.where(over <= view.last_step, rest - STOPPED_S + TIME_S, 0.0)
    return Judged(margin, rest, np.asarray(begins * view.dt_s))


def _obeys(told: Told, drive: Drive, view: View) -> Judged:
    """It does not go at red; who does not get there does not, nor who has hit somebody before."""
    name = drive.participant
    judged = _shown(name, drive.entry, None, view)
    gets_there = (_over_line(name, view) <= view.last_step) & (
        judged.time_s < hit_s(told, view, name)
    )
    return judged._replace(margin=np.where(gets_there, judged.margin, 0.0))


def _passes_dark(drive: Drive, view: View) -> Judged:
    """Whether its light is there and shows nothing as the front goes over the line.

    For one that does not get there, at the end.
    """
    plan = view.concrete.signals
    group = None if plan is None else plan.group_of(drive.entry)
    times = view.time_of(np.minimum(_over_line(drive.participant, view), view.last_step))
    dark = [
        plan is not None and group is not None and plan.state(group, t) is SignalState.OFF
        for t in times.tolist()
    ]
    return Judged(np.where(dark, 0.0, -1.0), np.asarray(dark, dtype=np.float64), times)


def _over_line(name: str, view: View, beyond_m: float = 0.0) -> Ints:
    """The step at which its front goes over the line, so far at least (c,)."""
    return view.beyond(name, view.ways[name].line_m + beyond_m, view.body(name).front_m)

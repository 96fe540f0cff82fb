"""What sets an act off: a time, another act, a measure, a way driven, the junction."""

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

from scegen.claims import tolerances
from scegen.claims.arms import arms_of
from scegen.claims.boxes import boxes
from scegen.claims.claim import Claim, Judged, as_wanted, within
from scegen.claims.moments import act_begins
from scegen.claims.series import at
from scegen.claims.statements.act_ends import act_ends
from scegen.claims.statements.of_an_act import claim_of, when_s
from scegen.claims.statements.spacings import measure_at
from scegen.claims.told import Told, amount, plain
from scegen.claims.view import View
from scegen.scenario.acts import (
    Act,
    ActKind,
    AfterAct,
    AfterDistance,
    AfterStart,
    BeforeJunction,
    WhenMeasure,
)
from scegen.scenario.in_line import is_said_ahead
from scegen.scenario.logical import Crossing, Drive
from scegen.scenario.model import Interval
from scegen.scenario.verbs import does, has_done

_FAR_M, _LONG_S = tolerances.DISTANCE_M, 2 * tolerances.TIME_S
_AT_ONCE_S = Interval(low=0.0, high=2.0)
"""What follows at once does so within the time of a slow reaction."""
_TURNS_AT_ONCE_S = Interval(low=0.0, high=4.0)
"""Who stood at a line comes to the bend first."""


def claims(told: Told, act: Act) -> Iterator[Claim]:
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
        later = "some time" if when.delay_s is None else f"{amount(when.delay_s)} s"
        later = "right" if when.delay_s is not None and when.delay_s.high == 0.0 else later
        said, unit, tolerance = f"{later} after {whose} {event}", "s", _LONG_S
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
    elif isinstance(when, BeforeJunction) and (way := told.way(when.participant or own)):
        whose = f" of {way.participant}" if when.participant else ""
        said = f"{amount(when.distance_m)} m{whose} before the junction"
        test = partial(_before, when, way)
    else:
        return
    yield claim_of(
        told, act, "when", f"{own} {does(act.kind)} {said}", unit, test, tolerance=tolerance
    )


def _after_start(when: AfterStart, told: Told, act: Act, view: View) -> Judged:
    time_s = when_s(view, act_begins(told, act, view))
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
        measure_at(view, when.measure, who, reference, step + n, ahead=ahead, act=act)
        for n in (-1, 0, 1)
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


def _before(
    when: BeforeJunction, way: Drive | Crossing, told: Told, act: Act, view: View
) -> Judged:
    """Where it begins; of one that stops, where it stands; of who crosses there, its middle."""
    arm = arms_of(view)[way.entry if isinstance(way, Drive) else way.arm]
    box = boxes(view, way.participant)
    step = act_begins(told, act, view)
    if act.kind is ActKind.STOP and when.participant is None:
        step = act_ends(told, act, view)
    reach = box.half_length if isinstance(way, Drive) else 0.0
    left, there = arm.length_m - at(arm.place(box)[0], step) - reach, step < view.steps
    return as_wanted(left, when.distance_m, _FAR_M, view.time_of(step), there=there)

"""How much of an act there is: its rate, speed, duration and distance, as far as they are said."""

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from scegen.claims import tolerances
from scegen.claims.boxes import to_side
from scegen.claims.claim import Claim, Judged, within
from scegen.claims.lateral import lateral_m
from scegen.claims.moments import act_begins, act_run, rest
from scegen.claims.series import at, greatest
from scegen.claims.sideways import aside_over, straightened
from scegen.claims.statements.of_an_act import claim_of
from scegen.claims.statements.touching import hit_s
from scegen.claims.told import KPH, Told, amount
from scegen.claims.view import View
from scegen.motion.batch.arrays import SPEED, Bools, Floats
from scegen.scenario.acts import GAINING, LEAVING, SLOWING, Act, ActKind
from scegen.scenario.model import Interval
from scegen.scenario.verbs import does

_ASIDE_M, _LONG_S = 2 * tolerances.LATERAL_M, 2 * tolerances.TIME_S
_SPEED_OVER_S = 0.1


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
    """The speed in which the run ends; a contact leaves open that of one who slows down."""
    run, hit = act_run(told, act, view), hit_s(told, view, act.participant)
    speed, time_s = at(view.speed_mps(act.participant), run.end), view.time_of(run.end)
    if act.kind in GAINING:  # whatever it does after a contact
        return _Found(speed, time_s, run.happens & (time_s <= hit))
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
    aside = lateral_m(view, act.participant, told.drive(act.participant))
    most, step = greatest(to_side(act.side, aside))
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
    _Amount("distance_m", _PACED, "{does} over {} m", "m", tolerances.DISTANCE_M, _goes_on),
    _Amount("lateral_m", LEAVING, "goes {} m to the side", "m", _ASIDE_M, _far_aside),
    _Amount("lateral_mps", LEAVING, "goes sideways at {} m/s", "m/s", _ASIDE_M, _fast_aside),
    _Amount("duration_s", LEAVING, "takes {} s to go aside", "s", _LONG_S, _lasts_aside),
    _Amount("duration_s", _WAITING, "stands for {} s", "s", _LONG_S, _stands),
    _Amount("distance_m", _REVERSING, "goes {} m back", "m", tolerances.GAP_M, _goes_back),
)


def claims(told: Told, act: Act) -> Iterator[Claim]:
    """One for every number that the text gives; who stops does so to 0 km/h."""
    for row in _AMOUNTS:
        wanted: Interval | None = getattr(act, row.part) if act.kind in row.kinds else None
        if act.kind is ActKind.STOP and row.part == "target_speed_mps":
            wanted = wanted or Interval(low=0.0, high=0.0)
        if wanted is not None:
            factor, scale = (KPH, 5.0) if row.unit == "km/h" else (1.0, 1.0)
            told_so = row.says.format(amount(wanted, factor), does=does(act.kind))
            yield claim_of(
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

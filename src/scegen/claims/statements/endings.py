"""A danger is over before the scenario is: it goes on after the closest approach, and apart."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims.claim import Claim, ClaimKind, Judged
from scegen.claims.hazards.table import PREDICATES
from scegen.claims.series import chosen, filled
from scegen.claims.told import Told
from scegen.claims.view import View
from scegen.motion.batch.arrays import Floats

GOES_ON_S = 2.0
_OVER_S = 0.5
_CLOSING_MPS = 0.3
_FAR_M = 20.0
"""Who is farther apart than this may close in on another without being in danger."""
_STEADY_M = 0.2


def claims(told: Told) -> Iterator[Claim]:
    """Of those whom it is about."""
    if len(told.people) < 2:
        return
    goes_on = f"it goes on for {GOES_ON_S:g} s after the closest approach"
    apart = "nobody is still closing in when it ends"
    for name, statement, unit, test in (
        ("goes_on", goes_on, "s", partial(_goes_on, told)),
        ("apart", apart, "m/s", partial(_no_more_closing, told)),
    ):
        yield Claim(f"ending.{name}", ClaimKind.ENDING, statement, "outcome", unit, test)


def pairs_of(told: Told, view: View) -> list[tuple[str, str]]:
    """Whom it is about: the outcome's pair, else those of the dangers, else the ego and others."""
    outcome = told.functional.outcome
    if outcome is not None and len(outcome.between) == 2:
        return [(outcome.between[0], outcome.between[1])]
    pairs = [
        (by, to)
        for hazard in told.hazards
        if PREDICATES[hazard.kind].conflict
        for by in hazard.by
        for to in hazard.to or (told.ego,)
        if by != to
    ]
    pairs = [pair for pair in pairs if told.ego in pair] or pairs
    everybody = [(told.ego, p.id) for p in told.people if p.id != told.ego and not p.parked]
    known = [pair for pair in pairs or everybody if {*pair} <= {*view.index}]
    return [pair for pair in known if view.pair(*pair) is not None]


def _ends(told: Told, view: View) -> list[tuple[tuple[str, str], Floats]]:
    """Whom it is about, and how far apart at the end, a little and some time before (c, 3)."""
    before = np.array([0, round(_OVER_S / view.dt_s), round(GOES_ON_S / view.dt_s)])
    steps = view.last_step[:, None] - before
    make = lambda: [(p, view.distance_m(*p, steps)) for p in pairs_of(told, view)]  # noqa: E731
    return view.once("ends", make)


def _goes_on(told: Told, view: View) -> Judged:
    """Two who keep their distance to the end are past their closest approach all the same."""
    never, start = np.full(view.count, np.inf), np.zeros(view.count)
    found = [(never, start, never)]
    for pair, ends in _ends(told, view):
        away = filled(view.of_pair("distance_m", *pair), np.inf)
        found.append((away, view.of_pair("closest_s", *pair), ends[:, 2]))
    least, when, before = chosen(found, np.argmin)
    left = view.time_of(view.last_step) - when - GOES_ON_S
    left = np.where(np.abs(left) < view.dt_s / 2, 0.0, left)
    keeps = before < np.where(np.isfinite(least), least + _STEADY_M, np.inf)
    steady = np.isinf(least) | (keeps & (least > 0.0))
    left = np.where(steady, np.maximum(left, 0.0), left)
    return Judged(left, left + GOES_ON_S, when)


def _no_more_closing(told: Told, view: View) -> Judged:
    found = [(np.full(view.count, _CLOSING_MPS), np.zeros(view.count))]
    for pair, ends in _ends(told, view):
        closing = (ends[:, 1] - ends[:, 0]) / _OVER_S
        # Those who have touched go through one another: what counts comes before.
        over = (ends[:, 0] > _FAR_M) | ~np.isnan(view.of_pair("contact_s", *pair))
        found.append((np.where(over, _CLOSING_MPS, _CLOSING_MPS - closing), closing))
    margin, worst = chosen(found, np.argmin)
    return Judged(margin, worst, view.time_of(view.last_step))

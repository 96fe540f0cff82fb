"""A danger is over before the scenario is: it goes on after the closest approach, and apart."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims.boxes import apart, box_at
from scegen.claims.claim import Claim, ClaimKind, Judged
from scegen.claims.hazards.table import PREDICATES
from scegen.claims.told import Told
from scegen.claims.view import View
from scegen.motion.batch.arrays import Floats, Ints

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
    yield Claim(
        id="ending.goes_on",
        kind=ClaimKind.ENDING,
        statement=f"it goes on for {GOES_ON_S:g} s after the closest approach",
        field="outcome",
        unit="s",
        test=partial(_goes_on, told),
    )
    yield Claim(
        id="ending.apart",
        kind=ClaimKind.ENDING,
        statement="nobody is still closing in when it ends",
        field="outcome",
        unit="m/s",
        test=partial(_no_more_closing, told),
    )


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


def _nearest(told: Told, view: View) -> tuple[Floats, Floats, Floats]:
    """When the nearest pair is nearest, the distance two seconds before the end, and then."""
    least = np.full(view.count, np.inf)
    when = np.zeros(view.count)
    before = np.full(view.count, np.inf)
    last = view.last_step
    for pair in pairs_of(told, view):
        away = view.of_pair("distance_m", *pair)
        chosen = away < least
        when = np.where(chosen, view.of_pair("closest_s", *pair), when)
        late = apart(*(box_at(view, who, last - _steps(view, GOES_ON_S)) for who in pair))
        before = np.where(chosen, late, before)
        least = np.where(chosen, away, least)
    return when, before, least


def _steps(view: View, time_s: float) -> int:
    return round(time_s / view.dt_s)


def _goes_on(told: Told, view: View) -> Judged:
    """Two who keep their distance to the end are past their closest approach all the same."""
    when, before, least = _nearest(told, view)
    left = view.time_of(view.last_step) - when - GOES_ON_S
    left = np.where(np.abs(left) < view.dt_s / 2, 0.0, left)
    keeps = before < np.where(np.isfinite(least), least + _STEADY_M, np.inf)
    steady = np.isinf(least) | (keeps & (least > 0.0))
    return Judged(np.where(steady, np.maximum(left, 0.0), left), left + GOES_ON_S, when)


def _no_more_closing(told: Told, view: View) -> Judged:
    margin = np.full(view.count, _CLOSING_MPS)
    worst = np.zeros(view.count)
    last = view.last_step
    for pair in pairs_of(told, view):
        end, before = (_away(view, pair, last - n) for n in (0, _steps(view, _OVER_S)))
        closing = (before - end) / _OVER_S
        # Those who have touched go through one another: what counts comes before.
        over = (end > _FAR_M) | ~np.isnan(view.of_pair("contact_s", *pair))
        value = np.where(over, _CLOSING_MPS, _CLOSING_MPS - closing)
        worst = np.where(value < margin, closing, worst)
        margin = np.minimum(margin, value)
    return Judged(margin, worst, view.time_of(last))


def _away(view: View, pair: tuple[str, str], step: Ints) -> Floats:
    return apart(*(box_at(view, who, step) for who in pair))

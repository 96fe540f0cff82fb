"""How it ends: a contact, a near miss or neither; and that nobody else touches anybody."""

from collections.abc import Iterator, Mapping
from functools import partial
from itertools import combinations

import numpy as np

from scegen.claims.boxes import contact, free, seen
from scegen.claims.claim import NEVER, Claim, ClaimKind, Judged, Test, best_of, within
from scegen.claims.near_miss import near_miss
from scegen.claims.series import clipped, filled
from scegen.claims.statements.touching import hit_s
from scegen.claims.told import Told, amount
from scegen.claims.tolerances import PERCENT
from scegen.claims.view import View
from scegen.motion.batch.arrays import Floats
from scegen.scenario.model import Interval
from scegen.scenario.outcome import BodySide, Outcome, OutcomeKind

_CORNER_M = 0.3
"""Nearer to a corner than this, which side is touched first would be a matter of rounding."""
_MET_MPS = 0.5
"""Who drives on bumper to bumper with another at one speed does not collide with it."""
_SIDES = (BodySide.FRONT, BodySide.REAR, BodySide.LEFT, BodySide.RIGHT)


def claims(told: Told) -> Iterator[Claim]:
    """Of the outcome, and of everybody else."""
    outcome = told.functional.outcome
    if outcome is not None:
        yield from _said(told, outcome)
    does = "nobody else touches anybody" if told.collides else "nobody touches anybody"
    if told.open_end and outcome is None:
        does = "nobody touches anybody but whom it meets"
    test = partial(_nobody_else, told)
    yield Claim("contacts", ClaimKind.CONTACT, does, "outcome", "m", test)


def _said(told: Told, outcome: Outcome) -> Iterator[Claim]:
    who = " and ".join(outcome.between) or f"{told.ego} and another"
    if outcome.kind is OutcomeKind.COLLISION:
        yield _claim("kind", f"{who} touch", "m", partial(_touch, told, outcome), 5.0)
        if outcome.impact_percent is not None:
            percent = outcome.impact_percent
            statement = f"the contact is at {amount(percent)} % of the ego's width from its left"
            test: Test = partial(_impact, told, outcome, percent)
            yield _claim("impact_percent", statement, "%", test, 20.0, PERCENT)
        if outcome.struck is not None:
            statement = f"the {outcome.struck} of the ego is touched first"
            test = partial(_struck, told, outcome, outcome.struck)
            yield _claim("struck", statement, "m", test, 1.0)
    elif outcome.kind is OutcomeKind.NEAR_MISS:
        test = partial(_nearly, told, outcome)
        yield _claim("kind", f"{who} nearly touch, and do not", "1", test, 1.0)
    else:
        yield _claim("kind", f"{who} do not touch", "m", partial(_apart, told, outcome), 1.0)


def _claim(
    part: str, statement: str, unit: str, test: Test, scale: float, tolerance: float = 0.0
) -> Claim:
    name, kind = f"outcome.{part}", ClaimKind.OUTCOME
    return Claim(name, kind, statement, name, unit, test, tolerance, scale)


def pairs_of(told: Told, outcome: Outcome, view: View) -> list[tuple[str, str]]:
    """Between whom it may be: the two who are named, or the ego and anybody."""
    between = outcome.between
    if len(between) == 2:
        doors = [(a, d) for a, b in (between, between[::-1]) for d, of in told.doors.items()
                 if of == b and d in view.index]  # fmt: skip
        return [(between[0], between[1]), *doors]
    one = between[0] if between and between[0] != told.ego else None
    others = [one] if one is not None else [name for name in view.index if name != told.ego]
    return [(told.ego, other) for other in others if other in view.index]


def _touch(told: Told, outcome: Outcome, view: View) -> Judged:
    """At least one of those pairs touches, at a speed that differs."""
    margin = np.full(view.count, -NEVER)
    when = np.full(view.count, np.nan)
    for pair in pairs_of(told, outcome, view):
        time_s = view.of_pair("contact_s", *pair)
        apart = filled(view.of_pair("distance_m", *pair), NEVER)
        slow = np.maximum(_MET_MPS - view.of_pair("impact_mps", *pair), 0.0)
        margin = np.maximum(margin, -np.where(np.isnan(time_s), apart, slow))
        when = np.fmin(when, time_s)
    return Judged(margin, -margin, when)


def _met(told: Told, outcome: Outcome, view: View) -> tuple[str, str] | None:
    """The pair that touches first in most candidates, the ego first; None if it is alone."""
    pairs = pairs_of(told, outcome, view)
    if not pairs:
        return None
    hits = [np.isfinite(view.of_pair("contact_s", *pair)).sum() for pair in pairs]
    first, second = pairs[int(np.argmax(hits))]
    return (first, second) if first == told.ego else (second, first)


def _nowhere(view: View) -> Judged:
    """Of a contact that cannot be."""
    never = np.full(view.count, np.nan)
    return Judged(never, never, never)


def _impact(told: Told, outcome: Outcome, wanted: Interval, view: View) -> Judged:
    pair = _met(told, outcome, view)
    if pair is None:
        return _nowhere(view)
    met = contact(view, *pair)
    aside = seen(met.first, met.second).y
    # The middle of who is met may lie beyond the ego's side: what is hit is its edge.
    percent = clipped(50.0 - 100.0 * aside / (2.0 * met.first.half_width), 0.0, 100.0)
    margin = np.where(met.happens, within(percent, wanted, PERCENT), np.nan)
    return Judged(margin, percent, met.time_s)


def _struck(told: Told, outcome: Outcome, side: BodySide, view: View) -> Judged:
    """The side from which the other is freest at the first contact is the one that it meets.

    The other reaches so far along that side that it is clear of the corners.
    """
    pair = _met(told, outcome, view)
    if pair is None:
        return _nowhere(view)
    met = contact(view, *pair)
    clear = dict(zip(_SIDES, free(met.first, met.second), strict=True))
    others: Floats = np.max([clear[other] for other in _SIDES if other is not side], axis=0)
    reaches = np.where(met.happens, clear[side] - others, np.nan)
    return Judged(reaches - _CORNER_M, reaches, met.time_s)


def _nearly(told: Told, outcome: Outcome, view: View) -> Judged:
    pairs = pairs_of(told, outcome, view)
    found = [(near_miss(view, pair), view.of_pair("closest_s", *pair)) for pair in pairs]
    return best_of(view, [Judged(margin, margin, time_s) for margin, time_s in found])


def _apart(told: Told, outcome: Outcome, view: View) -> Judged:
    """None of those pairs touches."""
    return _untouched(view, pairs_of(told, outcome, view))


def _nobody_else(told: Told, view: View) -> Judged:
    standing = {p.id for p in told.people if p.parked and not p.pulls_out}
    standing |= {name for name in view.index if all(name != p.id for p in told.people)}
    pairs = [
        (first, second)
        for first, second in combinations(view.index, 2)
        if not told.may_touch(first, second) and not {first, second} <= standing
    ]
    over_s = {name: hit_s(told, view, name) for name in view.index}
    return _untouched(view, pairs, over_s)


def _untouched(
    view: View, pairs: list[tuple[str, str]], over_s: Mapping[str, Floats] | None = None
) -> Judged:
    """The smallest distance of any pair, and how deep into each other's time the worst are.

    What those do is no matter for whom it is ``over``: a crash that is said may lead to others.
    """
    known = {pair: found[0] for pair in pairs if (found := view.pair(*pair)) is not None}
    measured = list(known.values())
    if not measured:
        free = np.full(view.count, NEVER)
        return Judged(free, free, np.full(view.count, np.nan))
    time_s = view.summary.contact_s[:, measured]
    apart = filled(view.summary.distance_m[:, measured], NEVER)
    if over_s is not None:
        ends = np.stack([np.minimum(over_s[a], over_s[b]) for a, b in known], axis=1)
        excused = time_s > ends
        time_s, apart = np.where(excused, np.nan, time_s), np.where(excused, NEVER, apart)
    depth = filled(clipped(-view.summary.pet_s[:, measured], 0.0, 3.0), 1.0)
    value = np.where(np.isnan(time_s), apart, -1.0 - depth)
    worst = np.arange(view.count), value.argmin(axis=1)
    margin = np.minimum(value[worst], NEVER)
    when = np.where(margin < NEVER, time_s[worst], np.nan)
    return Judged(margin, np.maximum(margin, 0.0), when)

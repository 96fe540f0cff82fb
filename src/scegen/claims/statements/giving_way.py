"""Right of way: kept by everybody who meets another of whom the text says nothing else."""

from collections.abc import Iterator
from functools import partial
from math import inf

import numpy as np

from scegen.claims.boxes import boxes, offset, same_way
from scegen.claims.claim import NEVER, Claim, ClaimKind, Judged, Test, rule_claim
from scegen.claims.series import at, chosen, clipped, first
from scegen.claims.statements.rules import rests_at_line
from scegen.claims.told import Told, plain
from scegen.claims.tolerances import TIME_S
from scegen.claims.view import View
from scegen.measures.grounds import Ground, grounds
from scegen.motion.rules.giving_way import CLEAR_S, TOGETHER_S, Duty, must_give_way
from scegen.scenario.acts import LETS_BY

_ENOUGH_S, _ENOUGH_M = 10.0, 10.0
_ALONG = 0.5
"""Cosine of 60 degrees: by more than that, two go neither the same way nor against each other."""


def claims(told: Told) -> Iterator[Claim]:
    """One for every two whose ways meet."""
    for duty in must_give_way(told.functional, told.logical):
        if duty.rule is None or {duty.yields, duty.other} == {*told.brought_together}:
            continue
        order = "whoever of both stops later" if duty.by_arrival else duty.yields
        between = f"{duty.yields} and {duty.other}" if duty.by_arrival else duty.other
        statement = f"{order} gives way: {between} ({plain(duty.rule)})"
        two = duty.yields, duty.other
        test: Test = partial(_in_order, duty) if duty.by_arrival else partial(_given, *two)
        name = f"way.{duty.yields}.{duty.other}"
        yield rule_claim(name, statement, test, tolerance=TIME_S)


def said(told: Told) -> Iterator[Claim]:
    """One for everybody who is said to let another go first."""
    for act in told.functional.acts:
        if act.kind in LETS_BY and act.into is not None:
            name, kind = f"{act.id}.into", ClaimKind.ACT
            does = f"{act.participant} lets {act.into} go first"
            # Along a plain road one who drives gets past the other.
            meet = not told.plain_road or None in map(told.drive, (act.participant, act.into))
            test = partial(_lets_by if meet else _gets_past, act.participant, act.into)
            yield Claim(f"act.{name}", kind, does, f"acts.{name}", "s", test, TIME_S)


def _lets_by(name: str, other: str, view: View) -> Judged:
    """How long after the other has left their ground it comes onto it, or that it gets past."""
    shared = _grounds(view, name, other)
    if not shared:
        return _gets_past(name, other, view)
    found = [(np.full(view.count, _ENOUGH_S), np.zeros(view.count))]
    for ground in shared:
        left_m = ground.other_leaves_m
        if not left_m < inf:
            left_m = ground.other_enters_m + view.body(other).length_m
        they_go = view.reaches_s(other, left_m)
        comes = view.reaches_s(name, ground.enter_m)
        with np.errstate(invalid="ignore"):
            own = np.where(np.isfinite(comes), comes - they_go, _ENOUGH_S)
        own = clipped(np.where(np.isfinite(they_go), own, -NEVER), -NEVER, _ENOUGH_S) + TIME_S
        found.append((own, np.where(np.isfinite(they_go), they_go, 0.0)))
    margin, time_s = chosen(found, np.argmin)
    return Judged(margin, margin, time_s)


def _gets_past(name: str, other: str, view: View) -> Judged:
    """By how much the other, who goes the same way or comes the other, is past in the end (m).

    Those who then go neither have parted without meeting.
    """
    own, theirs = boxes(view, name), boxes(view, other)
    along = at(same_way(own, theirs), view.last_step)
    ahead_m = at(offset(own, theirs)[0], view.last_step) * np.sign(along)
    past_m = ahead_m - own.half_length - theirs.half_length
    past_m = np.where(np.abs(along) < _ALONG, _ENOUGH_M, past_m)
    return Judged(past_m, past_m, view.time_of(view.last_step))


def _in_order(duty: Duty, view: View) -> Judged:
    """By order of arrival; who gives way where both come at once is in the duty."""
    own_s, other_s = (
        view.time_of(first(rests_at_line(view, name))) for name in (duty.yields, duty.other)
    )
    first_come = own_s - other_s < -TOGETHER_S
    turned, usual = _given(duty.other, duty.yields, view), _given(duty.yields, duty.other, view)
    return Judged(*(np.where(first_come, a, b) for a, b in zip(turned, usual, strict=True)))


def _given(name: str, other: str, view: View) -> Judged:
    """How long after the other, or how much more than long enough before it, one goes, and when.

    Below 0 it takes the other's way. One that does not come onto their ground gives way.
    """
    found = [(np.full(view.count, np.inf), np.zeros(view.count))]
    for ground in _grounds(view, name, other):
        comes, goes = (view.reaches_s(name, place) for place in ground[:2])
        they_come, they_go = (view.reaches_s(other, place) for place in ground[2:])
        there = np.isfinite(comes) & np.isfinite(they_come)
        with np.errstate(invalid="ignore"):
            between = np.maximum(comes - they_go, they_come - goes - CLEAR_S)
        found.append((np.where(there, np.maximum(between, -_ENOUGH_S), np.inf), comes))
    left_s, comes_s = chosen(found, np.argmin)
    margin = np.minimum(left_s + TIME_S, _ENOUGH_S)
    return Judged(margin, margin, np.where(margin < _ENOUGH_S, comes_s, 0.0))


def _grounds(view: View, name: str, other: str) -> list[Ground]:
    """The grounds ahead that two use; of any two, not only of those who are measured."""
    one, two = view.ways[name], view.ways[other]
    bodies = one.participant.body, two.participant.body
    if one.whole is None or two.whole is None:
        return [*grounds(one.path, bodies[0], two.path, bodies[1])]
    a, b = one.starts_m, two.starts_m
    # Many share whole ways: their grounds are found once for all.
    return [
        Ground(come - a, go - a, they_come - b, they_go - b)
        for come, go, they_come, they_go in grounds(one.whole, bodies[0], two.whole, bodies[1])
        if go > a and they_go > b
    ]

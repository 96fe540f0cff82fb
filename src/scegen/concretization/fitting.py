"""Fit starts, and the places of acts, to what the text says: exactly, and else as is usual.

Everybody's lateness, the places of acts that are open and the moments at which walkers set off are
the unknowns; what is said of spacings and triggers are equations between them. What is said
outweighs staying as it was.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial

import numpy as np

from scegen.concretization.deeds import is_open
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.moments import during_s, too_long_m
from scegen.concretization.setup import Setup
from scegen.motion.model import Array
from scegen.scenario.acts import (
    Act,
    ActKind,
    AfterAct,
    AfterDistance,
    AfterStart,
    BeforeJunction,
    WhenMeasure,
)  # fmt: skip
from scegen.scenario.spacings import CONTACT, LENGTHWISE, START

_AS_IT_WAS = 1e-6
_PER_M = 0.1
"""A metre counts as much as so many seconds."""
_STEP_S, _STEP_M = 0.01, 0.1
_ROUNDS, _ENOUGH = 25, 1e-4
_THEN_S = 0.3
"""Who answers another at once does so after this."""


def fit(scene: Setup) -> None:
    """Change what is open until what is said holds, as little as that needs."""
    said = len(list(_missed(scene)))
    if not said:
        return
    values, sizes, give = zip(*_unknowns(scene), strict=True)
    first, steps = np.array(values), np.array(sizes)

    def missed(x: Array) -> Array:
        for give_it, value in zip(give, x.tolist(), strict=True):
            give_it(value)
        kept = _AS_IT_WAS * _STEP_S / steps * (x - first)
        return np.concatenate([list(_missed(scene)), kept])

    x, now = first, missed(first)
    for _ in range(_ROUNDS):
        slope = np.empty((len(now), len(x)))
        for n, step in enumerate(steps):
            tried = x.copy()
            tried[n] += step
            slope[:, n] = (missed(tried) - now) / step
        way = -np.linalg.lstsq(slope, now, rcond=1e-12)[0]
        share = 1.0
        while share > 1e-3 and np.linalg.norm(missed(x + share * way)) > np.linalg.norm(now):
            share /= 2
        x = x + share * way
        now = missed(x)
        if np.linalg.norm(now[:said]) < _ENOUGH and np.abs(share * way).max() < _STEP_S:
            break
    missed(x)


def _unknowns(scene: Setup) -> Iterator[tuple[float, float, Callable[[float], None]]]:
    """How late everybody is, where acts are that are open, and when walkers set off.

    As it is, the step in which it is tried, and what sets it.
    """
    for draft in scene.drives.values():
        yield draft.offset_s, _STEP_S, partial(setattr, draft, "offset_s")
        for n, mark in enumerate(draft.steps):
            stood = n == 0 and mark.act is None and draft.parked_s_m is None
            if is_open(scene, mark) or stood:
                yield mark.s_m, _STEP_M, partial(_put, draft, n)
    for walk in scene.walks.values():
        if walk.sets_off_s is not None:
            yield walk.sets_off_s, _STEP_S, partial(setattr, walk, "sets_off_s")


def _put(draft: DriveDraft, number: int, s_m: float) -> None:
    draft.steps[number] = replace(draft.steps[number], s_m=s_m)


def _missed(scene: Setup) -> Iterator[float]:
    """By how much distances and moments are not as the text says."""
    known = {*scene.drives, *scene.walks, *scene.stands}
    for spacing in scene.functional.spacings:
        pair = {spacing.participant, spacing.reference}
        if spacing.measure in LENGTHWISE and spacing.at != CONTACT and known >= pair:
            at = None if spacing.at == START else scene.act(spacing.at)
            if at is None or at.participant in known:
                time_s = 0.0 if at is None else during_s(scene, at)[spacing.since == "end"]
                yield _PER_M * too_long_m(scene, spacing, time_s, at)
    for act in scene.acts:
        if act.when is not None and act.participant in known:
            yield from _mistimed(scene, act, known)


def _mistimed(scene: Setup, act: Act, known: set[str]) -> Iterator[float]:
    when, own_s = act.when, during_s(scene, act)[0]
    if isinstance(when, WhenMeasure) and when.measure in LENGTHWISE:
        if known >= {when.participant, when.reference}:
            yield _PER_M * too_long_m(scene, when, own_s, act)
    elif isinstance(when, AfterStart):
        yield own_s - when.delay_s.middle
    elif isinstance(when, AfterDistance | BeforeJunction):
        # How far one has come, or has still to go to the junction; one's own place is fixed.
        name, way_m = when.participant or act.participant, when.distance_m.middle
        draft = scene.drives.get(name)
        if draft is None:
            return
        course, late = draft.course, draft.offset_s
        if isinstance(when, AfterDistance):
            yield _PER_M * (course.s_at(own_s - late) - course.s_at(-late) - way_m)
        elif when.participant is not None:
            place = draft.junction_s_m - draft.body.front_m - way_m
            yield own_s - (late + course.time_at(place))
    elif isinstance(when, AfterAct):
        other = scene.act(when.act)
        own = scene.drives.get(act.participant)
        marks = own.steps if own is not None else ()
        chained = any(mark.act == act.id and mark.then_s is not None for mark in marks)
        if other.participant in known and not chained:
            since_s = during_s(scene, other)[when.since == "end"]
            yield own_s - since_s - (when.later_s.middle or _THEN_S)


def conditioned(scene: Setup, name: str) -> bool:
    """Whether the text says when somebody who crosses sets off."""
    named = {spacing.at for spacing in scene.functional.spacings}
    crosses = scene.acts_of(name, {ActKind.CROSS})
    return any(act.when is not None or act.id in named for act in crosses)
